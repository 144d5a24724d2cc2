// The same C++ natively: what WebAssembly costs.
import { existsSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

import { converse } from '../peers/conversation.mjs';
import { clampedSpline, uniformParameters } from '../splines.mjs';
import { work } from './case.mjs';
import { specOf } from './curves.mjs';

const program = fileURLToPath(new URL('../../../build/native-bench/knotwork_bench', import.meta.url));
const mostTimes = 2.5;

/** As the program has them: means of each third number, and of their squares. @param {Float64Array} numbers */
function moments(numbers) {
    const sums = new Float64Array(6);
    for (let i = 0; i < numbers.length; ++i) {
        sums[i % 3] += numbers[i] / numbers.length;
        sums[3 + i % 3] += numbers[i] ** 2 / numbers.length;
    }
    return sums;
}

/**
 * @param {string} name
 * @param {'samples' | 'derivatives' | 'basis'} task
 * @param {object} curve
 * @param {number} amount
 * @param {(kw: any) => import('./case.mjs').Work} ours
 * @returns {import('./case.mjs').Case}
 */
const against = (name, task, curve, amount, ours) => ({
    name: `${name}, natively`,
    unit: 'point',
    amount,
    ours: (kw) => ({ ...ours(kw), digest: moments }),
    peers: [{
        name: 'the same C++, g++ -O3',
        tolerance: 1e-9,
        atMost: mostTimes,
        work: () => (existsSync(program)
            ? converse(program, [], { task, curve, amount })
            : 'build/native-bench is not built'),
    }],
});

/** @param {object} curve @param {number} amount */
const samples = (curve, amount) => (/** @type {any} */ kw) => {
    const made = kw.curve(curve);
    const into = new Float64Array(3 * amount);
    return work(() => made.sample(amount, { into }));
};

const million = 1_000_000;
const cubicSpline = clampedSpline(3, 20, 1);
const cubic = specOf(cubicSpline);
const ts = uniformParameters(cubicSpline, million);
const nonic = specOf(clampedSpline(9, 64, 4));
const blend = {
    type: 'blending-curve', bFunction: { family: 'expo-rational' }, form: 'open',
    model: { type: 'parametric-curve', name: 'trefoil' }, locals: { count: 16, kind: 'bezier', degree: 3 },
};

/** @type {import('./case.mjs').Case[]} */
export const nativeCases = [
    against('clamped cubic', 'samples', cubic, million, samples(cubic, million)),
    against('with two derivatives', 'derivatives', cubic, million, (kw) => {
        const made = kw.curve(cubic);
        const into = new Float64Array(9 * million);
        return work(() => made.sampleAt(ts, { derivatives: 2, into }));
    }),
    against('degree 9', 'samples', nonic, 100_000, samples(nonic, 100_000)),
    against('basis functions', 'basis', cubic, million, (kw) => {
        const made = kw.curve(cubic);
        let into = made.basisAt(ts);
        return work(() => (into = made.basisAt(ts, { into })).values);
    }),
    against('blending curve by ERB', 'samples', blend, million, samples(blend, million)),
];
