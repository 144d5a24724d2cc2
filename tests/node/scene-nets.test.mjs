// What a scene can do with the nets and meshes of its surfaces.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { load, near, refuses, tolerances } from './support.mjs';

const kw = await load();

test('a stencil shows how much each vertex counts, and follows a vertex that is moved', () => {
    const scene = kw.scene(kw.scenes.find(({ id }) => id === 'subdivision-stencils').document);
    const [face] = scene.document.objects;
    const shapes = () => scene.drawing().shapes.filter(({ object }) => object === face.id);
    const texts = shapes().filter(({ kind }) => kind === 'label').map(({ text }) => text);
    assert.deepEqual(texts.sort(), ['1/4', '1/4', '1/4', '1/4', 'f']);
    const made = () => Array.from(shapes().filter(({ role, kind }) => role === 'trace' && kind === 'points').at(-1).positions);
    const [x, y] = made();
    scene.execute({ move: `objects[0].mesh.vertices[${face.mesh.faces[3][0]}]`, by: [0.4, -0.8] });
    near(made(), [x + 0.1, y - 0.2, 0], tolerances.exact);
    const kinds = scene.schema[0].fields.find(({ path }) => path === 'stencil.of').choices.map(({ value }) => value);
    assert.deepEqual(kinds, ['vertex', 'edge', 'face', 'corner']);
    refuses(() => scene.execute({ set: 'objects[0].stencil.of', value: 'corner' }), 'NOT_SUPPORTED', 'objects[0].stencil.of');
});

test('a knot of a surface takes a line of its net with it', () => {
    const points = [0, 1, 2, 3].map((i) => [0, 1, 2].map((j) => [i, j, (i * j) % 3]));
    const scene = kw.scene({ knotwork: 1, objects: [{ id: 'net', type: 'bspline-surface', degree: [2, 2], points }] });
    const sample = () => Array.from(kw.surface(scene.document.objects[0]).grid(7, 5).positions);
    const before = sample();
    assert.equal(scene.execute({ insertKnot: { object: 'net', at: 0.25, along: 'u' } }).path, 'objects[0].knots[0]');
    assert.deepEqual([scene.document.objects[0].points.length, scene.document.objects[0].knots[0]], [5, [0, 0, 0, 0.25, 1, 2, 2, 2]]);
    near(sample(), before, tolerances.refinement);
    scene.execute({ remove: 'objects[0].knots[0][3]' });
    near(sample(), before, tolerances.refinement);
    scene.undo();
    scene.undo();
    assert.deepEqual(scene.document.objects[0].points, points);
    refuses(() => scene.execute({ insertKnot: { object: 'net', at: 0.25 } }), 'WRONG_TYPE', 'insertKnot.along');
});
