// Subdivided polygons and subdivision curves through the delivered module.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { fractions, inSpace, load, near, randomness, refuses, tolerances, truth } from './support.mjs';

const kw = await load();
const square = [[0, 0], [1, 0], [1, 1], [0, 1]];
const ring = (count) => Array.from({ length: count }, (_, i) =>
    [Math.cos((2 * Math.PI * i) / count), Math.sin((2 * Math.PI * i) / count), (i * i) % 3]);
const triples = (numbers) => Array.from({ length: numbers.length / 3 }, (_, i) => Array.from(numbers.subarray(3 * i, 3 * i + 3)));
const close = (found, expected, tolerance) => near(Array.from(found), Array.from(expected), tolerance);

test('Lane–Riesenfeld subdivision of the square is the truth, without a shift', () => {
    for (const [key, texts] of Object.entries(truth.LR)) {
        const [degree, levels] = key.match(/\d+/g).map(Number);
        const found = kw.subdivide({ scheme: 'lane-riesenfeld', degree, points: square, closed: true, levels });
        assert.deepEqual(triples(found), fractions(texts).slice(0, -1).map(inSpace));
    }
});

test('the four-point scheme on the square is the truth', () => {
    const found = kw.subdivide({ scheme: 'four-point', points: square, closed: true, levels: 1 });
    assert.deepEqual(triples(found), fractions(truth.fourpoint_sq.k1).map(inSpace));
});

test('polygons have exactly as many points as is promised', () => {
    for (const levels of [0, 1, 3, 6, 7, 11]) {
        const count = (spec) => kw.subdivide({ levels, ...spec }).length / 3;
        for (const points of [square, ring(7)]) {
            for (const scheme of ['lane-riesenfeld', 'chaikin', 'four-point']) {
                assert.equal(count({ scheme, points, closed: true }), 2 ** levels * points.length);
            }
        }
        let [cubic, quadratic, fourPoint] = [7, 7, 7];
        for (let i = 0; i < levels; ++i) [cubic, quadratic, fourPoint] = [2 * cubic - 3, 2 * quadratic - 2, 2 * fourPoint - 1];
        assert.equal(count({ scheme: 'lane-riesenfeld', degree: 3, points: ring(7) }), cubic);
        assert.equal(count({ scheme: 'chaikin', points: ring(7) }), quadratic);
        assert.equal(count({ scheme: 'four-point', points: ring(7) }), fourPoint);
    }
});

/** Doubling and averaging, written out. */
function doubledAndAveraged(points, degree, levels) {
    let p = points;
    for (let level = 0; level < levels; ++level) {
        const n = p.length;
        const middle = (list, i) => list[i].map((x, axis) => (x + list[(i + 1) % list.length][axis]) / 2);
        p = Array.from({ length: 2 * n }, (_, i) => (i % 2 === 0 ? p[i / 2] : middle(p, (i - 1) / 2)));
        for (let pass = 1; pass < degree; ++pass) p = p.map((_, i) => middle(p, i));
    }
    return p;
}

test('blocks join: many levels equal doubling and averaging, written out', () => {
    const points = ring(11);
    for (const degree of [1, 2, 3, 4, 9]) {
        const found = kw.subdivide({ scheme: 'lane-riesenfeld', degree, points, closed: true, levels: 9 });
        close(found, doubledAndAveraged(points, degree, 9).flat(), tolerances.refinement);
    }
});

test('defaults are degree 3, tension 1/16, open and 4 levels; the type may be named', () => {
    const points = ring(9);
    assert.deepEqual(kw.subdivide({ scheme: 'lane-riesenfeld', points }),
        kw.subdivide({ type: 'subdivision-curve', scheme: 'lane-riesenfeld', degree: 3, points, closed: false, levels: 4 }));
    assert.deepEqual(kw.subdivide({ scheme: 'four-point', points }),
        kw.subdivide({ scheme: 'four-point', tension: 1 / 16, points: Float64Array.from(points.flat()), closed: false, levels: 4 }));
});

test('into is filled and returned, from the fields or beside them', () => {
    const spec = { scheme: 'chaikin', points: square, closed: true, levels: 10 };
    const fresh = kw.subdivide(spec);
    for (const act of [(into) => kw.subdivide({ ...spec, into }), (into) => kw.subdivide(spec, { into })]) {
        const into = new Float64Array(fresh.length);
        assert.equal(act(into), into);
        assert.deepEqual(into, fresh);
        refuses(() => act(new Float64Array(3)), 'WRONG_LENGTH', 'into');
        refuses(() => act([]), 'WRONG_TYPE', 'into');
    }
});

test('1.6 million points take no more memory the second time, and none afterwards', () => {
    const random = randomness(5);
    const spec = { scheme: 'lane-riesenfeld', degree: 3, points: random.points(100, 3), closed: true, levels: 14 };
    const into = new Float64Array(3 * 100 * 2 ** 14);
    const act = () => kw.subdivide({ ...spec, into });
    act();
    const bytes = kw.session.memoryInUse();
    act();
    assert.equal(kw.session.memoryInUse(), bytes);
    const coarse = kw.subdivide({ ...spec, levels: 13 });
    const at = (xyz, i) => triples(xyz.subarray(3 * i, 3 * i + 3))[0];
    for (const i of [0, 1, 77_777, 819_197]) {
        near(at(into, 2 * i), at(coarse, i).map((x, axis) => (x + at(coarse, i + 1)[axis]) / 2), tolerances.exact);
    }
});

test('a subdivision curve has the domain, the points and the slopes of its polygon', () => {
    const spec = { type: 'subdivision-curve', scheme: 'chaikin', points: square, closed: true, levels: 1 };
    const curve = kw.curve(spec);
    assert.deepEqual([curve.domain, curve.closed, curve.dimension], [[0, 4], true, 2]);
    assert.deepEqual(curve.point(0.25), [0.75, 0, 0]);
    assert.deepEqual(curve.point(4.25), [0.75, 0, 0]);
    assert.deepEqual(curve.derivatives(0.25, 2), [[0.75, 0, 0], [0.5, 0.5, 0], [0, 0, 0]]);
    assert.deepEqual(curve.derivatives(0.25, 1, { side: 'left' }), [[0.75, 0, 0], [1, 0, 0]]);
    assert.deepEqual(curve.spec, spec);
    assert.equal(curve.polyline({ tolerance: 1e-9 }).parameters.length, 10);
    near(triples(curve.sample(17))[1], curve.point(0.25), tolerances.exact);
    refuses(() => kw.curve({ ...spec, closed: false }).point(1.9), 'OUT_OF_RANGE', 't');
});

test('a subdivision curve comes to the B-spline of its degree at the same parameters', () => {
    for (const [form, closed] of [['closed', true], ['open', false]]) {
        for (const degree of [2, 3, 5]) {
            const points = ring(9);
            const spline = kw.curve({ type: 'bspline-curve', degree, form, points }).sample(200);
            const deviation = (levels) => {
                const curve = kw.curve({ type: 'subdivision-curve', scheme: 'lane-riesenfeld', degree, points, closed, levels });
                assert.deepEqual(curve.domain, closed ? [0, 9] : [degree, 9]);
                return Math.max(...curve.sample(200).map((x, i) => Math.abs(x - spline[i])));
            };
            assert.ok(deviation(10) < 3e-6);
        }
    }
});

test('limits of cubics, of Chaikin and of the four-point scheme have their stencils', () => {
    const points = ring(8);
    const stencil = (weights, i) => [0, 1, 2].map((axis) =>
        weights.reduce((sum, weight, k) => sum + weight * points[(i + k - 2 + 8) % 8][axis], 0));
    for (const [spec, limit, tangent] of [
        [{ scheme: 'lane-riesenfeld' }, [0, 1 / 6, 4 / 6, 1 / 6, 0], [0, -0.5, 0, 0.5, 0]],
        [{ scheme: 'chaikin' }, [0, 1 / 8, 6 / 8, 1 / 8, 0], [0, -0.5, 0, 0.5, 0]],
        [{ scheme: 'four-point' }, [0, 0, 1, 0, 0], [1 / 12, -8 / 12, 0, 8 / 12, -1 / 12]],
    ]) {
        const curve = kw.curve({ type: 'subdivision-curve', points, closed: true, levels: 0, ...spec });
        const [limits, tangents] = [curve.limitPoints(), curve.limitTangents()];
        assert.ok(limits instanceof Float64Array && tangents instanceof Float64Array);
        close(limits, points.flatMap((_, i) => stencil(limit, i)), tolerances.exact);
        close(tangents, points.flatMap((_, i) => stencil(tangent, i)), tolerances.exact);
    }
});

test('limits with corners have no tangents', () => {
    const curve = (spec) => kw.curve({ type: 'subdivision-curve', points: square, closed: true, levels: 2, ...spec });
    refuses(() => curve({ scheme: 'four-point', tension: 0 }).limitTangents(), 'NOT_SUPPORTED', 'tension');
    refuses(() => curve({ scheme: 'four-point', tension: 0.2 }).limitTangents(), 'NOT_SUPPORTED', 'tension');
    refuses(() => curve({ scheme: 'lane-riesenfeld', degree: 1 }).limitTangents(), 'NOT_SUPPORTED', 'degree');
});

test('what cannot be subdivided is refused with its place, by kw.subdivide() and kw.curve() alike', () => {
    const good = { scheme: 'lane-riesenfeld', points: square, closed: true, levels: 2 };
    for (const act of [(spec) => kw.subdivide(spec), (spec) => kw.curve({ type: 'subdivision-curve', ...spec })]) {
        const no = (changed, code, path) => refuses(() => act({ ...good, ...changed }), code, path);
        no({ scheme: undefined }, 'WRONG_TYPE', 'scheme');
        no({ scheme: 'loop' }, 'UNKNOWN_NAME', 'scheme');
        no({ points: undefined }, 'WRONG_TYPE', 'points');
        no({ points: [] }, 'WRONG_LENGTH', 'points');
        no({ points: square.slice(2) }, 'WRONG_LENGTH', 'points');
        no({ points: square.slice(1), closed: false }, 'WRONG_LENGTH', 'points');
        no({ points: [[0, 0], [1, '1'], [2, 0]] }, 'WRONG_TYPE', 'points[1][1]');
        no({ points: [[0, 0], [1, NaN], [2, 0]] }, 'NOT_FINITE', 'points[1][1]');
        no({ points: [[0, 0], [1, 0], [2e12, 0]] }, 'OUT_OF_RANGE', 'points[2]');
        no({ points: new Float64Array(8) }, 'WRONG_LENGTH', 'points');
        no({ closed: 1 }, 'WRONG_TYPE', 'closed');
        no({ levels: '2' }, 'WRONG_TYPE', 'levels');
        no({ levels: 1.5 }, 'NOT_INTEGER', 'levels');
        no({ levels: -1 }, 'OUT_OF_RANGE', 'levels');
        no({ levels: 2 ** 32 + 5 }, 'TOO_LARGE', 'levels');
        no({ levels: 21 }, 'TOO_LARGE', 'levels');
        no({ degree: 0 }, 'OUT_OF_RANGE', 'degree');
        no({ degree: 26 }, 'TOO_LARGE', 'degree');
        no({ degree: null }, 'WRONG_TYPE', 'degree');
        no({ tension: 0.1 }, 'UNKNOWN_FIELD', 'tension');
        no({ scheme: 'chaikin', degree: 2 }, 'UNKNOWN_FIELD', 'degree');
        no({ scheme: 'four-point', tension: 2 }, 'OUT_OF_RANGE', 'tension');
        no({ scheme: 'four-point', tension: Infinity }, 'NOT_FINITE', 'tension');
        no({ weights: [1] }, 'UNKNOWN_FIELD', 'weights');
    }
    refuses(() => kw.subdivide({ ...good, type: 'bspline-curve' }), 'UNKNOWN_NAME', 'type');
    refuses(() => kw.subdivide({ ...good, type: 3 }), 'WRONG_TYPE', 'type');
    refuses(() => kw.subdivide(), 'WRONG_TYPE', '');
    refuses(() => kw.subdivide(good, { twice: true }), 'UNKNOWN_FIELD', 'twice');
    assert.ok(kw.subdivide({ ...good, levels: 20 }).length === 3 * 2 ** 22);
    refuses(() => kw.curve({ type: 'subdivision-curve', ...good, levels: 19 }), 'TOO_LARGE', 'levels');
});

test('a blending curve blends subdivision curves as its local curves', () => {
    const local = (points) => ({ type: 'subdivision-curve', scheme: 'lane-riesenfeld', points, levels: 5 });
    const locals = [0, 1, 2].map((j) => local(ring(6).map(([x, y, z]) => [x + j, y, z + j])));
    const blend = kw.curve({ type: 'blending-curve', bFunction: { family: 'expo-rational' }, fit: 'affine', locals });
    assert.deepEqual(blend.domain, [0, 2]);
    near(blend.point(1), kw.curve(locals[1]).point(4.5), tolerances.exact);
    near(blend.point(0), kw.curve(locals[0]).point(3), tolerances.exact);
    near(blend.point(2), kw.curve(locals[2]).point(6), tolerances.exact);
    assert.deepEqual(blend.spec.locals[1], { ...locals[1], closed: false, degree: 3 });
});

test('subdivision curves stand in scenes: drawn, edited and undone', () => {
    const scene = kw.scene({ knotwork: 1, objects: [{ type: 'subdivision-curve', scheme: 'lane-riesenfeld', points: square, closed: true }] });
    const [object] = scene.document.objects;
    assert.deepEqual([object.levels, object.degree], [4, 3]);
    const drawn = () => scene.drawing().shapes.find(({ role }) => role === 'curve').positions.length / 3;
    assert.equal(drawn(), 4 * 16 + 1);
    const { shapes } = scene.drawing();
    assert.equal(shapes.find(({ role }) => role === 'polygon').positions.length, 3 * 5);
    assert.equal(shapes.find(({ role }) => role === 'points').path, 'objects[0].points');
    scene.execute({ set: 'objects[0].levels', value: 5 });
    assert.equal(drawn(), 4 * 32 + 1);
    scene.execute({ set: 'objects[0].scheme', value: 'four-point' });
    assert.deepEqual([scene.document.objects[0].degree, scene.document.objects[0].tension], [undefined, 1 / 16]);
    scene.execute({ move: 'objects[0].points[2]', by: [1, 0] });
    assert.deepEqual(scene.document.objects[0].points[2], [2, 1]);
    scene.undo();
    scene.undo();
    assert.equal(scene.document.objects[0].degree, 3);
});
