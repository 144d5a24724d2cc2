// The basis functions that are not zero, d + 1 at each parameter.
import { calcBasisFunctions, findSpan } from 'three/examples/jsm/curves/NURBSUtils.js';

/** @param {import('../splines.mjs').Spline} spline @returns {(ts: Float64Array, values: Float64Array) => void} */
export function threeBasis({ degree, knots }) {
    return (ts, values) => {
        let at = 0;
        for (let i = 0; i < ts.length; ++i) {
            const active = calcBasisFunctions(findSpan(degree, ts[i], knots), ts[i], degree, knots);
            for (let j = 0; j <= degree; ++j) values[at++] = active[j];
        }
    };
}
