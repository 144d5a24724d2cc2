// What can be said about a curve: measured through the public interface, told in a sentence.

/**
 * How smooth a B-spline curve is: `usual` at its simple knots, and the interior knots (one period
 * of them where closed) with less. −1 stands for a gap.
 * @param {{ degree: number, form: string, knots: number[] }} spec
 * @returns {{ usual: number, exceptions: { knot: number, order: number }[] }}
 */
export function continuity({ degree, form, knots }) {
    const first = form === 'closed' ? 0 : degree;
    const last = form === 'closed' ? knots.length - 1 : knots.length - degree - 1;
    const inside = (/** @type {number} */ knot) => (form === 'closed'
        ? knot >= knots[first] && knot < knots[last]
        : knot > knots[first] && knot < knots[last]);
    const times = new Map();
    for (const knot of knots.filter(inside)) times.set(knot, (times.get(knot) ?? 0) + 1);
    const exceptions = [...times]
        .filter(([, multiplicity]) => multiplicity > 1)
        .map(([knot, multiplicity]) => ({ knot, order: degree - multiplicity }));
    return { usual: degree - 1, exceptions };
}

const superscripts = '⁰¹²³⁴⁵⁶⁷⁸⁹';

/**
 * C², C¹⁰ or a gap.
 * @param {import('./words.mjs').Words} words
 * @param {number} order
 */
export function className(words, order) {
    if (order < 0) return words.text('shape.gap');
    if (order === Infinity) return 'C∞';
    return `C${[...String(order)].map((digit) => superscripts[Number(digit)]).join('')}`;
}

const namedExceptions = 3;

/**
 * "C² except C⁰ at t = 0.5"
 * @param {import('./words.mjs').Words} words
 * @param {{ degree: number, form: string, knots: number[] }} spec
 */
export function continuityText(words, spec) {
    const { usual, exceptions } = continuity(spec);
    const name = className(words, usual);
    if (exceptions.length === 0) return words.text('shape.smooth', { class: name });
    const told = exceptions.slice(0, namedExceptions).map(({ knot, order }) =>
        words.text('shape.at', { class: className(words, order), knot }));
    const rest = exceptions.length - told.length;
    if (rest > 0) told.push(words.text('shape.more', { count: rest }));
    return words.text('shape.except', { class: name, exceptions: told.join(', ') });
}

/**
 * One object in a sentence: "B-spline curve: degree 3, 7 points, closed, C²".
 * @param {import('./words.mjs').Words} words
 * @param {any} object as the canonical document has it
 * @param {string} label of its type
 */
export function shapeSentence(words, object, label) {
    const parts = [];
    if (object.type === 'bspline-curve') {
        parts.push(words.text('shape.degree', { degree: object.degree }));
        parts.push(words.text('shape.points', { count: pointCount(object.points) }));
        parts.push(formText(words, object.form), continuityText(words, object));
    }
    if (object.type === 'blending-curve') {
        parts.push(words.text('shape.locals', { count: localCount(object) }));
        if (object.form) parts.push(formText(words, object.form));
    }
    const name = words.label(label);
    return parts.length > 0 ? `${name}: ${parts.join(', ')}.` : `${name}.`;
}

/** @param {import('./words.mjs').Words} words @param {string} form */
function formText(words, form) {
    return words.text(`shape.${form}`);
}

/** @param {any} points a list of points, or a flat one of triples */
export function pointCount(points) {
    return typeof points?.[0] === 'number' ? points.length / 3 : points?.length ?? 0;
}

/** @param {any} object a blending curve */
export function localCount(object) {
    return Array.isArray(object.locals) ? object.locals.length : object.locals?.count ?? 0;
}

/**
 * What makes the object itself, as kw.curve() and kw.surface() take it.
 * @param {any} object of a canonical document
 */
export function bare(object) {
    const { id, style, show, t, trace, line, ...spec } = object;
    return spec;
}
