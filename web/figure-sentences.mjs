// What is selected and what a command did, in sentences to be read aloud.

import { bare } from './shape.mjs';

/** @typedef {import('./figure-handles.mjs').Held} Held */
/** @typedef {import('./words.mjs').Words} Words */

/**
 * "Control point 3 of 7"
 * @param {Words} words
 * @param {Held} held
 */
export function heldName(words, held) {
    const { number, count } = held;
    if (held.kind === 'group') return words.text('held.group', { name: severalName(words, nounOf(held), count) });
    if (isValue(held)) return valueName(words, held.path);
    const row = /\[(\d+)\]\[(\d+)\]$/.exec(held.path);
    if (row) return words.text('held.net', { number, count, row: Number(row[1]) + 1, column: Number(row[2]) + 1 });
    if (held.kind === 'line') return words.text(`held.${lineNoun(number)}`);
    return words.text(`held.${nounOf(held)}`, { number, count });
}

/** @param {number} number of its point or of its direction */
function lineNoun(number) {
    return number === 1 ? 'line-point' : 'line-direction';
}

/** Whether it is no element of a list. @param {Held} held */
const isValue = ({ kind }) => kind === 'parameter' || kind === 'effect';

/** How parameters are written in formulas. @type {Record<string, string>} */
const letters = { alpha: 'α', beta: 'β', gamma: 'γ', lambda: 'λ' };

/**
 * "λ of the B-function", "Angle of effect 2"
 * @param {Words} words
 * @param {string} path
 */
function valueName(words, path) {
    const [, effect] = /^effects\[(\d+)\]/.exec(path) ?? [];
    const [, place] = /\.values\[(\d+)\]$/.exec(path) ?? [];
    const name = path.slice(path.lastIndexOf('.') + 1);
    if (effect) return words.text(`held.effect.${name}`, { number: Number(effect) + 1 });
    if (place) return words.text('held.table', { number: Number(place) + 1 });
    return words.text('held.parameter', { name: letters[name] ?? name });
}

/** @param {{ kind: string, path: string, local?: any, of?: string }} held */
function nounOf({ kind, path, local, of = kind }) {
    if (kind === 'pose') return Array.isArray(local) ? 'patch' : 'local';
    return path.includes('.vertices[') ? 'vertex' : of;
}

/**
 * "5 points"
 * @param {Words} words
 * @param {string} noun
 * @param {number} count
 */
function severalName(words, noun, count) {
    return words.text(`several.${noun}`, { count });
}

/**
 * "x 1.25, y 0.5"; of a local also how it is turned and scaled.
 * @param {Words} words
 * @param {Held} held
 */
export function heldValues(words, { kind, value, spatial }) {
    if (kind === 'knot') return `t ${words.number(value)}`;
    if (typeof value === 'number') return words.number(value);
    if (kind === 'point' || kind === 'line') return coordinates(words, value);
    if (kind === 'effect') return coordinates(words, value.slice(0, spatial ? 3 : 2));
    if (kind === 'group') return coordinates(words, value.slice(0, spatial ? 3 : 2));
    const { translate, angle, scale } = value;
    const parts = [coordinates(words, translate.slice(0, spatial ? 3 : 2))];
    if (angle !== 0) parts.push(words.text('held.turned', { degrees: Math.round(angle * 180 / Math.PI) }));
    if (scale.some((/** @type {number} */ factor) => factor !== 1)) {
        const even = scale[0] === scale[1] && scale[1] === scale[2];
        parts.push(words.text('held.scaled', { factor: even ? scale[0] : scale.map((/** @type {number} */ f) => words.number(f)).join(' × ') }));
    }
    return parts.join(', ');
}

/**
 * @param {Words} words
 * @param {number[]} point
 */
export function coordinates(words, point) {
    return point.map((value, k) => `${'xyz'[k]} ${words.number(value)}`).join(', ');
}

/**
 * What was done, and what the shape is after it: "Knot inserted at 0.5. B-spline curve: degree 3,
 * 8 points, clamped, C²."
 * @param {Words} words
 * @param {{ source: string, command: any, what?: string }} change
 * @param {any} document after it
 * @param {string} shape the sentence about what there is now
 * @param {any} kw
 */
export function doneSentence(words, { command, what }, document, shape, kw) {
    if (what === 'undo' || command?.undo) return words.text('said.undone', { shape });
    if (what === 'redo' || command?.redo) return words.text('said.redone', { shape });
    if (!command) return shape;
    const panes = panesIn(command);
    if (panes) return words.text('said.shown', { panes: panes.map((name) => words.text(`pane.${name}`)).join(', ') });
    if (typeof command.move === 'string') return movedSentence(words, command.move, document, shape, kw);
    const value = isValuePath(command.set) ? valueAt(document, command.set) : undefined;
    if (value !== undefined) {
        const told = typeof value === 'number' ? words.number(value) : coordinates(words, value);
        return words.text('said.group', { name: valueName(words, command.set), value: told });
    }
    if (command.insertKnot) return words.text('said.knot-inserted', { at: command.insertKnot.at, shape });
    for (const done of ['insert', 'remove']) {
        const place = placeOf(command[done]);
        if (place) return words.text(`said.${done}`, { name: nameOf(words, place), shape });
    }
    if (command.pose?.by) return words.text('said.group', groupPosed(words, command.pose));
    if (command.pose) return posedSentence(words, command.pose);
    if (Array.isArray(command.move)) return words.text('said.group', groupMoved(words, command));
    if (command.all?.every((/** @type {any} */ one) => one.remove)) {
        return words.text('said.remove', { name: severalName(words, nounOfPath(command.all[0].remove), command.all.length), shape });
    }
    return shape;
}

/**
 * Whether it is one of those that handles of their own stand for.
 * @param {any} path
 */
const isValuePath = (path) => typeof path === 'string' &&
    (/\.bFunction\.(values\[\d+\]|order|p|q|m|c|lambda|beta|weight)$/.test(path) ||
        /^effects\[\d+\]\.(by|center|angle|axis|factor|translate|rotate\.angle)$/.test(path));

/** @param {string} path */
const nounOfPath = (path) => path.includes('.vertices[') ? 'vertex' : 'point';

/**
 * @param {Words} words
 * @param {any} command
 */
function groupMoved(words, { move, by }) {
    const value = words.text('said.by', { value: coordinates(words, by) });
    return { name: severalName(words, nounOfPath(move[0]), move.length), value };
}

/**
 * @param {Words} words
 * @param {any} pose
 */
function groupPosed(words, { locals, by: { translate, rotate, scale } }) {
    const value = translate ? words.text('said.by', { value: coordinates(words, translate) })
        : rotate ? words.text('held.turned', { degrees: Math.round(rotate.angle * 180 / Math.PI) })
            : words.text('held.scaled', { factor: scale });
    return { name: severalName(words, Array.isArray(locals[0]) ? 'patch' : 'local', locals.length), value };
}

/**
 * @param {Words} words
 * @param {string} path
 * @param {any} document
 * @param {string} shape
 * @param {any} kw
 */
function movedSentence(words, path, document, shape, kw) {
    const place = placeOf(path);
    const value = place && valueAt(document, path);
    if (!place || value === undefined) return shape;
    const name = nameOf(words, place);
    if (typeof value === 'number') return words.text('said.knot-moved', { name, value, shape });
    const moved = words.text('said.moved', { name, value: coordinates(words, value) });
    const object = document.objects[Number(/^objects\[(\d+)\]/.exec(path)?.[1])];
    const counted = crossingsOf(kw, object);
    return counted ? `${moved} ${words.text('crossings.said', counted)}` : moved;
}

/**
 * How often an object's line crosses its curve and its polygon, where it is there to be counted.
 * @param {any} kw
 * @param {any} object of a canonical document
 * @returns {{ curve: number, polygon: number } | null}
 */
export function crossingsOf(kw, object) {
    if (!object?.line || !object.show.crossings) return null;
    const made = kw.curve(bare(object));
    try {
        const { curve, polygon } = made.crossings(...object.line);
        return { curve: curve.length, polygon: polygon.length };
    } catch {
        return null;  // an object without a control polygon
    } finally {
        made.dispose();
    }
}

/** The panes that a command asks for. @param {any} command @returns {string[] | null} */
function panesIn(command) {
    const one = [command, ...command.all ?? []].find(({ set }) => set === 'view.panes');
    return one?.value ?? null;
}

/**
 * @param {Words} words
 * @param {any} pose
 */
function posedSentence(words, { local, translate, rotate, scale = 1 }) {
    const list = Array.isArray(local);
    const name = words.text(list ? 'said.patch' : 'said.local', { number: list ? local.map((/** @type {number} */ k) => k + 1).join(', ') : local + 1 });
    const [x = 0, y = 0, z = 0] = translate ?? [];
    const factors = typeof scale === 'number' ? [scale, scale, scale] : scale;
    const value = { translate: [x, y, z], angle: rotate?.angle ?? 0, scale: factors };
    const told = heldValues(words, /** @type {any} */ ({ kind: 'pose', value, spatial: list || z !== 0 }));
    return words.text('said.moved', { name, value: told });
}

/**
 * The list and the number that a path ends with.
 * @param {any} path
 */
function placeOf(path) {
    const [, list, index] = (typeof path === 'string' && /\.(\w+)(?:\[\d+\])*\[(\d+)\]$/.exec(path)) || [];
    return list ? { list, number: Number(index) + 1 } : undefined;
}

/**
 * @param {Words} words
 * @param {{ list: string, number: number }} place
 */
function nameOf(words, { list, number }) {
    if (list === 'line') return words.text(`said.${lineNoun(number)}`);
    const noun = { points: 'point', vertices: 'vertex', knots: 'knot' }[list];
    return noun ? words.text(`said.${noun}`, { number }) : words.text('said.element', { number });
}

/**
 * @param {any} document
 * @param {string} path such as objects[0].points[2]
 */
function valueAt(document, path) {
    const steps = path.match(/\w+/g) ?? [];
    return steps.reduce((value, step) => value?.[step], document);
}
