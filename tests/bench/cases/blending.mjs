// Many points of a blending curve of Bézier curves.
import { sampleBlend, tableOf } from '../peers/typed-array-blend.mjs';
import { work } from './case.mjs';

const amount = 1_000_000;
const locals = 16;

/** @param {object} bFunction */
const specOf = (bFunction) => ({
    type: 'blending-curve',
    bFunction,
    model: { type: 'parametric-curve', name: 'trefoil' },
    form: 'open',
    locals: { count: locals, kind: 'bezier', degree: 3 },
});
const expoRational = { family: 'expo-rational' };
const polynomial = { family: 'polynomial' };

/** @param {any} kw @param {object} bFunction */
function samplesOf(kw, bFunction) {
    const curve = kw.curve(specOf(bFunction));
    const into = new Float64Array(3 * amount);
    return work(() => curve.sample(amount, { into }), () => curve.dispose());
}

/** @param {any} kw */
function loop(kw) {
    const curve = kw.curve(specOf(expoRational));
    const specs = Array.from({ length: locals }, (_, j) => curve.local(j).spec);
    const points = Float64Array.from(specs.flatMap((spec) => spec.points.flat()));
    const domains = Float64Array.from(specs.flatMap((spec) => spec.domain));
    const knots = Float64Array.from(curve.knots);
    const table = tableOf(kw.bFunction(expoRational));
    const xyz = new Float64Array(3 * amount);
    return work(() => (sampleBlend(points, domains, knots, table, amount, xyz), xyz));
}

/** @type {import('./case.mjs').Case[]} */
export const blendingCases = [{
    name: 'blending curve of 16 Bézier curves by ERB, 1 000 000 samples',
    unit: 'point',
    amount,
    ours: (kw) => samplesOf(kw, expoRational),
    peers: [
        { name: 'typed-array loop, a table', tolerance: 1e-9, atLeast: 6, work: loop },
        {
            name: 'ours by 3t² − 2t³',
            tolerance: Infinity,  // another curve: what is compared is the cost of its B-function
            atMost: 1.5,
            work: (kw) => samplesOf(kw, polynomial),
        },
    ],
}];
