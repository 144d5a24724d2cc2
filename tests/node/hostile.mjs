// Values that are not what they should be, one valid specification of everything that takes one, and
// the arguments of every method: what the tests of bad input go through.
import { KnotworkError } from './support.mjs';

const hostile = () => { throw new RangeError('mine'); };
const revoked = () => {
    const { proxy, revoke } = Proxy.revocable({}, {});
    revoke();
    return proxy;
};

const primitives = [null, true, false, '', '0.5', 'x', 1n, Symbol('s')];
const objects = [
    [], [0.5], {}, { valueOf: () => 0.5 }, { toString: () => '0.5' }, () => 0.5, new Number(0.5), new String('x'),
    new Date(0), new Map(), new Set(), /x/, new Int32Array(3), new ArrayBuffer(8), new Proxy({}, {}), revoked(),
    { get valueOf() { return hostile(); } }, { [Symbol.toPrimitive]: hostile }, new Proxy({}, { get: hostile, ownKeys: hostile }),
];
const numbersAmiss = [NaN, Infinity, -Infinity];

const noTexts = [undefined, null, true, 0, 0.5, NaN, 1n, Symbol('s'), ...objects];

/** What is wrong where a value of each kind is wanted. */
export const wrong = {
    number: [undefined, ...primitives, ...objects, ...numbersAmiss],
    integer: [undefined, ...primitives, ...objects, ...numbersAmiss, 0.5, 2 ** 32 + 5, -(2 ** 31) - 1, 2 ** 53, 1e300],
    string: noTexts,
    scheme: [...noTexts, '', 'right'],
    format: [...noTexts, '', 'loop', 'constructor'],
    boolean: [undefined, null, '', 'true', 0, 1, NaN, 1n, Symbol('s'), ...objects],
    list: [undefined, ...primitives, 0, 0.5, NaN, {}, { length: 2, 0: 1, 1: 2 }, () => [], new Set([1]), new Int32Array(3), revoked(), new Proxy([], { get: hostile })],
    object: [undefined, ...primitives, 0, 0.5, NaN, [], [1], () => ({}), new Map(), new Date(0), new Float64Array(3), revoked()],
    // An object of options may be left out.
    options: [...primitives, 0, 0.5, NaN, [], () => ({}), new Map(), new Float64Array(3), revoked(), { unknown: 1 }, { constructor: 1 }],
    into: [...primitives, 0, 0.5, [], [0, 0, 0], new Float32Array(9), new Float64Array(2), new ArrayBuffer(72), {}, revoked()],
};

/** @param {string} kind */
export const wrongOptional = (kind) => wrong[kind].filter((value) => value !== undefined);

export const bFunctions = [
    { family: 'linear' },
    { family: 'trigonometric', order: 3 },
    { family: 'polynomial', p: 2, q: 1 },
    { family: 'rational', m: 2.5, c: 2 },
    { family: 'expo-rational', alpha: 1, beta: 2, gamma: 0.5, lambda: 0.4 },
    { family: 'logistic', c: 2 },
    { family: 'tabulated', values: [0, 0.2, 0.9, 1] },
    { family: 'formula', expression: 't^2*(3-2*t)' },
    { family: 'dual', of: { family: 'polynomial', p: 2, q: 1 } },
    { family: 'symmetrised', of: { family: 'polynomial', p: 2, q: 1 } },
    { family: 'composed', outer: { family: 'logistic' }, inner: { family: 'linear' } },
    { family: 'mixed', of: [{ family: 'linear' }, { family: 'logistic' }], weight: 0.25 },
];

const polygon = [[0, 0], [1, 2], [3, 3], [5, 0], [6, 2]];
const circle = { type: 'parametric-curve', name: 'circle', parameters: { radius: 2 }, domain: [0, 6] };

export const curves = [
    { type: 'bspline-curve', degree: 3, points: polygon },
    { type: 'bspline-curve', degree: 2, form: 'open', points: polygon, knots: [0, 1, 2, 4, 5, 6, 7, 8] },
    { type: 'bspline-curve', degree: 2, form: 'closed', points: polygon, knots: [0, 1, 1, 2, 3, 4] },
    { type: 'bspline-curve', degree: 2, points: polygon, weights: [1, 2, 1, 1, 3] },
    circle,
    { type: 'bezier-curve', points: polygon, domain: [0, 2] },
    { type: 'line-curve', from: [0, 0], to: [1, 2, 3] },
    { type: 'arc-curve', at: 0, point: [0, 0], first: [1, 0], second: [0, 1], domain: [0, 1] },
    {
        type: 'blending-curve', bFunction: { family: 'logistic' }, model: circle, form: 'open', locals: { count: 3 },
        poses: [{ local: 1, translate: [1, 0, 0], rotate: { axis: [0, 0, 1], angle: 1 }, scale: [1, 2, 1] }],
    },
    { type: 'blending-curve', bFunction: { family: 'polynomial' }, model: circle, form: 'open', locals: { count: 3, kind: 'bezier', degree: 2 } },
    { type: 'blending-curve', bFunction: { family: 'linear' }, model: circle, locals: { count: 4, kind: 'arc' }, spacing: 'length' },
    { type: 'blending-curve', bFunction: { family: 'linear' }, locals: [circle, circle], knots: [0, 6], form: 'open' },
    {
        type: 'blending-curve', bFunction: { family: 'linear' }, model: circle, form: 'closed',
        locals: { count: 3, kind: 'bezier', degree: 2 }, spacing: 'length',
    },
    { type: 'subdivision-curve', scheme: 'lane-riesenfeld', points: polygon, closed: true, levels: 2, degree: 4 },
    { type: 'subdivision-curve', scheme: 'chaikin', points: polygon, levels: 3 },
    { type: 'subdivision-curve', scheme: 'four-point', points: polygon, closed: false, levels: 1, tension: 0.1 },
    { type: 'formula-curve', x: 'a*t', y: 't^2', z: 'sin(t)', parameters: { a: 2 }, domain: [0, 1], closed: false },
];

export const meshes = [
    { solid: 'cube' },
    { solid: 'torus', parameters: { around: 5, across: 4, tube: 0.2 } },
    { vertices: [[0, 0], [1, 0, 1], [1, 1], [0, 1]], faces: [[0, 1, 2], [0, 2, 3]] },
    { obj: 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' },
];

const net = [0, 1, 2].map((i) => [0, 1, 2, 3].map((j) => [i, j, (i * j) % 3]));

export const surfaces = [
    { type: 'bspline-surface', degree: [2, 3], points: net },
    { type: 'bspline-surface', degree: [1, 2], form: ['open', 'closed'], points: net, weights: net.map((row) => row.map((_, j) => 1 + j)) },
    { type: 'parametric-surface', name: 'torus', parameters: { R: 3, r: 1 } },
    { type: 'parametric-surface', name: 'sphere' },
    {
        type: 'blending-surface', bFunction: { family: 'logistic' }, locals: [2, 3], kind: 'bezier', form: ['open', 'open'],
        model: { type: 'parametric-surface', name: 'plane', parameters: { width: 2, height: 3 } },
        poses: [{ local: [1, 0], translate: [0, 0, 1], rotate: { axis: [0, 0, 1], angle: 1 }, scale: [1, 2, 1] }],
    },
    {
        type: 'blending-surface', bFunction: [{ family: 'logistic' }, { family: 'polynomial', p: 2 }], locals: [3, 2],
        model: { type: 'parametric-surface', name: 'cylinder' },
        poses: [{ local: [1, 0], translate: [1, 0, 0], rotate: { axis: [0, 0, 1], angle: 1 }, scale: [1, 2, 1] }],
    },
    {
        type: 'blending-surface', bFunction: { family: 'linear' }, locals: [2, 3], kind: 'bezier', degree: [2, 3],
        model: { type: 'bspline-surface', degree: [2, 3], points: net }, form: ['open', 'closed'], knots: [[0, 1], [0, 1, 2, 3]],
    },
    {
        type: 'blending-triangle', order: 2,
        locals: [{ type: 'bspline-surface', degree: [2, 3], points: net }, { type: 'parametric-surface', name: 'torus' }, { type: 'parametric-surface', name: 'plane' }],
    },
    {
        type: 'blending-triangle', bFunction: { family: 'logistic', c: 2 },
        locals: ['sphere', 'cone', 'plane'].map((name) => ({ type: 'parametric-surface', name })),
    },
];

export const traces = [
    { algorithm: 'de-boor', curve: curves[0], t: 0.5 },
    { algorithm: 'cox-de-boor', curve: curves[2], t: 0.5 },
    { algorithm: 'factor-matrices', curve: curves[3], t: 0.5 },
    { algorithm: 'boehm', curve: curves[0], knot: 0.5 },
    { algorithm: 'oslo', curve: curves[0], knots: [0, 0, 0, 0, 1, 1.5, 2, 2, 2, 2] },
    { algorithm: 'lane-riesenfeld', points: polygon, closed: true, degree: 2, levels: 1 },
    { algorithm: 'four-point', points: polygon, closed: false, tension: 0.1, levels: 1 },
    { algorithm: 'blend', curve: curves[8], t: 0.5 },
    { algorithm: 'blend', surface: surfaces[5], u: 0.5, v: 0.5 },
    { algorithm: 'catmull-clark', mesh: meshes[2], levels: 1 },
];

export const scenes = [
    { knotwork: 1, title: 'One', objects: [{ id: 'c1', ...curves[0] }, { id: 'c2', ...curves[8] }], effects: [{ target: 'c2', kind: 'rotate', period: 3 }] },
];

/** Requests of kw.fit(). */
export const fitRequests = [
    { points: [[0, 0], [1, 2], [2, -1], [3, 1], [4, 0], [5, 2]], degree: 2, count: 4, form: 'clamped', parameters: 'chord', interpolateEnds: true, smoothing: 0.1 },
    { points: [[0, 0], [1, 2], [2, -1], [1, -2]], degree: 1, count: 3, form: 'open', parameters: [0, 0.25, 0.5, 1], knots: [-0.5, 0, 0.5, 1, 1.5] },
];

const surface = {
    point: ['number', 'number'], derivatives: ['number', 'number'], normal: ['number', 'number'],
    curvatures: ['number', 'number'], grid: ['integer', 'integer', { into: 'object' }],
    triangles: [{ tolerance: 'number' }], isoline: ['string', 'number', { count: 'integer', tolerance: 'number' }],
};

const picture = {
    phase: 'number', time: 'number', width: 'number', height: 'number', theme: 'string', title: 'string', description: 'string',
    background: 'string', panes: 'list',
};

/**
 * The arguments of every method, by kind; a name with `?` may be left out, an object lists options.
 * @type {Record<string, Record<string, unknown[]>>}
 */
export const methods = {
    BFunction: {
        value: ['number'], derivatives: ['number', 'integer'], sample: ['integer', { into: 'into' }],
    },
    Curve: {
        point: ['number'], derivatives: ['number', 'integer', { side: 'string' }],
        sample: ['integer', { into: 'into' }],
        sampleAt: ['list', { derivatives: 'integer', into: 'into' }],
        polyline: [{ tolerance: 'number' }],
        length: ['number?', 'number?'], parameterAtLength: ['number'],
        frame: ['number', { side: 'string' }], closestPoint: ['list'], crossings: ['list', 'list'],
    },
    BsplineCurve: {
        insertKnot: ['number', 'integer?'], refine: ['list', { algorithm: 'string' }], osloMatrix: ['list'],
        removeKnot: ['number', { tolerance: 'number' }], elevateDegree: ['integer?'], factorMatrices: ['number'],
        split: ['number'], controlPoints: [{ into: 'into' }], basis: ['number', { derivatives: 'integer' }], basisAt: ['list', { into: 'object' }],
    },
    BlendingCurve: {
        withPose: ['integer', 'object'], blendBasis: ['number'], local: ['integer'], withKnots: ['list', { recut: 'boolean' }],
    },
    Mesh: {
        vertexNormals: [{ into: 'into' }], subdivide: ['scheme', 'integer?'], limit: ['scheme'],
        classification: ['scheme'],
    },
    BsplineSurface: { ...surface, refine: ['list'] },
    ParametricSurface: surface,
    BlendingSurface: { ...surface, local: ['integer', 'integer'], withPose: ['list', 'object'] },
    BlendingTriangle: { ...surface, local: ['integer'], weights: ['number', 'number'] },
    Scene: {
        drawing: [{ phase: 'number', time: 'number', tolerance: 'number' }], execute: ['object'], select: ['list'],
        svg: [picture], exportAs: ['format', picture], exporting: ['format', picture],
    },
};

/** Methods that take nothing. */
export const withoutArguments = [
    'dispose', 'triangulated', 'toObj', 'enclosingSphere', 'undo', 'redo', 'limitPoints', 'limitTangents', 'bezierPieces', 'derivativeCurve', 'reversed',
];

const codes = new Set([
    'WRONG_TYPE', 'WRONG_LENGTH', 'NOT_FINITE', 'NOT_INTEGER', 'OUT_OF_RANGE', 'TOO_LARGE', 'UNKNOWN_NAME', 'UNKNOWN_FIELD',
    'KNOTS_DECREASING', 'KNOTS_MULTIPLICITY', 'KNOTS_COUNT', 'RANK_DEFICIENT', 'NOT_MANIFOLD', 'NOT_SUPPORTED', 'SYNTAX',
    'VERSION', 'DISPOSED', 'OUT_OF_MEMORY',
]);

/**
 * What `act` throws, which may only be a refusal with a known code; undefined where it throws nothing.
 * A module that ended (`OUT_OF_MEMORY`) is a failure too: nothing here is that large.
 * @param {() => unknown} act
 */
export function refusalOf(act) {
    try {
        act();
    } catch (error) {
        const fair = error instanceof KnotworkError && codes.has(error.code) && error.code !== 'OUT_OF_MEMORY'
            && typeof error.path === 'string' && error.message.length > 10;
        if (!fair) throw new Error(`no refusal: ${error?.stack ?? String(error)}`, { cause: error });
        return error;
    }
    return undefined;
}

/** A valid argument of each kind, for the places before the wrong one. */
export const valid = {
    number: 0.25, integer: 1, list: [0.25, 0.5], object: { translate: [1, 0] }, string: 'right', scheme: 'loop', format: 'svg',
    into: undefined,
};

/**
 * Every call of a method with one argument, or one option, that is wrong.
 * @param {Record<string, Function>} value
 * @param {string} name
 * @param {unknown[]} kinds
 * @returns {{ what: string, act: () => unknown }[]}
 */
export function wrongCalls(value, name, kinds) {
    const before = (i) => kinds.slice(0, i).map((kind) => (typeof kind === 'string' ? valid[kind.replace('?', '')] : {}));
    const callOf = (i, given, what) => ({
        what: `${name}: argument ${i + 1} ${what}`,
        act: () => value[name](...before(i), given),
    });
    return kinds.flatMap((kind, i) => {
        if (typeof kind === 'string') {
            const amiss = kind.endsWith('?') ? wrongOptional(kind.slice(0, -1)) : wrong[kind];
            return amiss.map((given, k) => callOf(i, given, `is wrong value ${k} for ${kind}`));
        }
        const options = Object.entries(/** @type {Record<string, string>} */ (kind)).flatMap(([option, of]) =>
            wrongOptional(of).map((given, k) => callOf(i, { [option]: given }, `has wrong value ${k} for ${option}`)));
        return [...options, ...wrong.options.map((given, k) => callOf(i, given, `is wrong value ${k} for options`))];
    });
}

/**
 * Every place of plain data, with what stands there.
 * @param {unknown} data
 * @param {(string | number)[]} [path]
 * @returns {{ path: (string | number)[], value: unknown }[]}
 */
export function placesOf(data, path = []) {
    if (typeof data !== 'object' || data === null) return [{ path, value: data }];
    return [{ path, value: data }, ...Object.keys(data).flatMap((key) =>
        placesOf(data[key], [...path, Array.isArray(data) ? Number(key) : key]))];
}

/**
 * A copy of plain data with something else in one place.
 * @param {any} data
 * @param {(string | number)[]} path
 * @param {unknown} value
 * @returns {any}
 */
export function withValue(data, path, value) {
    if (path.length === 0) return value;
    const copy = Array.isArray(data) ? [...data] : { ...data };
    copy[path[0]] = withValue(data[path[0]], path.slice(1), value);
    return copy;
}

/** @param {unknown} value the kind of what stands in a place of a specification */
export function kindOf(value) {
    if (Array.isArray(value)) return 'list';
    return typeof value === 'object' ? 'object' : typeof value;
}
