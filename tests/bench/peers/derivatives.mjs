// Points with their first two derivatives at given parameters: all points, then all first
// derivatives, then all second ones.
import { nurbs, verb } from './packages.mjs';

/** @typedef {import('../splines.mjs').Spline} Spline */
/** @typedef {(ts: Float64Array, rows: Float64Array) => void} DerivativeSampler */

/** @param {Spline} spline @returns {DerivativeSampler} */
export function nurbsDerivatives(spline) {
    const curve = nurbs({ points: spline.points, degree: spline.degree, knots: [spline.knots] });
    const evaluators = [curve.evaluate, curve.evaluator(1), curve.evaluator(2)];
    const row = [0, 0, 0];
    return (ts, rows) => {
        for (const [k, evaluate] of evaluators.entries()) {
            let at = 3 * k * ts.length;
            for (let i = 0; i < ts.length; ++i, at += 3) {
                evaluate(row, ts[i]);
                rows[at] = row[0];
                rows[at + 1] = row[1];
                rows[at + 2] = row[2];
            }
        }
    };
}

/** @param {Spline} spline @returns {DerivativeSampler} */
export function verbDerivatives(spline) {
    const data = new verb.core.NurbsCurveData(spline.degree, spline.knots, spline.points);
    return (ts, rows) => {
        for (let i = 0; i < ts.length; ++i) {
            const derivatives = verb.eval.Eval.curveDerivatives(data, ts[i], 2);
            for (let k = 0; k < 3; ++k) {
                const at = 3 * (k * ts.length + i);
                rows[at] = derivatives[k][0];
                rows[at + 1] = derivatives[k][1];
                rows[at + 2] = derivatives[k][2];
            }
        }
    };
}
