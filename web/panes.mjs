// Which panes a document asks for, which it could have, and the commands that show and hide them. A
// pane is shown where `view.panes` names it and some object offers something for it.

import { algorithmsFor } from './traces.mjs';

/**
 * In the order in which documents name them, with the flags of `show` of which one offers it.
 * @type {Record<string, string[]>}
 */
const flagsOf = {
    curve: [],
    basis: ['basis'],
    knots: ['knots', 'basis'],
    bFunction: ['bFunction'],
    curvature: ['curvature'],
    hodograph: ['hodograph'],
};

export const paneNames = Object.keys(flagsOf);

/**
 * @typedef {object} PaneState
 * @property {string} name of the pane, or `trace`
 * @property {boolean} shown
 * @property {boolean} fixed whether it has to stay as it is
 */

/**
 * The panes that one could have a look at, in order.
 * @param {any} document canonical
 * @param {any[]} schema of its scene
 * @returns {PaneState[]}
 */
export function paneStates(document, schema) {
    const shown = paneNames.filter((name) => isShown(document, schema, name));
    const states = paneNames
        .filter((name) => name === 'curve' || owners(document, schema, name).length > 0)
        .map((name) => ({ name, shown: shown.includes(name), fixed: shown.length === 1 && shown[0] === name }));
    const traced = document.objects.some((/** @type {any} */ { trace }) => trace);
    const traceable = document.objects.some((/** @type {any} */ object) => algorithmsFor(object).length > 0);
    return traceable ? [...states, { name: 'trace', shown: traced, fixed: false }] : states;
}

/**
 * The command that shows or hides a pane, one step of history.
 * @param {any} document canonical
 * @param {any[]} schema of its scene
 * @param {string} name
 * @param {boolean} shown
 * @param {number} selected object, whose pane it is to be; −1 for the first that has one
 */
export function paneCommand(document, schema, name, shown, selected) {
    if (name === 'trace') return traceCommand(document, shown, selected);
    const panes = paneNames.filter((other) => (other === name ? shown : document.view.panes.includes(other)));
    const command = { set: 'view.panes', value: panes };
    const able = owners(document, schema, name);
    if (!shown || able.length === 0 || able.some((k) => offers(document.objects[k], name))) return command;
    const owner = able.includes(selected) ? selected : able[0];
    return { all: [command, { set: `objects[${owner}].show.${flagsOf[name][0]}`, value: true }] };
}

/** @param {any} document @param {boolean} shown @param {number} selected */
function traceCommand({ objects }, shown, selected) {
    if (!shown) {
        const traced = objects.flatMap((/** @type {any} */ { trace }, /** @type {number} */ k) => (trace ? [k] : []));
        return { all: traced.map((/** @type {number} */ k) => ({ remove: `objects[${k}].trace` })) };
    }
    const able = objects.flatMap((/** @type {any} */ object, /** @type {number} */ k) => (algorithmsFor(object).length > 0 ? [k] : []));
    const owner = able.includes(selected) ? selected : able[0];
    return { set: `objects[${owner}].trace`, value: { algorithm: algorithmsFor(objects[owner])[0] } };
}

/** @param {any} document @param {any[]} schema @param {string} name */
function isShown(document, schema, name) {
    if (!document.view.panes.includes(name)) return false;
    return name === 'curve' || owners(document, schema, name).some((k) => offers(document.objects[k], name));
}

/** @param {any} object @param {string} name */
function offers({ show }, name) {
    return flagsOf[name].some((flag) => show[flag]);
}

/**
 * The objects that could have something in the pane.
 * @param {any} document
 * @param {any[]} schema
 * @param {string} name
 * @returns {number[]}
 */
function owners({ objects }, schema, name) {
    const paths = flagsOf[name].map((flag) => `show.${flag}`);
    return objects.flatMap((/** @type {any} */ object, /** @type {number} */ k) => {
        const fields = schema.find(({ object: id }) => id === object.id)?.fields ?? [];
        const able = fields.some((/** @type {any} */ field) => paths.includes(field.path));
        // A cloud has knots and basis functions only where a curve is fitted to it.
        return able && (object.type !== 'point-cloud' || object.fit) ? [k] : [];
    });
}
