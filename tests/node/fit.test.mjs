// Curves through and near points, and spheres around them.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { fractions, inSpace, load, near, randomness, refuses, tolerances, truth } from './support.mjs';

const kw = await load();
const forms = ['clamped', 'open', 'closed'];

/** Points as the flat array that crosses fastest. */
const flat = (points) => Float64Array.from(points.flatMap(inSpace));

test('the published interpolation comes out with its exact knots and control points', () => {
    const points = [[0, 0], [3, 4], [-1, 4], [-4, 0], [-4, -3]];
    const { curve, parameters, residuals } = kw.interpolate({ points, degree: 3 });
    near(curve.knots, fractions(truth.interp_PT_9_1.knots), tolerances.exact);
    near(curve.spec.points, fractions(truth.interp_PT_9_1.ctrl), tolerances.exact);
    near(parameters, [0, 5 / 17, 9 / 17, 14 / 17, 1], tolerances.exact);
    assert.ok(parameters instanceof Float64Array);
    near(residuals.max, 0, tolerances.exact);
});

for (const form of forms) {
    test(`a fit gives back the ${form} spline that its points come from`, () => {
        const random = randomness(7);
        const spline = kw.curve({ type: 'bspline-curve', degree: 3, form, points: random.points(12, 3) });
        const [start, end] = spline.domain;
        const ts = Array.from({ length: 500 }, (_, k) => start + (end - start) * (k / 500));
        const points = spline.sampleAt(ts);
        const fit = kw.fit({ points, degree: 3, count: 12, form, parameters: ts, knots: spline.knots });
        near(fit.curve.spec.points, spline.spec.points, 1e-12);
        near(fit.residuals.max, 0, tolerances.sampled);
        assert.deepEqual(Array.from(fit.parameters), ts);
        assert.equal(fit.curve.closed, form === 'closed');
    });

    test(`the ${form} curve through points passes through them at its parameters`, () => {
        const random = randomness(8);
        for (const parameters of ['chord', 'centripetal', 'uniform']) {
            for (const degree of [1, 2, 3, 5]) {
                const points = random.points(10, 3);
                const fit = kw.interpolate({ points, degree, form, parameters });
                near(fit.curve.sampleAt(fit.parameters), flat(points), 1e-11, `${parameters} ${degree}`);
                assert.equal(fit.parameters[0], 0);
                assert.equal(fit.parameters.at(-1) === 1, form !== 'closed');
            }
        }
    });
}

test('points one by one and as a flat array give the same fit, bit for bit', () => {
    const random = randomness(9);
    for (const dimension of [2, 3]) {
        const points = random.points(100, dimension);
        const request = { degree: 3, count: 12, parameters: 'centripetal', smoothing: 1e-3 };
        const one = kw.fit({ ...request, points });
        const other = kw.fit({ ...request, points: flat(points) });
        assert.deepEqual(one.curve.spec, other.curve.spec);
        assert.deepEqual(one.parameters, other.parameters);
        assert.deepEqual(one.residuals, other.residuals);
        assert.equal(one.curve.dimension, dimension);
    }
});

test('long lists give the same fit wherever they stand among the fields', () => {
    const random = randomness(10);
    const points = random.points(1500, 3);
    const parameters = Float64Array.from({ length: 1500 }, (_, k) => k / 1499);
    const request = { degree: 3, count: 12, smoothing: 1e-3 };
    const slow = kw.fit({ ...request, points, parameters: Array.from(parameters) });
    const long = { points: flat(points), parameters };
    // Fields of different sizes before the lists move them through all places in a word of memory.
    for (const form of ['clamped', 'open', 'closed']) {
        const usual = kw.fit({ ...request, form, points, parameters: Array.from(parameters) });
        for (const first of [{ form }, { degree: 3, form }, { interpolateEnds: false, form }]) {
            const fit = kw.fit({ ...first, ...long, ...request });
            assert.deepEqual(fit.curve.spec, usual.curve.spec);
            assert.deepEqual(fit.residuals, usual.residuals);
            assert.deepEqual(fit.parameters, parameters);
        }
    }
    const fit = kw.fit({ ...request, ...long });
    kw.fit({ ...request, points: flat(points).map((x) => -x), parameters: parameters.map((u) => u / 2) });
    assert.deepEqual(fit.parameters, slow.parameters);
});

test('parameters that were given come back as they are, and as numbers where they are a list', () => {
    const points = randomness(10).points(40, 3);
    const given = Float64Array.from({ length: 40 }, (_, k) => k / 39);
    for (const make of [(parameters) => kw.fit({ points, degree: 3, count: 8, parameters }),
        (parameters) => kw.interpolate({ points, degree: 3, parameters })]) {
        assert.equal(make(given).parameters, given);
        assert.deepEqual(make(Array.from(given)).parameters, given);
    }
});

test('the residuals are those of the curve', () => {
    const points = randomness(10).points(2000, 3);
    const { curve, parameters, residuals } = kw.fit({ points, degree: 3, count: 30 });
    const at = curve.sampleAt(parameters);
    const distances = points.map(([x, y, z], k) => Math.hypot(at[3 * k] - x, at[3 * k + 1] - y, at[3 * k + 2] - z));
    const sum = distances.reduce((total, distance) => total + distance ** 2, 0);
    near(residuals.sumOfSquares, sum, 1e-10);
    near(residuals.rms, Math.sqrt(sum / points.length), 1e-13);
    near(residuals.max, Math.max(...distances), 1e-13);
});

test('the ends are met exactly where that is asked for', () => {
    const points = randomness(11).points(50, 2);
    const loose = kw.fit({ points, degree: 3, count: 8 }).curve;
    const held = kw.fit({ points, degree: 3, count: 8, interpolateEnds: true }).curve;
    assert.deepEqual(held.point(0), inSpace(points[0]));
    assert.deepEqual(held.point(1), inSpace(points[49]));
    assert.notDeepEqual(loose.point(0), inSpace(points[0]));
});

test('more smoothing leaves larger residuals', () => {
    const points = randomness(12).points(60, 3);
    const sums = [0, 0.01, 1, 100].map((smoothing) =>
        kw.fit({ points, degree: 3, count: 20, smoothing }).residuals.sumOfSquares);
    for (let i = 1; i < sums.length; ++i) assert.ok(sums[i] > sums[i - 1]);
});

test('too little data is refused with the control point that starves', () => {
    const points = Array.from({ length: 40 }, (_, k) => [k, k % 3]);
    const parameters = points.map((_, k) => (k < 20 ? k / 100 : 1 - (39 - k) / 100));
    refuses(() => kw.fit({ points, parameters, degree: 3, count: 12 }), 'RANK_DEFICIENT', 'controlPoints[5]');
    refuses(() => kw.fit({ points: [[0, 0], [1, 0], [2, 1]], degree: 2, count: 5 }), 'RANK_DEFICIENT');
    assert.ok(kw.fit({ points, parameters, degree: 3, count: 12, smoothing: 1e-6 }).curve);
});

test('what cannot be fitted is refused with the place of the fault', () => {
    const points = [[0, 0], [1, 0], [2, 1], [3, 1], [4, 0]];
    const good = { points, degree: 2, count: 4 };
    const refused = [
        [undefined, 'WRONG_TYPE', ''],
        [{ degree: 2, count: 4 }, 'WRONG_TYPE', 'points'],
        [{ points, count: 4 }, 'WRONG_TYPE', 'degree'],
        [{ points, degree: 2 }, 'WRONG_TYPE', 'count'],
        [{ ...good, points: [] }, 'WRONG_LENGTH', 'points'],
        [{ ...good, points: [[0, 0], [1, '2']] }, 'WRONG_TYPE', 'points[1][1]'],
        [{ ...good, points: [[0, 0], [1, NaN]] }, 'NOT_FINITE', 'points[1][1]'],
        [{ ...good, points: new Float64Array(7) }, 'WRONG_LENGTH', 'points'],
        [{ ...good, points: new Float64Array(15) }, 'OUT_OF_RANGE', 'points'],
        [{ ...good, points: Float64Array.of(0, 0, 0, 1, NaN, 0, 2, 2, 0, 3, 3, 0) }, 'NOT_FINITE', 'points[4]'],
        [{ ...good, degree: 2.5 }, 'NOT_INTEGER', 'degree'],
        [{ ...good, degree: 26 }, 'TOO_LARGE', 'degree'],
        [{ ...good, count: 2 }, 'OUT_OF_RANGE', 'count'],
        [{ ...good, count: 1e6 }, 'TOO_LARGE', 'count'],
        [{ ...good, form: 'round' }, 'UNKNOWN_NAME', 'form'],
        [{ ...good, parameters: 'arc' }, 'UNKNOWN_NAME', 'parameters'],
        [{ ...good, parameters: null }, 'WRONG_TYPE', 'parameters'],
        [{ ...good, parameters: [0, 1, 2] }, 'WRONG_LENGTH', 'parameters'],
        [{ ...good, parameters: [0, 1, 3, 2, 4] }, 'OUT_OF_RANGE', 'parameters[3]'],
        [{ ...good, parameters: [0, 1, 2, '3', 4] }, 'WRONG_TYPE', 'parameters[3]'],
        [{ ...good, parameters: [0, 1, Infinity, 3, 4] }, 'NOT_FINITE', 'parameters[2]'],
        [{ ...good, parameters: Float64Array.of(0, 1, NaN, 3, 4) }, 'NOT_FINITE', 'parameters[2]'],
        [{ ...good, knots: [] }, 'KNOTS_COUNT', 'knots'],
        [{ ...good, knots: [0, 0, 0, 1, 0.5, 1, 1] }, 'KNOTS_DECREASING', 'knots[4]'],
        [{ ...good, knots: [0, 0, 0, 0.2, 0.5, 0.5, 0.5] }, 'OUT_OF_RANGE', 'parameters[3]'],
        [{ ...good, interpolateEnds: 1 }, 'WRONG_TYPE', 'interpolateEnds'],
        [{ ...good, form: 'closed', interpolateEnds: true }, 'NOT_SUPPORTED', 'interpolateEnds'],
        [{ ...good, smoothing: -1 }, 'OUT_OF_RANGE', 'smoothing'],
        [{ ...good, smooth: 1 }, 'UNKNOWN_FIELD', 'smooth'],
    ];
    for (const [request, code, path] of refused) refuses(() => kw.fit(request), code, path);
    refuses(() => kw.interpolate({ points, degree: 5 }), 'WRONG_LENGTH', 'points');
    refuses(() => kw.interpolate({ points, degree: 2, count: 5 }), 'UNKNOWN_FIELD', 'count');
});

test('the sphere around points is the smallest one, and others are not much larger', () => {
    const random = randomness(13);
    const points = random.points(300, 3);
    const smallest = kw.enclosingSphere(points);
    for (const method of ['minimal', 'ritter', 'incremental']) {
        const { center, radius } = kw.enclosingSphere(flat(points), { method });
        for (const [x, y, z] of points) {
            assert.ok(Math.hypot(x - center[0], y - center[1], z - center[2]) <= radius * (1 + 1e-12));
        }
        assert.ok(radius >= smallest.radius * (1 - 1e-12) && radius <= 1.5 * smallest.radius);
    }
    near(kw.enclosingSphere([[-1, 0], [1, 0], [0, 0.5]]).center, [0, 0, 0], 0);
    near(kw.enclosingSphere([[-1, 0], [1, 0], [0, 0.5]]).radius, 1, 0);
});

test('a sphere around nothing, or around what is no point, is refused', () => {
    refuses(() => kw.enclosingSphere([]), 'WRONG_LENGTH', 'points');
    refuses(() => kw.enclosingSphere(undefined), 'WRONG_TYPE', 'points');
    refuses(() => kw.enclosingSphere([[0, 0], [NaN, 1]]), 'NOT_FINITE', 'points[1][0]');
    refuses(() => kw.enclosingSphere([[0, 0]], { method: 'welzl' }), 'UNKNOWN_NAME', 'method');
    refuses(() => kw.enclosingSphere([[0, 0]], { exact: true }), 'UNKNOWN_FIELD', 'exact');
});

test('fitting again and again leaves no memory behind', () => {
    const points = flat(randomness(14).points(1000, 3));
    const once = () => kw.fit({ points, degree: 3, count: 20 }).curve.dispose();
    for (let i = 0; i < 20; ++i) once();
    const before = kw.session.memoryInUse();
    for (let i = 0; i < 50; ++i) once();
    assert.equal(kw.session.memoryInUse(), before);
});
