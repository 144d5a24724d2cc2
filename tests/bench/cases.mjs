// What is measured: the same work done by us and by a peer.
import { clampedSpline, randomNumbers, randomPoints } from './splines.mjs';

/** @typedef {import('./peers.mjs').Peer} Peer */
/** @typedef {{ act: () => Float64Array, dispose: () => void }} Work */

/**
 * @typedef {object} Case
 * @property {string} name
 * @property {number} points computed in one act
 * @property {number} tolerance of the difference between our result and a peer's
 * @property {number} [limit] how many times faster than the best npm peer we promise to be
 * @property {(kw: any) => Work} ours
 * @property {(peer: Peer) => Work} theirs
 */

const nothing = () => {};
const rounding = 1e-12;  // of coordinates up to 20, through the peers' own parameters

/** @param {import('./splines.mjs').Spline} spline */
function specOf({ degree, knots, points }) {
    return { type: 'bspline-curve', degree, form: 'clamped', points, knots };
}

/** @returns {Case} */
function manySamples() {
    const points = 1_000_000;
    const spline = clampedSpline(3, 20, 1);
    return {
        name: 'clamped cubic, 20 points, 1 000 000 samples',
        points,
        tolerance: rounding,
        limit: 10,
        ours(kw) {
            const curve = kw.curve(specOf(spline));
            const into = new Float64Array(3 * points);
            return { act: () => curve.sample(points, { into }), dispose: () => curve.dispose() };
        },
        theirs(peer) {
            const sample = peer.make(spline);
            const xyz = new Float64Array(3 * points);
            return { act: () => (sample(points, xyz), xyz), dispose: nothing };
        },
    };
}

/**
 * The curve under someone's hand: all 20 points change, 1 000 samples are taken, the curve goes.
 * @returns {Case}
 */
function changedCurve() {
    const points = 1000;
    const spline = clampedSpline(3, 20, 2);
    /** Two polygons in turn, so that no one can keep the last result. */
    const turns = () => {
        const random = randomNumbers(3);
        const polygons = [0, 1].map(() => ({ ...spline, points: randomPoints(20, random) }));
        let turn = 0;
        return () => polygons[turn++ % 2];
    };
    return {
        name: 'clamped cubic, 20 points changed, 1 000 samples',
        points: 20 * points,
        tolerance: rounding,
        ours(kw) {
            const next = turns();
            const into = new Float64Array(3 * points);
            return {
                act: repeated(20, () => {
                    const curve = kw.curve(specOf(next()));
                    curve.sample(points, { into });
                    curve.dispose();
                    return into;
                }),
                dispose: nothing,
            };
        },
        theirs(peer) {
            const next = turns();
            const xyz = new Float64Array(3 * points);
            return {
                act: repeated(20, () => {
                    peer.make(next())(points, xyz);
                    return xyz;
                }),
                dispose: nothing,
            };
        },
    };
}

/**
 * Short work, often enough for the clock.
 * @param {number} times
 * @param {() => Float64Array} act
 */
function repeated(times, act) {
    return () => {
        let answer = act();
        for (let i = 1; i < times; ++i) answer = act();
        return answer;
    };
}

/** @type {Case[]} */
export const cases = [manySamples(), changedCurve()];
