// Formulae: MathML from a text, made element by element, so that nothing but mathematics gets in.

const namespace = 'http://www.w3.org/1998/Math/MathML';

const elements = new Set([
    'math', 'mrow', 'mi', 'mn', 'mo', 'mtext', 'mspace', 'mfrac', 'msqrt', 'mroot', 'msub', 'msup', 'msubsup',
    'munder', 'mover', 'munderover', 'mtable', 'mtr', 'mtd',
]);

/** Those that only say how a formula is set. */
const attributes = ['display', 'mathvariant', 'stretchy', 'fence', 'separator', 'columnalign', 'width'];

/**
 * The formula as an element, or null where the text is no well-formed MathML. Elements and
 * attributes that are none of these are left out with all that is in them.
 * @param {string | undefined} text
 * @returns {Element | null}
 */
export function formulaOf(text) {
    if (!text) return null;
    const parsed = new DOMParser().parseFromString(text, 'application/xml');
    const malformed = parsed.getElementsByTagName('parsererror').length > 0;
    return malformed || parsed.documentElement.localName !== 'math' ? null : copyOf(parsed.documentElement);
}

/** @param {Element} original @returns {Element | null} */
function copyOf(original) {
    if (original.namespaceURI !== namespace || !elements.has(original.localName)) return null;
    const copy = document.createElementNS(namespace, original.localName);
    for (const name of attributes) {
        const value = original.getAttribute(name);
        if (value !== null) copy.setAttribute(name, value);
    }
    for (const child of original.childNodes) {
        if (child instanceof Element) copy.append(copyOf(child) ?? '');
        else if (child.nodeType === Node.TEXT_NODE) copy.append(child.textContent ?? '');
    }
    return copy;
}
