// Part 2 of the interface: B-functions.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { load, near, randomness, refuses, tolerances } from './support.mjs';

const kw = await load();
const make = (spec) => kw.bFunction(spec);

/** One of every family, with its Hermite orders and whether it is symmetric. */
const families = [
    [{ family: 'linear' }, [0, 0], true],
    [{ family: 'trigonometric' }, [1, 1], true],
    [{ family: 'trigonometric', order: 4 }, [4, 4], true],
    [{ family: 'polynomial' }, [1, 1], true],
    [{ family: 'polynomial', p: 3, q: 2 }, [3, 2], false],
    [{ family: 'rational' }, [1, 1], true],
    [{ family: 'rational', m: 3, c: 2 }, [2, 2], false],
    [{ family: 'expo-rational' }, [Infinity, Infinity], true],
    [{ family: 'expo-rational', gamma: 2 }, [Infinity, Infinity], false],
    [{ family: 'logistic' }, [Infinity, Infinity], true],
    [{ family: 'dual', of: { family: 'polynomial', p: 3, q: 2 } }, [2, 3], false],
    [{ family: 'symmetrised', of: { family: 'polynomial', p: 3, q: 2 } }, [2, 2], true],
    [{ family: 'composed', outer: { family: 'polynomial' }, inner: { family: 'trigonometric' } }, [3, 3], true],
    [{ family: 'mixed', of: [{ family: 'linear' }, { family: 'logistic' }], weight: 0.25 }, [0, 0], true],
];

const named = families.map((row) => [JSON.stringify(row[0]), ...row]);

for (const [name, spec, order, symmetric] of named) {
    test(`${name} keeps the axioms`, () => {
        const b = make(spec);
        assert.equal(b.value(0), 0);
        assert.equal(b.value(1), 1);
        const values = b.sample(501);
        for (let i = 1; i < values.length; ++i) assert.ok(values[i] >= values[i - 1], `falls at ${i / 500}`);
    });

    test(`${name} knows its orders and its symmetry`, () => {
        const b = make(spec);
        assert.deepEqual(b.order, order);
        assert.equal(b.symmetric, symmetric);
        if (!symmetric) return;
        for (const t of [0.1, 0.37, 0.5]) near(b.value(t) + b.value(1 - t), 1, tolerances.expoRational);
    });

    test(`${name} has vanishing derivatives up to its order`, () => {
        const b = make(spec);
        for (const [end, t] of [[0, 0], [1, 1]]) {
            const vanishing = Math.min(order[end], 3);
            near(b.derivatives(t, 3).slice(1, vanishing + 1), Array(vanishing).fill(0), tolerances.exact);
            if (vanishing < 3) assert.notEqual(b.derivatives(t, 3)[vanishing + 1], 0);
        }
    });

    test(`${name} has derivatives that are the limits of differences`, () => {
        const b = make(spec);
        for (const t of [0.2, 0.45, 0.8]) {
            const h = 1e-4;
            const before = b.derivatives(t - h, 2);
            const after = b.derivatives(t + h, 2);
            const rows = b.derivatives(t, 3);
            const scale = 1 + Math.max(...rows.map(Math.abs)) * 1e3;
            for (let k = 0; k < 3; ++k) {
                near((after[k] - before[k]) / (2 * h), rows[k + 1], 2e-7 * scale, `order ${k + 1} at ${t}`);
            }
        }
    });

    test(`${name} reads back as a specification of the same function`, () => {
        const b = make(spec);
        const again = make(b.spec);
        assert.deepEqual(again.spec, b.spec);
        assert.deepEqual(again.sample(33), b.sample(33));
    });
}

test('defaults are filled in', () => {
    assert.deepEqual(make({ family: 'expo-rational' }).spec,
        { family: 'expo-rational', alpha: 1, beta: 1, gamma: 1, lambda: 0.5 });
    assert.deepEqual(make({ family: 'rational' }).spec, { family: 'rational', m: 2, c: 1 });
    assert.deepEqual(make({ family: 'polynomial' }).spec, { family: 'polynomial', p: 1, q: 1 });
    assert.deepEqual(make({ family: 'trigonometric' }).spec, { family: 'trigonometric', order: 1 });
    assert.deepEqual(make({ family: 'logistic' }).spec, { family: 'logistic', c: 1 });
});

test('the families are what their formulas say', () => {
    const random = randomness(11);
    for (let i = 0; i < 200; ++i) {
        const t = random.unit();
        near(make({ family: 'linear' }).value(t), t, 0);
        near(make({ family: 'trigonometric' }).value(t), Math.sin(Math.PI * t / 2) ** 2, tolerances.exact);
        near(make({ family: 'polynomial' }).value(t), 3 * t ** 2 - 2 * t ** 3, tolerances.exact);
        const m = random.between(1, 10);
        const c = random.between(0.1, 10);
        near(make({ family: 'rational', m, c }).value(t), t ** m / (t ** m + c * (1 - t) ** m), tolerances.exact);
        near(make({ family: 'logistic', c }).value(t), 1 / (1 + Math.exp(c * (1 / t - 1 / (1 - t)))), 1e-13);
    }
});

test('the algebra of B-functions is what its names say', () => {
    const of = { family: 'polynomial', p: 3, q: 1 };
    const other = { family: 'expo-rational', beta: 2 };
    const [b, second] = [make(of), make(other)];
    for (const t of [0, 0.15, 0.5, 0.8, 1]) {
        near(make({ family: 'dual', of }).value(t), 1 - b.value(1 - t), tolerances.exact);
        near(make({ family: 'symmetrised', of }).value(t), (b.value(t) + 1 - b.value(1 - t)) / 2, tolerances.exact);
        near(make({ family: 'composed', outer: of, inner: other }).value(t), b.value(second.value(t)), tolerances.exact);
        near(make({ family: 'mixed', of: [of, other], weight: 0.3 }).value(t), 0.3 * b.value(t) + 0.7 * second.value(t), tolerances.exact);
    }
});

test('a tabulated B-function passes through its samples and stays monotone', () => {
    const values = [0, 0, 0.1, 0.1, 0.9, 1];
    for (const given of [values, Float64Array.from(values)]) {
        const b = make({ family: 'tabulated', values: given });
        near(Array.from(values, (_, i) => b.value(i / 5)), values, tolerances.exact);
        const fine = b.sample(1001);
        for (let i = 1; i < fine.length; ++i) assert.ok(fine[i] >= fine[i - 1]);
        assert.deepEqual(b.spec.values, values);
    }
});

test('sample() agrees with value(), also beyond one block, and fills what it is given', () => {
    const b = make({ family: 'expo-rational' });
    const into = new Float64Array(2500);
    const samples = b.sample(2500, { into });
    assert.equal(samples, into);
    for (const i of [0, 1, 1023, 1024, 1025, 2048, 2499]) near(samples[i], b.value(i / 2499), tolerances.expoRational);
    assert.deepEqual(Array.from(b.sample(1)), [0]);
    assert.deepEqual(Array.from(b.sample(2)), [0, 1]);
});

test('kw.bFunctions lists the families with parameters that are their own defaults', () => {
    const listed = kw.bFunctions;
    const names = listed.map(({ family }) => family);
    for (const [{ family }] of families) assert.ok(names.includes(family), family);
    for (const { family, label, parameters, operands } of listed) {
        assert.ok(label.length > 0);
        if (operands.length > 0 || family === 'tabulated' || family === 'formula') continue;
        const spec = make({ family }).spec;
        for (const { name, label: words, min, max, default: usual } of parameters) {
            assert.equal(spec[name], usual);
            assert.ok(words.length > 0 && min <= usual && usual <= max);
        }
    }
});

test('ranges of parameters hold to the last number', () => {
    const allowed = [
        ['expo-rational', 'alpha', [1e-3, 4]], ['expo-rational', 'gamma', [1e-3, 4]],
        ['expo-rational', 'beta', [1e-3, 100]], ['expo-rational', 'lambda', [1e-3, 0.999]],
        ['rational', 'm', [1, 50]], ['rational', 'c', [1e-3, 1000]], ['logistic', 'c', [1e-3, 1000]],
        ['polynomial', 'p', [0, 20]], ['polynomial', 'q', [0, 20]], ['trigonometric', 'order', [1, 20]],
    ];
    const beyond = [
        ['expo-rational', 'alpha', [0, -1, 4.0000001]], ['expo-rational', 'gamma', [0, 4.1]],
        ['expo-rational', 'beta', [0, 100.1]], ['expo-rational', 'lambda', [0, 1]],
        ['rational', 'm', [0.999, 50.1]], ['rational', 'c', [0, 1001]], ['logistic', 'c', [0, 1000.1]],
        ['polynomial', 'p', [-1, 21]], ['polynomial', 'q', [-1, 21, 2 ** 32 + 5]], ['trigonometric', 'order', [0, 21]],
    ];
    for (const [family, name, values] of allowed) {
        for (const value of values) assert.equal(make({ family, [name]: value }).spec[name], value);
    }
    for (const [family, name, values] of beyond) {
        for (const value of values) refuses(() => make({ family, [name]: value }), 'OUT_OF_RANGE', name);
    }
    refuses(() => make({ family: 'polynomial', p: 1.5 }), 'NOT_INTEGER', 'p');
    refuses(() => make({ family: 'trigonometric', order: 2.000001 }), 'NOT_INTEGER', 'order');
});

test('refusals name the place, also in the depth of the algebra', () => {
    refuses(() => make({ family: 'sine' }), 'UNKNOWN_NAME', 'family');
    refuses(() => make({}), 'WRONG_TYPE', 'family');
    refuses(() => make({ family: 'linear', order: 1 }), 'UNKNOWN_FIELD', 'order');
    refuses(() => make({ family: 'logistic', c: NaN }), 'NOT_FINITE', 'c');
    refuses(() => make({ family: 'logistic', c: -Infinity }), 'NOT_FINITE', 'c');
    refuses(() => make({ family: 'logistic', c: '1' }), 'WRONG_TYPE', 'c');
    refuses(() => make({ family: 'logistic', c: null }), 'WRONG_TYPE', 'c');
    const deep = { family: 'composed', outer: { family: 'mixed', of: [{ family: 'linear' }, { family: 'logistic', c: 0 }] }, inner: { family: 'linear' } };
    refuses(() => make(deep), 'OUT_OF_RANGE', 'outer.of[1].c');
    refuses(() => make({ family: 'mixed', of: [{ family: 'linear' }] }), 'WRONG_LENGTH', 'of');
    refuses(() => make({ family: 'tabulated', values: [0, 0.6, 0.5, 1] }), 'OUT_OF_RANGE', 'values[2]');
    refuses(() => make({ family: 'tabulated', values: [0, NaN, 1] }), 'NOT_FINITE', 'values[1]');
    refuses(() => make({ family: 'tabulated', values: [0] }), 'WRONG_LENGTH', 'values');
    refuses(() => make({ family: 'tabulated', values: [0.1, 1] }), 'OUT_OF_RANGE', 'values[0]');
});

test('arguments outside their range are refused', () => {
    const b = make({ family: 'logistic' });
    refuses(() => b.value(-1e-9), 'OUT_OF_RANGE', 't');
    refuses(() => b.value(1.0000001), 'OUT_OF_RANGE', 't');
    refuses(() => b.derivatives(2, 1), 'OUT_OF_RANGE', 't');
    refuses(() => b.derivatives(0.5, -1), 'OUT_OF_RANGE', 'n');
    refuses(() => b.derivatives(0.5, 26), 'OUT_OF_RANGE', 'n');
    refuses(() => b.derivatives(0.5, 0.5), 'NOT_INTEGER', 'n');
    refuses(() => b.value(NaN), 'NOT_FINITE', 't');
    refuses(() => b.value('0.5'), 'WRONG_TYPE', 't');
    refuses(() => b.value(), 'WRONG_TYPE', 't');
    refuses(() => b.sample(0), 'OUT_OF_RANGE', 'count');
    refuses(() => b.sample(10, { into: new Float64Array(9) }), 'WRONG_LENGTH', 'into');
    refuses(() => b.sample(10, { into: new Float32Array(10) }), 'WRONG_TYPE', 'into');
});
