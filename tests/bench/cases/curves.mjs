// Many points of a B-spline curve, its derivatives and its basis functions.
import { threeBasis } from '../peers/basis.mjs';
import { nurbsPackage, threePackage, typedArrayLoop, verbPackage } from '../peers/curves.mjs';
import { nurbsDerivatives, verbDerivatives } from '../peers/derivatives.mjs';
import { clampedSpline, randomNumbers, randomPoints, uniformParameters } from '../splines.mjs';
import { repeated, work } from './case.mjs';

/** @typedef {import('./case.mjs').Case} Case */
/** @typedef {import('./case.mjs').Peer} Peer */
/** @typedef {import('../splines.mjs').Spline} Spline */

const rounding = 1e-12;  // of coordinates up to 20, through the peers' own parameters

/** @param {Spline} spline */
export function specOf({ degree, knots, points }) {
    return { type: 'bspline-curve', degree, form: 'clamped', points, knots };
}

/**
 * @param {string} name
 * @param {Spline} spline
 * @param {number} amount
 * @param {[import('../peers/curves.mjs').Peer, number?][]} peers with what is promised
 * @returns {Case}
 */
function manySamples(name, spline, amount, peers) {
    return {
        name,
        unit: 'point',
        amount,
        ours(kw) {
            const curve = kw.curve(specOf(spline));
            const into = new Float64Array(3 * amount);
            return work(() => curve.sample(amount, { into }), () => curve.dispose());
        },
        peers: peers.map(([peer, atLeast]) => ({
            name: peer.name,
            tolerance: spline.degree > 3 ? 10 * rounding : rounding,
            atLeast,
            work() {
                const sample = peer.make(spline);
                const xyz = new Float64Array(3 * amount);
                return work(() => (sample(amount, xyz), xyz));
            },
        })),
    };
}

/**
 * The curve under someone's hand: all 20 points change, 1 000 samples are taken, the curve goes.
 * @returns {Case}
 */
function changedCurve() {
    const points = 1000;
    const turns = 20;
    const spline = clampedSpline(3, 20, 2);
    /** Two polygons in turn, so that no one can keep the last result. */
    const polygons = () => {
        const random = randomNumbers(3);
        const both = [0, 1].map(() => ({ ...spline, points: randomPoints(20, random) }));
        let turn = 0;
        return () => both[turn++ % 2];
    };
    /** @type {[import('../peers/curves.mjs').Peer, number?][]} */
    const peers = [[nurbsPackage, 8], [threePackage], [verbPackage], [typedArrayLoop]];
    return {
        name: 'clamped cubic, 20 points changed, 1 000 samples',
        unit: 'point',
        amount: turns * points,
        ours(kw) {
            const next = polygons();
            const into = new Float64Array(3 * points);
            return work(repeated(turns, () => {
                const curve = kw.curve(specOf(next()));
                curve.sample(points, { into });
                curve.dispose();
                return into;
            }));
        },
        peers: peers.map(([peer, atLeast]) => ({
            name: peer.name,
            tolerance: rounding,
            atLeast,
            work() {
                const next = polygons();
                const xyz = new Float64Array(3 * points);
                return work(repeated(turns, () => {
                    peer.make(next())(points, xyz);
                    return xyz;
                }));
            },
        })),
    };
}

/** @returns {Case} */
function derivatives() {
    const amount = 1_000_000;
    const spline = clampedSpline(3, 20, 1);
    const ts = uniformParameters(spline, amount);
    /** @param {string} name @param {typeof nurbsDerivatives} make @param {number} atLeast @returns {Peer} */
    const peer = (name, make, atLeast) => ({
        name,
        tolerance: 1e-10,  // second derivatives reach a hundred
        atLeast,
        work() {
            const sample = make(spline);
            const rows = new Float64Array(9 * amount);
            return work(() => (sample(ts, rows), rows));
        },
    });
    return {
        name: 'clamped cubic with two derivatives, 1 000 000 parameters',
        unit: 'point',
        amount,
        ours(kw) {
            const curve = kw.curve(specOf(spline));
            const into = new Float64Array(9 * amount);
            return work(() => curve.sampleAt(ts, { derivatives: 2, into }), () => curve.dispose());
        },
        peers: [peer('nurbs', nurbsDerivatives, 9), peer('verb-nurbs-web', verbDerivatives, 35)],
    };
}

/** @returns {Case} */
function basisFunctions() {
    const amount = 1_000_000;
    const spline = clampedSpline(3, 20, 1);
    const ts = uniformParameters(spline, amount);
    return {
        name: 'the four cubic basis functions, 1 000 000 parameters',
        unit: 'parameter',
        amount,
        ours(kw) {
            const curve = kw.curve(specOf(spline));
            let into = curve.basisAt(ts);
            return work(() => (into = curve.basisAt(ts, { into })).values, () => curve.dispose());
        },
        peers: [{
            name: 'three NURBSUtils',
            tolerance: rounding,
            atLeast: 12,
            work() {
                const fill = threeBasis(spline);
                const values = new Float64Array(4 * amount);
                return work(() => (fill(ts, values), values));
            },
        }],
    };
}

/** @type {Case[]} */
export const curveCases = [
    manySamples('clamped cubic, 20 points, 1 000 000 samples', clampedSpline(3, 20, 1), 1_000_000,
        [[nurbsPackage, 18], [threePackage, 25], [verbPackage, 35], [typedArrayLoop, 10]]),
    changedCurve(),
    derivatives(),
    manySamples('degree 9, 64 points, 100 000 samples', clampedSpline(9, 64, 4), 100_000,
        [[nurbsPackage, 15], [threePackage]]),
    basisFunctions(),
];
