// How many times faster one of two ways is, on a machine whose speed drifts by a factor of two:
// both alternate inside one process, and the ratio of their medians is what counts.

const rounds = 9;
const tries = 3;

/** @typedef {() => number} Clock milliseconds */

/** @param {() => void} act @param {Clock} clock @returns {number} milliseconds */
function timeOnce(act, clock) {
    const start = clock();
    act();
    return clock() - start;
}

/** @param {() => void} act @param {Clock} clock */
function bestOf(act, clock) {
    let best = Infinity;
    for (let i = 0; i < tries; ++i) best = Math.min(best, timeOnce(act, clock));
    return best;
}

/** @param {number[]} values */
export function median(values) {
    const sorted = [...values].sort((a, b) => a - b);
    const middle = sorted.length >> 1;
    return sorted.length % 2 === 1 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
}

/**
 * Nine alternations of the best of three calls of `ours` and one call of `theirs`, after one call
 * of each that nobody measures (compilation, first memory).
 * @param {() => void} ours
 * @param {() => void} theirs
 * @param {Clock} [clock]
 * @returns {{ ratio: number, ours: number, theirs: number }} milliseconds are medians
 */
export function compare(ours, theirs, clock = () => performance.now()) {
    ours();
    theirs();
    /** @type {number[]} */
    const oursTimes = [];
    /** @type {number[]} */
    const theirTimes = [];
    for (let i = 0; i < rounds; ++i) {
        oursTimes.push(bestOf(ours, clock));
        theirTimes.push(timeOnce(theirs, clock));
    }
    const result = { ours: median(oursTimes), theirs: median(theirTimes) };
    return { ...result, ratio: result.theirs / result.ours };
}

/**
 * The largest difference of two lists. Lists of different length differ infinitely, and so do
 * lists with a number that is none.
 * @param {ArrayLike<number>} a
 * @param {ArrayLike<number>} b
 */
export function largestDifference(a, b) {
    if (a.length !== b.length) return Infinity;
    let largest = 0;
    for (let i = 0; i < a.length; ++i) {
        const difference = Math.abs(a[i] - b[i]);
        if (Number.isNaN(difference)) return Infinity;
        if (difference > largest) largest = difference;
    }
    return largest;
}
