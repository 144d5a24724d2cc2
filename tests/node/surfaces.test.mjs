// Surfaces through the public interface.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { load, near, refuses, tolerances } from './support.mjs';

const kw = await load();

const net = Array.from({ length: 5 }, (_, i) => Array.from({ length: 4 }, (_, j) => [i, j, Math.sin(i * j)]));
const bicubic = { type: 'bspline-surface', degree: [3, 2], points: net };
const weights = net.map((row) => row.map((_, j) => 1 + j / 4));
const model = (name, parameters) => kw.surface({ type: 'parametric-surface', name, ...parameters && { parameters } });

test('a B-spline surface has the domain, the ends and the corners of its forms', () => {
    const surface = kw.surface(bicubic);
    assert.deepEqual(surface.domain, [[0, 2], [0, 2]]);
    assert.deepEqual(surface.closed, [false, false]);
    assert.deepEqual(surface.point(0, 0), net[0][0]);
    assert.deepEqual(surface.point(2, 2), net[4][3]);
    assert.deepEqual(surface.point(2, 0), net[4][0]);
    const closed = kw.surface({ ...bicubic, form: ['closed', 'open'] });
    assert.deepEqual(closed.domain, [[0, 5], [2, 4]]);
    assert.deepEqual(closed.closed, [true, false]);
    assert.deepEqual(closed.point(5, 3), closed.point(0, 3));
});

test('a specification comes back complete and makes the same surface', () => {
    const surface = kw.surface({ ...bicubic, weights });
    const { spec } = surface;
    assert.deepEqual(Object.keys(spec), ['type', 'degree', 'form', 'points', 'knots', 'weights']);
    assert.deepEqual(spec.form, ['clamped', 'clamped']);
    assert.deepEqual(spec.knots, [[0, 0, 0, 0, 1, 2, 2, 2, 2], [0, 0, 0, 1, 2, 2, 2]]);
    assert.deepEqual(kw.surface(spec).derivatives(0.3, 1.2), surface.derivatives(0.3, 1.2));
    assert.deepEqual(model('torus').spec, { type: 'parametric-surface', name: 'torus', parameters: { R: 2, r: 1 } });
});

test('rows are lists of points or flat lists of triples', () => {
    const flat = net.map((row) => new Float64Array(row.flat()));
    assert.deepEqual(kw.surface({ ...bicubic, points: flat }).point(0.7, 0.9), kw.surface(bicubic).point(0.7, 0.9));
});

test('derivatives of the models are those of their formulas', () => {
    const [u, v] = [0.7, 0.4];
    const { S, Su, Sv, Suu, Suv, Svv } = model('torus').derivatives(u, v);
    const [cu, su, cv, sv] = [Math.cos(u), Math.sin(u), Math.cos(v), Math.sin(v)];
    near(S, [(2 + cv) * cu, (2 + cv) * su, sv], tolerances.exact);
    near(Su, [-(2 + cv) * su, (2 + cv) * cu, 0], tolerances.exact);
    near(Sv, [-sv * cu, -sv * su, cv], tolerances.exact);
    near(Suu, [-(2 + cv) * cu, -(2 + cv) * su, 0], tolerances.exact);
    near(Suv, [sv * su, -sv * cu, 0], tolerances.exact);
    near(Svv, [-cv * cu, -cv * su, -sv], tolerances.exact);
});

test('normals point outwards and are limits at the poles', () => {
    const sphere = model('sphere', { radius: 3 });
    for (const [u, v] of [[0, 0], [1, 0.4], [2, -Math.PI / 2], [4, Math.PI / 2]]) {
        near(sphere.normal(u, v), sphere.point(u, v).map((x) => x / 3), tolerances.exact);
    }
    assert.deepEqual(model('plane').normal(1, 1), [0, 0, 1]);
    assert.deepEqual(model('cylinder', { radius: 0 }).normal(1, 1), [0, 0, 0]);
    near(model('cone').normal(0, 1), [Math.SQRT1_2, 0, Math.SQRT1_2], tolerances.exact);
    refuses(() => sphere.normal(0, 2), 'OUT_OF_RANGE', 'v');
});

test('curvatures are those of the surface, at poles too', () => {
    const sphere = model('sphere', { radius: 2 });
    for (const v of [0, 1, Math.PI / 2]) {
        const { gaussian, mean, k1, k2 } = sphere.curvatures(0.3, v);
        near([gaussian, mean, k1, k2], [0.25, -0.5, -0.5, -0.5], 1e-13);
    }
    const { gaussian, mean, k1, k2 } = model('torus').curvatures(1, 0);
    near([gaussian, mean, k1, k2], [1 / 3, -2 / 3, -1 / 3, -1], 1e-13);
    refuses(() => model('cone').curvatures(0, 1), 'NOT_SUPPORTED', '');
    refuses(() => sphere.curvatures(0, NaN), 'NOT_FINITE', 'v');
});

test('the list of models has what each takes, and every model is made by its name', () => {
    assert.deepEqual(kw.parametricSurfaces.map(({ name }) => name),
        ['plane', 'cylinder', 'torus', 'sphere', 'cone', 'moebius', 'klein', 'helicoid', 'seashell']);
    for (const { name, label, formula, closed, parameters } of kw.parametricSurfaces) {
        assert.ok(label.length > 2 && formula.length > 10);
        const surface = model(name);
        assert.deepEqual(surface.closed, closed);
        assert.deepEqual(Object.keys(surface.spec.parameters), parameters.map((one) => one.name));
    }
});

test('a closed direction wraps and any other is refused outside', () => {
    const cylinder = model('cylinder', { height: 2 });
    near(cylinder.point(-1, 0.5), cylinder.point(2 * Math.PI - 1, 0.5), tolerances.exact);
    assert.deepEqual(cylinder.point(2 * Math.PI, 1), cylinder.point(0, 1));
    refuses(() => cylinder.point(0, 2.01), 'OUT_OF_RANGE', 'v');
    refuses(() => model('plane').derivatives(-0.1, 0), 'OUT_OF_RANGE', 'u');
    refuses(() => cylinder.point('0', 0), 'WRONG_TYPE', 'u');
    refuses(() => cylinder.point(0, NaN), 'NOT_FINITE', 'v');
});

test('refinement keeps the surface and adds points in both directions', () => {
    for (const spec of [bicubic, { ...bicubic, weights }]) {
        const surface = kw.surface(spec);
        const finer = surface.refine([[0, 0, 0, 0, 0.5, 1, 1.5, 2, 2, 2, 2], [0, 0, 0, 0.3, 1, 2, 2, 2]]);
        assert.equal(finer.spec.points.length, 7);
        assert.equal(finer.spec.points[0].length, 5);
        for (const [u, v] of [[0, 0], [0.5, 0.3], [1, 1], [1.7, 0.2], [2, 2]]) {
            near(finer.point(u, v), surface.point(u, v), tolerances.refinement);
        }
    }
    refuses(() => kw.surface(bicubic).refine([[0, 0, 0, 0, 2, 2, 2, 2], bicubic.knots]), 'WRONG_TYPE', 'knots[1]');
    refuses(() => kw.surface(bicubic).refine([kw.surface(bicubic).spec.knots[0], [0, 0, 0, 2, 2, 2, 2]]),
        'KNOTS_MULTIPLICITY', 'knots[1][6]');
});

test('what is wrong with a net is said by row and column', () => {
    const changed = (change) => {
        const spec = structuredClone({ ...bicubic, weights });
        change(spec);
        return () => kw.surface(spec);
    };
    refuses(changed((spec) => { spec.points[2][3][1] = NaN; }), 'NOT_FINITE', 'points[2][3][1]');
    refuses(changed((spec) => { spec.points[2][3] = [1]; }), 'WRONG_LENGTH', 'points[2][3]');
    refuses(changed((spec) => { spec.points[2][3] = [1, 1e13]; }), 'OUT_OF_RANGE', 'points[2][3]');
    refuses(changed((spec) => { spec.points[2].pop(); }), 'WRONG_LENGTH', 'points[2]');
    refuses(changed((spec) => { spec.points.length = 3; }), 'WRONG_LENGTH', 'points');
    refuses(changed((spec) => { spec.points = spec.points.map((row) => row.slice(0, 2)); }), 'WRONG_LENGTH', 'points[0]');
    refuses(changed((spec) => { spec.weights[1][0] = 0; }), 'OUT_OF_RANGE', 'weights[1][0]');
    refuses(changed((spec) => { spec.weights.pop(); }), 'WRONG_LENGTH', 'weights');
    refuses(changed((spec) => { spec.weights[4].push(1); }), 'WRONG_LENGTH', 'weights[4]');
    refuses(changed((spec) => { spec.knots = [[0, 0, 0, 0, 1, 2, 2, 2, 2], [0, 0, 0, 2, 1, 2, 2]]; }), 'KNOTS_DECREASING', 'knots[1][4]');
    refuses(changed((spec) => { spec.knots = [[0, 1], [0, 0, 0, 1, 2, 2, 2]]; }), 'KNOTS_COUNT', 'knots[0]');
    refuses(changed((spec) => { spec.knots = [[0, 1]]; }), 'WRONG_LENGTH', 'knots');
    refuses(changed((spec) => { spec.degree = [0, 2]; }), 'OUT_OF_RANGE', 'degree[0]');
    refuses(changed((spec) => { spec.degree = [3, 26]; }), 'TOO_LARGE', 'degree[1]');
    refuses(changed((spec) => { spec.degree = 3; }), 'WRONG_TYPE', 'degree');
    refuses(changed((spec) => { spec.form = ['clamped', 'round']; }), 'UNKNOWN_NAME', 'form[1]');
    refuses(changed((spec) => { spec.name = 'x'; }), 'UNKNOWN_FIELD', 'name');
    refuses(() => kw.surface({ type: 'bspline-curve' }), 'UNKNOWN_NAME', 'type');
    refuses(() => kw.surface({ type: 'parametric-surface', name: 'sponge' }), 'UNKNOWN_NAME', 'name');
    refuses(() => model('torus', { radius: 1 }), 'UNKNOWN_FIELD', 'parameters.radius');
    refuses(() => model('plane', { width: 0 }), 'OUT_OF_RANGE', 'parameters.width');
    refuses(() => model('plane', { width: '1' }), 'WRONG_TYPE', 'parameters.width');
});

test('a surface that was disposed of is gone', () => {
    const surface = model('sphere');
    surface.dispose();
    surface.dispose();
    for (const ask of [() => surface.domain, () => surface.closed, () => surface.spec, () => surface.point(0, 0)]) {
        refuses(ask, 'DISPOSED');
    }
});

test('a grid has the points and normals of the surface, row by row', () => {
    for (const surface of [kw.surface(bicubic), kw.surface({ ...bicubic, weights }), kw.surface({ ...bicubic, form: ['closed', 'open'] }), model('cone'), model('klein')]) {
        const [[u0, u1], [v0, v1]] = surface.domain;
        const { positions, normals, indices } = surface.grid(9, 33);
        assert.deepEqual([positions.length, normals.length, indices.length], [3 * 9 * 33, 3 * 9 * 33, 6 * 8 * 32]);
        for (let i = 0; i < 9; ++i) {
            for (let j = 0; j < 33; ++j) {
                const [u, v] = [u0 + (u1 - u0) * i / 8, v0 + (v1 - v0) * j / 32];
                const at = 3 * (33 * i + j);
                near(Array.from(positions.subarray(at, at + 3)), surface.point(u, v), tolerances.sampled);
                near(Array.from(normals.subarray(at, at + 3)), surface.normal(u, v), 1e-11);
            }
        }
    }
});

test('triangles are counter-clockwise and leave no edge at a closed seam', () => {
    const { positions, normals, indices } = model('torus').grid(12, 9);
    const at = (list, k) => Array.from(list.subarray(3 * k, 3 * k + 3));
    const edges = new Set();
    for (let k = 0; k < indices.length; k += 3) {
        const corners = Array.from(indices.subarray(k, k + 3));
        corners.forEach((corner, c) => edges.add(`${corner} ${corners[(c + 1) % 3]}`));
        const [a, b, c] = corners.map((corner) => at(positions, corner));
        const [p, q] = [b, c].map((corner) => corner.map((x, axis) => x - a[axis]));
        const n = at(normals, corners[0]);
        const volume = n[0] * (p[1] * q[2] - p[2] * q[1]) + n[1] * (p[2] * q[0] - p[0] * q[2]) + n[2] * (p[0] * q[1] - p[1] * q[0]);
        assert.ok(volume > 0);
    }
    for (const edge of edges) assert.ok(edges.has(edge.split(' ').reverse().join(' ')));
    assert.equal(edges.size, 6 * 11 * 8);
    assert.deepEqual(positions.slice(0, 27), positions.slice(-27));
});

test('a grid fills the arrays of an earlier answer, whatever they held', () => {
    const torus = model('torus');
    const sphere = model('sphere');
    const grid = torus.grid(40, 60);
    const { positions, normals, indices } = grid;
    assert.equal(sphere.grid(40, 60, { into: grid }), grid);
    assert.deepEqual(grid, sphere.grid(40, 60));
    assert.equal(grid.positions, positions);
    const turned = sphere.grid(60, 40, { into: { positions, normals, indices: new Uint32Array(indices.length) } });
    assert.equal(turned.normals, normals);
    assert.deepEqual(turned, sphere.grid(60, 40));
    assert.deepEqual(kw.surface(bicubic).grid(60, 40, { into: { positions, normals, indices } }), kw.surface(bicubic).grid(60, 40));
});

test('a grid that cannot be is refused', () => {
    const plane = model('plane');
    const { positions, normals, indices } = plane.grid(2, 3);
    refuses(() => plane.grid(1, 3), 'OUT_OF_RANGE', 'nu');
    refuses(() => plane.grid(3, 2.5), 'NOT_INTEGER', 'nv');
    refuses(() => plane.grid(2001, 2000), 'TOO_LARGE', 'nv');
    refuses(() => plane.grid(2 ** 32 + 5, 2), 'TOO_LARGE', 'nu');
    refuses(() => plane.grid(2, 3, { into: positions }), 'WRONG_TYPE', 'into');
    refuses(() => plane.grid(3, 3, { into: { positions, normals, indices } }), 'WRONG_LENGTH', 'into.positions');
    refuses(() => plane.grid(3, 2, { into: { positions, normals, indices: new Uint32Array(5) } }), 'WRONG_LENGTH', 'into.indices');
    refuses(() => plane.grid(3, 2, { into: { positions, normals: [], indices } }), 'WRONG_TYPE', 'into.normals');
    refuses(() => plane.grid(3, 2, { into: { positions, normals, indices: new Float64Array(12) } }), 'WRONG_TYPE', 'into.indices');
    refuses(() => plane.grid(3, 2, { onto: 1 }), 'UNKNOWN_FIELD', 'onto');
});

test('adaptive triangles stay within the tolerance and close up', () => {
    for (const [tolerance, most] of [[0.1, 600], [0.01, 6000]]) {
        const { positions, normals, parameters, indices } = model('torus').triangles({ tolerance });
        const vertices = positions.length / 3;
        assert.deepEqual([normals.length, parameters.length], [3 * vertices, 2 * vertices]);
        assert.ok(vertices < most && Math.max(...indices) === vertices - 1);
        const edges = new Set();
        for (let k = 0; k < indices.length; k += 3) {
            const corners = Array.from(indices.subarray(k, k + 3));
            corners.forEach((corner, c) => edges.add(`${corner} ${corners[(c + 1) % 3]}`));
            const middle = [0, 1, 2].map((axis) => corners.reduce((sum, corner) => sum + positions[3 * corner + axis] / 3, 0));
            const distance = 1 - Math.hypot(Math.hypot(middle[0], middle[1]) - 2, middle[2]);
            assert.ok(Math.abs(distance) <= tolerance);
        }
        for (const edge of edges) assert.ok(edges.has(edge.split(' ').reverse().join(' ')));
        for (let k = 0; k < vertices; k += 17) {
            near(Array.from(positions.subarray(3 * k, 3 * k + 3)), model('torus').point(parameters[2 * k], parameters[2 * k + 1]), 1e-14);
        }
    }
    refuses(() => model('torus').triangles({ tolerance: 0 }), 'OUT_OF_RANGE', 'tolerance');
    refuses(() => model('torus', { R: 1e6 }).triangles({ tolerance: 1e-6 }), 'TOO_LARGE', 'tolerance');
});

test('isolines run along one parameter at a constant other', () => {
    const surface = kw.surface(bicubic);
    const line = surface.isoline('v', 0.3, { count: 5 });
    for (let i = 0; i < 5; ++i) near(Array.from(line.subarray(3 * i, 3 * i + 3)), surface.point(0.3, i / 2), tolerances.sampled);
    const circle = model('cylinder').isoline('u', 0.5, { tolerance: 0.001 });
    assert.ok(circle.length / 3 > 50 && circle.length / 3 < 150);
    for (let k = 0; k < circle.length; k += 3) near([Math.hypot(circle[k], circle[k + 1]), circle[k + 2]], [1, 0.5], tolerances.exact);
    refuses(() => surface.isoline('u', 2.5), 'OUT_OF_RANGE', 'at');
    refuses(() => surface.isoline('w', 0), 'UNKNOWN_NAME', 'along');
    refuses(() => surface.isoline('u', 0, { count: 1 }), 'OUT_OF_RANGE', 'count');
    refuses(() => surface.isoline('u', 0, { tolerance: -1 }), 'OUT_OF_RANGE', 'tolerance');
});
