// Making elements without markup: every word that reaches the page goes through textContent, so no
// document, link or file can smuggle in markup, and no style attribute offends a strict policy.

/**
 * @typedef {object} Making
 * @property {string} [class]
 * @property {string} [text]
 * @property {Record<string, string | number | boolean | null | undefined>} [attributes] null, false
 *     and undefined leave the attribute out, true makes it empty
 * @property {Record<string, (event: any) => void>} [on]
 */

/**
 * An element with its attributes, listeners and children.
 * @template {keyof HTMLElementTagNameMap} Tag
 * @param {Tag} tag
 * @param {Making} [making]
 * @param {...(Node | string | null | undefined)} children
 * @returns {HTMLElementTagNameMap[Tag]}
 */
export function el(tag, making = {}, ...children) {
    const element = document.createElement(tag);
    if (making.class) element.className = making.class;
    if (making.text !== undefined) element.textContent = making.text;
    setAttributes(element, making.attributes ?? {});
    for (const [type, listener] of Object.entries(making.on ?? {})) {
        element.addEventListener(type, listener);
    }
    element.append(...children.filter((child) => child !== null && child !== undefined));
    return element;
}

/**
 * @param {Element} element
 * @param {Record<string, string | number | boolean | null | undefined>} attributes
 */
export function setAttributes(element, attributes) {
    for (const [name, value] of Object.entries(attributes)) {
        if (value === null || value === undefined || value === false) element.removeAttribute(name);
        else element.setAttribute(name, value === true ? '' : String(value));
    }
}

/**
 * Writes text only where it differs, so that live regions and selections are left in peace.
 * @param {Element} element
 * @param {string} text
 */
export function setText(element, text) {
    if (element.textContent !== text) element.textContent = text;
}

let lastId = 0;

/**
 * An id that no other element made here has, for labels and descriptions.
 * @param {string} prefix
 */
export function uniqueId(prefix) {
    lastId += 1;
    return `${prefix}-${lastId}`;
}

const svgNamespace = 'http://www.w3.org/2000/svg';

/**
 * A line icon of 24 by 24 units in the colour of the text around it; decoration only.
 * @param {string} path
 */
export function icon(path) {
    const svg = document.createElementNS(svgNamespace, 'svg');
    setAttributes(svg, { viewBox: '0 0 24 24', class: 'icon', 'aria-hidden': 'true', focusable: 'false' });
    const line = document.createElementNS(svgNamespace, 'path');
    line.setAttribute('d', path);
    svg.append(line);
    return svg;
}
