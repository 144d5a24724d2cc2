// Curves and spheres from points.

import { options } from './check.mjs';
import { adopt } from './curve.mjs';

/** @typedef {import('./core.mjs').Core} Core */

/** Where the block has the residuals, after the traits of the curve. */
const residualsStart = 5;

/**
 * The curve that a call has made, and what it left besides. Parameters that were given are answered
 * as they are: a copy would cost a third of a fit.
 * @param {Core} core
 * @param {'fit' | 'interpolate'} name
 * @param {any} request
 */
function made(core, name, request) {
    const curve = adopt(core, core.ask(name, core.send(request)));
    const [sumOfSquares, rms, max, count] = core.block(residualsStart, 4);
    return { curve, parameters: count > 0 ? found(core, count) : numbers(request.parameters), residuals: { sumOfSquares, rms, max } };
}

/** @param {Core} core @param {number} count */
function found(core, count) {
    const parameters = core.bulk(count);
    core.call('dropBulk');
    return parameters;
}

/** @param {ArrayLike<number>} list */
const numbers = (list) => (list instanceof Float64Array ? list : Float64Array.from(list));

/** The B-spline curve nearest to points. @param {Core} core @param {unknown} request */
export function fit(core, request) {
    return made(core, 'fit', request);
}

/** The B-spline curve through points. @param {Core} core @param {unknown} request */
export function interpolate(core, request) {
    return made(core, 'interpolate', request);
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
