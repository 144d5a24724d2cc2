// A thousand knots into a cubic of a hundred points.
import { verb } from '../peers/packages.mjs';
import { clampedSpline, randomNumbers } from '../splines.mjs';
import { work } from './case.mjs';
import { specOf } from './curves.mjs';

const inserted = 1000;
const spline = clampedSpline(3, 100, 6);

function newKnots() {
    const random = randomNumbers(7);
    const start = spline.knots[0];
    const length = spline.knots[spline.knots.length - 1] - start;
    return Array.from({ length: inserted }, () => start + length * (0.001 + 0.998 * random())).sort((a, b) => a - b);
}

/** @type {import('./case.mjs').Case[]} */
export const refinementCases = [{
    name: 'refinement of a cubic of 100 points by 1 000 knots',
    unit: 'knot',
    amount: inserted,
    ours(kw) {
        const all = Float64Array.from([...spline.knots, ...newKnots()]).sort();
        const spec = specOf(spline);
        const points = inserted + spline.points.length;
        const into = new Float64Array(3 * points);
        return work(() => {
            const curve = kw.curve(spec);
            const refined = curve.refine(all);
            refined.controlPoints({ into });
            curve.dispose();
            refined.dispose();
            return into;
        });
    },
    peers: [{
        name: 'verb-nurbs-web',
        tolerance: 1e-12,
        atLeast: 45,
        work() {
            const knots = newKnots();
            return work(() => {
                const data = new verb.core.NurbsCurveData(spline.degree, spline.knots, spline.points);
                const refined = verb.eval.Modify.curveKnotRefine(data, knots);
                return Float64Array.from(refined.controlPoints.flat());
            });
        },
    }],
}];
