// Surfaces as values: what every kind answers, and what B-spline surfaces answer besides.

import { choice, finite, indexPair, integer, options } from './check.mjs';
import { Held } from './held.mjs';
import { fillGrid, gridSize, gridTarget } from './surface-grid.mjs';

/** @typedef {import('./core.mjs').Core} Core */
/** @typedef {[number, number]} Pair */

const directions = /** @type {const} */ (['u', 'v']);

export class Surface extends Held {
    /** Starts and ends of the domain, and where it is closed. @type {number[]} */
    #traits;

    /** @param {Core} core @param {number} handle @param {ArrayLike<number>} traits as Session::holdSurface leaves them */
    constructor(core, handle, traits) {
        super(core, handle);
        this.#traits = Array.from(traits);
    }

    /** @returns {[Pair, Pair]} */
    get domain() {
        Held.of(this);
        const [u0, u1, v0, v1] = this.#traits;
        return [[u0, u1], [v0, v1]];
    }

    /** Whether it is periodic along u and along v. @returns {[boolean, boolean]} */
    get closed() {
        Held.of(this);
        return [this.#traits[4] === 1, this.#traits[5] === 1];
    }

    /** @param {number} u @param {number} v */
    point(u, v) {
        const { core, handle } = Held.of(this);
        core.ask('surfacePoint', handle, finite(u, 'u'), finite(v, 'v'));
        return core.point(0);
    }

    /** The point, its first and its second derivatives. @param {number} u @param {number} v */
    derivatives(u, v) {
        const { core, handle } = Held.of(this);
        core.ask('surfaceDerivatives', handle, finite(u, 'u'), finite(v, 'v'));
        return {
            S: core.point(0), Su: core.point(1), Sv: core.point(2),
            Suu: core.point(3), Suv: core.point(4), Svv: core.point(5),
        };
    }

    /** The unit normal, that of Su × Sv; zeros where there is none. @param {number} u @param {number} v */
    normal(u, v) {
        const { core, handle } = Held.of(this);
        core.ask('surfaceNormal', handle, finite(u, 'u'), finite(v, 'v'));
        return core.point(0);
    }

    /** @param {number} u @param {number} v */
    curvatures(u, v) {
        const { core, handle } = Held.of(this);
        core.ask('surfaceCurvatures', handle, finite(u, 'u'), finite(v, 'v'));
        return { gaussian: core.number(0), mean: core.number(1), k1: core.number(2), k2: core.number(3) };
    }

    /**
     * nu × nv points, uniform in the parameters, with unit normals and triangles.
     * @param {number} nu
     * @param {number} nv
     * @param {{ into?: import('./surface-grid.mjs').Grid }} [given]
     */
    grid(nu, nv, given) {
        const { core, handle } = Held.of(this);
        const size = gridSize(nu, nv, this.closed);
        const { into } = options(given, ['into']);
        const grid = gridTarget(into, size);
        fillGrid(core, handle, size, grid);
        return /** @type {typeof grid} */ (into ?? grid);
    }

    /**
     * Triangles nowhere farther from the surface than the tolerance, more where it is more curved.
     * @param {{ tolerance?: number }} [given]
     */
    triangles(given) {
        const { core, handle } = Held.of(this);
        const { tolerance = 1e-2 } = options(given, ['tolerance']);
        const { vertices, indices } = core.json('surfaceTriangles', handle, finite(tolerance, 'tolerance'));
        const all = core.bulk(8 * vertices);
        const answer = {
            positions: all.slice(0, 3 * vertices), normals: all.slice(3 * vertices, 6 * vertices),
            parameters: all.slice(6 * vertices), indices: core.indices(core.call('bulkIndices'), indices).slice(),
        };
        core.call('dropBulk');
        return answer;
    }

    /**
     * Points of the line on which v (of `'u'`, along which it runs) or u (of `'v'`) is constant.
     * @param {'u' | 'v'} along
     * @param {number} at the constant parameter
     * @param {{ count?: number, tolerance?: number }} [given] uniform points, or within a tolerance
     */
    isoline(along, at, given) {
        const { core, handle } = Held.of(this);
        const alongU = choice(along, 'along', directions) === 'u';
        const { count, tolerance = 1e-3 } = options(given, ['count', 'tolerance']);
        const uniform = count === undefined ? 0 : integer(count, 'count', 2, 4_000_000, 'TOO_LARGE');
        const found = core.count('surfaceIsoline', handle, alongU, finite(at, 'at'), uniform, finite(tolerance, 'tolerance'));
        const points = core.bulk(3 * found);
        core.call('dropBulk');
        return points;
    }

    /** What it was made from, defaults filled in. */
    get spec() {
        const { core, handle } = Held.of(this);
        return core.json('surfaceSpec', handle);
    }
}

export class BsplineSurface extends Surface {
    /** The same surface over full vectors of more knots. @param {ArrayLike<ArrayLike<number>>} knots along u and along v */
    refine(knots) {
        return askSurface(this, 'refine', { knots }).surfaces[0];
    }
}

export class ParametricSurface extends Surface {}

export class BlendingSurface extends Surface {
    /** Where the local patches are centred, along u and along v. @returns {[number[], number[]]} */
    get knots() {
        return askSurface(this, 'knots', {}).knots;
    }

    /** Where the own points of all local patches stand, posed, row by row: x, y, z of patch [i, j] at 3 (i nv + j). */
    get localOrigins() {
        const { core } = Held.of(this);
        const { count } = askSurface(this, 'origins', {});
        const origins = core.bulk(count);
        core.call('dropBulk');
        return origins;
    }

    /** Local patch [i, j] where it takes part, posed. @param {number} i @param {number} j */
    local(i, j) {
        return askSurface(this, 'local', { i, j }).surfaces[0];
    }

    /** The same surface with local patch [i, j] in another pose. @param {ArrayLike<number>} place @param {object} pose */
    withPose(place, pose) {
        const { core, handle } = Held.of(this);
        const [i, j] = indexPair(place, 'local');
        return adoptSurface(core, core.ask('surfaceWithPose', handle, i, j, core.send(pose)));
    }
}

export class BlendingTriangle extends Surface {
    /** The local patch of corner 0, 1 or 2, over all of its own rectangle. @param {number} corner */
    local(corner) {
        return askSurface(this, 'corner', { corner }).surfaces[0];
    }

    /** What each patch counts at (u, v): three numbers, not negative, that sum to 1. @param {number} u @param {number} v @returns {[number, number, number]} */
    weights(u, v) {
        return askSurface(this, 'weights', { u, v }).weights;
    }
}

/** In the order of Surface::Kind. */
const kinds = [BsplineSurface, ParametricSurface, BlendingSurface, BlendingTriangle];

/** How many numbers of the block tell what kind of surface was made. */
const traitCount = 7;

/**
 * The surface behind a handle, which was made just now where its traits still stand in the block.
 * @param {Core} core
 * @param {number} handle
 * @param {ArrayLike<number>} traits
 * @returns {Surface}
 */
export function adoptSurface(core, handle, traits = core.block(0, traitCount)) {
    return new kinds[traits[6]](core, handle, traits);
}

/**
 * What a surface answers to a question by name; `surfaces` in the answer are surfaces already.
 * @param {Surface} surface
 * @param {string} question
 * @param {object} given
 * @returns {any}
 */
export function askSurface(surface, question, given) {
    const { core, handle } = Held.of(surface);
    const answer = core.json('askSurface', question, handle, core.send(given));
    /** @param {{ handle: number, traits: number[] }} found */
    const adopted = (found) => adoptSurface(core, found.handle, found.traits);
    return answer.surfaces ? { ...answer, surfaces: answer.surfaces.map(adopted) } : answer;
}

/** @param {Core} core @param {unknown} spec */
export function makeSurface(core, spec) {
    return adoptSurface(core, core.ask('surface', core.send(spec)));
}
