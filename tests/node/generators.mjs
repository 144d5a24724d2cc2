// Random curves, B-functions and places on them, for the tests of properties.
import fc from 'fast-check';

fc.configureGlobal({
    seed: Number(process.env.KNOTWORK_SEED ?? 20_240_711),
    numRuns: 300 * Number(process.env.KNOTWORK_CASES ?? 1),
    endOnFailure: false,
    includeErrorInReport: true,
});

/** @param {import('fast-check').IPropertyWithHooks<any>} property @param {object} [options] */
export const holds = (property, options) => fc.assert(property, options);

/** Their squares do not vanish: torsion and curvature have such in their formulas. */
export const coordinate = fc.double({ min: -1, max: 1, noNaN: true }).map((x) => (Math.abs(x) < 1e-40 ? 0 : x));
export const share = fc.double({ min: 0, max: 1, noNaN: true });
/** Equal knots, nearly equal ones and others. */
export const gap = fc.oneof(fc.constant(0), fc.integer({ min: -9, max: -5 }).map((k) => 10 ** k), fc.double({ min: 0.1, max: 2, noNaN: true }));

/** Gaps between knots of which no more than `most` are 0 in a row, and the one at `ordinary` is 1. */
function fromGaps(gaps, most, ordinary) {
    let zeros = 0;
    return gaps.map((one, i) => {
        zeros = one === 0 ? zeros + 1 : 0;
        if (i !== ordinary && zeros < most) return one;
        zeros = 0;
        return 1;
    });
}

/** Knots with these gaps. */
export const added = (gaps, start = 0) => gaps.reduce((knots, one) => [...knots, knots.at(-1) + one], [start]);

/** One knot vector of each form for n points. */
function knotsOf(form, degree, gaps, n) {
    if (form === 'closed') return added(fromGaps(gaps.slice(0, n), degree, n - 1));
    if (form === 'open') return added(fromGaps(gaps.slice(0, n + degree), degree, degree));
    const inner = added(fromGaps(gaps.slice(0, n - degree), degree + 1, 0).map((one, i, all) =>
        (i === all.length - 1 && one === 0 ? 1 : one)));
    return [...Array(degree).fill(inner[0]), ...inner, ...Array(degree).fill(inner.at(-1))];
}

/** @param {import('fast-check').Arbitrary<number>} one between knots */
const splineWith = (one) => fc.record({
    degree: fc.integer({ min: 1, max: 7 }),
    form: fc.constantFrom('clamped', 'open', 'closed'),
    more: fc.integer({ min: 1, max: 8 }),
    gaps: fc.array(one, { minLength: 24, maxLength: 24 }),
    points: fc.array(fc.array(coordinate, { minLength: 3, maxLength: 3 }), { minLength: 15, maxLength: 15 }),
    weights: fc.option(fc.array(fc.double({ min: 0.3, max: 3, noNaN: true }), { minLength: 15, maxLength: 15 })),
}).map(({ degree, form, more, gaps, points, weights }) => {
    const n = degree + more;
    return {
        type: 'bspline-curve', degree, form, points: points.slice(0, n), knots: knotsOf(form, degree, gaps, n),
        ...(weights ? { weights: weights.slice(0, n) } : {}),
    };
});
export const spline = splineWith(gap);
/** Knots are equal or well apart: of nearly equal ones higher derivatives are mostly rounding. */
export const gentleSpline = splineWith(fc.oneof(fc.constant(0), fc.double({ min: 0.1, max: 2, noNaN: true })));

/** Both ends, every knot and one parameter between, each from both sides. */
export function places(curve, between) {
    const [a, b] = curve.domain;
    const inside = (curve.knots ?? []).filter((t) => a <= t && t <= b);
    return [a, b, Math.min(b, a + between * (b - a)), ...new Set(inside)].flatMap((t) => [{ t, side: 'left' }, { t, side: 'right' }]);
}

export const distance = (p, q) => Math.hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);

export const number = (min, max) => fc.double({ min, max, noNaN: true });
export const family = fc.oneof(
    fc.constant({ family: 'linear' }),
    fc.record({ family: fc.constant('trigonometric'), order: fc.integer({ min: 1, max: 20 }) }),
    fc.record({ family: fc.constant('polynomial'), p: fc.integer({ min: 0, max: 20 }), q: fc.integer({ min: 0, max: 20 }) }),
    fc.record({ family: fc.constant('rational'), m: number(1, 50), c: number(1e-3, 1000) }),
    fc.record({ family: fc.constant('expo-rational'), alpha: number(0.01, 4), beta: number(0.01, 100), gamma: number(0.01, 4), lambda: number(0.01, 0.99) }),
    fc.record({ family: fc.constant('logistic'), c: number(1e-3, 1000) }),
);
export const { blend } = fc.letrec((tie) => ({
    blend: fc.oneof({ maxDepth: 3 }, family, family,
        fc.record({ family: fc.constantFrom('dual', 'symmetrised'), of: tie('blend') }),
        fc.record({ family: fc.constant('composed'), outer: tie('blend'), inner: tie('blend') }),
        fc.record({ family: fc.constant('mixed'), of: fc.tuple(tie('blend'), tie('blend')), weight: share })),
}));

/** Makes the curve, runs `act` with it, disposes of it. */
export function withCurve(kw, spec, act) {
    const curve = kw.curve(spec);
    try {
        act(curve);
    } finally {
        curve.dispose();
    }
}
