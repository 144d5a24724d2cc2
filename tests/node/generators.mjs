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

// Documents of every type of object, and commands on them.

const place2 = fc.tuple(number(-5, 5), number(-5, 5));
const place3 = fc.tuple(number(-5, 5), number(-5, 5), number(-5, 5));
/** @param {number} least @param {number} most */
const places23 = (least, most) => fc.oneof(
    fc.array(place2, { minLength: least, maxLength: most }), fc.array(place3, { minLength: least, maxLength: most }));
const model = fc.constantFrom(
    { type: 'parametric-curve', name: 'circle' }, { type: 'parametric-curve', name: 'trefoil' },
    { type: 'bspline-curve', degree: 2, points: [[0, 0], [1, 2], [3, 3], [5, 0]] });
const net = fc.record({ rows: fc.integer({ min: 3, max: 4 }), row: fc.array(place3, { minLength: 3, maxLength: 5 }) })
    .map(({ rows, row }) => Array.from({ length: rows }, (_, i) => row.map(([x, y, z]) => [x + i, y, z])));

export const sceneObject = fc.oneof(
    spline,
    fc.record({ type: fc.constant('blending-curve'), bFunction: family, model, locals: fc.record({ count: fc.integer({ min: 2, max: 6 }) }) }),
    fc.record({
        type: fc.constant('blending-surface'), bFunction: family,
        model: fc.constantFrom({ type: 'parametric-surface', name: 'torus' }, { type: 'parametric-surface', name: 'plane' }),
        locals: fc.tuple(fc.integer({ min: 2, max: 4 }), fc.integer({ min: 2, max: 4 })),
    }),
    fc.record({ type: fc.constant('bspline-surface'), degree: fc.constantFrom([1, 2], [2, 1]), points: net, form: fc.constantFrom(['clamped', 'closed'], ['open', 'clamped']) }),
    fc.record({ type: fc.constant('subdivision-surface'), levels: fc.integer({ min: 0, max: 2 }), mesh: fc.constantFrom({ solid: 'cube' }, { solid: 'torus' }) }),
    fc.record({ type: fc.constant('point-cloud'), points: places23(4, 8) }),
    fc.record({ type: fc.constant('bezier-curve'), points: places23(2, 5) }),
    fc.record({ type: fc.constant('subdivision-curve'), scheme: fc.constantFrom('lane-riesenfeld', 'chaikin', 'four-point'), points: places23(4, 6) }),
    fc.constantFrom(
        { type: 'formula-curve', x: 't', y: 'sin(t)', domain: [0, 3] }, { type: 'line-curve', from: [0, 0], to: [1, 2] },
        { type: 'arc-curve', at: 0, point: [0, 0], first: [1, 0], second: [0, 1], domain: [0, 1] },
        { type: 'parametric-surface', name: 'sphere' }, { type: 'parametric-curve', name: 'butterfly' }),
);

/** One effect of each kind that goes on every object. */
const effect = fc.record({
    kind: fc.constantFrom('translate', 'rotate', 'scale', 'colour'), period: number(0.1, 100), easing: family,
});

export const sceneDocument = fc.record({
    title: fc.string(), objects: fc.array(sceneObject, { minLength: 1, maxLength: 4 }), effects: fc.array(effect, { maxLength: 3 }),
}).map(({ title, objects, effects }) => ({
    knotwork: 1, title,
    objects: objects.map((object, i) => ({ id: `o${i}`, ...object })),
    effects: effects.map((one, i) => ({ target: `o${i % objects.length}`, ...one })),
}));

/** Every place of a document, as the paths of commands name them. */
export function pathsOf(value, path = '') {
    if (typeof value !== 'object' || value === null) return [path];
    const steps = Array.isArray(value)
        ? value.map((one, i) => [`${path}[${i}]`, one])
        : Object.entries(value).map(([key, one]) => [path ? `${path}.${key}` : key, one]);
    return [...(path ? [path] : []), ...steps.flatMap(([step, one]) => pathsOf(one, step))];
}

const anything = fc.oneof(
    fc.integer({ min: -1, max: 9 }), number(-9, 9), place2, place3, sceneObject, family,
    fc.constantFrom(null, true, [], {}, 'x', 1e308, 'open', 'closed', 'clamped', 'loop', 'torus', 'cube', 'bezier', 'length', '#00ff00',
        'bspline-curve', 'blending-curve', 'bspline-surface', 'blending-surface', 'subdivision-surface', 'point-cloud', 'parametric-curve'));
const local = fc.oneof(fc.integer({ min: 0, max: 5 }), fc.tuple(fc.integer({ min: 0, max: 3 }), fc.integer({ min: 0, max: 3 })));
const inObjects = fc.record({
    i: fc.integer({ min: 0, max: 3 }), j: fc.integer({ min: 0, max: 3 }), k: fc.integer({ min: 0, max: 6 }),
    where: fc.constantFrom('points[k]', 'points[j][k]', 'knots[k]', 'knots[0][k]', 'mesh.vertices[k]', 'form', 'degree', 'locals.count', 'locals[1]', 'type'),
}).map(({ i, j, k, where }) => `objects[${i}].${where.replace('j', j).replace('[k]', `[${k}]`)}`);

/** A function of the document that the command is for. */
const oneCommand = fc.record({
    kind: fc.integer({ min: 0, max: 9 }), at: fc.nat(), deep: fc.boolean(), named: inObjects, other: inObjects, value: anything, by: place2,
    object: fc.integer({ min: 0, max: 3 }), more: sceneObject, local, to: fc.integer({ min: 0, max: 4 }),
}).map(({ kind, at, deep, named, other, value, by, object, more, local: one, to }) => (document) => {
    const paths = pathsOf(document);
    const path = deep ? paths[at % paths.length] : named;
    return [
        () => ({ set: path, value }), () => ({ set: other, value }), () => ({ move: path, by }), () => ({ move: path, to: value, snap: 0.5 }),
        () => ({ insert: path, value }), () => ({ remove: path }), () => ({ add: more }), () => ({ move: [named, other], by }),
        () => ({ pose: { object: `o${object}`, locals: [one], by: { translate: by, scale: 1.5 } } }), () => ({ move: `objects[${object}]`, to }),
    ][kind]();
});
export const sceneCommand = fc.oneof(
    { weight: 5, arbitrary: oneCommand },
    { weight: 1, arbitrary: fc.tuple(oneCommand, oneCommand).map(([a, b]) => (document) => ({ all: [a(document), b(document)] })) },
    { weight: 1, arbitrary: fc.tuple(oneCommand, fc.constantFrom('a', 'b')).map(([one, gesture]) => (document) => ({ ...one(document), gesture })) },
);
