// How many times faster one of two ways is, on a machine whose speed drifts by a factor of two:
// both alternate inside one process, and the ratio of their medians is what counts.

const usualRounds = 9;
const tries = 3;
const warmth = 200;  // milliseconds

/** @typedef {() => number} Clock milliseconds */
/**
 * What is measured: work in this process, or in another one that says how long it took.
 * @typedef {{ act: () => unknown } | { time: () => Promise<number> }} Timed
 */

/** @param {Timed} work @param {Clock} clock @returns {Promise<number>} milliseconds */
async function timeOnce(work, clock) {
    if ('time' in work) return work.time();
    const start = clock();
    work.act();
    return clock() - start;
}

/** @param {Timed} work @param {Clock} clock */
async function bestOf(work, clock) {
    let best = Infinity;
    for (let i = 0; i < tries; ++i) best = Math.min(best, await timeOnce(work, clock));
    return best;
}

/** @param {number[]} values */
export function median(values) {
    const sorted = [...values].sort((a, b) => a - b);
    const middle = sorted.length >> 1;
    return sorted.length % 2 === 1 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
}

/**
 * As often as it takes for engines to have compiled what is called often, once at least.
 * @param {Timed} work
 * @param {Clock} clock
 */
async function warmUp(work, clock) {
    const start = clock();
    do await timeOnce(work, clock); while (clock() - start < warmth);
}

/**
 * Nine alternations of the best of three calls of `ours` and one call of `theirs`, after calls of
 * each that nobody measures (compilation, first memory).
 * @param {Timed} ours
 * @param {Timed} theirs
 * @param {Clock} [clock]
 * @param {number} [rounds] fewer where one call takes many seconds
 * @returns {Promise<{ ratio: number, ours: number, theirs: number }>} milliseconds are medians
 */
export async function compare(ours, theirs, clock = () => performance.now(), rounds = usualRounds) {
    await warmUp(ours, clock);
    await warmUp(theirs, clock);
    /** @type {number[]} */
    const oursTimes = [];
    /** @type {number[]} */
    const theirTimes = [];
    for (let i = 0; i < rounds; ++i) {
        oursTimes.push(await bestOf(ours, clock));
        theirTimes.push(await timeOnce(theirs, clock));
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
