// Curves and spheres from points.

import { options } from './check.mjs';
import { adopt } from './curve.mjs';

/** @typedef {import('./core.mjs').Core} Core */

/** Where the block has the residuals, after the traits of the curve. */
const residualsStart = 5;

/**
 * The curve that Session::fit or Session::interpolate made, and what it left besides.
 * @param {Core} core
 * @param {number} handle
 */
function answer(core, handle) {
    const curve = adopt(core, handle);
    const [sumOfSquares, rms, max, count] = core.block(residualsStart, 4);
    const parameters = core.bulk(count);
    core.call('dropBulk');
    return { curve, parameters, residuals: { sumOfSquares, rms, max } };
}

/** The B-spline curve nearest to points. @param {Core} core @param {unknown} request */
export function fit(core, request) {
    return answer(core, core.ask('fit', core.send(request)));
}

/** The B-spline curve through points. @param {Core} core @param {unknown} request */
export function interpolate(core, request) {
    return answer(core, core.ask('interpolate', core.send(request)));
}

/**
 * A sphere around points.
 * @param {Core} core
 * @param {unknown} points
 * @param {unknown} given
 */
export function enclosingSphere(core, points, given) {
    const { method } = options(given, ['method']);
    core.ask('enclosingSphere', core.send({ points, method }));
    return { center: core.point(0), radius: core.number(3) };
}
