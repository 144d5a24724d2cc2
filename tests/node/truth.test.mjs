// Numbers from outside this project: tests/truth/cases.json through the delivered module.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { fraction, fractions, inSpace, load, near, tolerances, truth } from './support.mjs';

const kw = await load();

/** Keys such as `dB(0.3)` or `(2,3) 1/3`, taken apart into numbers. */
const numbersIn = (key) => key.match(/-?[\d./]+/g).map(fraction);

test('the default expo-rational B-function has the published values and derivatives', () => {
    const erb = kw.bFunction({ family: 'expo-rational' });
    const known = truth.ERB_default;
    for (const [t, value] of Object.entries(known.B)) {
        near(erb.value(Number(t)), Number(value), tolerances.expoRational, `B(${t})`);
    }
    near(erb.derivatives(0.5, 1)[1], Number(known.S), tolerances.expoRational, 'S');
    near(erb.derivatives(0.3, 2).slice(1), [Number(known['dB(0.3)']), Number(known['d2B(0.3)'])], 1e-12);
    near(erb.derivatives(0.3, 3)[3], Number(known['d3B(0.3)']), 1e-11);
    near(erb.derivatives(0.5, 3)[3], Number(known['d3B(0.5)']), 1e-11);
});

test('the tail of the expo-rational B-function keeps nine digits', () => {
    const erb = kw.bFunction({ family: 'expo-rational' });
    const known = Number(truth.ERB_default.B['0.01']);
    near(erb.value(0.01) / known, 1, 1e-9);
});

test('the logistic B-function has the published values and derivatives', () => {
    const logistic = kw.bFunction({ family: 'logistic' });
    for (const [t, value] of Object.entries(truth.logistic.B)) {
        near(logistic.value(Number(t)) / Number(value), 1, 1e-13, `B(${t})`);
    }
    near(logistic.derivatives(0.25, 1)[1], Number(truth.logistic['dB(0.25)']), tolerances.exact);
    near(logistic.derivatives(0.25, 2)[2], Number(truth.logistic['d2B(0.25)']), 1e-12);
    near(logistic.derivatives(0.5, 1)[1], 2, tolerances.exact);
});

test('the polynomial B-functions are the exact fractions', () => {
    for (const [key, value] of Object.entries(truth.beta)) {
        const [p, q, t] = numbersIn(key);
        near(kw.bFunction({ family: 'polynomial', p, q }).value(t), fraction(value), tolerances.exact, key);
    }
});

test('the rational B-functions are the exact fractions', () => {
    for (const [key, value] of Object.entries(truth.rational)) {
        const [m, t] = numbersIn(key);
        near(kw.bFunction({ family: 'rational', m }).value(t), fraction(value), tolerances.exact, key);
    }
});

test('the trigonometric B-functions have the published values', () => {
    for (const [key, value] of Object.entries(truth.trig)) {
        const [order, t] = numbersIn(key);
        near(kw.bFunction({ family: 'trigonometric', order }).value(t), Number(value), tolerances.exact, key);
    }
});

const quadratic = () => kw.curve({
    type: 'bspline-curve', degree: truth.quad_curve.d,
    knots: fractions(truth.quad_curve.knots), points: fractions(truth.quad_curve.ctrl),
});

test('a clamped quadratic passes through the exact points', () => {
    const curve = quadratic();
    for (const [t, point] of Object.entries(truth.quad_curve.pts)) {
        near(curve.point(fraction(t)), inSpace(fractions(point)), tolerances.exact, `c(${t})`);
    }
    near(curve.derivatives(2, 1)[1], [4 / 3, -2 / 3, 0], tolerances.exact, "c'(2)");
});

test('inserting the knots of the Oslo case one by one gives its control points', () => {
    let curve = quadratic();
    for (const knot of [1 / 2, 1, 2, 7 / 2]) curve = curve.insertKnot(knot);
    near(curve.knots, fractions(truth.oslo_quad.to), 0);
    near(curve.spec.points, fractions(truth.oslo_quad.ctrl), tolerances.exact);
});

test('a closed uniform cubic passes through the exact points', () => {
    const points = fractions(truth.closed_cubic_uniform.ctrl);
    const curve = kw.curve({ type: 'bspline-curve', degree: 3, form: 'closed', points });
    assert.deepEqual(curve.domain, [0, 5]);
    for (const [t, point] of Object.entries(truth.closed_cubic_uniform.pts)) {
        near(curve.point(fraction(t)), inSpace(fractions(point)), tolerances.exact, `c(${t})`);
    }
});

test('basis functions and their derivatives on multiple knots are the exact fractions', () => {
    const { d, knots } = truth.bspline_basis;
    const points = Array.from({ length: knots.length - d - 1 }, (_, i) => [i, 0]);
    const curve = kw.curve({ type: 'bspline-curve', degree: d, knots: fractions(knots), points });
    const expected = [fractions(truth.bspline_basis['N(5/4)']), fractions(truth.bspline_basis['N1(5/4)'])];
    near(curve.basis(5 / 4, { derivatives: 1 }), expected, tolerances.exact);
});

test('Piegl and Tiller, examples 2.3 and 2.4: quadratic basis functions at 5/2', () => {
    const knots = [0, 0, 0, 1, 2, 3, 4, 4, 5, 5, 5];
    const points = Array.from({ length: 8 }, (_, i) => [i, i * i]);
    const rows = kw.curve({ type: 'bspline-curve', degree: 2, knots, points }).basis(5 / 2, { derivatives: 2 });
    const active = rows.map((row) => row.slice(2, 5));
    near(active, [[1 / 8, 3 / 4, 1 / 8], [-1 / 2, 0, 1 / 2], [1, -2, 1]], tolerances.exact);
});

test('Piegl and Tiller, example 5.1: inserting 5/2 into a cubic', () => {
    const points = [[0, 0], [1, 3], [3, 4], [5, 1], [6, -2], [8, 0], [9, 3], [11, 2]];
    const knots = [0, 0, 0, 0, 1, 2, 3, 4, 5, 5, 5, 5];
    const { points: refined } = kw.curve({ type: 'bspline-curve', degree: 3, knots, points }).insertKnot(5 / 2).spec;
    const mix = (s, i, j) => points[i].map((_, c) => (1 - s) * points[i][c] + s * points[j][c]);
    near(refined.slice(3, 6), [mix(5 / 6, 2, 3), mix(1 / 2, 3, 4), mix(1 / 6, 4, 5)], tolerances.exact);
});

/** c1 of the case is a circle of radius 2, turned by π/6 about its own origin and moved into place. */
function twoArcs(bFunction) {
    const angle = Math.PI / 6;
    const own = [2 * Math.cos(2), 2 * Math.sin(2)];
    const there = [1 + 2 * Math.cos(2 + angle), 2 * Math.sin(2 + angle)];
    return kw.curve({
        type: 'blending-curve', bFunction, form: 'open', knots: [0, 2],
        locals: [
            { type: 'parametric-curve', name: 'circle' },
            { type: 'parametric-curve', name: 'circle', parameters: { radius: 2 } },
        ],
        poses: [{ local: 1, rotate: { axis: [0, 0, 1], angle }, translate: [there[0] - own[0], there[1] - own[1]] }],
    });
}

for (const [name, bFunction] of [
    ['ERB', { family: 'expo-rational' }], ['poly1', { family: 'polynomial' }],
    ['logistic', { family: 'logistic' }], ['linear', { family: 'linear' }],
]) {
    test(`two posed arcs blended by ${name} have the published point and derivatives`, () => {
        const known = truth.blend_two_arcs[name];
        const rows = (Array.isArray(known[0]) ? known : [known]).map((row) => inSpace(row.map(Number)));
        near(twoArcs(bFunction).derivatives(0.7, rows.length - 1), rows, 1e-12);
    });
}

const angles = { 'pi/3': Math.PI / 3, '2pi': 2 * Math.PI, '6pi': 6 * Math.PI, '12pi': 12 * Math.PI };

test('the butterfly passes through the published points', () => {
    const curve = kw.curve({ type: 'parametric-curve', name: 'butterfly' });
    near(curve.domain, [0, 12 * Math.PI], tolerances.exact);
    for (const [key, point] of Object.entries(truth.butterfly)) {
        if (key.startsWith('length')) continue;
        near(curve.point(angles[key] ?? Number(key)), inSpace(point.map(Number)), tolerances.rounding, key);
    }
});

test('the rose with k = 4/3 passes through the published points and closes after 6π', () => {
    const curve = kw.curve({ type: 'parametric-curve', name: 'rose', parameters: { k: 4 / 3 } });
    near(curve.domain, [0, 6 * Math.PI], tolerances.exact);
    assert.equal(curve.closed, true);
    for (const [key, point] of Object.entries(truth.rose_4_3)) {
        near(curve.point(Number(key.slice(2))), inSpace(point.map(Number)), tolerances.rounding, key);
    }
});
