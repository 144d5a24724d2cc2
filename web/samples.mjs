// Many numbers out of the module: in blocks that stay in the processor's first cache.

import { copyInto } from './check.mjs';
import { blockPoints } from './core.mjs';

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
    const total = ts.length;
    const most = Math.floor(blockPoints / (derivatives + 1));
    for (let first = 0; first < total; first += most) {
        const count = Math.min(most, total - first);
        core.sendParameters(ts.subarray(first, first + count));
        core.ask('curveAt', handle, first, count, derivatives);
        for (let k = 0; k <= derivatives; ++k) {
            copyInto(answer, core.block(3 * count * k, 3 * count), 3 * (total * k + first));
        }
    }
}
