// Blending triangles through the public interface.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { load, near, refuses, tolerances } from './support.mjs';

const kw = await load();

const torus = { type: 'parametric-surface', name: 'torus', parameters: { R: 3, r: 1 } };
const plane = { type: 'parametric-surface', name: 'plane', parameters: { width: 2, height: 3 } };
const cone = { type: 'parametric-surface', name: 'cone' };
const spline = {
    type: 'bspline-surface', degree: [2, 3],
    points: [0, 1, 2, 3].map((i) => [0, 1, 2, 3].map((j) => [i, j, (i * i + 3 * j) % 4])),
};
const triangle = (fields) => kw.surface({ type: 'blending-triangle', locals: [torus, plane, spline], ...fields });
const kinds = [{ order: 1 }, { order: 2 }, { bFunction: { family: 'expo-rational' } }, { bFunction: { family: 'linear' } }];

/** The corners in u and v, and the place of the patch of each. */
const corners = [[0, 0.3], [1, 0], [1, 1]];
const cornerOf = (patch, k) => patch.point(patch.domain[0][k === 1 ? 1 : 0], patch.domain[1][k === 2 ? 1 : 0]);

test('it is a surface over the unit square, closed nowhere', () => {
    const surface = triangle();
    assert.deepEqual(surface.domain, [[0, 1], [0, 1]]);
    assert.deepEqual(surface.closed, [false, false]);
    refuses(() => surface.point(1.1, 0), 'OUT_OF_RANGE', 'u');
    refuses(() => surface.point(0, -0.1), 'OUT_OF_RANGE', 'v');
});

for (const fields of kinds) {
    test(`by ${JSON.stringify(fields)} each corner is that of its patch, and weights sum to one`, () => {
        const surface = triangle(fields);
        corners.forEach(([u, v], k) => {
            assert.deepEqual(surface.point(u, v), cornerOf(surface.local(k), k));
            const expected = [0, 0, 0];
            expected[k] = 1;
            assert.deepEqual(surface.weights(u, v), expected);
        });
        for (let i = 0; i <= 10; ++i) {
            for (let j = 0; j <= 10; ++j) {
                const weights = surface.weights(i / 10, j / 10);
                near([weights[0] + weights[1] + weights[2]], [1], tolerances.exact);
                assert.ok(weights.every((one) => one >= 0));
                const [x, y] = [i / 10 * (1 - j / 10), i / 10 * (j / 10)];
                const patches = [0, 1, 2].map((k) => surface.local(k));
                const points = patches.map((patch) => patch.point(...patch.domain.map(([from, to], axis) => Math.min(from + [x, y][axis] * (to - from), to))));
                const sum = [0, 1, 2].map((axis) => points.reduce((all, point, k) => all + weights[k] * point[axis], 0));
                near(surface.point(i / 10, j / 10), sum, tolerances.exact);
            }
        }
    });
}

test('in its corners it has the first derivatives, the normals and at order 2 the curvatures of its patches', () => {
    const surface = triangle({ order: 2 });
    corners.forEach(([u, v], k) => {
        const alone = triangle({ order: 2, locals: [surface.local(k).spec, surface.local(k).spec, surface.local(k).spec] });
        const [got, expected] = [surface.derivatives(u, v), alone.derivatives(u, v)];
        for (const row of Object.keys(got)) near(got[row], expected[row], 1e-12);
        const patch = surface.local(k);
        const place = [patch.domain[0][k === 1 ? 1 : 0], patch.domain[1][k === 2 ? 1 : 0]];
        near(surface.normal(u, v), patch.normal(...place), 1e-9);
        const [bends, own] = [surface.curvatures(u, v), patch.curvatures(...place)];
        near([bends.gaussian, bends.mean], [own.gaussian, own.mean], 1e-8);
    });
});

test('weights are the fractions of their formulas', () => {
    // (1/2, 1/4, 1/4) is at u = v = 1/2.
    assert.deepEqual(triangle().weights(0.5, 0.5), [19 / 32, 13 / 64, 13 / 64]);
    assert.deepEqual(triangle({ order: 2 }).weights(0.5, 0.5), [677 / 1024, 347 / 2048, 347 / 2048]);
    const cubic = triangle({ bFunction: { family: 'polynomial', p: 1, q: 1 } }).weights(0.5, 0.5);
    near(cubic, [8 / 13, 5 / 26, 5 / 26], tolerances.exact);
});

test('three times the same surface is that surface, over half of its rectangle', () => {
    for (const local of [torus, spline, cone]) {
        const [surface, alone] = [triangle({ locals: [local, local, local] }), kw.surface(local)];
        const [[u0, u1], [v0, v1]] = alone.domain;
        for (const [u, v] of [[0.2, 0.7], [1, 0.5], [0.5, 0.25], [0.8, 0]]) {
            const place = [u0 + u * (1 - v) * (u1 - u0), v0 + u * v * (v1 - v0)];
            near(surface.point(u, v), alone.point(...place), tolerances.exact);
            near(surface.normal(u, v), alone.normal(...place), 1e-12);
        }
    }
});

test('grids, triangles and isolines cover the triangle and nothing else', () => {
    const surface = triangle({ locals: [plane, plane, plane] });
    const inside = ([x, y]) => x >= 0 && y >= 0 && 3 * x + 2 * y <= 6 + 1e-12;
    const pointsOf = (xyz) => Array.from({ length: xyz.length / 3 }, (_, k) => [xyz[3 * k], xyz[3 * k + 1], xyz[3 * k + 2]]);
    const areaOf = (xyz, indices) => {
        const points = pointsOf(xyz);
        let area = 0;
        for (let k = 0; k < indices.length; k += 3) {
            const [p, q, r] = [points[indices[k]], points[indices[k + 1]], points[indices[k + 2]]];
            area += ((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])) / 2;
        }
        return area;
    };
    const grid = surface.grid(9, 7);
    assert.ok(pointsOf(grid.positions).every(inside));
    near([areaOf(grid.positions, grid.indices)], [3], 1e-12);
    assert.ok(pointsOf(grid.normals).every((normal) => normal[2] > 1 - 1e-12));
    const mesh = surface.triangles({ tolerance: 0.05 });
    near([areaOf(mesh.positions, mesh.indices)], [3], 1e-12);
    const pole = pointsOf(surface.isoline('v', 0, { count: 4 }));
    for (const point of pole) assert.deepEqual(point, [0, 0, 0]);
    const opposite = pointsOf(surface.isoline('v', 1, { count: 5 }));
    for (const [x, y] of opposite) near([3 * x + 2 * y], [6], 1e-12);
});

test('its specification is complete and makes it again', () => {
    const byOrder = triangle().spec;
    assert.deepEqual(Object.keys(byOrder), ['type', 'locals', 'order']);
    assert.equal(byOrder.order, 1);
    assert.equal(byOrder.locals[2].knots.length, 2);
    const byFunction = triangle({ bFunction: { family: 'expo-rational' } }).spec;
    assert.deepEqual(Object.keys(byFunction), ['type', 'locals', 'bFunction']);
    assert.equal(byFunction.bFunction.beta, 1);
    for (const spec of [byOrder, byFunction]) {
        const again = kw.surface(spec);
        assert.deepEqual(again.spec, spec);
        assert.deepEqual(again.grid(5, 5).positions, kw.surface(spec).grid(5, 5).positions);
    }
});

test('a local is a surface by itself that outlives the triangle', () => {
    const surface = triangle();
    const local = surface.local(2);
    assert.equal(local.constructor.name, kw.surface(spline).constructor.name);
    surface.dispose();
    refuses(() => surface.weights(0, 0), 'DISPOSED', '');
    assert.deepEqual(local.point(0, 0), kw.surface(spline).point(0, 0));
});

const nested = (depth) => depth === 0 ? plane : { type: 'blending-triangle', locals: [nested(depth - 1), plane, plane] };
const wide = (depth) => depth === 0 ? plane : { type: 'blending-triangle', locals: Array(3).fill(wide(depth - 1)) };

test('it nests 8 deep, and as a model of blending surfaces', () => {
    const deep = kw.surface(nested(8));
    assert.ok(deep.normal(0.4, 0.3).every(Number.isFinite));
    assert.ok(Number.isFinite(deep.curvatures(0.4, 0.3).mean));
    const copy = kw.surface({ type: 'blending-surface', bFunction: { family: 'linear' }, locals: [3, 3], model: triangle().spec });
    near(copy.point(0.3, 0.4), triangle().point(0.3, 0.4), tolerances.exact);
    const taylor = kw.surface({ type: 'blending-surface', bFunction: { family: 'linear' }, locals: [3, 3], kind: 'bezier', model: triangle().spec });
    near(taylor.point(0.5, 0.5), triangle().point(0.5, 0.5), tolerances.exact);
    refuses(() => kw.surface({ ...taylor.spec, degree: [13, 13] }), 'NOT_FINITE', 'model');
    refuses(() => kw.surface(nested(9)), 'TOO_LARGE', 'locals');
    refuses(() => kw.surface(wide(7)), 'TOO_LARGE', 'locals');
});

for (const [what, fields, code, path] of [
    ['no locals', { locals: undefined }, 'WRONG_TYPE', 'locals'],
    ['two locals', { locals: [plane, plane] }, 'WRONG_LENGTH', 'locals'],
    ['four locals', { locals: [plane, plane, plane, plane] }, 'WRONG_LENGTH', 'locals'],
    ['a number for a local', { locals: [plane, 3, plane] }, 'WRONG_TYPE', 'locals[1]'],
    ['a curve for a local', { locals: [plane, plane, { type: 'line-curve', from: [0, 0], to: [1, 1] }] }, 'UNKNOWN_NAME', 'locals[2].type'],
    ['a local with a fault', { locals: [{ ...plane, parameters: { width: 'a' } }, plane, plane] }, 'WRONG_TYPE', 'locals[0].parameters.width'],
    ['order 0', { order: 0 }, 'OUT_OF_RANGE', 'order'],
    ['order 3', { order: 3 }, 'OUT_OF_RANGE', 'order'],
    ['half an order', { order: 1.5 }, 'NOT_INTEGER', 'order'],
    ['an order and a B-function', { order: 1, bFunction: { family: 'linear' } }, 'NOT_SUPPORTED', 'order'],
    ['a B-function that vanishes in the middle', { bFunction: { family: 'logistic', c: 1000 } }, 'OUT_OF_RANGE', 'bFunction'],
    ['a B-function with a fault', { bFunction: { family: 'logistic', c: -1 } }, 'OUT_OF_RANGE', 'bFunction.c'],
    ['a field that it does not have', { degree: [1, 1] }, 'UNKNOWN_FIELD', 'degree'],
]) {
    test(`${what} is refused with ${code} at ${path}`, () => {
        const spec = { type: 'blending-triangle', locals: [plane, plane, plane], ...fields };
        if (spec.locals === undefined) delete spec.locals;
        refuses(() => kw.surface(spec), code, path);
    });
}

test('corners and places are checked', () => {
    const surface = triangle();
    refuses(() => surface.local(3), 'OUT_OF_RANGE', 'corner');
    refuses(() => surface.local(0.5), 'NOT_INTEGER', 'corner');
    refuses(() => surface.weights(2, 0), 'OUT_OF_RANGE', 'u');
    refuses(() => surface.weights(0, NaN), 'NOT_FINITE', 'v');
});
