// The five schemes through the public interface: counts, known points, limits, what is refused.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { load, near, refuses, tolerances } from './support.mjs';

const kw = await load();
const schemes = ['catmull-clark', 'doo-sabin', 'loop', 'butterfly', 'sqrt3'];
const ofTriangles = ['loop', 'butterfly', 'sqrt3'];

const rows = (flat) => Array.from({ length: flat.length / 3 }, (_, i) => Array.from(flat.subarray(3 * i, 3 * i + 3)));
/** @param {string} scheme one that it takes */
const bases = (scheme) => (ofTriangles.includes(scheme)
    ? [kw.mesh({ solid: 'icosahedron' }), kw.mesh({ solid: 'torus' }).triangulated(), kw.mesh({ solid: 'grid' }).triangulated()]
    : [kw.mesh({ solid: 'cube' }), kw.mesh({ solid: 'cuboctahedron' }), kw.mesh({ solid: 'torus' }), kw.mesh({ solid: 'grid' })]);

/** The counts of one more level, by the laws of the schemes; Doo–Sabin’s hold for closed meshes. */
const laws = {
    'catmull-clark': ({ vertices, edges, faces }, corners) => ({ vertices: vertices + edges + faces, edges: 2 * edges + corners, faces: corners }),
    'doo-sabin': ({ vertices, edges, faces }, corners) => ({ vertices: corners, edges: 2 * corners, faces: faces + edges + vertices }),
    loop: ({ vertices, edges, faces }) => ({ vertices: vertices + edges, edges: 2 * edges + 3 * faces, faces: 4 * faces }),
    butterfly: (counts, corners) => laws.loop(counts, corners),
    sqrt3: ({ vertices, edges, faces }) => ({ vertices: vertices + faces, edges: edges + 3 * faces, faces: 3 * faces }),
};

for (const scheme of schemes) {
    test(`${scheme}: the counts of three levels follow its laws`, () => {
        for (const base of bases(scheme)) {
            if (base.counts.boundaryEdges > 0 && ['doo-sabin', 'sqrt3'].includes(scheme)) continue;
            let mesh = base;
            for (let level = 0; level < 3; ++level) {
                const corners = mesh.faces.reduce((sum, face) => sum + face.length, 0);
                const expected = laws[scheme](mesh.counts, corners);
                mesh = mesh.subdivide(scheme);
                const { vertices, edges, faces } = mesh.counts;
                assert.deepEqual({ vertices, edges, faces }, expected);
            }
        }
    });

    test(`${scheme}: three levels at once are three levels one by one, to the bit`, () => {
        for (const base of bases(scheme)) {
            if (scheme === 'sqrt3' && base.counts.boundaryEdges > 0) continue;
            const at = base.subdivide(scheme, 3);
            const by = base.subdivide(scheme).subdivide(scheme, 1).subdivide(scheme);
            assert.deepEqual(at.vertices, by.vertices);
            assert.deepEqual(at.faces, by.faces);
        }
    });

    test(`${scheme}: what comes out is a mesh like one that is given`, () => {
        for (const base of bases(scheme)) {
            const { vertices, faces, counts, edges } = base.subdivide(scheme, 2);
            const again = kw.mesh({ vertices, faces });
            assert.deepEqual(again.counts, counts);
            assert.deepEqual(again.edges, edges);
        }
    });

    test(`${scheme}: no level at all is the mesh itself`, () => {
        const [base] = bases(scheme);
        assert.deepEqual(base.subdivide(scheme, 0).vertices, base.vertices);
        assert.deepEqual(base.subdivide(scheme, 0).faces, base.faces);
    });

    test(`${scheme}: too many levels are refused before work begins`, () => {
        const [base] = bases(scheme);
        const held = kw.session.held();
        for (const levels of [12, 30, 1000, 1e6]) refuses(() => base.subdivide(scheme, levels), 'TOO_LARGE', 'levels');
        refuses(() => base.subdivide(scheme, -1), 'OUT_OF_RANGE', 'levels');
        refuses(() => base.subdivide(scheme, 1.5), 'NOT_INTEGER', 'levels');
        refuses(() => base.subdivide(scheme, '1'), 'WRONG_TYPE', 'levels');
        assert.equal(kw.session.held(), held);
    });
}

test('Catmull–Clark of a cube is what a hand computes', () => {
    const once = rows(kw.mesh({ solid: 'cube' }).subdivide('catmull-clark').vertices);
    const corner = once[0].map(Math.abs);
    near(corner, [5 / 9, 5 / 9, 5 / 9], tolerances.exact);
    const kinds = once.map((p) => p.map((x) => Math.abs(x).toFixed(12)).sort().join());
    assert.equal(kinds.filter((kind) => kind === [0, 0.75, 0.75].map((x) => x.toFixed(12)).join()).length, 12);
    assert.equal(kinds.filter((kind) => kind === [0, 0, 1].map((x) => x.toFixed(12)).join()).length, 6);
});

test('Loop of a tetrahedron is what a hand computes', () => {
    const once = rows(kw.mesh({ solid: 'tetrahedron' }).subdivide('loop').vertices);
    // β = 3/16 at valence 3, and the sum of the neighbours of v is −v: (1 − 9/16) − 3/16 = 1/4.
    near(once[0], [0.25, 0.25, 0.25], tolerances.exact);
    // The middle of the edge from (1,1,1) to (1,−1,−1): 3/8 of their sum, 1/8 of the others'.
    const middles = once.slice(4).map((p) => p.map(Math.abs).sort().reverse());
    for (const middle of middles) near(middle, [0.5, 0, 0], tolerances.exact);
});

test('an interpolating scheme keeps the vertices, and its limits are they', () => {
    const mesh = kw.mesh({ solid: 'icosahedron' });
    assert.deepEqual(mesh.subdivide('butterfly', 2).vertices.subarray(0, 36), mesh.vertices);
    near(mesh.limit('butterfly').positions, mesh.vertices, tolerances.exact);
});

test('vertices go where their limits say', () => {
    for (const [scheme, levels, apart] of [['catmull-clark', 6, 1e-3], ['loop', 6, 1e-3], ['sqrt3', 8, 1e-3], ['butterfly', 4, 1e-12]]) {
        const [mesh] = bases(scheme);
        const count = 3 * mesh.counts.vertices;
        const { positions, normals } = mesh.limit(scheme);
        assert.equal(positions.length, count);
        near(mesh.subdivide(scheme, levels).vertices.subarray(0, count), positions, apart, scheme);
        // All of these are round: the normals point away from the middle.
        for (const [i, normal] of rows(normals).entries()) {
            near(Math.hypot(...normal), 1, tolerances.exact);
            const p = rows(positions)[i];
            assert.ok(normal.reduce((sum, x, k) => sum + x * p[k], 0) > 0, `${scheme} ${i}`);
        }
    }
});

test('a limit belongs to the surface, however fine the mesh', () => {
    for (const scheme of ['catmull-clark', 'loop', 'sqrt3']) {
        const [mesh] = bases(scheme);
        const { positions, normals } = mesh.limit(scheme);
        const finer = mesh.subdivide(scheme, 2).limit(scheme);
        near(finer.positions.subarray(0, positions.length), positions, tolerances.rounding, scheme);
        near(finer.normals.subarray(0, normals.length), normals, tolerances.rounding, scheme);
    }
});

test('the boundary of an open mesh is a curve of its own', () => {
    const flat = kw.mesh({ solid: 'grid' });
    for (const scheme of schemes) {
        const mesh = ofTriangles.includes(scheme) ? flat.triangulated() : flat;
        const finer = mesh.subdivide(scheme, 2);
        assert.ok(finer.counts.boundaryEdges > mesh.counts.boundaryEdges, scheme);
        assert.ok(rows(finer.vertices).every(([, , z]) => z === 0), scheme);
    }
});

test('a classification says what a scheme is good for', () => {
    const mesh = kw.mesh({ solid: 'cube' });
    const expected = {
        'catmull-clark': [true, 'C2', 'any'], 'doo-sabin': [true, 'C1', 'any'], loop: [true, 'C2', 'triangles'],
        butterfly: [false, 'C1', 'triangles'], sqrt3: [true, 'C2', 'triangles'],
    };
    for (const [scheme, [approximating, regular, takes]] of Object.entries(expected)) {
        assert.deepEqual(mesh.classification(scheme), { approximating, regular, extraordinary: 'C1', mesh: takes });
    }
});

test('schemes for triangles refuse other faces by their number, and take them cut', () => {
    const mixed = kw.mesh({ solid: 'prism' });
    for (const scheme of ofTriangles) {
        refuses(() => mixed.subdivide(scheme), 'NOT_SUPPORTED', 'faces[0]');
        refuses(() => mixed.limit(scheme), 'NOT_SUPPORTED', 'faces[0]');
        assert.ok(mixed.triangulated().subdivide(scheme).counts.faces > 0);
    }
});

test('what there is not is refused by name', () => {
    const mesh = kw.mesh({ solid: 'cube' });
    refuses(() => mesh.limit('doo-sabin'), 'NOT_SUPPORTED', 'scheme');
    for (const scheme of ['chaikin', 'Loop', '', 'constructor']) {
        refuses(() => mesh.subdivide(scheme), 'UNKNOWN_NAME', 'scheme');
        refuses(() => mesh.limit(scheme), 'UNKNOWN_NAME', 'scheme');
        refuses(() => mesh.classification(scheme), 'UNKNOWN_NAME', 'scheme');
    }
    refuses(() => mesh.subdivide(), 'WRONG_TYPE', 'scheme');
    mesh.dispose();
    refuses(() => mesh.subdivide('loop'), 'DISPOSED');
    refuses(() => mesh.limit('loop'), 'DISPOSED');
    refuses(() => mesh.classification('loop'), 'DISPOSED');
});

test('a cube of level 8 comes out whole, and every level has four times the faces', () => {
    let mesh = kw.mesh({ solid: 'cube' });
    for (let level = 1; level <= 8; ++level) {
        const finer = mesh.subdivide('catmull-clark');
        assert.equal(finer.counts.faces, 6 * 4 ** level);
        mesh.dispose();
        mesh = finer;
    }
    assert.deepEqual(mesh.counts, { vertices: 393_218, edges: 786_432, faces: 393_216, boundaryEdges: 0 });
    assert.ok(mesh.faces.every((face) => face.length === 4));
    mesh.dispose();
});
