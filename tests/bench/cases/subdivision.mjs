// A closed polygon of 100 points, Lane–Riesenfeld of degree 3 to 1.6 million points.
import { subdivide, SUBDIV_CUBIC } from '@thi.ng/geom-subdiv-curve';

import { laneRiesenfeld } from '../peers/typed-array-subdivision.mjs';
import { randomNumbers, randomPoints } from '../splines.mjs';
import { work } from './case.mjs';

const levels = 14;
const polygon = randomPoints(100, randomNumbers(8));
const amount = polygon.length * 2 ** levels;

/**
 * One polygon begins elsewhere than the other: the sums of all coordinates, and of their squares.
 * @param {Float64Array} xyz
 */
function moments(xyz) {
    const sums = new Float64Array(6);
    for (let i = 0; i < xyz.length; ++i) {
        sums[i % 3] += xyz[i] / amount;
        sums[3 + i % 3] += xyz[i] ** 2 / amount;
    }
    return sums;
}

/** @type {import('./case.mjs').Case[]} */
export const subdivisionCases = [{
    name: 'Lane–Riesenfeld of degree 3, 100 points to 1.6 million',
    unit: 'point',
    amount,
    ours(kw) {
        const points = Float64Array.from(polygon.flat());
        const into = new Float64Array(3 * amount);
        const spec = { scheme: 'lane-riesenfeld', degree: 3, closed: true, levels, points };
        return { ...work(() => kw.subdivide(spec, { into })), digest: moments };
    },
    peers: [
        {
            name: '@thi.ng/geom-subdiv-curve',
            tolerance: 1e-9,
            atLeast: 250,
            work: () => ({
                act: () => subdivide(polygon, new Array(levels).fill(SUBDIV_CUBIC), true),
                dispose() {},
                digest: (/** @type {number[][]} */ points) => moments(Float64Array.from(points.flat())),
            }),
        },
        {
            name: 'typed-array loop',
            tolerance: 1e-9,
            atLeast: 3,
            work() {
                const points = Float64Array.from(polygon.flat());
                return { ...work(() => laneRiesenfeld(points, levels)), digest: moments };
            },
        },
    ],
}];
