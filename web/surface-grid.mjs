// Grids of surfaces: points, normals and triangles into arrays of the caller's.

import { copyInto, integer, isPlain, isUint32Array, lengthOfNumbers, target } from './check.mjs';
import { blockPoints } from './core.mjs';
import { describe, KnotworkError, reading } from './errors.mjs';

const mostPoints = 4_000_000;

/** @typedef {{ positions: Float64Array, normals: Float64Array, indices: Uint32Array }} Grid */
/** @typedef {{ nu: number, nv: number, closed: [boolean, boolean] }} Size */

/**
 * @param {unknown} nu
 * @param {unknown} nv
 * @param {[boolean, boolean]} closed
 * @returns {Size}
 */
export function gridSize(nu, nv, closed) {
    const rows = integer(nu, 'nu', 2, mostPoints / 2, 'TOO_LARGE');
    const columns = integer(nv, 'nv', 2, mostPoints / 2, 'TOO_LARGE');
    if (rows * columns > mostPoints) {
        throw new KnotworkError('TOO_LARGE', 'nv',
            `nu × nv is ${rows * columns}; a grid has at most ${mostPoints} points.`);
    }
    return { nu: rows, nv: columns, closed };
}

/** For what size the triangles in an array were made, if they were. @type {WeakMap<Uint32Array, string>} */
const made = new WeakMap();

/** @param {Size} size */
const indexCount = ({ nu, nv }) => 6 * (nu - 1) * (nv - 1);

/**
 * Where a grid goes: the arrays of an earlier answer, which is returned itself, or new ones.
 * @param {unknown} into
 * @param {Size} size
 * @returns {Grid}
 */
export function gridTarget(into, size) {
    const numbers = 3 * size.nu * size.nv;
    if (into === undefined) {
        return {
            positions: target(undefined, numbers), normals: target(undefined, numbers), indices: freshIndices(size),
        };
    }
    const { positions, normals, indices } = earlierGrid(into);
    return {
        positions: target(positions ?? null, numbers, 'into.positions'),
        normals: target(normals ?? null, numbers, 'into.normals'),
        indices: indexTarget(indices, size),
    };
}

/** The arrays of an earlier answer, each read once. @param {unknown} into */
function earlierGrid(into) {
    return reading(() => 'into', () => {
        if (typeof into !== 'object' || into === null || !isPlain(into)) {
            throw new KnotworkError('WRONG_TYPE', 'into', `into must be an earlier answer, not ${describe(into)}.`);
        }
        const { positions, normals, indices } = /** @type {Record<string, unknown>} */ (into);
        return { positions, normals, indices };
    });
}

/** @param {unknown} indices @param {Size} size */
function indexTarget(indices, size) {
    if (!isUint32Array(indices)) {
        throw new KnotworkError('WRONG_TYPE', 'into.indices',
            `into.indices must be a Uint32Array, not ${describe(indices)}.`);
    }
    if (lengthOfNumbers(indices) === indexCount(size)) return indices;
    throw new KnotworkError('WRONG_LENGTH', 'into.indices',
        `into.indices has ${lengthOfNumbers(indices)} numbers; the answer has ${indexCount(size)}.`);
}

/** @param {Size} size */
function freshIndices(size) {
    try {
        return new Uint32Array(indexCount(size));
    } catch {
        throw new KnotworkError('OUT_OF_MEMORY', '', `There is no room for ${indexCount(size)} indices.`);
    }
}

/**
 * @param {import('./core.mjs').Core} core
 * @param {number} handle
 * @param {Size} size
 * @param {Grid} grid
 */
export function fillGrid(core, handle, size, { positions, normals, indices }) {
    const { nu, nv } = size;
    for (let first = 0; first < nu * nv; first += blockPoints) {
        const count = Math.min(blockPoints, nu * nv - first);
        core.ask('surfaceGrid', handle, nu, nv, first, count);
        copyInto(positions, core.block(0, 3 * count), 3 * first);
        copyInto(normals, core.normals(3 * count), 3 * first);
    }
    const key = `${nu} ${nv} ${size.closed}`;
    if (made.get(indices) === key) return;
    fillTriangles(size, indices);
    made.set(indices, key);
}

/**
 * Two triangles a cell; at a closed seam they use the points of the first row or column.
 * @param {Size} size
 * @param {Uint32Array} indices
 */
function fillTriangles({ nu, nv, closed: [closedU, closedV] }, indices) {
    let at = 0;
    for (let i = 0; i + 1 < nu; ++i) {
        const row = i * nv;
        const next = closedU && i + 2 === nu ? 0 : row + nv;
        for (let j = 0; j + 1 < nv; ++j) {
            const right = closedV && j + 2 === nv ? 0 : j + 1;
            indices[at] = row + j;
            indices[at + 1] = next + j;
            indices[at + 2] = next + right;
            indices[at + 3] = row + j;
            indices[at + 4] = next + right;
            indices[at + 5] = row + right;
            at += 6;
        }
    }
}
