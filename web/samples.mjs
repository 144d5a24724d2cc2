// Many numbers out of the module: in blocks that stay in the processor's first cache.

import { copyInto, isInt32Array, isPlain, lengthOfNumbers, partOf, target } from './check.mjs';
import { blockPoints } from './core.mjs';
import { describe, KnotworkError, reading } from './errors.mjs';

/**
 * Fills `answer` with `total` rows of `width` numbers; `compute(first, count)` leaves rows in the block.
 * @param {import('./core.mjs').Core} core
 * @param {Float64Array} answer
 * @param {number} total
 * @param {number} width
 * @param {(first: number, count: number) => void} compute
 */
export function fill(core, answer, total, width, compute) {
    for (let first = 0; first < total; first += blockPoints) {
        const count = Math.min(blockPoints, total - first);
        compute(first, count);
        copyInto(answer, core.block(0, width * count), width * first);
    }
}

/**
 * Points and derivatives at given parameters: all positions, then all first derivatives, ….
 * @param {import('./core.mjs').Core} core
 * @param {number} handle
 * @param {Float64Array} ts
 * @param {number} derivatives
 * @param {Float64Array} answer
 */
export function fillAt(core, handle, ts, derivatives, answer) {
    const total = lengthOfNumbers(ts);
    const most = Math.floor(blockPoints / (derivatives + 1));
    for (let first = 0; first < total; first += most) {
        const count = Math.min(most, total - first);
        core.sendParameters(partOf(ts, first, count));
        core.ask('curveAt', handle, first, count, derivatives);
        for (let k = 0; k <= derivatives; ++k) {
            copyInto(answer, core.block(3 * count * k, 3 * count), 3 * (total * k + first));
        }
    }
}

/**
 * @typedef {{ values: Float64Array, first: Int32Array }} BasisValues
 */

/**
 * Where the basis functions at `count` parameters go: the lists of an earlier answer, or new ones.
 * @param {unknown} into
 * @param {number} count
 * @param {number} width
 * @returns {BasisValues}
 */
export function basisTarget(into, count, width) {
    if (into === undefined) {
        return { values: target(undefined, width * count), first: new Int32Array(count) };
    }
    const { values, first } = earlierBasis(into);
    if (!isInt32Array(first)) {
        throw new KnotworkError('WRONG_TYPE', 'into.first', `into.first must be an Int32Array, not ${describe(first)}.`);
    }
    if (lengthOfNumbers(first) !== count) {
        throw new KnotworkError('WRONG_LENGTH', 'into.first',
            `into.first has ${lengthOfNumbers(first)} numbers; the answer has ${count}.`);
    }
    return { values: target(values ?? null, width * count), first };
}

/** The two lists of an earlier answer, each read once. @param {unknown} into */
function earlierBasis(into) {
    return reading(() => 'into', () => {
        if (typeof into !== 'object' || into === null || !isPlain(into)) {
            throw new KnotworkError('WRONG_TYPE', 'into', `into must be an earlier answer, not ${describe(into)}.`);
        }
        const { values, first } = /** @type {Record<string, unknown>} */ (into);
        return { values, first };
    });
}

/**
 * @param {import('./core.mjs').Core} core
 * @param {number} handle
 * @param {Float64Array} ts
 * @param {number} width
 * @param {BasisValues} answer
 */
export function fillBasis(core, handle, ts, width, { values, first }) {
    const total = lengthOfNumbers(ts);
    const most = Math.min(blockPoints, Math.floor(3 * blockPoints / width));
    for (let from = 0; from < total; from += most) {
        const count = Math.min(most, total - from);
        core.sendParameters(partOf(ts, from, count));
        core.ask('curveBasisAt', handle, from, count);
        copyInto(values, core.block(0, width * count), width * from);
        copyInto(first, core.integers(count), from);
    }
}
