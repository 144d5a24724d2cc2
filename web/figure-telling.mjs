// What a figure says in words: its text alternative, and why it shows nothing.

import { el, setText } from './dom.mjs';
import { hasValues } from './figure-controls.mjs';
import { shapeSentence } from './shape.mjs';

/** @typedef {ReturnType<import('./figure-parts.mjs').makeParts>} Parts */
/** @typedef {import('./words.mjs').Words} Words */

/**
 * What keys do in this figure, and where its numbers are.
 * @param {import('./figure.mjs').Wishes} wishes
 */
function keysSentence({ words, readOnly, controls }) {
    const panel = hasValues(controls);
    return [
        ...readOnly ? [] : ['hands'], ...panel && !readOnly ? ['exact'] : [], 'view', ...panel ? ['values'] : [],
    ].map((part) => words.text(`figure.keys.${part}`)).join(' ');
}

/**
 * Keeps the text alternative in step with the picture, and answers its sentence about the shape.
 * @param {Parts} parts
 * @param {import('./figure.mjs').Wishes} wishes
 * @param {import('./figure-reading.mjs').Reading} read
 * @param {string} name of a built-in scene, or ''
 */
export function describe(parts, wishes, read, name) {
    const { words } = wishes;
    const { title, objects } = read.document;
    const shown = words.scene(name, 'title', title ?? '');
    parts.wrapper.setAttribute('aria-label', words.text('figure', { title: shown }));
    const labels = new Map(read.schema.map((/** @type {any} */ o) => [o.object, o.label ?? o.type]));
    const sentence = objects.map((/** @type {any} */ object) =>
        shapeSentence(words, object, labels.get(object.id) ?? object.type)).join(' ');
    setText(parts.about, `${sentence} ${keysSentence(wishes)}`);
    return sentence;
}

/**
 * Says in the picture's place why there is none.
 * @param {Parts} parts
 * @param {Words} words
 * @param {string} reason
 */
export function showFailure(parts, words, reason) {
    parts.fallback.hidden = false;
    parts.message.hidden = false;
    parts.message.className = '';
    setText(parts.message, `${words.text('failed')} ${reason}`);
}

/**
 * Says in the figure itself why a document was refused.
 * @param {Parts} parts
 * @param {Words} words
 * @param {any} error
 * @param {boolean} kept whether a former scene is still shown
 */
export function showRefusal(parts, words, error, kept) {
    const sentences = [words.text('refused.scene'), words.refusal(error)];
    if (error.path) sentences.push(words.text('refused.where', { path: error.path }));
    if (kept) sentences.push(words.text('refused.kept'));
    parts.message.hidden = true;
    parts.refusal.hidden = false;
    parts.refusal.replaceChildren(...sentences.map((text) => el('p', { text })));
}

/**
 * Selects the first thing that can be taken hold of; answers whether there is one.
 * @param {import('./page-module.mjs').App} app
 * @param {number} id of the view
 * @param {any} document
 */
export function selectFirst(app, id, document) {
    for (const k of document.objects.keys()) {
        for (const list of ['points', 'poses']) {
            app.select(id, `objects[${k}].${list}[0]`);
            if (app.selection(id) !== 'null') return true;
        }
    }
    return false;
}
