// Least squares: 10 000 points, 100 control points.
import { scipy } from '../peers/scipy.mjs';
import { randomNumbers } from '../splines.mjs';
import { work } from './case.mjs';

const amount = 10_000;
const count = 100;
const degree = 3;

/** A noisy curve with the parameters of its points. */
function data() {
    const random = randomNumbers(9);
    const points = new Float64Array(3 * amount);
    const parameters = Float64Array.from({ length: amount }, (_, i) => i / (amount - 1));
    for (let i = 0; i < amount; ++i) {
        const t = 20 * parameters[i];
        points[3 * i] = t + 0.01 * random();
        points[3 * i + 1] = Math.sin(t) + 0.01 * random();
        points[3 * i + 2] = Math.cos(1.7 * t) + 0.01 * random();
    }
    return { points, parameters };
}

/** Clamped over [0, 1], uniform inside. */
function knots() {
    const inner = Array.from({ length: count - degree - 1 }, (_, i) => (i + 1) / (count - degree));
    return Float64Array.from([0, 0, 0, 0, ...inner, 1, 1, 1, 1]);
}

/** @type {import('./case.mjs').Case[]} */
export const fittingCases = [{
    name: 'least squares, 10 000 points to 100 control points',
    unit: 'point',
    amount,
    ours(kw) {
        const given = { ...data(), degree, count, knots: knots() };
        const into = new Float64Array(3 * count);
        return work(() => {
            const { curve } = kw.fit(given);
            curve.controlPoints({ into });
            curve.dispose();
            return into;
        });
    },
    peers: [{
        name: 'scipy make_lsq_spline',
        tolerance: 1e-9,
        atLeast: 4,
        work: () => scipy({ ...data(), degree, knots: knots() }),
    }],
}];
