// The B-functions of all objects of a scene in one graph, to be compared.

import { el, setAttributes, uniqueId } from './dom.mjs';

const namespace = 'http://www.w3.org/2000/svg';
const size = { width: 240, height: 132, margin: 6 };
const samples = 97;
const dashes = ['', '7 4', '2 4', '9 4 2 4'];  // so that colour is not all that tells them apart

/**
 * The graphs of the B-functions of these objects with their names, or null where there are no two.
 * @param {import('./words.mjs').Words} words
 * @param {any} kw
 * @param {any[]} objects of a canonical document
 */
export function graphsOf(words, kw, objects) {
    const shown = comparedOf(objects);
    if (shown.length < 2) return null;
    const pens = pensOf(shown);
    const labels = new Map(kw.bFunctions.map((/** @type {any} */ { family, label }) => [family, label]));
    const nameOf = (/** @type {any} */ { id, bFunction }) => `${id}: ${words.label(labels.get(bFunction.family) ?? bFunction.family)}`;
    const title = uniqueId('graphs');
    const picture = svg('svg', {
        viewBox: `0 0 ${size.width} ${size.height}`, role: 'img', class: 'graph', 'aria-labelledby': title,
    }, frame(), ...shown.map((object, k) => graph(kw, object, pens[k])));
    const legend = el('ul', { class: 'legend', attributes: { id: title } }, ...shown.map((object, k) =>
        el('li', {}, svg('svg', { viewBox: '0 0 32 6', class: 'sample', 'aria-hidden': 'true' },
            svg('path', { d: 'M0 3H32', ...pens[k] })), nameOf(object))));
    return el('div', { class: 'graphs' }, picture, legend);
}

/**
 * The first object of each B-function, as many as can be told apart.
 * @param {any[]} objects of a canonical document
 */
export function comparedOf(objects) {
    const firsts = new Map();
    for (const object of objects) {
        const { type, bFunction } = object;
        if (type === 'b-function' || !bFunction || Array.isArray(bFunction)) continue;
        const spec = JSON.stringify(bFunction);
        if (!firsts.has(spec)) firsts.set(spec, object);
    }
    return [...firsts.values()].slice(0, dashes.length);
}

/** @typedef {{ stroke: string, 'stroke-dasharray': string | null }} Pen */

/** @param {any} kw @param {any} object @param {Pen} pen */
function graph(kw, object, pen) {
    const b = kw.bFunction(object.bFunction);
    const values = b.sample(samples);
    b.dispose();
    const points = Array.from(values, (value, i) => place(i / (samples - 1), value));
    return svg('path', { d: `M${points.join('L')}`, ...pen });
}

function frame() {
    const lines = [[0, 0, 1, 0], [0, 0.5, 1, 0.5], [0, 1, 1, 1], [0, 0, 0, 1], [0.5, 0, 0.5, 1], [1, 0, 1, 1]];
    return svg('path', { class: 'grid', d: lines.map(([t, b, t1, b1]) => `M${place(t, b)}L${place(t1, b1)}`).join('') });
}

/** @param {number} t @param {number} value */
function place(t, value) {
    const { width, height, margin } = size;
    const [x, y] = [margin + t * (width - 2 * margin), margin + (1 - value) * (height - 2 * margin)];
    return `${x.toFixed(2)} ${y.toFixed(2)}`;
}

/**
 * As in the picture; where all are drawn alike, dashes that the picture has not.
 * @param {any[]} objects
 * @returns {Pen[]}
 */
function pensOf(objects) {
    const told = objects.some(({ style }) => style?.dashed);
    return objects.map(({ style }, k) => {
        const dash = told ? dashes[style?.dashed ? 1 : 0] : dashes[k];
        return { stroke: style?.colour ?? '#2b6cb0', 'stroke-dasharray': dash || null };
    });
}

/**
 * @param {string} tag
 * @param {Record<string, string | number | null>} attributes
 * @param {...Node} children
 */
function svg(tag, attributes, ...children) {
    const element = document.createElementNS(namespace, tag);
    setAttributes(element, attributes);
    element.append(...children);
    return element;
}
