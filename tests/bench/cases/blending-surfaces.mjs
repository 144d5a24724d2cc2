// Grids of points and normals of blending surfaces and blending triangles, beside those of a bicubic
// B-spline surface.
import { repeated } from './case.mjs';

/** @typedef {import('./case.mjs').Case} Case */
/** @typedef {import('./case.mjs').Work} Work */

const torus = { type: 'parametric-surface', name: 'torus' };
const expoRational = { family: 'expo-rational' };
const patches = { type: 'blending-surface', bFunction: expoRational, model: torus, locals: [8, 8], kind: 'bezier' };
const bicubic = {
    type: 'bspline-surface', degree: [3, 3],
    points: Array.from({ length: 16 }, (_, i) => Array.from({ length: 16 }, (_, j) => [i, j, 4 * Math.sin(i * j)])),
};
const poses = [0, 3, 5].map((i) => ({ local: [i, i], translate: [0, 0, 1], rotate: { axis: [0, 0, 1], angle: 0.5 } }));

/** Another surface: what is compared is the cost of a point. */
const another = Infinity;

/** @param {any} kw @param {object} spec @param {number} side @returns {Work} */
function gridOf(kw, spec, side) {
    const surface = kw.surface(spec);
    const into = surface.grid(side, side);
    return {
        act: () => surface.grid(side, side, { into }),
        digest: ({ positions }) => positions,
        dispose: () => surface.dispose(),
    };
}

/** @returns {Case} */
function largeGrid() {
    const side = 500;
    return {
        name: 'blending surface, 8 × 8 Bézier patches by ERB, grid of 500 × 500 with normals',
        unit: 'point',
        amount: side * side,
        ours: (kw) => gridOf(kw, patches, side),
        peers: [
            { name: 'ours, bicubic, 16 × 16 points', tolerance: another, atMost: 4, work: (kw) => gridOf(kw, bicubic, side) },
            {
                name: 'ours, sub-surfaces, three posed', tolerance: another,
                work: (kw) => gridOf(kw, { ...patches, kind: 'sub-surface', poses }, side),
            },
        ],
    };
}

/** A handle is dragged: another pose, a small grid. @returns {Case} */
function dragged() {
    const side = 40;
    const turns = 10;
    return {
        name: 'blending surface, 8 × 8 Bézier patches, one of them moved, grid of 40 × 40',
        unit: 'point',
        amount: turns * side * side,
        ours(kw) {
            const surface = kw.surface(patches);
            const into = surface.grid(side, side);
            let height = 0;
            return {
                act: repeated(turns, () => {
                    const moved = surface.withPose([2, 3], { translate: [0, 0, (height += 0.01) % 1] });
                    moved.grid(side, side, { into });
                    moved.dispose();
                    return into;
                }),
                digest: ({ positions }) => positions,
                dispose: () => surface.dispose(),
            };
        },
        peers: [{ name: 'ours, bicubic at rest', tolerance: another, work: (kw) => gridOf(kw, bicubic, 126) }],
    };
}

const triangle = {
    type: 'blending-triangle',
    locals: [torus, { type: 'parametric-surface', name: 'plane' }, bicubic], bFunction: expoRational,
};

/**
 * Point by point, each by three patches, their weights and a change of variables: 4.4 µs where a
 * bicubic grid takes 14 ns, 325 times as much.
 * @returns {Case}
 */
function triangleGrid() {
    const side = 200;
    return {
        name: 'blending triangle of a torus, a plane and a bicubic surface, grid of 200 × 200 with normals',
        unit: 'point',
        amount: side * side,
        ours: (kw) => gridOf(kw, triangle, side),
        peers: [
            { name: 'ours, bicubic, 16 × 16 points', tolerance: another, atMost: 500, work: (kw) => gridOf(kw, bicubic, side) },
        ],
    };
}

/** @type {Case[]} */
export const blendingSurfaceCases = [largeGrid(), dragged(), triangleGrid()];
