// Meshes: solids, lists in and out, normals, OBJ, and what is refused.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { load, near, randomness, refuses, tolerances } from './support.mjs';

const kw = await load();

/** Quads over whole coordinates, columns × rows of them. */
function grid(columns, rows) {
    const vertices = [];
    const faces = [];
    for (let j = 0; j <= rows; ++j) {
        for (let i = 0; i <= columns; ++i) vertices.push([i, j]);
    }
    for (let j = 0; j < rows; ++j) {
        for (let i = 0; i < columns; ++i) {
            const at = j * (columns + 1) + i;
            faces.push([at, at + 1, at + columns + 2, at + columns + 1]);
        }
    }
    return { vertices, faces };
}

const lengthOf = ([x, y, z]) => Math.hypot(x, y, z);
const rows = (flat) => Array.from({ length: flat.length / 3 }, (_, i) => Array.from(flat.subarray(3 * i, 3 * i + 3)));

test('the solids have the counts of the books', () => {
    const expected = {
        tetrahedron: [4, 6, 4], cube: [8, 12, 6], octahedron: [6, 12, 8], dodecahedron: [20, 30, 12],
        icosahedron: [12, 30, 20], cuboctahedron: [12, 24, 14],
    };
    for (const [solid, [vertices, edges, faces]] of Object.entries(expected)) {
        assert.deepEqual(kw.mesh({ solid }).counts, { vertices, edges, faces, boundaryEdges: 0 }, solid);
    }
});

test('every solid of the list can be made, with Euler’s characteristic', () => {
    for (const { name, label, parameters } of kw.solids) {
        const { vertices, edges, faces, boundaryEdges } = kw.mesh({ solid: name }).counts;
        assert.equal(vertices - edges + faces, { torus: 0, grid: 1 }[name] ?? 2, name);
        assert.equal(boundaryEdges > 0, name === 'grid');
        assert.ok(label.length > 3);
        const defaults = Object.fromEntries(parameters.map((one) => [one.name, one.default]));
        assert.deepEqual(kw.mesh({ solid: name, parameters: defaults }).counts, kw.mesh({ solid: name }).counts);
    }
});

test('cube, tetrahedron and octahedron have the corners that people expect', () => {
    const corners = (solid) => rows(kw.mesh({ solid }).vertices).map(String).sort();
    const signs = [-1, 1];
    assert.deepEqual(corners('cube'), signs.flatMap((x) => signs.flatMap((y) => signs.map((z) => String([x, y, z])))).sort());
    assert.deepEqual(corners('tetrahedron'), [[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]].map(String).sort());
    assert.deepEqual(corners('octahedron'),
        [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]].map(String).sort());
});

test('the other solids are inscribed in the unit sphere', () => {
    for (const solid of ['icosahedron', 'dodecahedron', 'cuboctahedron', 'prism', 'torus', 'sphere', 'grid']) {
        const lengths = rows(kw.mesh({ solid }).vertices).map(lengthOf);
        near(Math.max(...lengths), 1, tolerances.exact, solid);
    }
});

test('faces run counter-clockwise seen from outside', () => {
    for (const { name } of kw.solids.filter((one) => !['torus', 'grid'].includes(one.name))) {
        const mesh = kw.mesh({ solid: name });
        const p = rows(mesh.vertices);
        for (const face of mesh.faces) {
            const [a, b, c] = face.map((v) => p[v]);
            const [u, v] = [b.map((x, k) => x - a[k]), c.map((x, k) => x - a[k])];
            const normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
            assert.ok(normal[0] * a[0] + normal[1] * a[1] + normal[2] * a[2] > 0, name);
        }
    }
});

test('edges have their two faces, and −1 on a boundary', () => {
    const mesh = kw.mesh({ vertices: [[0, 0], [1, 0], [1, 1], [0, 1], [2, 0]], faces: [[0, 1, 2, 3], [2, 1, 4]] });
    assert.deepEqual(mesh.edges, [[0, 1, 0, -1], [1, 2, 0, 1], [2, 3, 0, -1], [3, 0, 0, -1], [1, 4, 1, -1], [4, 2, 1, -1]]);
    assert.deepEqual(mesh.counts, { vertices: 5, edges: 6, faces: 2, boundaryEdges: 5 });
});

test('vertices come in as points or flat, and go out as triples of their own', () => {
    const faces = [[0, 1, 2]];
    const expected = Float64Array.of(0, 0, 0, 1, 0, 0, 0, 1, 2);
    for (const vertices of [
        [[0, 0], [1, 0], [0, 1, 2]], [[0, 0, 0], [1, 0, 0], [0, 1, 2]], expected, Array.from(expected),
        [Float64Array.of(0, 0), [1, 0], Float64Array.of(0, 1, 2)],
    ]) {
        const mesh = kw.mesh({ vertices, faces });
        assert.deepEqual(mesh.vertices, expected);
        mesh.vertices[0] = 9;
        mesh.faces[0][0] = 9;
        assert.deepEqual(mesh.vertices, expected);
        assert.deepEqual(mesh.faces, faces);
    }
});

test('isolated vertices and bow ties are meshes', () => {
    const mesh = kw.mesh({ vertices: [[0, 0], [1, 0], [0, 1], [-1, 0], [0, -1], [5, 5]], faces: [[0, 1, 2], [0, 3, 4]] });
    assert.deepEqual(mesh.counts, { vertices: 6, edges: 6, faces: 2, boundaryEdges: 6 });
    assert.deepEqual(Array.from(mesh.vertexNormals().subarray(15)), [0, 0, 0]);
    assert.deepEqual(Array.from(mesh.vertexNormals().subarray(0, 3)), [0, 0, 1]);
});

test('normals of a cube are its diagonals, also where its sides are cut in two', () => {
    const cube = kw.mesh({ solid: 'cube' });
    for (const mesh of [cube, cube.triangulated()]) {
        near(mesh.vertexNormals(), Array.from(mesh.vertices, (x) => x / Math.sqrt(3)), tolerances.exact);
    }
    const into = new Float64Array(24);
    assert.equal(cube.vertexNormals({ into }), into);
    assert.deepEqual(into, cube.vertexNormals());
});

test('triangles cover every face', () => {
    for (const { name } of kw.solids) {
        const mesh = kw.mesh({ solid: name });
        const triangles = mesh.faces.reduce((sum, face) => sum + face.length - 2, 0);
        assert.ok(mesh.indices instanceof Uint32Array);
        assert.equal(mesh.indices.length, 3 * triangles, name);
        const cut = mesh.triangulated();
        assert.deepEqual(cut.faces.flat(), Array.from(mesh.indices));
        assert.deepEqual(cut.vertices, mesh.vertices);
    }
});

test('the specification of a mesh makes it again', () => {
    assert.deepEqual(kw.mesh({ solid: 'cube' }).spec, { solid: 'cube' });
    assert.deepEqual(kw.mesh({ solid: 'prism' }).spec, { solid: 'prism', parameters: { sides: 6 } });
    const given = { vertices: [[0, 0, 1], [1, 0, 0], [0, 1, 0], [3, 3, 3]], faces: [[0, 1, 2], [2, 1, 3]] };
    assert.deepEqual(kw.mesh(given).spec, given);
    assert.deepEqual(kw.mesh({ solid: 'tetrahedron' }).triangulated().spec.faces, kw.mesh({ solid: 'tetrahedron' }).faces);
    assert.deepEqual(kw.mesh(JSON.parse(JSON.stringify(kw.mesh(given).spec))).vertices, kw.mesh(given).vertices);
});

test('OBJ that was written reads back to the bit', () => {
    const random = randomness(4);
    const given = grid(9, 7);
    given.vertices = given.vertices.map(([x, y]) => [x + random.between(-1e-3, 1e-3), y * 1e-7, random.between(-1e9, 1e9)]);
    for (const mesh of [kw.mesh(given), ...kw.solids.map(({ name }) => kw.mesh({ solid: name }))]) {
        const again = kw.mesh({ obj: mesh.toObj() });
        assert.deepEqual(again.vertices, mesh.vertices);
        assert.deepEqual(again.faces, mesh.faces);
    }
});

test('OBJ of other programs is read', () => {
    const mesh = kw.mesh({
        obj: '\ufeff# Blender 3.4\r\nmtllib å.mtl\r\no Würfel\r\nv 0 0 0\r\nv 1.0 0 0 1.0\r\nv 1 1 0 0.2 0.3 0.4\r\nv 0 1e0 0\r\n'
            + 'vt 0 0\r\nvn 0 0 1\r\nusemtl stone\r\ns off\r\nf 1/1/1 2//1 \\\r\n -2/1 4# last\r\n',
    });
    assert.deepEqual(mesh.faces, [[0, 1, 2, 3]]);
});

test('a mesh of 400 000 quads comes out whole', () => {
    const given = grid(1000, 400);
    const mesh = kw.mesh(given);
    assert.deepEqual(mesh.counts, { vertices: 401_401, edges: 801_400, faces: 400_000, boundaryEdges: 2800 });
    const { faces } = mesh;
    assert.deepEqual(faces.at(-1), given.faces.at(-1));
    assert.ok(faces.every((face, f) => face.every((v, j) => v === given.faces[f][j])));
    assert.equal(mesh.edges.length, 801_400);
    assert.equal(mesh.indices.length, 6 * 400_000);
    const normals = mesh.vertexNormals();
    for (let i = 0; i < normals.length; i += 3) {
        if (normals[i] !== 0 || normals[i + 1] !== 0 || normals[i + 2] !== 1) assert.fail(`normal ${i / 3}`);
    }
    mesh.dispose();
});

test('a mesh that was disposed of answers nothing more', () => {
    const mesh = kw.mesh({ solid: 'cube' });
    mesh.dispose();
    mesh.dispose();
    for (const act of [
        () => mesh.counts, () => mesh.vertices, () => mesh.faces, () => mesh.edges, () => mesh.indices, () => mesh.spec,
        () => mesh.vertexNormals(), () => mesh.triangulated(), () => mesh.toObj(),
    ]) refuses(act, 'DISPOSED');
});

// ---- What is refused ---------------------------------------------------------------------------

const square = [[0, 0], [1, 0], [1, 1], [0, 1]];
const nan = [[0, 0], [1, 0], [NaN, 1], [0, 1]];
/** @type {[string, object, string, string][]} */
const refusals = [
    ['an edge of three faces', { vertices: [...square, [2, 2]], faces: [[0, 1, 2], [1, 0, 3], [0, 1, 4]] }, 'NOT_MANIFOLD', 'edges[0,1]'],
    ['a face turned round', { vertices: square, faces: [[0, 1, 2], [0, 2, 3].reverse()] }, 'NOT_MANIFOLD', 'edges[0,2]'],
    ['a face twice', { vertices: square, faces: [[0, 1, 2], [0, 1, 2]] }, 'NOT_MANIFOLD', 'edges[0,1]'],
    ['a vertex that there is not', { vertices: square, faces: [[0, 1, 2], [0, 2, 4]] }, 'OUT_OF_RANGE', 'faces[1][2]'],
    ['a negative index', { vertices: square, faces: [[0, 1, -1]] }, 'OUT_OF_RANGE', 'faces[0][2]'],
    ['an index past 32 bits', { vertices: square, faces: [[0, 1, 2 ** 32 + 2]] }, 'OUT_OF_RANGE', 'faces[0][2]'],
    ['an index that is not whole', { vertices: square, faces: [[0, 1.5, 2]] }, 'NOT_INTEGER', 'faces[0][1]'],
    ['an index that is not finite', { vertices: square, faces: [[0, NaN, 2]] }, 'NOT_FINITE', 'faces[0][1]'],
    ['an index as text', { vertices: square, faces: [[0, '1', 2]] }, 'WRONG_TYPE', 'faces[0][1]'],
    ['two vertices in a face', { vertices: square, faces: [[0, 1, 2], [0, 2]] }, 'WRONG_LENGTH', 'faces[1]'],
    ['a vertex twice in a face', { vertices: square, faces: [[0, 1, 2, 1]] }, 'OUT_OF_RANGE', 'faces[0]'],
    ['no faces', { vertices: square, faces: [] }, 'WRONG_LENGTH', 'faces'],
    ['no vertices', { vertices: [], faces: [[0, 1, 2]] }, 'WRONG_LENGTH', 'vertices'],
    ['faces that are missing', { vertices: square }, 'WRONG_TYPE', 'faces'],
    ['vertices that are missing', { faces: [[0, 1, 2]] }, 'WRONG_TYPE', 'vertices'],
    ['a face that is no list', { vertices: square, faces: [[0, 1, 2], 3] }, 'WRONG_TYPE', 'faces[1]'],
    ['NaN', { vertices: nan, faces: [[0, 1, 2]] }, 'NOT_FINITE', 'vertices[2]'],
    ['infinity', { vertices: Float64Array.of(0, 0, 0, 1, 0, Infinity, 0, 1, 0), faces: [[0, 1, 2]] }, 'NOT_FINITE', 'vertices[1]'],
    ['a vertex too far out', { vertices: [[0, 0], [1, 0], [0, 2e12]], faces: [[0, 1, 2]] }, 'OUT_OF_RANGE', 'vertices[2]'],
    ['one number as a vertex', { vertices: [[0, 0], [1], [0, 2]], faces: [[0, 1, 2]] }, 'WRONG_LENGTH', 'vertices[1]'],
    ['text as a coordinate', { vertices: [[0, 0], [1, '0'], [0, 2]], faces: [[0, 1, 2]] }, 'WRONG_TYPE', 'vertices[1][1]'],
    ['half a triple', { vertices: new Float64Array(10), faces: [[0, 1, 2]] }, 'WRONG_LENGTH', 'vertices'],
    ['single precision', { vertices: new Float32Array(9), faces: [[0, 1, 2]] }, 'WRONG_TYPE', 'vertices'],
    ['too many vertices', { vertices: new Float64Array(12_000_003), faces: [[0, 1, 2]] }, 'TOO_LARGE', 'vertices'],
    ['a list that says it is endless', { vertices: Object.assign([], { length: 2 ** 32 - 1 }), faces: [[0, 1, 2]] }, 'TOO_LARGE', 'vertices'],
    ['endless faces', { vertices: square, faces: Object.assign([], { length: 2 ** 32 - 1 }) }, 'TOO_LARGE', 'faces'],
    ['an endless face', { vertices: square, faces: [Object.assign([], { length: 2 ** 32 - 1 })] }, 'TOO_LARGE', 'faces'],
    ['a solid that there is not', { solid: 'teapot' }, 'UNKNOWN_NAME', 'solid'],
    ['a solid that is no name', { solid: 4 }, 'WRONG_TYPE', 'solid'],
    ['a parameter that the solid has not', { solid: 'cube', parameters: { sides: 4 } }, 'UNKNOWN_FIELD', 'parameters.sides'],
    ['two sides of a prism', { solid: 'prism', parameters: { sides: 2 } }, 'OUT_OF_RANGE', 'parameters.sides'],
    ['half a side', { solid: 'prism', parameters: { sides: 4.5 } }, 'NOT_INTEGER', 'parameters.sides'],
    ['a side that is no number', { solid: 'prism', parameters: { sides: '5' } }, 'WRONG_TYPE', 'parameters.sides'],
    ['two ways at once', { solid: 'cube', vertices: square }, 'UNKNOWN_FIELD', 'vertices'],
    ['a field that there is not', { solid: 'cube', size: 2 }, 'UNKNOWN_FIELD', 'size'],
    ['OBJ that is no text', { obj: 7 }, 'WRONG_TYPE', 'obj'],
    ['something else than OBJ', { obj: '<html>' }, 'SYNTAX', 'obj'],
    ['OBJ without faces', { obj: 'v 0 0 0' }, 'WRONG_LENGTH', 'faces'],
    ['OBJ of a vertex that there is not', { obj: 'v 0 0 0\nv 1 0 0\nf 1 2 3' }, 'OUT_OF_RANGE', 'obj'],
    ['nothing', {}, 'WRONG_TYPE', ''],
    ['null', null, 'WRONG_TYPE', ''],
    ['a list', [], 'WRONG_TYPE', ''],
];
for (const [what, spec, code, path] of refusals) {
    test(`${what} is refused as ${code}`, () => {
        const held = kw.session.held();
        refuses(() => kw.mesh(spec), code, path);
        assert.equal(kw.session.held(), held);
        assert.equal(kw.mesh({ solid: 'cube' }).counts.faces, 6);
    });
}

test('a message names the vertices of the edge and the faces, and the line of an OBJ', () => {
    const twisted = refuses(() => kw.mesh({ vertices: square, faces: [[0, 1, 2], [3, 0, 1].reverse(), [0, 1, 3]] }), 'NOT_MANIFOLD');
    assert.match(twisted.message, /vertices 0 and 1 .*3 faces/);
    const mixed = refuses(() => kw.mesh({ vertices: square, faces: [[0, 1, 2], [0, 2, 3].reverse()] }), 'NOT_MANIFOLD');
    assert.match(mixed.message, /faces 0 and 1 go along the edge between the vertices 0 and 2/);
    assert.match(refuses(() => kw.mesh({ obj: 'v 0 0 0\n\nv 1 x 0' }), 'SYNTAX').message, /^Line 3: "x"/);
});

test('four million vertices are allowed, and one more is not', () => {
    const mesh = kw.mesh({ vertices: new Float64Array(12_000_000), faces: [[0, 1, 3_999_999]] });
    assert.equal(mesh.counts.vertices, 4_000_000);
    refuses(() => mesh.toObj(), 'TOO_LARGE', '');
    mesh.dispose();
    refuses(() => kw.mesh({ vertices: new Float64Array(12_000_003), faces: [[0, 1, 2]] }), 'TOO_LARGE', 'vertices');
});

test('what the caller’s lists do while they are read leaves the module as it was', () => {
    const { vertices, faces } = grid(2, 2);
    const meddling = new Proxy(faces, {
        get(list, key) {
            kw.mesh({ solid: 'cube' }).dispose();
            return list[key];
        },
    });
    assert.deepEqual(kw.mesh({ vertices, faces: meddling }).counts, kw.mesh({ vertices, faces }).counts);
    refuses(() => kw.mesh({ vertices, faces: new Proxy([], { get: () => { throw new RangeError('mine'); } }) }), 'WRONG_TYPE', 'faces');
});
