// Curves as values: what every kind answers, and what B-spline and blending curves answer besides.

import {
    choice, copyInto, derivativeOrder, finite, integer, lengthOfNumbers, numbers, options, point, sampleCount,
    target,
} from './check.mjs';
import { boehmOrOslo, factorRows, matrixRows, refinedKnots, removal } from './bspline-curve.mjs';
import { Held } from './held.mjs';
import { basisTarget, fill, fillAt, fillBasis } from './samples.mjs';

/** @typedef {import('./core.mjs').Core} Core */
/** @typedef {'left' | 'right'} Side */

/** The largest multiplicity that anyone can ask for; the core says which fits the degree. */
const mostTimes = 1000;

const sides = /** @type {const} */ (['left', 'right']);

export class Curve extends Held {
    #start;
    #end;
    #closed;
    #dimension;

    /** @param {Core} core @param {number} handle @param {ArrayLike<number>} traits as Session::holdCurve leaves them */
    constructor(core, handle, traits) {
        super(core, handle);
        this.#start = traits[0];
        this.#end = traits[1];
        this.#closed = traits[2] === 1;
        this.#dimension = traits[3];
    }

    /** @returns {[number, number]} */
    get domain() {
        Held.of(this);
        return [this.#start, this.#end];
    }

    get closed() {
        Held.of(this);
        return this.#closed;
    }

    /** 2 where it lies in the plane z = 0, otherwise 3. */
    get dimension() {
        Held.of(this);
        return this.#dimension;
    }

    /** @param {number} t */
    point(t) {
        const { core, handle } = Held.of(this);
        core.ask('curvePoint', handle, finite(t, 't'));
        return core.point(0);
    }

    /** @param {number} t @param {number} n @param {{ side?: Side }} [given] */
    derivatives(t, n, given) {
        const { core, handle } = Held.of(this);
        const order = derivativeOrder(n, 'n');
        core.ask('curveDerivatives', handle, finite(t, 't'), order, sideNumber(options(given, ['side']).side));
        const rows = [];
        for (let k = 0; k <= order; ++k) rows.push(core.point(k));
        return rows;
    }

    /** @param {number} count @param {{ into?: Float64Array }} [given] */
    sample(count, given) {
        const { core, handle } = Held.of(this);
        const total = sampleCount(count);
        const answer = target(options(given, ['into']).into, 3 * total);
        fill(core, answer, total, 3, (first, part) => {
            core.ask('curveSample', handle, first, part, total);
        });
        return answer;
    }

    /** @param {ArrayLike<number>} ts @param {{ derivatives?: number, into?: Float64Array }} [given] */
    sampleAt(ts, given) {
        const { core, handle } = Held.of(this);
        const { derivatives = 0, into } = options(given, ['derivatives', 'into']);
        const parameters = numbers(ts, 'ts');
        const order = derivativeOrder(derivatives, 'derivatives');
        const answer = target(into, 3 * lengthOfNumbers(parameters) * (order + 1));
        fillAt(core, handle, parameters, order, answer);
        return answer;
    }

    /** @param {{ tolerance?: number }} [given] */
    polyline(given) {
        const { core, handle } = Held.of(this);
        const { tolerance = 1e-3 } = options(given, ['tolerance']);
        const count = core.count('curvePolyline', handle, finite(tolerance, 'tolerance'));
        const both = core.bulk(4 * count);
        core.call('dropBulk');
        return { points: both.slice(0, 3 * count), parameters: both.slice(3 * count) };
    }

    /** The moving frame, curvature and torsion. @param {number} t @param {{ side?: Side }} [given] */
    frame(t, given) {
        const { core, handle } = Held.of(this);
        core.ask('curveFrame', handle, finite(t, 't'), sideNumber(options(given, ['side']).side));
        return {
            point: core.point(0), tangent: core.point(1), normal: core.point(2), binormal: core.point(3),
            curvature: core.number(12), torsion: core.number(13),
        };
    }

    /** The length from a to b, by default of all of it. @param {number} [a] @param {number} [b] */
    length(a, b) {
        const { core, handle } = Held.of(this);
        core.ask('curveLength', handle, finiteIfGiven(a, 'a'), finiteIfGiven(b, 'b'));
        return core.number(0);
    }

    /** Where the length from the start is s. @param {number} s */
    parameterAtLength(s) {
        const { core, handle } = Held.of(this);
        core.ask('curveParameterAtLength', handle, finite(s, 's'));
        return core.number(0);
    }

    /** The point nearest to a place. @param {ArrayLike<number>} p */
    closestPoint(p) {
        const { core, handle } = Held.of(this);
        const place = point(p, 'p');
        core.ask('curveClosestPoint', handle, place[0], place[1], place[2]);
        /** @type {[number, number, number]} */
        const found = [core.number(1), core.number(2), core.number(3)];
        return { t: core.number(0), point: found, distance: core.number(4) };
    }

    /** Where a line in the plane crosses it and its control polygon. @param {ArrayLike<number>} place @param {ArrayLike<number>} direction */
    crossings(place, direction) {
        const line = { point: [...point(place, 'point')], direction: [...point(direction, 'direction')] };
        return ask(this, 'crossings', line);
    }

    /** The smallest sphere around all of it. */
    enclosingSphere() {
        const { core, handle } = Held.of(this);
        core.ask('curveSphere', handle);
        return { center: core.point(0), radius: core.number(3) };
    }

    /** What it was made from, defaults filled in. */
    get spec() {
        const { core, handle } = Held.of(this);
        return core.json('curveSpec', handle);
    }
}

/** NaN stands for what is not given. @param {unknown} value @param {string} name */
const finiteIfGiven = (value, name) => (value === undefined ? NaN : finite(value, name));

/** @param {unknown} side */
function sideNumber(side) {
    if (side === undefined) return 0;
    return choice(side, 'side', sides) === 'left' ? -1 : 1;
}

export class ParametricCurve extends Curve {}

/** @param {Curve} curve @param {string} list */
function listOf(curve, list) {
    const { core, handle } = Held.of(curve);
    return Array.from(core.bulk(core.count(list, handle)));
}

export class BsplineCurve extends Curve {
    /** The knots in the form in which they are given: one period of a closed curve. */
    get knots() {
        return listOf(this, 'curveKnots');
    }

    /** The Greville abscissae, one a point. */
    get greville() {
        return listOf(this, 'curveGrevilles');
    }

    /** The control points as x, y, z triples. @param {{ into?: Float64Array }} [given] */
    controlPoints(given) {
        const { core, handle } = Held.of(this);
        const { into } = options(given, ['into']);
        const length = 3 * core.count('curveControlPoints', handle);
        if (into === undefined) return core.bulk(length);
        const answer = target(into, length);
        copyInto(answer, core.bulkView(length), 0);
        return answer;
    }

    /** The same curve with one more knot. @param {number} t @param {number} [times] */
    insertKnot(t, times = 1) {
        const { core, handle } = Held.of(this);
        const often = integer(times, 'times', 1, mostTimes);
        return adopt(core, core.ask('curveInsertKnot', handle, finite(t, 't'), often));
    }

    /**
     * The same curve over a full vector of more knots (one period where closed).
     * @param {ArrayLike<number>} knots
     * @param {{ algorithm?: 'oslo' | 'boehm' }} [given]
     */
    refine(knots, given) {
        const { core, handle } = Held.of(this);
        const byBoehm = boehmOrOslo(options(given, ['algorithm']).algorithm);
        const full = refinedKnots(knots);
        core.sendNumbers(full);
        return adopt(core, core.ask('curveRefine', handle, full.length, byBoehm));
    }

    /** The matrix of discrete B-splines: a row a point of the refined curve. @param {ArrayLike<number>} knots */
    osloMatrix(knots) {
        const { count, columns } = ask(this, 'osloMatrix', { knots });
        return matrixRows(Held.of(this).core.bulk(count), columns);
    }

    /** Without one knot t, if that moves it little enough. @param {number} t @param {{ tolerance?: number }} [given] */
    removeKnot(t, given) {
        const { tolerance = 1e-9 } = options(given, ['tolerance']);
        return removal(ask(this, 'removeKnot', { t, tolerance }));
    }

    /** The same curve with a higher degree. @param {number} [by] */
    elevateDegree(by = 1) {
        return ask(this, 'elevateDegree', { by }).curves[0];
    }

    /** The specification of a Bézier curve for each span. */
    bezierPieces() {
        return ask(this, 'bezierPieces', {}).pieces;
    }

    /** The matrices T₁ … T_d with which the curve is c(t) = T₁ … T_d c. @param {number} t */
    factorMatrices(t) {
        const { count } = ask(this, 'factorMatrices', { t });
        return factorRows(Held.of(this).core.bulk(count));
    }

    /** The hodograph. */
    derivativeCurve() {
        return ask(this, 'derivativeCurve', {}).curves[0];
    }

    /** Before t and after it; a closed curve comes back as one that begins and ends at t. @param {number} t */
    split(t) {
        return ask(this, 'split', { t }).curves;
    }

    /** The same curve from its end to its start. */
    reversed() {
        return ask(this, 'reversed', {}).curves[0];
    }

    /** Row k: the k-th derivative of all n basis functions at t. @param {number} t @param {{ derivatives?: number }} [given] */
    basis(t, given) {
        const { core, handle } = Held.of(this);
        const { derivatives = 0 } = options(given, ['derivatives']);
        const order = derivativeOrder(derivatives, 'derivatives');
        const count = core.count('curveBasis', handle, finite(t, 't'), order);
        const rows = core.bulk(count * (order + 1));
        return Array.from({ length: order + 1 }, (_, k) => Array.from(rows.subarray(k * count, (k + 1) * count)));
    }

    /**
     * The degree + 1 basis functions that are not zero at each parameter, and for each parameter the
     * index of the first of them.
     * @param {ArrayLike<number>} ts
     * @param {{ into?: { values: Float64Array, first: Int32Array } }} [given]
     */
    basisAt(ts, given) {
        const { core, handle } = Held.of(this);
        const { into } = options(given, ['into']);
        const parameters = numbers(ts, 'ts');
        const width = core.ask('curveBasisAt', handle, 0, 0);
        const lists = basisTarget(into, lengthOfNumbers(parameters), width);
        fillBasis(core, handle, parameters, width, lists);
        return /** @type {typeof lists} */ (into ?? lists);
    }
}

export class BlendingCurve extends Curve {
    /** Where each local curve is centred; a closed curve has one more, a period after the first. */
    get knots() {
        return listOf(this, 'curveKnots');
    }

    /** The same curve with local curve j in another pose. @param {number} j @param {object} pose */
    withPose(j, pose) {
        const { core, handle } = Held.of(this);
        const local = integer(j, 'j', 0, 2 ** 31 - 1);
        return adopt(core, core.ask('curveWithPose', handle, local, core.send(pose)));
    }

    /** Local curve j where it takes part, posed. @param {number} j */
    local(j) {
        const { core, handle } = Held.of(this);
        return adopt(core, core.ask('curveLocal', handle, integer(j, 'j', 0, 2 ** 31 - 1)));
    }

    /** The same local curves at other knots. @param {ArrayLike<number>} knots @param {{ recut?: boolean }} [given] */
    withKnots(knots, given) {
        const { core, handle } = Held.of(this);
        const { recut = true } = options(given, ['recut']);
        return adopt(core, core.ask('curveWithKnots', handle, core.send({ knots, recut })));
    }

    /** The weights with which the local curves are blended at t. @param {number} t */
    blendBasis(t) {
        const { core, handle } = Held.of(this);
        return Array.from(core.bulk(core.count('curveBlendBasis', handle, finite(t, 't'))));
    }
}

export class BezierCurve extends Curve {}
export class LineCurve extends Curve {}
export class ArcCurve extends Curve {}
/** Made of formulas in t. */
export class FormulaCurve extends Curve {}
/** A local curve of a blending curve where it takes part, posed. */
export class LocalCurve extends Curve {}

export class SubdivisionCurve extends Curve {
    /** Where the points of the polygon go, one each. */
    limitPoints() {
        return answeredPoints(this, 'limitPoints');
    }

    /** The derivatives of the limit there. */
    limitTangents() {
        return answeredPoints(this, 'limitTangents');
    }
}

/** In the order of Curve::Kind. */
const kinds = [
    BsplineCurve, ParametricCurve, BlendingCurve, BezierCurve, LineCurve, ArcCurve, LocalCurve, SubdivisionCurve,
    FormulaCurve, Curve,
];

/**
 * Points that a curve answers to a question by name.
 * @param {Curve} curve
 * @param {string} question
 */
function answeredPoints(curve, question) {
    const { core } = Held.of(curve);
    const points = core.bulk(ask(curve, question, {}).count);
    core.call('dropBulk');
    return points;
}

/**
 * The curve behind a handle, which was made just now where its traits still stand in the block.
 * @param {Core} core
 * @param {number} handle
 * @param {ArrayLike<number>} traits
 * @returns {Curve}
 */
export function adopt(core, handle, traits = core.block(0, 5)) {
    return new kinds[traits[4]](core, handle, traits);
}

/**
 * What a curve answers to a question by name; `curves` in the answer are curves already.
 * @param {Curve} curve
 * @param {string} question
 * @param {object} given
 * @returns {any}
 */
export function ask(curve, question, given) {
    const { core, handle } = Held.of(curve);
    return withCurves(core, core.json('askCurve', question, handle, core.send(given)));
}

/**
 * @param {Core} core
 * @param {any} answer of a question by name
 */
export function withCurves(core, answer) {
    /** @param {{ handle: number, traits: number[] }} found */
    const adopted = ({ handle, traits }) => adopt(core, handle, traits);
    return answer.curves ? { ...answer, curves: answer.curves.map(adopted) } : answer;
}

/** @param {Core} core @param {unknown} spec */
export function makeCurve(core, spec) {
    return adopt(core, core.ask('curve', core.send(spec)));
}
