// The npm packages that we are measured against, each in the fastest way that it documents.
import { createRequire } from 'node:module';

import { Vector3, Vector4 } from 'three';
import { NURBSCurve } from 'three/examples/jsm/curves/NURBSCurve.js';

import { prepare, sample } from './typed-array-loop.mjs';

/** @typedef {import('./splines.mjs').Spline} Spline */

/**
 * One way to sample: `make` builds a curve; what it returns fills triples uniformly over the domain.
 * @typedef {(count: number, xyz: Float64Array) => void} Sampler
 * @typedef {{ name: string, npm: boolean, make: (spline: Spline) => Sampler }} Peer
 */

const require = createRequire(import.meta.url);

/** verb greets on standard output when it is loaded. */
function quietly(name) {
    const { log } = console;
    console.log = () => {};
    try {
        return require(name);
    } finally {
        console.log = log;
    }
}

const nurbs = require('nurbs');
const verb = quietly('verb-nurbs-web');

/** @param {Spline} spline @returns {[number, number]} */
function domainOf({ degree, knots }) {
    return [knots[degree], knots[knots.length - 1 - degree]];
}

/** @type {Peer} */
const nurbsPackage = {
    name: 'nurbs',
    npm: true,
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
const threePackage = {
    name: 'three NURBSCurve',
    npm: true,
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
const verbPackage = {
    name: 'verb-nurbs-web',
    npm: true,
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
const typedArrayLoop = {
    name: 'typed-array loop',
    npm: false,
    make(spline) {
        const prepared = prepare(spline);
        return (count, xyz) => sample(prepared, count, xyz);
    },
};

export const peers = [nurbsPackage, threePackage, verbPackage, typedArrayLoop];
