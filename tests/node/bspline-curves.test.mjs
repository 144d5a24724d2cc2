// Part 3 of the interface: B-spline curves.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { inSpace, load, near, randomKnots, randomness, refuses, tolerances } from './support.mjs';

const kw = await load();
const make = (fields) => kw.curve({ type: 'bspline-curve', ...fields });
const row = (count) => Array.from({ length: count }, (_, i) => [i, i % 2]);

/** Random clamped curves; each is passed with its own random numbers. */
function eachRandom(seed, times, act) {
    const random = randomness(seed);
    for (let i = 0; i < times; ++i) {
        const degree = random.integer(1, 7);
        const count = random.integer(degree + 1, degree + 12);
        const knots = randomKnots(random, degree, count);
        const points = random.points(count, 3);
        act(make({ degree, knots, points }), { random, degree, count, knots, points });
    }
}

const sumOf = (list) => list.reduce((sum, one) => sum + one, 0);

test('default knots are uniform with unit spans in all three forms', () => {
    const points = row(7);
    const clamped = make({ degree: 3, points });
    assert.deepEqual(clamped.knots, [0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4]);
    assert.deepEqual([clamped.domain, clamped.closed, clamped.dimension], [[0, 4], false, 2]);
    const open = make({ degree: 3, form: 'open', points });
    assert.deepEqual(open.knots, [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10]);
    assert.deepEqual([open.domain, open.closed], [[3, 7], false]);
    const closed = make({ degree: 3, form: 'closed', points });
    assert.deepEqual(closed.knots, [0, 1, 2, 3, 4, 5, 6, 7]);
    assert.deepEqual([closed.domain, closed.closed], [[0, 7], true]);
});

test('the specification reads back with its defaults, and makes the same curve', () => {
    const curve = make({ degree: 2, points: row(4) });
    assert.deepEqual(curve.spec, {
        type: 'bspline-curve', degree: 2, form: 'clamped', points: row(4), knots: [0, 0, 0, 1, 2, 2, 2],
    });
    eachRandom(1, 20, (one) => {
        const again = kw.curve(one.spec);
        assert.deepEqual(again.spec, one.spec);
        assert.deepEqual(again.sample(17), one.sample(17));
    });
});

test('flat Float64Arrays mean the same as lists', () => {
    const points = [[0, 0, 1], [1, 2, 3], [4, 1, 0], [5, 5, 5]];
    const knots = [0, 0, 0, 2, 3, 3, 3];
    const lists = make({ degree: 2, points, knots });
    const flat = make({ degree: 2, points: Float64Array.from(points.flat()), knots: Float64Array.from(knots) });
    assert.deepEqual(flat.spec, lists.spec);
    assert.deepEqual(flat.sample(11), lists.sample(11));
});

test('basis functions sum to one, are not negative and reproduce the curve', () => {
    eachRandom(2, 60, (curve, { random, points, degree }) => {
        const [start, end] = curve.domain;
        for (const t of [start, end, random.between(start, end), ...curve.knots]) {
            const [values] = curve.basis(t);
            near(sumOf(values), 1, tolerances.partition);
            assert.ok(values.every((value) => value >= 0));
            assert.ok(values.filter((value) => value !== 0).length <= degree + 1);
            const point = [0, 1, 2].map((c) => sumOf(values.map((value, i) => value * points[i][c])));
            near(curve.point(t), point, tolerances.refinement);
        }
    });
});

test('derivatives of the basis are the derivatives of the curve', () => {
    eachRandom(3, 30, (curve, { random, points }) => {
        const t = random.between(...curve.domain);
        const rows = curve.basis(t, { derivatives: 3 });
        assert.equal(rows.length, 4);
        const expected = curve.derivatives(t, 3);
        for (let k = 0; k <= 3; ++k) {
            const scale = Math.max(1, ...rows[k].map(Math.abs));
            const sum = [0, 1, 2].map((c) => sumOf(rows[k].map((value, i) => value * points[i][c])));
            near(sum, expected[k], tolerances.refinement * scale * 100);
        }
    });
});

test('derivatives are limits of differences', () => {
    eachRandom(4, 20, (curve, { random }) => {
        const [start, end] = curve.domain;
        const knots = new Set(curve.knots);
        const t = random.between(start + 0.1 * (end - start), end - 0.1 * (end - start));
        if ([...knots].some((knot) => Math.abs(knot - t) < 1e-3)) return;
        const h = 1e-5;
        const [before, at, after] = [t - h, t, t + h].map((s) => curve.derivatives(s, 3));
        for (let k = 0; k < 3; ++k) {
            const scale = 1 + Math.max(...at[Math.min(3, k + 1)].map(Math.abs), ...at[3].map(Math.abs)) * 10;
            near(after[k].map((x, c) => (x - before[k][c]) / (2 * h)), at[k + 1], 1e-6 * scale, `order ${k + 1}`);
        }
    });
});

test('a clamped curve begins and ends in its end points exactly', () => {
    eachRandom(5, 40, (curve, { points }) => {
        assert.deepEqual(curve.point(curve.domain[0]), points[0]);
        assert.deepEqual(curve.point(curve.domain[1]), points.at(-1));
    });
});

test('the side decides at a knot where the curve has a corner', () => {
    const curve = make({ degree: 1, points: [[0, 0], [1, 0], [1, 2]] });
    assert.deepEqual(curve.derivatives(1, 1)[1], [0, 2, 0]);
    assert.deepEqual(curve.derivatives(1, 1, { side: 'right' })[1], [0, 2, 0]);
    assert.deepEqual(curve.derivatives(1, 1, { side: 'left' })[1], [1, 0, 0]);
    assert.deepEqual(curve.derivatives(2, 1)[1], [0, 2, 0]);
    assert.deepEqual(curve.derivatives(2, 1, { side: 'right' })[1], [0, 2, 0]);
    assert.deepEqual(curve.derivatives(0, 1, { side: 'left' })[1], [1, 0, 0]);
});

test('the right end of a closed curve is approached from the left by default', () => {
    const curve = make({ degree: 1, form: 'closed', points: [[0, 0], [1, 0], [0, 1]] });
    const [, end] = curve.domain;
    assert.deepEqual(curve.derivatives(end, 1)[1], curve.derivatives(end, 1, { side: 'left' })[1]);
    assert.deepEqual(curve.derivatives(end, 1, { side: 'right' })[1], curve.derivatives(0, 1)[1]);
    assert.notDeepEqual(curve.derivatives(end, 1)[1], curve.derivatives(0, 1)[1]);
});

test('an interior knot of multiplicity degree + 1 is a gap with two sides', () => {
    const points = [[0, 0], [1, 1], [2, 0], [5, 5], [6, 6], [7, 5]];
    const curve = make({ degree: 2, points, knots: [0, 0, 0, 1, 1, 1, 2, 2, 2] });
    assert.deepEqual(curve.point(1), [5, 5, 0]);
    assert.deepEqual(curve.derivatives(1, 0, { side: 'left' }), [[2, 0, 0]]);
});

test('a closed curve wraps and an open one does not', () => {
    const closed = make({ degree: 3, form: 'closed', points: row(6) });
    near(closed.point(6.5), closed.point(0.5), tolerances.exact);
    near(closed.point(-0.25), closed.point(5.75), tolerances.exact);
    near(closed.point(600.5), closed.point(0.5), 1e-12);
    near(closed.point(6), closed.point(0), tolerances.exact);
    for (const form of ['open', 'clamped']) {
        const curve = make({ degree: 3, form, points: row(6) });
        const [start, end] = curve.domain;
        for (const t of [start - 1e-9, end + 1e-9]) {
            refuses(() => curve.point(t), 'OUT_OF_RANGE', 't');
            refuses(() => curve.derivatives(t, 1), 'OUT_OF_RANGE', 't');
            refuses(() => curve.basis(t), 'OUT_OF_RANGE', 't');
            refuses(() => curve.sampleAt([start, t]), 'OUT_OF_RANGE', 'ts[1]');
        }
    }
});

test('a closed curve of random knots is as smooth over its seam as its knots say', () => {
    const random = randomness(6);
    for (let i = 0; i < 20; ++i) {
        const degree = random.integer(2, 5);
        const count = random.integer(degree + 1, 12);
        const knots = [random.between(-2, 2)];
        while (knots.length <= count) knots.push(knots.at(-1) + random.between(0.2, 2));
        const curve = make({ degree, form: 'closed', points: random.points(count, 2), knots });
        const left = curve.derivatives(knots[count], degree - 1, { side: 'left' });
        const right = curve.derivatives(knots[0], degree - 1, { side: 'right' });
        left.forEach((derivative, k) => near(derivative, right[k], 1e-10 * 10 ** k, `order ${k}`));
        assert.deepEqual(curve.knots, knots);
    }
});

test('Greville abscissae are means of the knots', () => {
    const curve = make({ degree: 3, points: row(6) });
    near(curve.greville, [0, 1 / 3, 1, 2, 8 / 3, 3], tolerances.exact);
    const line = make({ degree: 3, points: curve.greville.map((t) => [t, 2 * t]) });
    for (const t of [0, 0.7, 1.9, 3]) near(line.point(t), [t, 2 * t, 0], tolerances.exact);
});

test('inserting a knot does not move the curve', () => {
    eachRandom(7, 60, (curve, { random, degree }) => {
        const t = random.between(...curve.domain);
        const times = random.integer(1, degree);
        const refined = curve.insertKnot(t, times);
        assert.equal(refined.knots.length, curve.knots.length + times);
        assert.equal(refined.knots.filter((knot) => knot === t).length, times);
        near(refined.sample(50), curve.sample(50), tolerances.refinement);
        near(refined.point(t), curve.point(t), tolerances.refinement);
    });
});

test('a knot of multiplicity degree puts a control point on the curve', () => {
    eachRandom(8, 30, (curve, { random, degree }) => {
        const t = random.between(...curve.domain);
        const on = inSpace(curve.point(t));
        const refined = curve.insertKnot(t, degree);
        const nearest = Math.min(...refined.spec.points.map((p) => Math.hypot(...p.map((x, c) => x - on[c]))));
        near(nearest, 0, tolerances.refinement);
    });
});

test('inserting a knot changes nothing in place', () => {
    const curve = make({ degree: 2, points: row(5) });
    const before = curve.spec;
    const refined = curve.insertKnot(0.5);
    curve.dispose();
    near(refined.point(0.5), kw.curve(before).point(0.5), tolerances.exact);
});

test('inserting a knot is refused where the curve has no room for it', () => {
    const curve = make({ degree: 2, points: row(5) });
    refuses(() => curve.insertKnot(4), 'OUT_OF_RANGE', 't');
    refuses(() => curve.insertKnot(-1), 'OUT_OF_RANGE', 't');
    refuses(() => curve.insertKnot(0.5, 0), 'OUT_OF_RANGE', 'times');
    refuses(() => curve.insertKnot(0.5, 1.5), 'NOT_INTEGER', 'times');
    refuses(() => curve.insertKnot(NaN), 'NOT_FINITE', 't');
    refuses(() => curve.insertKnot(0.5, 4), 'KNOTS_MULTIPLICITY', 't');
});

test('an affine map of the points is an affine map of the curve', () => {
    eachRandom(9, 20, (curve, { points, degree, knots }) => {
        const map = ([x, y, z]) => [2 * x - y + 1, x + z, 3 * z - y - 2];
        const mapped = make({ degree, knots, points: points.map(map) });
        const samples = curve.sample(20);
        const expected = Array.from({ length: 20 }, (_, i) => map(samples.slice(3 * i, 3 * i + 3))).flat();
        near(mapped.sample(20), expected, 1e-13);
    });
});

test('the dimension is 2 exactly where every z is 0', () => {
    assert.equal(make({ degree: 1, points: [[0, 0], [1, 1]] }).dimension, 2);
    assert.equal(make({ degree: 1, points: [[0, 0, 0], [1, 1, 0]] }).dimension, 2);
    assert.equal(make({ degree: 1, points: [[0, 0], [1, 1, 1e-300]] }).dimension, 3);
});

test('equal weights change nothing, and unequal ones make a circle', () => {
    const points = [[1, 0], [1, 1], [0, 1]];
    const plain = make({ degree: 2, points });
    near(make({ degree: 2, points, weights: [3, 3, 3] }).sample(9), plain.sample(9), tolerances.exact);
    const arc = make({ degree: 2, points, weights: [1, Math.SQRT1_2, 1] });
    const samples = arc.sample(101);
    for (let i = 0; i < 101; ++i) near(Math.hypot(samples[3 * i], samples[3 * i + 1]), 1, tolerances.exact);
    assert.deepEqual(arc.spec.weights, [1, Math.SQRT1_2, 1]);
});

const good = { degree: 2, points: row(4) };
for (const [name, fields, code, path] of [
    ['a degree of 0', { degree: 0 }, 'OUT_OF_RANGE', 'degree'],
    ['a degree that is no integer', { degree: 2.5 }, 'NOT_INTEGER', 'degree'],
    ['a degree as text', { degree: '2' }, 'WRONG_TYPE', 'degree'],
    ['a degree of null', { degree: null }, 'WRONG_TYPE', 'degree'],
    ['a degree beyond the limit', { degree: 26 }, 'TOO_LARGE', 'degree'],
    ['a degree beyond 32 bits', { degree: 2 ** 32 + 2 }, 'TOO_LARGE', 'degree'],
    ['a missing degree', { degree: undefined }, 'WRONG_TYPE', 'degree'],
    ['an unknown form', { form: 'periodic' }, 'UNKNOWN_NAME', 'form'],
    ['too few points', { points: row(2) }, 'WRONG_LENGTH', 'points'],
    ['no points at all', { points: [] }, 'WRONG_LENGTH', 'points'],
    ['a point of one number', { points: [[0, 0], [1], [2, 0]] }, 'WRONG_LENGTH', 'points[1]'],
    ['a point of four numbers', { points: [[0, 0], [1, 1, 1, 1], [2, 0]] }, 'WRONG_LENGTH', 'points[1]'],
    ['a NaN in a point', { points: [[0, 0], [1, NaN], [2, 0]] }, 'NOT_FINITE', 'points[1][1]'],
    ['infinity in a point', { points: [[0, 0], [1, 1], [-Infinity, 0]] }, 'NOT_FINITE', 'points[2][0]'],
    ['text in a point', { points: [[0, 0], ['1', 1], [2, 0]] }, 'WRONG_TYPE', 'points[1][0]'],
    ['a hole in a list', { points: [[0, 0], , [2, 0]] }, 'WRONG_TYPE', 'points[1]'],
    ['a flat list that is no triples', { points: new Float64Array(10) }, 'WRONG_LENGTH', 'points'],
    ['a NaN in a flat list', { points: Float64Array.of(0, 0, 0, 1, NaN, 0, 2, 0, 0) }, 'NOT_FINITE', undefined],
    ['single precision', { points: new Float32Array(9) }, 'WRONG_TYPE', 'points'],
    ['too few knots', { knots: [0, 0, 0, 1, 1, 1] }, 'KNOTS_COUNT', 'knots'],
    ['too many knots', { knots: [0, 0, 0, 1, 2, 2, 2, 2] }, 'KNOTS_COUNT', 'knots'],
    ['a knot that falls', { form: 'open', knots: [0, 1, 2, 3, 2.5, 5, 6] }, 'KNOTS_DECREASING', 'knots[4]'],
    ['a NaN among the knots', { knots: [0, 0, 0, NaN, 2, 2, 2] }, 'NOT_FINITE', 'knots[3]'],
    ['a knot too large', { form: 'open', knots: [0, 1, 2, 3, 4, 5, 1e10] }, 'OUT_OF_RANGE', 'knots[6]'],
    ['a domain of length zero', { form: 'open', knots: [0, 0, 1, 1, 1, 2, 3] }, 'OUT_OF_RANGE', 'knots'],
    ['weights that are too few', { weights: [1, 1] }, 'WRONG_LENGTH', 'weights'],
    ['a weight of zero', { weights: [1, 0, 1, 1] }, 'OUT_OF_RANGE', 'weights[1]'],
    ['a negative weight', { weights: [1, 1, 1, -1] }, 'OUT_OF_RANGE', 'weights[3]'],
    ['a field that is not known', { tension: 0.5 }, 'UNKNOWN_FIELD', 'tension'],
    ['a degree for a closed curve of too few points', { form: 'closed', points: row(2) }, 'WRONG_LENGTH', 'points'],
]) {
    test(`${name} is refused as ${code}`, () => {
        refuses(() => make({ ...good, ...fields }), code, path);
    });
}

test('too many equal knots are refused with their place', () => {
    const knots = [0, 0, 0, 1, 1, 1, 1, 2, 2, 2];
    refuses(() => make({ degree: 2, points: row(7), knots }), 'KNOTS_MULTIPLICITY', 'knots[6]');
});

test('an unknown type of curve is refused as such', () => {
    refuses(() => kw.curve({ type: 'spline' }), 'UNKNOWN_NAME', 'type');
    refuses(() => kw.curve({}), 'WRONG_TYPE', 'type');
    refuses(() => kw.curve({ type: 5 }), 'WRONG_TYPE', 'type');
});

test('the quick way and the careful way make the same curve', () => {
    eachRandom(10, 30, (curve, { degree, knots, points }) => {
        const careful = kw.curve({ id: 'c1', type: 'bspline-curve', degree, knots, points });
        assert.deepEqual(careful.sample(40), curve.sample(40));
        assert.deepEqual(careful.knots, curve.knots);
        assert.deepEqual(careful.spec, curve.spec);
    });
});
