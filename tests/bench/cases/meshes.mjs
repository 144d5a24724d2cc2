// Subdivided meshes, from the given mesh to vertices in an array of the program's.
import { BufferAttribute, BufferGeometry } from 'three';
import { LoopSubdivision } from 'three-subdivide';

import { glCatmullClark } from '../peers/packages.mjs';
import { catmullClark } from '../peers/typed-array-catmull-clark.mjs';
import { repeated } from './case.mjs';

/** @typedef {import('./case.mjs').Work} Work */

/** The largest level of a cube for which gl-catmull-clark takes less than a second or two. */
const feasible = 7;
const finest = 8;
const loopLevels = 3;

/** @param {number} level */
const quadsOfCube = (level) => 6 * 4 ** level;

/** Triangles all of valence 6, 10 000 of them. */
const ring = { solid: 'torus', parameters: { around: 100, across: 50 } };

/** three-subdivide takes vertices that agree in two decimals for one. */
const enlarged = 1024;

/**
 * Vertices come in different orders: the sums of all coordinates, of their squares and fourth powers.
 * @param {ArrayLike<number>} xyz
 */
function moments(xyz) {
    const sums = new Float64Array(9);
    for (let i = 0; i < xyz.length; ++i) {
        const square = xyz[i] ** 2;
        sums[i % 3] += xyz[i];
        sums[3 + i % 3] += square;
        sums[6 + i % 3] += square ** 2;
    }
    return sums.map((sum) => 3 * sum / xyz.length);
}

/** @param {any} kw @param {number} level @returns {Work} */
function ourCube(kw, level) {
    return {
        act() {
            const cube = kw.mesh({ solid: 'cube' });
            const mesh = cube.subdivide('catmull-clark', level);
            const { vertices } = mesh;
            mesh.dispose();
            cube.dispose();
            return vertices;
        },
        digest: moments,
        dispose() {},
    };
}

/** @param {any} kw */
function flatCube(kw) {
    const cube = kw.mesh({ solid: 'cube' });
    return { positions: cube.vertices, quads: Uint32Array.from(cube.faces.flat()) };
}

/**
 * One level of a cube that is there already, as often as it takes to make as many quads as the finest has.
 * @param {any} kw
 * @param {number} from
 * @returns {Work}
 */
function oneLevel(kw, from) {
    const mesh = kw.mesh({ solid: 'cube' }).subdivide('catmull-clark', from);
    return {
        act: repeated(4 ** (finest - 1 - from), () => {
            mesh.subdivide('catmull-clark').dispose();
            return new Float64Array(1);
        }),
        dispose: () => mesh.dispose(),
    };
}

/** Each triangle with vertices of its own, as three-subdivide gives them. @param {any} mesh */
function soup(mesh) {
    const { vertices, indices } = mesh;
    const xyz = new Float64Array(3 * indices.length);
    for (let i = 0; i < indices.length; ++i) {
        for (let axis = 0; axis < 3; ++axis) xyz[3 * i + axis] = vertices[3 * indices[i] + axis];
    }
    return xyz;
}

/** @type {import('./case.mjs').Case[]} */
export const meshCases = [
    {
        name: `Catmull–Clark of a cube to level ${finest}, from scratch`,
        unit: 'quad',
        amount: quadsOfCube(finest),
        ours: (kw) => ourCube(kw, finest),
        peers: [
            {
                name: `gl-catmull-clark, level ${feasible}`,
                tolerance: 1e-6,  // it computes in single precision
                atLeast: 100,
                amount: quadsOfCube(feasible),
                same: (kw) => ourCube(kw, feasible),
                work(kw) {
                    const { vertices, faces } = kw.mesh({ solid: 'cube' });
                    const points = Array.from({ length: 8 }, (_, i) => Array.from(vertices.subarray(3 * i, 3 * i + 3)));
                    return {
                        act: () => glCatmullClark(points, faces, feasible, false),
                        digest: (/** @type {{ positions: number[][] }} */ { positions }) =>
                            moments(positions.flatMap((point) => Array.from(point))),
                        dispose() {},
                    };
                },
            },
            {
                name: 'typed-array loop',
                tolerance: 1e-12,
                atLeast: 5,
                work(kw) {
                    const cube = flatCube(kw);
                    return {
                        act: () => catmullClark(cube, finest).positions,
                        digest: moments,
                        dispose() {},
                    };
                },
            },
        ],
    },
    {
        name: 'Loop of 10 000 triangles, 3 levels',
        unit: 'triangle',
        amount: 10_000 * 4 ** loopLevels,
        ours(kw) {
            const base = kw.mesh(ring).triangulated();
            return {
                act() {
                    const mesh = base.subdivide('loop', loopLevels);
                    const { vertices } = mesh;
                    mesh.dispose();
                    return vertices;
                },
                dispose: () => base.dispose(),
            };
        },
        peers: [{
            name: 'three-subdivide',
            tolerance: 1e-6,  // it computes in single precision
            atLeast: 300,
            rounds: 3,
            same: (kw) => ({
                act: () => soup(kw.mesh(ring).triangulated().subdivide('loop', loopLevels)),
                digest: moments,
                dispose() {},
            }),
            work(kw) {
                const geometry = new BufferGeometry();
                const triangles = soup(kw.mesh(ring).triangulated());
                geometry.setAttribute('position', new BufferAttribute(Float32Array.from(triangles, (x) => enlarged * x), 3));
                return {
                    act: () => LoopSubdivision.modify(geometry, loopLevels, { split: false }),
                    digest: (/** @type {BufferGeometry} */ { attributes }) =>
                        moments(Float64Array.from(attributes.position.array, (x) => x / enlarged)),
                    dispose: () => geometry.dispose(),
                };
            },
        }],
    },
    ...[6, 7].map((level) => ({
        name: `Catmull–Clark, level ${level + 1} of a cube against level ${level}`,
        unit: 'quad',
        amount: quadsOfCube(finest),
        ours: (/** @type {any} */ kw) => oneLevel(kw, level),
        peers: [{
            name: 'the level before',
            tolerance: 0,
            within: 0.2,
            work: (/** @type {any} */ kw) => oneLevel(kw, level - 1),
        }],
    })),
];
