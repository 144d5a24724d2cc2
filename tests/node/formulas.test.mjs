// Formulas that a person types: curves, B-functions, and what is said about wrong ones.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { load, near, refuses, tolerances } from './support.mjs';

const kw = await load();
const { sin, cos, exp, PI } = Math;
const curveOf = (given) => kw.curve({ type: 'formula-curve', x: 't', y: 't', domain: [0, 1], ...given });

test('a formula curve is the model of the same formula, with its derivatives', () => {
    const model = kw.curve({ type: 'parametric-curve', name: 'torus-knot', parameters: { p: 2, q: 3, R: 2, r: 1 } });
    const curve = curveOf({
        x: '(R+r*cos(q*t))*cos(p*t)', y: '(R+r*cos(q*t))*sin(p*t)', z: 'r*sin(q*t)',
        parameters: { p: 2, q: 3, R: 2, r: 1 }, domain: [0, 2 * PI], closed: true,
    });
    assert.deepEqual([curve.closed, curve.dimension, curve.domain], [true, 3, [0, 2 * PI]]);
    for (const t of [0, 0.7, 3, 2 * PI, 7]) {
        const rows = curve.derivatives(t, 4);
        model.derivatives(t, 4).forEach((row, k) => near(rows[k], row, 1e-10, `order ${k} at ${t}`));
    }
    near(curve.sample(100), model.sample(100), tolerances.rounding);
    near(curve.length(), model.length(), 1e-10);
});

test('a formula curve reads back as what it was made from, and makes it again', () => {
    const { spec } = curveOf({ x: 'a*t', parameters: { a: 2 } });
    assert.deepEqual(spec, {
        type: 'formula-curve', x: 'a*t', y: 't', parameters: { a: 2 }, domain: [0, 1], closed: false,
    });
    assert.deepEqual(kw.curve(spec).sample(10), kw.curve(spec).sample(10));
    assert.deepEqual(curveOf({ z: '0' }).spec.z, '0');
});

test('the language is that of the interface', () => {
    const valueAt3 = (x) => curveOf({ x, y: '0', domain: [2, 4] }).point(3)[0];
    const meanings = {
        '-t^2': -9, '2^-1': 0.5, '2^3^2/100': 5.12, '2*-t': -6, '8/4/2': 1, '1e-3+.5': 0.501,
        'abs(-t)': 3, 'log(e^t)': 3, 'atan(tan(t/3))': 1, 'asin(sin(t/3))': 1, 'acos(cos(t))': 3,
        'sinh(t)^2-cosh(t)^2': -1, 'tanh(0)+sqrt(t+1)': 2, 'cos(pi*t)': -1,
    };
    for (const [text, expected] of Object.entries(meanings)) near(valueAt3(text), expected, 1e-12, text);
});

test('wrong formulas are refused with field and column', () => {
    const message = (act) => {
        try {
            act();
        } catch (error) {
            return error.message;
        }
        return '';
    };
    refuses(() => curveOf({ x: '2*' }), 'SYNTAX', 'x');
    assert.match(message(() => curveOf({ x: '2*' })), /column 3/);
    refuses(() => curveOf({ y: 't+a' }), 'UNKNOWN_NAME', 'y');
    refuses(() => curveOf({ z: 'constructor(t)' }), 'UNKNOWN_NAME', 'z');
    refuses(() => curveOf({ x: '1/t' }), 'NOT_FINITE', 'x');
    refuses(() => curveOf({ x: 1 }), 'WRONG_TYPE', 'x');
    refuses(() => curveOf({ domain: undefined }), 'WRONG_TYPE', 'domain');
    refuses(() => curveOf({ closed: true }), 'OUT_OF_RANGE', 'closed');
    refuses(() => curveOf({ parameters: { pi: 3 } }), 'OUT_OF_RANGE', 'parameters.pi');
    refuses(() => curveOf({ parameters: { a: NaN } }), 'NOT_FINITE', 'parameters.a');
    refuses(() => curveOf({ x: '('.repeat(100_000) }), 'TOO_LARGE', 'x');
    refuses(() => curveOf({ x: `${'t^'.repeat(4000)}t` }), 'TOO_LARGE', 'x');
    refuses(() => curveOf({ x: 't\0' }), 'SYNTAX', 'x');
    near(curveOf({ x: `${'('.repeat(4999)}t${')'.repeat(4999)}` }).point(0.5), [0.5, 0.5, 0], 0);
});

test('formulas are locals and models of blending curves', () => {
    const model = { type: 'formula-curve', x: 'cos(t)', y: 'sin(t)', domain: [0, 2 * PI], closed: true };
    const bFunction = { family: 'formula', expression: '1/(1+exp(1/t-1/(1-t)))' };
    const blend = kw.curve({ type: 'blending-curve', bFunction, model, locals: { count: 5 } });
    assert.equal(blend.closed, true);
    near(blend.point(1), [cos(1), sin(1), 0], tolerances.rounding);
    const open = kw.curve({
        type: 'blending-curve', bFunction: { family: 'linear' },
        locals: [{ ...model, closed: false }, { type: 'line-curve', from: [0, 0], to: [1, 1] }],
    });
    assert.ok(open.sample(5).every(Number.isFinite));
});

test('a B-function that is typed has the orders and the symmetry of its formula', () => {
    const typed = (expression) => kw.bFunction({ family: 'formula', expression });
    const cases = [
        ['t', [0, 0], true], ['sin(pi*t/2)^2', [1, 1], true], ['t^3*(10-15*t+6*t^2)', [2, 2], true],
        ['t^3', [2, 0], false], ['1/(1+exp(1/t-1/(1-t)))', [Infinity, Infinity], true],
    ];
    for (const [expression, order, symmetric] of cases) {
        const b = typed(expression);
        assert.deepEqual([b.order, b.symmetric], [order, symmetric], expression);
        assert.deepEqual([b.value(0), b.value(1)], [0, 1]);
        assert.deepEqual(b.spec, { family: 'formula', expression });
    }
    const b = typed('1/(1+exp(1/t-1/(1-t)))');
    near(b.value(0.3), 1 / (1 + exp(1 / 0.3 - 1 / 0.7)), tolerances.exact);
    near(b.derivatives(0.3, 3), kw.bFunction({ family: 'logistic' }).derivatives(0.3, 3), 1e-11);
    assert.ok(kw.bFunctions.some(({ family }) => family === 'formula'));
});

test('the axioms are a checklist for whatever is typed', () => {
    const article = kw.axioms({ family: 'formula', expression: 'sin(pi*t)^2' });
    assert.deepEqual(article.map(({ axiom }) => axiom), ['D1', 'D2', 'D3', 'D4', 'D5']);
    assert.deepEqual(article.map(({ holds }) => holds), [false, true, false, false, false]);
    assert.equal(article[2].text, 'Not so: B(1) = 0.');
    assert.match(article[0].text, /takes values twice/);
    near(article[2].t, 1, 0);
    near(article[4].found, 2 * sin(PI * article[4].t) ** 2, tolerances.exact);
    const right = kw.axioms({ family: 'formula', expression: 'sin(pi*t/2)^2' });
    assert.ok(right.every(({ holds, text, statement }) => holds && text === `${statement}.`));
    for (const { family } of kw.bFunctions) {
        if (!['tabulated', 'formula', 'dual', 'symmetrised', 'composed', 'mixed'].includes(family)) {
            assert.ok(kw.axioms({ family }).every(({ holds }) => holds), family);
        }
    }
    assert.deepEqual(kw.axioms({ family: 'polynomial', p: 1, q: 3 }).map(({ holds }) => holds),
        [true, true, true, true, false]);
    refuses(() => kw.axioms({ family: 'formula', expression: 't+' }), 'SYNTAX', 'expression');
    refuses(() => kw.axioms({ family: 'formula' }), 'WRONG_TYPE', 'expression');
    refuses(() => kw.axioms('t'), 'WRONG_TYPE', '');
});

test('what is no B-function is refused with the axiom that it breaks', () => {
    const typed = (expression) => kw.bFunction({ family: 'formula', expression });
    refuses(() => typed('sin(pi*t)^2'), 'OUT_OF_RANGE', 'expression');
    assert.throws(() => typed('sin(pi*t)^2'), /B\(1\) must be 1 \(axiom D3\)/);
    refuses(() => typed('1-t'), 'OUT_OF_RANGE', 'expression');
    refuses(() => typed('t+sin(2*pi*t)/4'), 'OUT_OF_RANGE', 'expression');
    refuses(() => typed('t+'), 'SYNTAX', 'expression');
    refuses(() => typed(7), 'WRONG_TYPE', 'expression');
    refuses(() => kw.bFunction({ family: 'formula' }), 'WRONG_TYPE', 'expression');
    refuses(() => kw.bFunction({ family: 'dual', of: { family: 'formula', expression: '2*t' } }), 'OUT_OF_RANGE', 'of.expression');
});
