// SVG read back: a document checked by an XML parser, and the paths in it as points.
import assert from 'node:assert/strict';

import { SaxesParser } from 'saxes';

/**
 * The elements of a well-formed document, in order, each with the ones that it stands in.
 * @param {string} text
 */
export function elementsOf(text) {
    const parser = new SaxesParser({ xmlns: true });
    const open = [];
    const found = [];
    parser.on('error', (error) => assert.fail(error));
    parser.on('opentag', ({ name, uri, attributes }) => {
        const own = Object.fromEntries(Object.entries(attributes).map(([key, { value }]) => [key, value]));
        const element = { name, uri, attributes: own, text: '', parent: open.at(-1) };
        found.push(element);
        open.push(element);
    });
    parser.on('text', (content) => {
        if (open.length > 0) open.at(-1).text += content;
    });
    parser.on('closetag', () => open.pop());
    parser.write(text).close();
    return found;
}

/** The element of this name (and with these attributes) around one; undefined where there is none. */
export function around(element, attribute) {
    for (let at = element; at; at = at.parent) if (attribute in at.attributes) return at.attributes[attribute];
    return undefined;
}

const arity = { M: 2, L: 2, C: 6, Z: 0 };

/**
 * The data of a path as steps { command, points }; Z ends where its piece began.
 * @param {string} data
 */
export function stepsOf(data) {
    const words = data.match(/[A-Za-z]|[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?/g) ?? [];
    assert.equal(words.join('').length, data.replace(/[\s,]/g, '').length, 'nothing but commands and numbers');
    const steps = [];
    let start = [0, 0];
    for (let i = 0; i < words.length;) {
        const command = words[i++];
        assert.ok(command in arity, `${command} in ${data.slice(0, 60)}`);
        const numbers = words.slice(i, i + arity[command]).map(Number);
        i += arity[command];
        assert.ok(numbers.length === arity[command] && numbers.every(Number.isFinite));
        const points = command === 'Z' ? [start] : numbers.flatMap((x, k) => (k % 2 === 0 ? [[x, numbers[k + 1]]] : []));
        if (command === 'M') start = points[0];
        steps.push({ command, points });
    }
    return steps;
}

/** A point of a step that begins at `from`. */
export function pointOn(from, { command, points }, s) {
    if (command !== 'C') return [0, 1].map((c) => from[c] + s * (points[0][c] - from[c]));
    const r = 1 - s;
    const [first, second, end] = points;
    return [0, 1].map((c) => r ** 3 * from[c] + 3 * r * r * s * first[c] + 3 * r * s * s * second[c] + s ** 3 * end[c]);
}

/** What SVG's matrix(a b c d e f) makes of a point, and back. */
export const mapped = ([a, b, c, d, e, f], [x, y]) => [a * x + c * y + e, b * x + d * y + f];
export function unmapped([a, b, c, d, e, f], [x, y]) {
    const [u, v, determinant] = [x - e, y - f, a * d - b * c];
    return [(d * u - c * v) / determinant, (a * v - b * u) / determinant];
}
