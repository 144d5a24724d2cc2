// Scenes as values.

import { finite, options } from './check.mjs';
import { KnotworkError } from './errors.mjs';
import { beginExport, exportScene } from './exports.mjs';
import { Held } from './held.mjs';

export class Scene extends Held {
    /** The canonical document: defaults filled in, keys in a fixed order. */
    get document() {
        const { core, handle } = Held.of(this);
        return core.json('sceneDocument', handle);
    }

    /** The fields of each object. */
    get schema() {
        const { core, handle } = Held.of(this);
        return core.json('sceneSchema', handle);
    }

    /** @param {{ phase?: number, time?: number, tolerance?: number, panes?: string[] }} [given] */
    drawing(given) {
        const { core, handle } = Held.of(this);
        const fields = options(given, ['phase', 'time', 'tolerance', 'panes']);
        const { phase, time } = moment(fields);
        const { tolerance } = fields;
        const distance = tolerance === undefined ? NaN : finite(tolerance, 'tolerance');
        const { bounds, shapes } = core.json('sceneDrawing', handle, phase, time, distance, paneBits(fields.panes));
        for (const shape of shapes) takeNumbers(core, shape);
        return { bounds, shapes };
    }

    /** The picture as SVG. @param {unknown} [given] */
    svg(given) {
        return this.exportAs('svg', given);
    }

    /** The scene for other programs. @param {unknown} format @param {unknown} [given] */
    exportAs(format, given) {
        const { core, handle } = Held.of(this);
        return exportScene(core, handle, format, given);
    }

    /** The same in slices. @param {unknown} format @param {unknown} [given] */
    exporting(format, given) {
        const { core, handle } = Held.of(this);
        return beginExport(core, handle, format, given);
    }

    /** Applies a command and says what it changed. @param {object} command */
    execute(command) {
        const { core, handle } = Held.of(this);
        return core.json('sceneExecute', handle, core.send(command));
    }

    /** Whether there was a step to take back. */
    undo() {
        const { core, handle } = Held.of(this);
        return core.count('sceneUndo', handle) === 1;
    }

    redo() {
        const { core, handle } = Held.of(this);
        return core.count('sceneRedo', handle) === 1;
    }

    get canUndo() {
        const { core, handle } = Held.of(this);
        return core.call('sceneCanUndo', handle);
    }

    get canRedo() {
        const { core, handle } = Held.of(this);
        return core.call('sceneCanRedo', handle);
    }

    /** What is selected: paths into the document, those left out that lead nowhere any more. */
    get selection() {
        const { core, handle } = Held.of(this);
        return core.json('sceneSelection', handle);
    }

    /** Selects without a step of history. @param {string[]} paths */
    select(paths) {
        const { core, handle } = Held.of(this);
        core.ask('sceneSelect', handle, core.send(paths));
    }

    /** Grows by one with every change. */
    get revision() {
        const { core, handle } = Held.of(this);
        return core.count('sceneRevision', handle);
    }

    /** Its name in the module, for a view that shows it. */
    get handle() {
        return Held.of(this).handle;
    }
}

/** @param {Record<string, unknown>} fields */
function moment({ phase, time }) {
    if (phase !== undefined && time !== undefined) {
        throw new KnotworkError('UNKNOWN_FIELD', 'time', 'Give a phase or a time, not both.');
    }
    if (time !== undefined) return { phase: NaN, time: finite(time, 'time') };
    const turn = phase === undefined ? 0 : finite(phase, 'phase');
    if (turn >= 0 && turn <= 1) return { phase: turn, time: NaN };
    throw new KnotworkError('OUT_OF_RANGE', 'phase', `phase is ${turn}; it must lie in [0, 1].`);
}

/** In the order of their bits. */
const paneNames = ['curve', 'basis', 'knots', 'bFunction', 'hodograph', 'curvature'];

/** Which panes are drawn, all where nothing is said. @param {unknown} panes */
function paneBits(panes) {
    if (panes === undefined) return (1 << paneNames.length) - 1;
    if (!Array.isArray(panes)) {
        throw new KnotworkError('WRONG_TYPE', 'panes', `panes is a list of names of panes: ${paneNames.join(', ')}.`);
    }
    return panes.reduce((bits, name, i) => bits | 1 << paneNumber(name, i), 0);
}

/** @param {unknown} name @param {number} i */
function paneNumber(name, i) {
    const number = paneNames.indexOf(/** @type {string} */ (name));
    if (number >= 0) return number;
    throw new KnotworkError('UNKNOWN_NAME', `panes[${i}]`, `Choose one of the panes ${paneNames.join(', ')}.`);
}

/** @param {import('./core.mjs').Core} core @param {any} shape */
function takeNumbers(core, shape) {
    const { at, count, normalsAt, indicesAt, indexCount } = shape;
    shape.positions = core.copy(at, count);
    if (normalsAt !== undefined) shape.normals = core.copy(normalsAt, count);
    if (indicesAt !== undefined) shape.indices = core.indices(indicesAt, indexCount).slice();
    for (const key of ['at', 'count', 'normalsAt', 'indicesAt', 'indexCount']) delete shape[key];
}

/** @param {import('./core.mjs').Core} core @param {unknown} document */
export function openScene(core, document) {
    return new Scene(core, core.openScene(core.send(document)));
}

/**
 * All that is wrong with a document, in the order in which it is read; nothing where it opens.
 * @param {import('./core.mjs').Core} core
 * @param {unknown} document
 * @returns {import('./errors.mjs').Problem[]}
 */
export function validate(core, document) {
    try {
        return core.problems(core.send(document));
    } catch (problem) {
        // What is no plain data, or too much of it, does not even get there.
        if (problem instanceof KnotworkError && problem.code !== 'OUT_OF_MEMORY') return problem.problems;
        throw problem;
    }
}
