// What is drawn of every type of object: roles, triangles, edges, measures, labels and traces.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { load, near, refuses, tolerances } from './support.mjs';

const kw = await load();
const spline = { id: 'c1', type: 'bspline-curve', degree: 3, points: [[0, 0], [1, 3], [4, 2], [5, -1], [7, 1], [8, 4]] };
const torus = { id: 't1', type: 'parametric-surface', name: 'torus' };
const sceneOf = (...objects) => kw.scene({ knotwork: 1, objects });
const shapesOf = (drawing, role) => drawing.shapes.filter((shape) => shape.role === role);
const pointIn = ({ positions }, i) => Array.from(positions.subarray(3 * i, 3 * i + 3));
const roles = ['curve', 'surface', 'wireframe', 'polygon', 'points', 'knots', 'local', 'handle', 'basis', 'bFunction',
    'comb', 'hodograph', 'hull', 'frame', 'sphere', 'residual', 'isoline', 'trace', 'label'];

const everything = Object.fromEntries(['wireframe', 'locals', 'comb', 'hodograph', 'curvature', 'crossings', 'osculating', 'hull', 'frames',
    'sphere', 'labels'].map((flag) => [flag, true]));
const showcase = [
    { ...spline, show: everything, trace: { algorithm: 'de-boor', frame: 2 } },
    { id: 'blend', type: 'blending-curve', model: { type: 'parametric-curve', name: 'rose' },
        locals: { count: 6, kind: 'arc' }, bFunction: { family: 'expo-rational' }, show: everything },
    { ...torus, show: everything },
    { id: 'sheet', type: 'blending-surface', model: { type: 'parametric-surface', name: 'cylinder' }, locals: [4, 3],
        kind: 'bezier', form: ['closed', 'open'], bFunction: { family: 'expo-rational' }, show: everything },
    { id: 'net', type: 'bspline-surface', degree: [2, 1], form: ['clamped', 'clamped'],
        points: [[[0, 0, 0], [0, 1, 1]], [[1, 0, 1], [1, 1, 0]], [[2, 0, 0], [2, 1, 2]]], show: everything },
    { id: 'mesh', type: 'subdivision-surface', scheme: 'catmull-clark', levels: 2, mesh: { solid: 'cube' }, show: everything },
    { id: 'data', type: 'point-cloud', points: [[0, 0], [1, 1], [2, 0.5], [3, 1.5], [4, 0], [5, 1]],
        fit: { degree: 3, count: 4 }, show: everything },
];

test('the shapes of all types have every role between them and no other', () => {
    const { bounds, shapes } = sceneOf(...showcase).drawing({ tolerance: 0.01 });
    assert.deepEqual([...new Set(shapes.map(({ role }) => role))].sort(), [...roles].sort());
    for (const shape of shapes) {
        assert.ok(shape.positions.every(Number.isFinite), shape.role);
        assert.ok(['polyline', 'points', 'triangles', 'label'].includes(shape.kind));
        for (const i of shape.indices ?? []) assert.ok(i < shape.positions.length / 3);
        if (shape.kind === 'label') assert.ok(shape.text.length > 0 && shape.offset.length === 2);
        if (shape.pane !== 'curve') continue;
        shape.positions.forEach((x, i) => assert.ok(bounds.min[i % 3] <= x && x <= bounds.max[i % 3]));
    }
});

test('a surface is triangles with unit normals, counter-clockwise seen from where they point', () => {
    const [{ kind, positions, normals, indices }] = shapesOf(sceneOf(torus).drawing({ tolerance: 0.05 }), 'surface');
    assert.equal(kind, 'triangles');
    assert.ok(normals instanceof Float64Array && indices instanceof Uint32Array && indices.length % 3 === 0);
    const at = (list, i) => Array.from(list.subarray(3 * i, 3 * i + 3));
    const minus = (a, b) => a.map((x, c) => x - b[c]);
    const cross = ([a, b, c], [d, e, f]) => [b * f - c * e, c * d - a * f, a * e - b * d];
    const dot = (a, b) => a.reduce((sum, x, c) => sum + x * b[c], 0);
    for (let i = 0; i < indices.length; i += 3) {
        const [a, b, c] = indices.subarray(i, i + 3);
        const across = cross(minus(at(positions, b), at(positions, a)), minus(at(positions, c), at(positions, a)));
        assert.ok(dot(across, at(normals, a)) > 0);
        assert.ok(Math.abs(dot(at(normals, a), at(normals, a)) - 1) < 1e-12);
    }
});

test('the wires of a subdivision surface are the edges of its mesh', () => {
    const drawing = sceneOf(showcase[5]).drawing();
    const mesh = kw.mesh({ solid: 'cube' }).subdivide('catmull-clark', 2);
    const [{ indices, positions }] = shapesOf(drawing, 'wireframe');
    assert.deepEqual(Array.from(indices), mesh.edges.flatMap(([a, b]) => [a, b]));
    near(positions, mesh.vertices, tolerances.sampled);
});

test('teeth of the comb end at C − scale κ N, whatever the scale', () => {
    const [teeth] = shapesOf(sceneOf({ ...spline, show: { comb: true } }).drawing(), 'comb');
    const curve = kw.curve(spline);
    const scales = [];
    for (let i = 0; i < teeth.positions.length / 6; i += 7) {
        const [foot, tip] = [pointIn(teeth, 2 * i), pointIn(teeth, 2 * i + 1)];
        const { t } = curve.closestPoint(foot);
        const { normal, curvature } = curve.frame(t);
        if (Math.abs(curvature) < 0.05 || Math.abs(t - Math.round(t)) < 1e-9) continue;
        scales.push((foot[0] - tip[0]) * normal[0] / curvature + (foot[1] - tip[1]) * normal[1] / curvature);
    }
    assert.ok(scales.length > 5);
    scales.forEach((scale) => assert.ok(scale > 0 && Math.abs(scale / scales[0] - 1) < 1e-6, `${scales}`));
});

test('only the panes that are asked for are drawn', () => {
    const scene = sceneOf(...showcase);
    for (const panes of [['curve'], ['basis', 'knots'], ['hodograph'], ['curvature'], []]) {
        const found = new Set(scene.drawing({ tolerance: 0.1, panes }).shapes.map(({ pane }) => pane));
        found.forEach((pane) => assert.ok(panes.includes(pane), pane));
        panes.forEach((pane) => assert.ok(found.has(pane), pane));
    }
    refuses(() => scene.drawing({ panes: ['tower'] }), 'UNKNOWN_NAME', 'panes[0]');
    refuses(() => scene.drawing({ panes: 'curve' }), 'WRONG_TYPE', 'panes');
});

test('a drawing after a change is the drawing of the changed document', () => {
    const scene = sceneOf(...showcase);
    const same = () => {
        const again = kw.scene(scene.document);
        assert.deepEqual(scene.drawing({ tolerance: 0.02, phase: 0.5 }), again.drawing({ tolerance: 0.02, phase: 0.5 }));
        again.dispose();
    };
    same();
    for (const command of [
        { move: 'objects[0].points[2]', by: [0.1, 0.2] }, { set: 'objects[0].knots[4]', value: 0.7 },
        { set: 'objects[2].show.isolines', value: false }, { set: 'objects[0].trace.frame', value: 1 },
        { set: 'objects[5].levels', value: 1 }, { remove: 'objects[1]' },
    ]) {
        scene.execute(command);
        same();
        scene.undo();
        same();
        scene.redo();
    }
});

test('a parameter and a trace are fields of an object and are checked', () => {
    assert.equal(sceneOf({ ...spline, t: 1.5 }).document.objects[0].t, 1.5);
    assert.equal(sceneOf(showcase[0]).document.objects[0].trace.frame, 2);
    refuses(() => sceneOf({ ...spline, t: 9 }), 'OUT_OF_RANGE', 'objects[0].t');
    refuses(() => sceneOf({ ...spline, trace: { algorithm: 'de-boor', t: -1 } }), 'OUT_OF_RANGE', 'objects[0].trace.t');
    refuses(() => sceneOf({ ...spline, trace: { algorithm: 'blend' } }), 'NOT_SUPPORTED', 'objects[0].trace.algorithm');
    const scene = sceneOf({ ...spline, t: 1.5, trace: { algorithm: 'de-boor', frame: 99 } });
    const { id: _, ...curve } = spline;
    const { frames } = kw.trace({ algorithm: 'de-boor', curve, t: 1.5 });
    const [edges, points] = shapesOf(scene.drawing(), 'trace');
    near(points.positions, frames.at(-1).points.flat(), tolerances.sampled);
    assert.deepEqual(Array.from(edges.indices), frames.at(-1).edges.flat());
});

test('residuals go from each datum to its point on the fit', () => {
    const { points, fit } = showcase[6];
    const { curve, parameters } = kw.fit({ points, ...fit });
    const [residual] = shapesOf(sceneOf(showcase[6]).drawing(), 'residual');
    points.forEach((datum, i) => {
        near(pointIn(residual, 2 * i).slice(0, 2), datum, 0);
        near(pointIn(residual, 2 * i + 1), curve.point(parameters[i]), 1e-12);
    });
});
