// Part 3 of the interface: refinement, removal, elevation, pieces, matrices, hodographs, splitting.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { fractions, inSpace, load, near, randomKnots, randomness, refuses, tolerances, truth } from './support.mjs';

const kw = await load();
const make = (fields) => kw.curve({ type: 'bspline-curve', ...fields });
const row = (count) => Array.from({ length: count }, (_, i) => [i, i % 2]);

const quadratic = () => make({
    degree: 2, knots: fractions(truth.quad_curve.knots), points: fractions(truth.quad_curve.ctrl),
});

/** Random curves of every form, half of them rational. */
function eachRandom(seed, times, act) {
    const random = randomness(seed);
    for (let i = 0; i < times; ++i) {
        const degree = random.integer(1, 5);
        const count = random.integer(degree + 2, degree + 9);
        const form = ['clamped', 'open', 'closed'][i % 3];
        const points = random.points(count, 3);
        const fields = { degree, form, points };
        if (form === 'clamped') fields.knots = randomKnots(random, degree, count);
        if (i % 2) fields.weights = points.map(() => random.between(0.5, 2));
        act(make(fields), { random, degree, form, fields });
    }
}

/** Some more knots inside, sorted in. */
function refined(curve, random, more) {
    const [start, end] = curve.domain;
    const added = Array.from({ length: more }, () => random.between(start, end));
    return [...curve.knots, ...added].sort((a, b) => a - b);
}

test('refinement by both algorithms keeps the curve', () => {
    eachRandom(1, 60, (curve, { random }) => {
        const knots = refined(curve, random, 7);
        const oslo = curve.refine(knots);
        assert.deepEqual(oslo.knots, knots);
        near(oslo.sample(60), curve.sample(60), tolerances.refinement);
        const boehm = curve.refine(Float64Array.from(knots), { algorithm: 'boehm' });
        near(boehm.spec.points, oslo.spec.points, 2e-14);
        assert.deepEqual(curve.refine(knots, { algorithm: 'oslo' }).spec, oslo.spec);
    });
});

test('the refined quadratic and its matrix are those of the truth', () => {
    const { to, alpha, ctrl } = truth.oslo_quad;
    const curve = quadratic();
    near(curve.osloMatrix(fractions(to)), fractions(alpha), tolerances.exact);
    near(curve.refine(fractions(to)).spec.points, fractions(ctrl), tolerances.exact);
});

test('rows of the matrix are not negative, sum to one and give the refined points', () => {
    eachRandom(2, 30, (curve, { random, fields }) => {
        if (fields.weights) return;
        const knots = refined(curve, random, 5);
        const matrix = curve.osloMatrix(knots);
        const points = curve.refine(knots).spec.points;
        assert.equal(matrix.length, points.length);
        matrix.forEach((weights, j) => {
            assert.equal(weights.length, fields.points.length);
            assert.ok(weights.every((weight) => weight >= 0));
            near(weights.reduce((sum, weight) => sum + weight, 0), 1, tolerances.partition);
            const point = [0, 1, 2].map((c) => weights.reduce((sum, w, i) => sum + w * fields.points[i][c], 0));
            near(points[j], point, 2e-14);
        });
    });
});

test('what is no refinement is refused with its place', () => {
    const curve = make({ degree: 2, points: row(5) });
    const { knots } = curve;
    refuses(() => curve.refine(knots.slice(1)), 'KNOTS_COUNT', 'knots');
    refuses(() => curve.refine([]), 'KNOTS_COUNT', 'knots');
    refuses(() => curve.refine([0, 0, 0, 1.5, 2, 3, 3, 3]), 'KNOTS_MULTIPLICITY', 'knots[3]');
    refuses(() => curve.refine([0, 0, 0, 2, 1, 3, 3, 3]), 'KNOTS_DECREASING', 'knots[4]');
    refuses(() => curve.refine([0, 0, 0, 1, NaN, 2, 3, 3, 3]), 'NOT_FINITE', 'knots[4]');
    refuses(() => curve.refine([0, 0, 0, '1', 2, 3, 3, 3]), 'WRONG_TYPE', 'knots[3]');
    refuses(() => curve.refine(), 'WRONG_TYPE', 'knots');
    refuses(() => curve.refine(new Float64Array(2 ** 20)), 'TOO_LARGE', 'knots');
    refuses(() => curve.refine(knots, { algorithm: 'Oslo' }), 'UNKNOWN_NAME', 'algorithm');
    refuses(() => curve.refine(knots, { by: 'oslo' }), 'UNKNOWN_FIELD', 'by');
    refuses(() => curve.osloMatrix([0, 0, 0, 3, 3, 3]), 'KNOTS_COUNT', 'knots');
    refuses(() => curve.osloMatrix('knots'), 'WRONG_TYPE', 'knots');
});

test('a matrix of too many numbers is refused', () => {
    const curve = make({ degree: 1, points: row(3000) });
    refuses(() => curve.osloMatrix(curve.knots), 'TOO_LARGE', 'knots');
});

test('removing an inserted knot gives the curve back', () => {
    eachRandom(3, 60, (curve, { random }) => {
        const t = random.between(...curve.domain);
        const { curve: back, deviation, removed } = curve.insertKnot(t).removeKnot(t);
        assert.equal(removed, true);
        assert.ok(deviation <= 1e-12);
        assert.deepEqual(back.knots, curve.knots);
        near(back.sample(40), curve.sample(40), 5e-13);
    });
});

test('beyond the tolerance the curve stays, and the deviation says how far it would have moved', () => {
    const curve = make({ degree: 3, points: row(7) });
    const kept = curve.removeKnot(2);
    assert.equal(kept.removed, false);
    assert.deepEqual(kept.curve.spec, curve.spec);
    const gone = curve.removeKnot(2, { tolerance: kept.deviation });
    assert.equal(gone.removed, true);
    assert.equal(gone.curve.knots.filter((knot) => knot === 2).length, 0);
    const [before, after] = [curve.sample(1001), gone.curve.sample(1001)];
    let moved = 0;
    for (let i = 0; i < before.length; i += 3) {
        moved = Math.max(moved, Math.hypot(before[i] - after[i], before[i + 1] - after[i + 1]));
    }
    assert.ok(moved <= gone.deviation && gone.deviation <= 1.05 * moved, `${moved} of ${gone.deviation}`);
    refuses(() => curve.removeKnot(0.5), 'OUT_OF_RANGE', 't');
    refuses(() => curve.removeKnot(0), 'OUT_OF_RANGE', 't');
    refuses(() => curve.removeKnot('1'), 'WRONG_TYPE', 't');
    refuses(() => curve.removeKnot(1, { tolerance: -1 }), 'OUT_OF_RANGE', 'tolerance');
    refuses(() => curve.removeKnot(1, { tolerance: NaN }), 'NOT_FINITE', 'tolerance');
    refuses(() => curve.removeKnot(1, { epsilon: 1 }), 'UNKNOWN_FIELD', 'epsilon');
});

test('the elevated quadratic is that of the truth, and elevation keeps every curve', () => {
    const cubic = quadratic().elevateDegree();
    assert.deepEqual(cubic.knots, fractions(truth.degree_elev.to_knots));
    near(cubic.spec.points, fractions(truth.degree_elev.ctrl), tolerances.exact);
    eachRandom(4, 30, (curve, { degree }) => {
        const raised = curve.elevateDegree(2);
        assert.equal(raised.spec.degree, degree + 2);
        assert.deepEqual(raised.domain, curve.domain);
        near(raised.sample(50), curve.sample(50), 1e-13);
    });
    refuses(() => quadratic().elevateDegree(0), 'OUT_OF_RANGE', 'by');
    refuses(() => quadratic().elevateDegree(1.5), 'NOT_INTEGER', 'by');
    refuses(() => quadratic().elevateDegree(24), 'TOO_LARGE', 'by');
    refuses(() => quadratic().elevateDegree(100), 'TOO_LARGE', 'by');
});

test('Bézier pieces are curves on their own intervals', () => {
    eachRandom(5, 30, (curve, { fields }) => {
        const pieces = curve.bezierPieces();
        assert.equal(pieces[0].domain[0], curve.domain[0]);
        assert.equal(pieces.at(-1).domain[1], curve.domain[1]);
        for (const piece of pieces) {
            assert.equal(piece.type, 'bezier-curve');
            assert.equal('weights' in piece, 'weights' in fields);
            const bezier = kw.curve(piece);
            for (const w of [0, 0.3, 0.9]) {
                const t = piece.domain[0] + w * (piece.domain[1] - piece.domain[0]);
                near(bezier.point(t), curve.point(t), tolerances.refinement);
            }
        }
    });
});

test('factor matrices multiply to the point', () => {
    eachRandom(6, 30, (curve, { random, degree, fields }) => {
        if (fields.weights || curve.closed) return;
        const t = random.between(...curve.domain);
        const matrices = curve.factorMatrices(t);
        assert.equal(matrices.length, degree);
        matrices.forEach((matrix, k) => {
            assert.equal(matrix.length, k + 1);
            matrix.forEach((weights) => assert.equal(weights.length, k + 2));
        });
        const first = curve.knots.findLastIndex((knot, i) => knot <= t && i < fields.points.length) - degree;
        const product = matrices.reduceRight(
            (vector, matrix) => matrix.map((weights) => [0, 1, 2].map(
                (c) => weights.reduce((sum, w, i) => sum + w * vector[i][c], 0))),
            fields.points.slice(first, first + degree + 1));
        near(product[0], curve.point(t), tolerances.refinement);
    });
    refuses(() => quadratic().factorMatrices(5), 'OUT_OF_RANGE', 't');
    refuses(() => quadratic().factorMatrices(), 'WRONG_TYPE', 't');
});

test('the hodograph is the derivative from both sides of every knot', () => {
    eachRandom(7, 40, (curve, { random }) => {
        const derivative = curve.derivativeCurve();
        assert.deepEqual(derivative.domain, curve.domain);
        const [start, end] = curve.domain;
        for (const t of [...curve.knots.filter((knot) => start < knot && knot < end), random.between(start, end)]) {
            for (const side of ['left', 'right']) {
                const expected = curve.derivatives(t, 1, { side })[1];
                near(derivative.derivatives(t, 0, { side })[0], expected, 1e-11 * Math.max(1, ...expected.map(Math.abs)));
            }
        }
    });
});

test('the halves of a split curve meet where it was split', () => {
    eachRandom(8, 40, (curve, { random, form }) => {
        const [start, end] = curve.domain;
        const t = random.between(start, end);
        const parts = curve.split(t);
        if (form === 'closed') {
            assert.equal(parts.length, 1);
            assert.equal(parts[0].spec.form, 'clamped');
            assert.equal(parts[0].domain[0], t);
            near(parts[0].point(parts[0].domain[0]), curve.point(t), tolerances.refinement);
            near(parts[0].point(parts[0].domain[1]), curve.point(t), tolerances.refinement);
            return;
        }
        assert.deepEqual(parts.map((part) => part.domain), [[start, t], [t, end]]);
        near(parts[0].point(t), parts[1].point(t), tolerances.refinement);
        near(parts[0].point((start + t) / 2), curve.point((start + t) / 2), tolerances.refinement);
        near(parts[1].point((end + t) / 2), curve.point((end + t) / 2), tolerances.refinement);
    });
    refuses(() => quadratic().split(0), 'OUT_OF_RANGE', 't');
    refuses(() => quadratic().split(4), 'OUT_OF_RANGE', 't');
});

test('a reversed curve runs through the same points, and twice reversed it is the curve', () => {
    eachRandom(9, 40, (curve, { random }) => {
        const [start, end] = curve.domain;
        const back = curve.reversed();
        for (const t of [start, end, random.between(start, end)]) {
            near(back.point(start + (end - t)), curve.point(t), 1e-12);
        }
        near(back.reversed().spec.points, curve.spec.points, 0);
        near(back.reversed().knots, curve.knots, 1e-14);
    });
    near(inSpace(quadratic().reversed().spec.points[0]), [6, 2, 0], 0);
});

test('knots of a scene come and go with their points', () => {
    const scene = kw.scene({ knotwork: 1, objects: [{ type: 'bspline-curve', degree: 3, points: row(6) }] });
    scene.execute({ insert: 'objects[0].knots', value: 1.5 });
    assert.equal(scene.document.objects[0].points.length, 7);
    scene.execute({ remove: 'objects[0].knots[5]' });
    near(scene.document.objects[0].points, row(6), 1e-13);
    refuses(() => scene.execute({ remove: 'objects[0].knots[0]' }), 'OUT_OF_RANGE', 'objects[0].knots[0]');
});
