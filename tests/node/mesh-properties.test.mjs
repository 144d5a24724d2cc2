// Subdivision of random meshes through the public interface: solids with faces missing, so that there
// are boundaries, bow ties and vertices without faces, and with their vertices shaken.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import fc from 'fast-check';

import { holds, number } from './generators.mjs';
import { load, near } from './support.mjs';

const kw = await load();
const schemes = ['catmull-clark', 'doo-sabin', 'loop', 'butterfly', 'sqrt3'];

/** Vertices and faces of a solid some of whose faces are missing. */
const punched = fc.record({
    solid: fc.constantFrom('cube', 'tetrahedron', 'octahedron', 'icosahedron', 'dodecahedron', 'torus', 'grid'),
    missing: fc.array(fc.nat(), { maxLength: 6 }),
    moves: fc.array(number(-0.2, 0.2), { minLength: 1, maxLength: 12 }),
}).map(({ solid, missing, moves }) => {
    const mesh = kw.mesh({ solid });
    const { vertices, faces } = mesh;
    mesh.dispose();
    const gone = new Set(missing.map((index) => index % faces.length));
    return {
        vertices: vertices.map((x, i) => x + moves[i % moves.length]),
        faces: faces.filter((_, i) => gone.size === faces.length || !gone.has(i)),
    };
});

/** The same with every face as a fan of triangles. */
const cut = ({ vertices, faces }) => ({
    vertices,
    faces: faces.flatMap((face) => face.slice(2).map((_, k) => [face[0], face[k + 1], face[k + 2]])),
});

const specFor = (scheme, spec) => (scheme === 'catmull-clark' || scheme === 'doo-sabin' ? spec : cut(spec));

/** Calls act with the mesh and with the scheme, for all five. */
function withSchemes(spec, act) {
    for (const scheme of schemes) {
        const mesh = kw.mesh(specFor(scheme, spec));
        act(mesh, scheme);
        mesh.dispose();
    }
}

const euler = ({ vertices, edges, faces }) => vertices - edges + faces;

test('every level of any mesh is a mesh, with the counts of its scheme', () => {
    holds(fc.property(punched, (spec) => withSchemes(spec, (mesh, scheme) => {
        const { counts } = mesh;
        const corners = mesh.faces.flat().length;
        const fine = mesh.subdivide(scheme, 2);
        const again = kw.mesh({ vertices: fine.vertices, faces: fine.faces });
        assert.deepEqual(again.counts, fine.counts, scheme);
        const once = mesh.subdivide(scheme).counts;
        const { vertices: v, edges: e, faces: f, boundaryEdges: b } = counts;
        const expected = {
            'catmull-clark': [v + e + f, corners, 2 * b], 'doo-sabin': [corners + 2 * b, once.faces, 2 * b],
            loop: [v + e, 4 * f, 2 * b], butterfly: [v + e, 4 * f, 2 * b], sqrt3: [v + f, 3 * f, b],
        }[scheme];
        assert.deepEqual([once.vertices, once.faces, once.boundaryEdges], expected, scheme);
        if (scheme !== 'doo-sabin') assert.equal(euler(fine.counts), euler(counts), scheme);
    })), { numRuns: 60 });
});

test('levels one by one are levels at once', () => {
    holds(fc.property(punched, (spec) => withSchemes(spec, (mesh, scheme) => {
        const step = scheme === 'sqrt3' ? 2 : 1;
        const at = mesh.subdivide(scheme, 2 * step);
        const by = mesh.subdivide(scheme, step).subdivide(scheme, step);
        assert.deepEqual(at.faces, by.faces, scheme);
        assert.deepEqual(at.vertices, by.vertices, scheme);
    })), { numRuns: 60 });
});

test('what is subdivided and moved is what is moved and subdivided', () => {
    const turn = (xyz) => xyz.map((_, i) => {
        const [x, y, z] = xyz.subarray(i - (i % 3), i - (i % 3) + 3);
        return [1.5 * x - y + 3, 0.25 * x + 2 * z - 1, y - 0.5 * z][i % 3];
    });
    holds(fc.property(punched, (spec) => withSchemes(spec, (mesh, scheme) => {
        const moved = kw.mesh({ vertices: turn(mesh.vertices), faces: mesh.faces });
        near(moved.subdivide(scheme, 2).vertices, turn(mesh.subdivide(scheme, 2).vertices), 1e-14, scheme);
    })), { numRuns: 60 });
});

test('limits stay where they are on finer meshes', () => {
    holds(fc.property(punched, (spec) => withSchemes(spec, (mesh, scheme) => {
        if (scheme === 'doo-sabin') return;
        const { positions, normals } = mesh.limit(scheme);
        const finer = mesh.subdivide(scheme, scheme === 'sqrt3' ? 2 : 1).limit(scheme);
        near(finer.positions.subarray(0, positions.length), positions, 4e-15, scheme);
        for (let i = 0; i < normals.length; i += 3) {
            const length = Math.hypot(normals[i], normals[i + 1], normals[i + 2]);
            assert.ok(length === 0 || Math.abs(length - 1) < 1e-14, `${scheme} ${length}`);
        }
    })), { numRuns: 60 });
});
