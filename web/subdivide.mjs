// Subdivided polygons: the last levels are made where the points go, block by block.

import { options, target } from './check.mjs';
import { KnotworkError } from './errors.mjs';
import { fill } from './samples.mjs';

const fields = /** @type {const} */ (['scheme', 'points', 'closed', 'levels', 'degree', 'tension']);

/**
 * The final polygon of what a `subdivision-curve` is made from. `into` may stand among the fields or
 * in an object of its own.
 * @param {import('./core.mjs').Core} core
 * @param {unknown} given
 * @param {unknown} [more]
 */
export function subdivide(core, given, more) {
    const { into: among, ...spec } = options(given ?? missing(), ['type', ...fields, 'into']);
    const { into = among } = options(more, ['into']);
    const total = core.count('subdivision', core.send(spec));
    try {
        const answer = target(into, 3 * total);
        fill(core, answer, total, 3, (first, count) => {
            core.ask('subdivisionPoints', first, count);
        });
        return answer;
    } finally {
        core.call('dropSubdivision');
    }
}

/** @returns {never} */
function missing() {
    throw new KnotworkError('WRONG_TYPE', '', `Give an object with ${fields.join(', ')}.`);
}
