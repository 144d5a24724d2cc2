// Arguments and answers of the operations on B-spline curves.

import { choice, lengthOfNumbers, numbers } from './check.mjs';
import { KnotworkError } from './errors.mjs';

/** As many as 100 000 points of degree 25 have; the core says what fits the curve. */
const mostKnots = 100_026;

const algorithms = /** @type {const} */ (['oslo', 'boehm']);

/** @param {unknown} algorithm */
export const boehmOrOslo = (algorithm = 'oslo') => choice(algorithm, 'algorithm', algorithms) === 'boehm';

/** @param {unknown} knots */
export function refinedKnots(knots) {
    const full = numbers(knots, 'knots');
    const length = lengthOfNumbers(full);
    if (length <= mostKnots) return full;
    throw new KnotworkError('TOO_LARGE', 'knots', `${length} knots given; at most ${mostKnots} are supported.`);
}

/** @param {Float64Array} flat @param {number} columns */
export function matrixRows(flat, columns) {
    return Array.from({ length: flat.length / columns },
        (_, row) => Array.from(flat.subarray(row * columns, (row + 1) * columns)));
}

/** T_k has k rows of k + 1; one after the other they fill the list. @param {Float64Array} flat */
export function factorRows(flat) {
    const matrices = [];
    for (let k = 1, at = 0; at < flat.length; at += k * (k + 1), ++k) {
        matrices.push(matrixRows(flat.subarray(at, at + k * (k + 1)), k + 1));
    }
    return matrices;
}

/** @param {{ curves: any[], deviation: number | null, removed: boolean }} answer JSON knows no Infinity */
export function removal({ curves, deviation, removed }) {
    return { curve: curves[0], deviation: deviation ?? Infinity, removed };
}
