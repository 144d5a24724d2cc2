// Grids of points and normals of B-spline surfaces.
import { collapsingSurface, nurbsSurface, typedArraySurface } from '../peers/surfaces.mjs';
import { clampedSpline, randomNumbers } from '../splines.mjs';
import { repeated } from './case.mjs';

/** @typedef {import('./case.mjs').Case} Case */
/** @typedef {import('./case.mjs').Work} Work */
/** @typedef {import('../peers/surfaces.mjs').Peer} Peer */
/** @typedef {import('../peers/surfaces.mjs').SplineSurface} SplineSurface */

// Of coordinates up to 20 and of unit normals, through the peers' own parameters.
const rounding = 1e-11;

/**
 * Hills over a plane, so that normals are well defined.
 * @param {number} count of points in either direction
 * @param {number} seed
 * @returns {SplineSurface}
 */
function hills(count, seed) {
    const random = randomNumbers(seed);
    return {
        degrees: [3, 3],
        knots: [clampedSpline(3, count, seed).knots, clampedSpline(3, count, seed + 1).knots],
        points: Array.from({ length: count }, (_, i) =>
            Array.from({ length: count }, (_, j) => [i + 0.3 * random(), j + 0.3 * random(), 4 * random()])),
    };
}

/** @param {SplineSurface} surface */
const specOf = ({ degrees, knots, points }) => ({ type: 'bspline-surface', degree: degrees, points, knots });

/** @param {{ positions: Float64Array, normals: Float64Array }} grid */
function bothLists({ positions, normals }) {
    const all = new Float64Array(2 * positions.length);
    all.set(positions);
    all.set(normals, positions.length);
    return all;
}

/** @param {Peer} peer @param {SplineSurface} surface @param {number} side @returns {Work} */
function workOf(peer, surface, side) {
    const gridder = peer.make(surface);
    const into = { positions: new Float64Array(3 * side * side), normals: new Float64Array(3 * side * side) };
    return {
        act() {
            gridder(side, side, into);
            return into;
        },
        digest: bothLists,
        dispose() {},
    };
}

/** @returns {Case} */
function largeGrid() {
    const side = 1000;
    const surface = hills(16, 1);
    /** @type {[Peer, number?][]} */
    const peers = [[nurbsSurface, 35], [typedArraySurface, 7], [collapsingSurface]];
    return {
        name: 'bicubic surface, 16 × 16 points, grid of 1 000 × 1 000 with normals',
        unit: 'point',
        amount: side * side,
        ours(kw) {
            const made = kw.surface(specOf(surface));
            const into = made.grid(side, side);
            return { act: () => made.grid(side, side, { into }), digest: bothLists, dispose: () => made.dispose() };
        },
        peers: peers.map(([peer, atLeast]) => ({
            name: peer.name, tolerance: rounding, atLeast, work: () => workOf(peer, surface, side),
        })),
    };
}

/**
 * The surface under someone's hand: all of its points change, a small grid is taken, it goes.
 * @returns {Case}
 */
function changedSurface() {
    const side = 40;
    const turns = 10;
    const surfaces = [hills(16, 3), hills(16, 5)];
    const next = () => {
        let turn = 0;
        return () => surfaces[turn++ % 2];
    };
    return {
        name: 'bicubic surface, 16 × 16 points changed, grid of 40 × 40',
        unit: 'point',
        amount: turns * side * side,
        ours(kw) {
            const following = next();
            const into = kw.surface(specOf(surfaces[0])).grid(side, side);
            return {
                act: repeated(turns, () => {
                    const made = kw.surface(specOf(following()));
                    made.grid(side, side, { into });
                    made.dispose();
                    return into;
                }),
                digest: bothLists,
                dispose() {},
            };
        },
        peers: [nurbsSurface, typedArraySurface, collapsingSurface].map((peer) => ({
            name: peer.name,
            tolerance: rounding,
            work() {
                const following = next();
                const into = { positions: new Float64Array(3 * side * side), normals: new Float64Array(3 * side * side) };
                return {
                    act: repeated(turns, () => {
                        peer.make(following())(side, side, into);
                        return into;
                    }),
                    digest: bothLists,
                    dispose() {},
                };
            },
        })),
    };
}

/** @type {Case[]} */
export const surfaceCases = [largeGrid(), changedSurface()];
