// Creases of meshes through the public interface: what they do, how they are carried on, what is refused.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { load, refuses } from './support.mjs';

const kw = await load();

const cube = () => kw.mesh({ solid: 'cube' });
const allEdges = (mesh, sharpness) => mesh.edges.map(([a, b]) => ({ edge: [a, b], sharpness }));

test('a cube whose edges are all sharp for ever stays a cube', () => {
    const sharp = kw.mesh({ solid: 'cube', creases: allEdges(cube(), 'infinite') }).subdivide('catmull-clark', 3);
    const largest = (i) => Math.max(...sharp.vertices.subarray(3 * i, 3 * i + 3).map(Math.abs));
    for (let i = 0; i < sharp.counts.vertices; ++i) assert.equal(largest(i), 1);
    assert.deepEqual(sharp.vertices.subarray(0, 24), cube().vertices);
    assert.equal(sharp.creases.length, 12 * 8);
});

test('a level takes 1 from every sharpness, and what is left is carried on', () => {
    const { vertices, faces } = cube();
    const mesh = kw.mesh({ vertices, faces, creases: allEdges(cube(), 2.25) });
    assert.deepEqual(new Set(mesh.subdivide('catmull-clark').creases.map(({ sharpness }) => sharpness)), new Set([1.25]));
    assert.deepEqual(new Set(mesh.subdivide('catmull-clark', 2).creases.map(({ sharpness }) => sharpness)), new Set([0.25]));
    assert.deepEqual(mesh.subdivide('catmull-clark', 3).creases, []);
    assert.deepEqual(mesh.subdivide('catmull-clark', 3).vertices,
        mesh.subdivide('catmull-clark', 1).subdivide('catmull-clark', 2).vertices);
    assert.deepEqual(mesh.subdivide('catmull-clark', 2).vertices,
        kw.mesh({ vertices, faces, creases: allEdges(cube(), 'infinite') }).subdivide('catmull-clark', 2).vertices);
    assert.notDeepEqual(mesh.subdivide('catmull-clark').vertices, cube().subdivide('catmull-clark').vertices);
});

test('Loop’s scheme keeps creases on the triangles of a mesh', () => {
    const creases = [{ edge: [0, 1], sharpness: 'infinite' }];
    const sharp = kw.mesh({ solid: 'octahedron', creases: [{ edge: [0, 2], sharpness: 1 }] });
    assert.notDeepEqual(sharp.subdivide('loop').vertices, kw.mesh({ solid: 'octahedron' }).subdivide('loop').vertices);
    assert.deepEqual(kw.mesh({ solid: 'cube', creases }).triangulated().creases, creases);
});

test('the specification of a mesh with creases makes it again', () => {
    const creases = [{ edge: [0, 1], sharpness: 'infinite' }, { edge: [1, 2], sharpness: 0.5 }];
    const { vertices, faces } = cube();
    for (const mesh of [kw.mesh({ solid: 'cube', creases }), kw.mesh({ vertices, faces, creases })]) {
        assert.deepEqual(mesh.creases, creases);
        assert.deepEqual(mesh.spec.creases, creases);
        assert.deepEqual(kw.mesh(mesh.spec).creases, creases);
        const fine = mesh.subdivide('catmull-clark');
        assert.deepEqual(kw.mesh(fine.spec).creases, fine.creases);
    }
    assert.equal('creases' in cube().spec, false);
    assert.deepEqual(cube().creases, []);
    assert.equal('creases' in kw.mesh({ solid: 'cube', creases: [] }).spec, false);
});

test('a subdivision surface of a scene keeps its creases', () => {
    const object = (scheme, creases) => ({ type: 'subdivision-surface', scheme, levels: 1, mesh: { solid: 'cube', creases } });
    const creases = allEdges(cube(), 'infinite');
    const scene = kw.scene({ knotwork: 1, objects: [object('catmull-clark', creases)] });
    assert.deepEqual(scene.document.objects[0].mesh.creases, creases);
    scene.dispose();
    refuses(() => kw.scene({ knotwork: 1, objects: [object('doo-sabin', creases)] }), 'NOT_SUPPORTED', 'objects[0].scheme');
    refuses(() => kw.scene({ knotwork: 1, objects: [object('catmull-clark', [{ edge: [0, 9], sharpness: 1 }])] }),
        'OUT_OF_RANGE', 'objects[0].mesh.creases[0].edge');
    refuses(() => kw.trace({ algorithm: 'catmull-clark', mesh: { solid: 'cube', creases } }), 'NOT_SUPPORTED', 'mesh.creases');
});

test('creases that cannot be are refused by their place, and the module goes on', () => {
    const { vertices, faces } = cube();
    const hostile = [
        ['sharp', 'WRONG_TYPE', 'creases'],
        [null, 'WRONG_TYPE', 'creases'],
        [{}, 'WRONG_TYPE', 'creases'],
        [[1], 'WRONG_TYPE', 'creases[0]'],
        [[{}], 'WRONG_TYPE', 'creases[0].edge'],
        [[{ edge: [0, 1] }], 'WRONG_TYPE', 'creases[0].sharpness'],
        [[{ edge: [0, 1], sharpness: 1, colour: 'red' }], 'UNKNOWN_FIELD', 'creases[0].colour'],
        [[{ edge: [0], sharpness: 1 }], 'WRONG_TYPE', 'creases[0].edge'],
        [[{ edge: [0, 1, 2], sharpness: 1 }], 'WRONG_TYPE', 'creases[0].edge'],
        [[{ edge: [0, '1'], sharpness: 1 }], 'WRONG_TYPE', 'creases[0].edge[1]'],
        [[{ edge: [0.5, 1], sharpness: 1 }], 'NOT_INTEGER', 'creases[0].edge[0]'],
        [[{ edge: [NaN, 1], sharpness: 1 }], 'NOT_FINITE', 'creases[0].edge[0]'],
        [[{ edge: [-1, 1], sharpness: 1 }], 'OUT_OF_RANGE', 'creases[0].edge[0]'],
        [[{ edge: [0, 1e300], sharpness: 1 }], 'OUT_OF_RANGE', 'creases[0].edge[1]'],
        [[{ edge: [0, 1], sharpness: 1 }, { edge: [0, 6], sharpness: 1 }], 'OUT_OF_RANGE', 'creases[1].edge'],
        [[{ edge: [0, 1], sharpness: 1 }, { edge: [1, 0], sharpness: 1 }], 'OUT_OF_RANGE', 'creases[1].edge'],
        [[{ edge: [0, 1], sharpness: 'very' }], 'WRONG_TYPE', 'creases[0].sharpness'],
        [[{ edge: [0, 1], sharpness: 0 }], 'OUT_OF_RANGE', 'creases[0].sharpness'],
        [[{ edge: [0, 1], sharpness: 11 }], 'OUT_OF_RANGE', 'creases[0].sharpness'],
        [[{ edge: [0, 1], sharpness: Infinity }], 'NOT_FINITE', 'creases[0].sharpness'],
        [[{ edge: [0, 1], sharpness: NaN }], 'NOT_FINITE', 'creases[0].sharpness'],
    ];
    for (const [creases, code, path] of hostile) {
        refuses(() => kw.mesh({ vertices, faces, creases }), code, path);
        refuses(() => kw.mesh({ solid: 'cube', creases }), code, path);
    }
    refuses(() => kw.mesh({ obj: 'v 0 0 0', creases: [] }), 'UNKNOWN_FIELD', 'creases');
    const crease = kw.mesh({ solid: 'octahedron', creases: [{ edge: [0, 2], sharpness: 1 }] });
    for (const scheme of ['doo-sabin', 'butterfly', 'sqrt3']) refuses(() => crease.subdivide(scheme), 'NOT_SUPPORTED', 'scheme');
    refuses(() => crease.limit('loop'), 'NOT_SUPPORTED', 'creases');
    assert.equal(crease.subdivide('loop', 2).limit('loop').positions.length, 3 * crease.subdivide('loop', 2).counts.vertices);
    const throwing = { get length() { throw new Error('mine'); } };
    assert.throws(() => kw.mesh({ vertices, faces, creases: throwing }));
    assert.equal(cube().counts.edges, 12);
});
