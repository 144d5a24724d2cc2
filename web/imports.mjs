// Documents from what other programs write: JSON, tables of points, OBJ, SVG paths.

import { choice, options, text } from './check.mjs';
import { KnotworkError } from './errors.mjs';
import { readTable } from './import-table.mjs';
import { readPaths } from './import-paths.mjs';
import { makeMesh } from './mesh.mjs';

/** @typedef {import('./core.mjs').Core} Core */

const formats = /** @type {const} */ (['json', 'csv', 'obj', 'svg']);

/** Letters of a text; a document that is made of it has at most 1 MiB all the same. */
const mostLetters = 2 ** 22;
/** Twice that, for blanks and ends of lines. */
const mostLettersOfJson = 2 ** 21;
/** Of a scene. */
const mostObjects = 1000;

/**
 * The canonical document of a text.
 * @param {Core} core
 * @param {unknown} given
 * @param {unknown} [settings]
 */
export function importDocument(core, given, settings) {
    const { format, as, title } = options(settings, ['format', 'as', 'title']);
    const whole = text(given, 'text');
    if (whole.length > mostLetters) {
        throw new KnotworkError('TOO_LARGE', 'text',
            `The text has ${whole.length} letters; at most ${mostLetters} are read.`);
    }
    const read = whole.startsWith('\uFEFF') ? whole.slice(1) : whole;
    const kind = format === undefined ? guess(read) : choice(format, 'format', formats);
    const document = readers[kind](core, read, choice(as ?? 'points', 'as', ['points', 'curve']));
    if (title !== undefined) document.title = text(title, 'title');
    return core.canonicalDocument(core.send(document));
}

/** @type {Record<typeof formats[number], (core: Core, text: string, as: 'points' | 'curve') => any>} */
const readers = {
    json: (_core, whole) => readJson(whole),
    csv: (_core, whole, as) => documentOf(readTable(whole, mostObjects).map(({ name, points }) => ({
        ...(name === '' ? {} : { id: name }), ...(as === 'points' ? cloudOf(points) : splineOf(points)),
    }))),
    obj: (core, whole) => documentOf([meshOf(core, whole)]),
    svg: (_core, whole) => documentOf(readPaths(whole, mostObjects)),
};

/** @param {string} whole */
function guess(whole) {
    if (/^\s*[{[]/.test(whole)) return 'json';
    if (/^\s*(<|[Mm]\s*[-+.\d])/.test(whole)) return 'svg';
    return /^[ \t]*v[ \t]+[-+.\d]/m.test(whole) ? 'obj' : 'csv';
}

/** @param {object[]} objects */
const documentOf = (objects) => ({ knotwork: 1, objects });

/** @param {number[][]} points */
const cloudOf = (points) => ({ type: 'point-cloud', points });

/** The points as control points. @param {number[][]} points */
const splineOf = (points) => ({ type: 'bspline-curve', degree: Math.min(3, Math.max(1, points.length - 1)), points });

/** @param {Core} core @param {string} whole */
function meshOf(core, whole) {
    const mesh = makeMesh(core, { obj: whole });
    try {
        const { vertices, faces } = mesh.spec;
        const scheme = faces.every((/** @type {number[]} */ face) => face.length === 3) ? 'loop' : 'catmull-clark';
        return { type: 'subdivision-surface', scheme, levels: 0, mesh: { vertices, faces } };
    } finally {
        mesh.dispose();
    }
}

/** @param {string} whole */
function readJson(whole) {
    if (whole.length > mostLettersOfJson) {
        throw new KnotworkError('TOO_LARGE', 'text', `A document has at most 1 MiB; this one has ${whole.length} letters.`);
    }
    try {
        return JSON.parse(whole);
    } catch (error) {
        throw new KnotworkError('SYNTAX', 'text', `This is no JSON. ${/** @type {Error} */ (error).message}`);
    }
}
