// The trace of an object of a scene: which algorithms suit it, and its frames, with what is left out
// filled in as the scene itself does when it draws them.

import { bare } from './shape.mjs';

const ofSplines = ['de-boor', 'cox-de-boor', 'factor-matrices', 'boehm', 'oslo'];

/**
 * The algorithms that can be shown on an object.
 * @param {any} object of a canonical document
 * @returns {string[]}
 */
export function algorithmsFor({ type, scheme }) {
    switch (type) {
        case 'bspline-curve': return ofSplines;
        case 'subdivision-curve': return [scheme === 'four-point' ? 'four-point' : 'lane-riesenfeld'];
        case 'blending-curve':
        case 'blending-surface': return ['blend'];
        case 'subdivision-surface': return ['catmull-clark'];
        default: return [];
    }
}

/**
 * What kw.trace() takes for the trace of an object.
 * @param {any} kw
 * @param {any} object of a canonical document, with `trace`
 */
export function traceArguments(kw, object) {
    const { trace } = object;
    const { algorithm } = trace;
    const spec = bare(object);
    if (algorithm === 'catmull-clark') {
        return { algorithm, mesh: object.mesh, levels: trace.levels ?? object.levels };
    }
    if (['lane-riesenfeld', 'four-point'].includes(algorithm)) return subdivision(object, trace);
    if (object.type === 'blending-surface') return { algorithm, surface: spec, ...placeOf(kw, spec, trace) };
    const curve = kw.curve(spec);
    try {
        const t = trace.t ?? object.t ?? middle(curve.domain);
        if (algorithm === 'boehm') return { algorithm, curve: spec, knot: trace.knot ?? object.t ?? middle(curve.domain) };
        if (algorithm === 'oslo') return { algorithm, curve: spec, knots: trace.knots ?? halved(curve) };
        return { algorithm, curve: spec, t };
    } finally {
        curve.dispose();
    }
}

/** @param {any} object @param {any} trace */
function subdivision({ points, closed, degree, tension, scheme, levels }, trace) {
    const common = { algorithm: trace.algorithm, points, closed, levels: trace.levels ?? levels };
    if (trace.algorithm === 'four-point') return tension === undefined ? common : { ...common, tension };
    const chaikin = scheme === 'chaikin' ? 2 : undefined;  // which is Lane–Riesenfeld of that degree
    return { ...common, degree: chaikin ?? degree ?? 3 };
}

/** @param {any} kw @param {any} spec @param {any} trace */
function placeOf(kw, spec, trace) {
    const surface = kw.surface(spec);
    const [u, v] = surface.domain.map(middle);
    surface.dispose();
    return { u: trace.u ?? u, v: trace.v ?? v };
}

/** @param {[number, number]} domain */
function middle([start, end]) {
    return (start + end) / 2;
}

/**
 * The knots with one more in the middle of every span of the domain.
 * @param {any} curve
 */
function halved({ knots, domain: [start, end] }) {
    return knots.flatMap((/** @type {number} */ knot, /** @type {number} */ k) => {
        const last = knots[k - 1];
        return k > 0 && last < knot && last >= start && knot <= end ? [(last + knot) / 2, knot] : [knot];
    });
}
