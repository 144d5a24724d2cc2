// The interface that load() gives, over either of the two modules.

import { makeBFunction } from './b-function.mjs';
import { Core } from './core.mjs';
import { makeCurve } from './curve.mjs';
import { enclosingSphere, fit, interpolate } from './fit.mjs';
import { importDocument } from './imports.mjs';
import { decodeLink, encodeLink } from './links.mjs';
import { makeMesh } from './mesh.mjs';
import { openScene, validate } from './scene.mjs';
import { subdivide } from './subdivide.mjs';
import { makeSurface } from './surface.mjs';

/**
 * @param {import('./core.mjs').Module} module
 */
export function makeApi(module) {
    const core = new Core(module);
    return Object.freeze({
        /** @param {unknown} spec */
        bFunction: (spec) => makeBFunction(core, spec),
        get bFunctions() {
            return core.json('bFunctions');
        },
        /** @param {unknown} spec */
        curve: (spec) => makeCurve(core, spec),
        get parametricCurves() {
            return core.json('parametricCurves');
        },
        /** @param {unknown} spec */
        surface: (spec) => makeSurface(core, spec),
        get parametricSurfaces() {
            return core.json('parametricSurfaces');
        },
        /** @param {unknown} spec @param {unknown} [given] */
        subdivide: (spec, given) => subdivide(core, spec, given),
        /** @param {unknown} spec */
        mesh: (spec) => makeMesh(core, spec),
        get solids() {
            return core.json('solids');
        },
        /** @param {unknown} request */
        fit: (request) => fit(core, request),
        /** @param {unknown} request */
        interpolate: (request) => interpolate(core, request),
        /** @param {unknown} points @param {unknown} [given] */
        enclosingSphere: (points, given) => enclosingSphere(core, points, given),
        /** @param {unknown} spec */
        axioms: (spec) => core.json('ask', 'axioms', core.send(spec)).axioms,
        /** @param {unknown} given the algorithm and its arguments */
        trace: (given) => core.json('ask', 'trace', core.send(given)),
        /** @param {unknown} document */
        scene: (document) => openScene(core, document),
        /** @param {unknown} document */
        validate: (document) => validate(core, document),
        get scenes() {
            return core.json('scenes');
        },
        /** @param {unknown} text @param {unknown} [given] */
        importDocument: (text, given) => importDocument(core, text, given),
        /** @param {unknown} document */
        encodeLink: async (document) => encodeLink(core, document),
        /** @param {unknown} link */
        decodeLink: async (link) => decodeLink(core, link),
        documentSchema: () => core.json('documentSchema'),
        /** The session of the module, for the application that draws its scenes. */
        session: core.session,
    });
}
