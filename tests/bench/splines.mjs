// The splines that are measured: the same numbers on every machine.

/**
 * A clamped spline without weights.
 * @typedef {{ degree: number, knots: number[], points: number[][] }} Spline
 */

/** Numbers in [0, 1) from a seed (a linear congruence of Knuth's). @param {number} seed */
export function randomNumbers(seed) {
    let state = seed >>> 0;
    return () => {
        state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
        return state / 2 ** 32;
    };
}

/** Points within ±20. @param {number} count @param {() => number} random */
export function randomPoints(count, random) {
    const coordinate = () => 40 * random() - 20;
    return Array.from({ length: count }, () => [coordinate(), coordinate(), coordinate()]);
}

/**
 * Spans between 0.3 and 1.7, so that nobody can use that the knots are uniform.
 * @param {number} degree
 * @param {number} count of points
 * @param {number} seed
 * @returns {Spline}
 */
export function clampedSpline(degree, count, seed) {
    const random = randomNumbers(seed);
    const knots = new Array(degree + 1).fill(0);
    for (let t = 0; knots.length < count;) knots.push((t += 0.3 + 1.4 * random()));
    const end = knots[knots.length - 1] + 1;
    for (let i = 0; i <= degree; ++i) knots.push(end);
    return { degree, knots, points: randomPoints(count, random) };
}

/** `count` parameters over the domain, both ends included. @param {Spline} spline @param {number} count */
export function uniformParameters({ degree, knots }, count) {
    const start = knots[degree];
    const length = knots[knots.length - 1 - degree] - start;
    return Float64Array.from({ length: count }, (_, i) => start + length * i / (count - 1));
}
