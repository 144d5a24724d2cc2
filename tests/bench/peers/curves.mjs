// Who samples B-spline curves, each in the fastest way that it documents.
import { Vector3, Vector4 } from 'three';
import { NURBSCurve } from 'three/examples/jsm/curves/NURBSCurve.js';

import { nurbs, verb } from './packages.mjs';
import { prepare, sample } from './typed-array-curve.mjs';

/** @typedef {import('../splines.mjs').Spline} Spline */

/**
 * One way to sample: `make` builds a curve; what it returns fills triples uniformly over the domain.
 * @typedef {(count: number, xyz: Float64Array) => void} Sampler
 * @typedef {{ name: string, make: (spline: Spline) => Sampler }} Peer
 */

/** @param {Spline} spline @returns {[number, number]} */
export function domainOf({ degree, knots }) {
    return [knots[degree], knots[knots.length - 1 - degree]];
}

/** @type {Peer} */
export const nurbsPackage = {
    name: 'nurbs',
    make(spline) {
        const { evaluate } = nurbs({
            points: spline.points, degree: spline.degree, knots: [spline.knots],
        });
        const [start, end] = domainOf(spline);
        const point = [0, 0, 0];
        return (count, xyz) => {
            for (let i = 0; i < count; ++i) {
                evaluate(point, start + ((end - start) * i) / (count - 1));
                xyz[3 * i] = point[0];
                xyz[3 * i + 1] = point[1];
                xyz[3 * i + 2] = point[2];
            }
        };
    },
};

/** @type {Peer} */
export const threePackage = {
    name: 'three NURBSCurve',
    make({ degree, knots, points }) {
        const control = points.map(([x, y, z]) => new Vector4(x, y, z, 1));
        const curve = new NURBSCurve(degree, knots, control);
        const point = new Vector3();
        return (count, xyz) => {
            for (let i = 0; i < count; ++i) {
                curve.getPoint(i / (count - 1), point);
                xyz[3 * i] = point.x;
                xyz[3 * i + 1] = point.y;
                xyz[3 * i + 2] = point.z;
            }
        };
    },
};

/** @type {Peer} */
export const verbPackage = {
    name: 'verb-nurbs-web',
    make(spline) {
        const data = new verb.core.NurbsCurveData(spline.degree, spline.knots, spline.points);
        const [start, end] = domainOf(spline);
        return (count, xyz) => {
            for (let i = 0; i < count; ++i) {
                const t = start + ((end - start) * i) / (count - 1);
                const point = verb.eval.Eval.curvePoint(data, t);
                xyz[3 * i] = point[0];
                xyz[3 * i + 1] = point[1];
                xyz[3 * i + 2] = point[2];
            }
        };
    },
};

/** @type {Peer} */
export const typedArrayLoop = {
    name: 'typed-array loop',
    make(spline) {
        const prepared = prepare(spline);
        return (count, xyz) => sample(prepared, count, xyz);
    },
};

export const peers = [nurbsPackage, threePackage, verbPackage, typedArrayLoop];
