// Bulk results: uniform samples, samples at parameters, polylines, and arrays of the caller's.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { load, near, randomness, refuses, tolerances } from './support.mjs';

const kw = await load();
const random = randomness(21);

const curves = {
    'a clamped cubic': { type: 'bspline-curve', degree: 3, points: random.points(20, 2) },
    'a closed quintic in space': { type: 'bspline-curve', degree: 5, form: 'closed', points: random.points(11, 3) },
    'an open spline of degree 12': { type: 'bspline-curve', degree: 12, form: 'open', points: random.points(20, 3) },
    'a rational curve': { type: 'bspline-curve', degree: 2, points: random.points(6, 2), weights: [1, 2, 0.5, 1, 3, 1] },
    'the butterfly': { type: 'parametric-curve', name: 'butterfly' },
    'a closed blending curve': {
        type: 'blending-curve', bFunction: { family: 'expo-rational' },
        model: { type: 'parametric-curve', name: 'rose' }, locals: { count: 9 },
        poses: [{ local: 2, translate: [0.3, 0.1] }, { local: 5, rotate: { axis: [1, 0, 0], angle: 0.4 } }],
    },
};

const pointOf = (samples, i) => Array.from(samples.subarray(3 * i, 3 * i + 3));
const parameter = ([start, end], i, count) => start + ((end - start) * i) / (count - 1);

for (const [name, spec] of Object.entries(curves)) {
    test(`${name}: uniform samples are its points`, () => {
        const curve = kw.curve(spec);
        const count = 2500;
        const samples = curve.sample(count);
        assert.ok(samples instanceof Float64Array);
        assert.equal(samples.length, 3 * count);
        for (let i = 0; i < count; i += 7) {
            near(pointOf(samples, i), curve.point(parameter(curve.domain, i, count)), tolerances.sampled * 10, `sample ${i}`);
        }
        near(pointOf(samples, 0), curve.point(curve.domain[0]), tolerances.exact);
        near(pointOf(samples, count - 1), curve.point(curve.domain[1]), tolerances.exact);
    });

    test(`${name}: samples at parameters are its points and derivatives`, () => {
        const curve = kw.curve(spec);
        const ts = Array.from({ length: 1500 }, () => random.between(...curve.domain));
        const all = curve.sampleAt(ts, { derivatives: 2 });
        assert.equal(all.length, 9 * ts.length);
        for (let i = 0; i < ts.length; i += 11) {
            const expected = curve.derivatives(ts[i], 2);
            for (let k = 0; k <= 2; ++k) {
                const scale = 1 + Math.hypot(...expected[k]);
                near(pointOf(all, ts.length * k + i), expected[k], 1e-11 * scale, `order ${k} at ${ts[i]}`);
            }
        }
        near(curve.sampleAt(ts), all.subarray(0, 3 * ts.length), tolerances.sampled * 10);
    });

    test(`${name}: its polyline stays within the tolerance`, () => {
        const curve = kw.curve(spec);
        for (const tolerance of [0.1, 1e-3]) {
            const { points, parameters } = curve.polyline({ tolerance });
            assert.ok(points instanceof Float64Array);
            assert.equal(points.length, 3 * parameters.length);
            assert.deepEqual([parameters[0], parameters.at(-1)], curve.domain);
            let worst = 0;
            for (let i = 1; i < parameters.length; ++i) {
                assert.ok(parameters[i] >= parameters[i - 1]);
                for (const part of [0.25, 0.5, 0.75]) {
                    const t = parameters[i - 1] + part * (parameters[i] - parameters[i - 1]);
                    worst = Math.max(worst, distance(curve.point(t), pointOf(points, i - 1), pointOf(points, i)));
                }
            }
            assert.ok(worst <= tolerance * (1 + 1e-9), `${worst} is more than ${tolerance}`);
        }
        const counts = [0.1, 0.01, 0.001].map((tolerance) => curve.polyline({ tolerance }).parameters.length);
        assert.ok(counts[0] <= counts[1] && counts[1] < counts[2], `${counts}`);
    });
}

/** From a point to a chord. */
function distance(point, from, to) {
    const along = to.map((x, c) => x - from[c]);
    const offset = point.map((x, c) => x - from[c]);
    const square = along.reduce((sum, x) => sum + x * x, 0);
    const s = square > 0 ? Math.min(1, Math.max(0, along.reduce((sum, x, c) => sum + x * offset[c], 0) / square)) : 0;
    return Math.hypot(...offset.map((x, c) => x - s * along[c]));
}

const cubic = kw.curve(curves['a clamped cubic']);

test('the array that is given is filled and returned', () => {
    const into = new Float64Array(3000).fill(NaN);
    assert.equal(cubic.sample(1000, { into }), into);
    assert.deepEqual(into, cubic.sample(1000));
    const rows = new Float64Array(60);
    assert.equal(cubic.sampleAt(Float64Array.of(0, 1, 2, 3, 4, 5, 6, 7, 8, 9), { into: rows, derivatives: 1 }), rows);
    assert.deepEqual(rows, cubic.sampleAt([0, 1, 2, 3, 4, 5, 6, 7, 8, 9], { derivatives: 1 }));
});

test('an array of another length or type is refused and left alone', () => {
    const into = new Float64Array(3001).fill(7);
    refuses(() => cubic.sample(1000, { into }), 'WRONG_LENGTH', 'into');
    refuses(() => cubic.sample(1000, { into: new Float64Array(2999) }), 'WRONG_LENGTH', 'into');
    refuses(() => cubic.sampleAt([0, 1], { into: new Float64Array(5) }), 'WRONG_LENGTH', 'into');
    assert.ok(into.every((value) => value === 7));
    for (const wrong of [new Float32Array(3000), Array(3000).fill(0), new ArrayBuffer(24000), null, {}, 5]) {
        refuses(() => cubic.sample(1000, { into: wrong }), 'WRONG_TYPE', 'into');
    }
});

test('what comes back is a copy that no later call changes', () => {
    const first = cubic.sample(10);
    const kept = first.slice();
    kw.curve(curves['the butterfly']).sample(5000);
    kw.scene(kw.scenes[0].document).drawing();
    assert.deepEqual(first, kept);
    assert.ok(first.buffer.byteLength === 240, 'no view of a larger memory');
    const { points } = cubic.polyline();
    assert.equal(points.buffer.byteLength, points.byteLength);
});

test('few samples, and counts that make no sense', () => {
    near(cubic.sample(1), cubic.point(cubic.domain[0]), 0);
    near(cubic.sample(2), [...cubic.point(cubic.domain[0]), ...cubic.point(cubic.domain[1])], tolerances.exact);
    assert.equal(cubic.sampleAt([]).length, 0);
    refuses(() => cubic.sample(0), 'OUT_OF_RANGE', 'count');
    refuses(() => cubic.sample(-3), 'OUT_OF_RANGE', 'count');
    refuses(() => cubic.sample(2.5), 'NOT_INTEGER', 'count');
    refuses(() => cubic.sample(NaN), 'NOT_FINITE', 'count');
    refuses(() => cubic.sample('10'), 'WRONG_TYPE', 'count');
    refuses(() => cubic.sample(), 'WRONG_TYPE', 'count');
    refuses(() => cubic.sample(2 ** 40), 'TOO_LARGE', 'count');
});

test('parameters are checked one by one', () => {
    const [, end] = cubic.domain;
    refuses(() => cubic.sampleAt([0, 1, end + 1e-6]), 'OUT_OF_RANGE', 'ts[2]');
    refuses(() => cubic.sampleAt([...Array(1100).fill(1), -1]), 'OUT_OF_RANGE', 'ts[1100]');
    refuses(() => cubic.sampleAt([0, NaN]), 'NOT_FINITE', 'ts[1]');
    refuses(() => cubic.sampleAt(Float64Array.of(0, Infinity)), 'NOT_FINITE', 'ts[1]');
    refuses(() => cubic.sampleAt(['0']), 'WRONG_TYPE', 'ts[0]');
    refuses(() => cubic.sampleAt([0, null]), 'WRONG_TYPE', 'ts[1]');
    refuses(() => cubic.sampleAt(5), 'WRONG_TYPE', 'ts');
    refuses(() => cubic.sampleAt(new Float32Array(3)), 'WRONG_TYPE', 'ts');
    refuses(() => cubic.sampleAt([0], { derivatives: 26 }), 'OUT_OF_RANGE', 'derivatives');
    refuses(() => cubic.sampleAt([0], { derivatives: 0.5 }), 'NOT_INTEGER', 'derivatives');
});

test('a closed curve wraps the parameters it is given', () => {
    const closed = kw.curve(curves['a closed quintic in space']);
    const [start, end] = closed.domain;
    near(closed.sampleAt([start - 1, end + 2.5]), [...closed.point(end - 1), ...closed.point(start + 2.5)], 1e-12);
});

test('tolerances are positive numbers', () => {
    refuses(() => cubic.polyline({ tolerance: 0 }), 'OUT_OF_RANGE', 'tolerance');
    refuses(() => cubic.polyline({ tolerance: -1 }), 'OUT_OF_RANGE', 'tolerance');
    refuses(() => cubic.polyline({ tolerance: NaN }), 'NOT_FINITE', 'tolerance');
    refuses(() => cubic.polyline({ tolerance: '1' }), 'WRONG_TYPE', 'tolerance');
    refuses(() => cubic.polyline({ precision: 1 }), 'UNKNOWN_FIELD', 'precision');
});

test('active basis functions are the ones of basis() that are not zero, each at its place', () => {
    for (const form of ['clamped', 'open', 'closed']) {
        const curve = kw.curve({ type: 'bspline-curve', degree: 3, form, points: random.points(12, 2) });
        const ts = Array.from({ length: 900 }, () => random.between(...curve.domain)).concat(curve.domain, curve.knots.slice(3, 9));
        const { values, first } = curve.basisAt(ts);
        assert.equal(values.length, 4 * ts.length);
        for (let i = 0; i < ts.length; i += ts.length - i > 20 ? 13 : 1) {
            const row = new Array(12).fill(0);
            for (let j = 0; j < 4; ++j) row[(first[i] + j) % 12] = values[4 * i + j];
            near(row, curve.basis(ts[i])[0], tolerances.partition, `at ${ts[i]}`);
        }
    }
});

test('active basis functions fill an earlier answer, and only one that fits', () => {
    const curve = kw.curve({ type: 'bspline-curve', degree: 2, points: random.points(6, 2) });
    const into = curve.basisAt([0, 1]);
    assert.equal(curve.basisAt([2, 3], { into }), into);
    near(Array.from(into.values.subarray(0, 3)), curve.basis(2)[0].filter((_, i) => i >= into.first[0] && i < into.first[0] + 3), 1e-15);
    refuses(() => curve.basisAt([0, 1, 2], { into }), 'WRONG_LENGTH', 'into.first');
    refuses(() => curve.basisAt([0, 1], { into: { first: into.first } }), 'WRONG_TYPE', 'into');
    refuses(() => curve.basisAt([0, 1], { into: { values: into.values, first: [0, 0] } }), 'WRONG_TYPE', 'into.first');
    refuses(() => curve.basisAt([0, 9]), 'OUT_OF_RANGE', 'ts[1]');
    refuses(() => curve.basisAt([0, 'x']), 'WRONG_TYPE', 'ts[1]');
});
