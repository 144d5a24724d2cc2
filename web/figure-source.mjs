// Where a figure's document comes from: a link, an address, the element's own content, or the name
// of a built-in scene.

import { KnotworkError } from './errors.mjs';

/**
 * @typedef {object} Source
 * @property {'state' | 'src' | 'inline' | 'scene' | 'none'} kind
 * @property {string} text
 */

/**
 * The first of the sources that the element names.
 * @param {HTMLElement} element
 * @returns {Source}
 */
export function sourceOf(element) {
    for (const kind of /** @type {const} */ (['state', 'src'])) {
        const text = element.getAttribute(kind);
        if (text) return { kind, text };
    }
    const inline = element.querySelector(':scope > script[type="application/json"]');
    if (inline?.textContent) return { kind: 'inline', text: inline.textContent };
    const text = element.getAttribute('scene');
    return text ? { kind: 'scene', text } : { kind: 'none', text: '' };
}

/**
 * The document itself, not checked yet but for being JSON.
 * @param {Source} source
 * @param {any} kw
 * @returns {Promise<any>}
 */
export async function readSource(source, kw) {
    switch (source.kind) {
        case 'state': return kw.decodeLink(source.text);
        case 'src': return parseText(await fetchText(source.text), source.text);
        case 'inline': return parseText(source.text, 'script');
        case 'scene': return builtin(source.text, kw);
        default: return undefined;
    }
}

/**
 * @param {string} id
 * @param {any} kw
 */
function builtin(id, kw) {
    const found = kw.scenes.find((/** @type {{ id: string }} */ scene) => scene.id === id);
    if (found) return found.document;
    const names = kw.scenes.map((/** @type {{ id: string }} */ scene) => scene.id).join(', ');
    throw new KnotworkError('UNKNOWN_NAME', 'scene', `There is no scene "${id}"; there are ${names}.`);
}

const largestDocument = 1024 * 1024;  // bytes, as the core has it

/** @param {string} address */
async function fetchText(address) {
    const url = new URL(address, document.baseURI).href;
    const response = await fetch(url).catch((error) => {
        throw new KnotworkError('NOT_SUPPORTED', 'src', `${url} could not be fetched: ${error.message}`);
    });
    if (!response.ok) {
        throw new KnotworkError('NOT_SUPPORTED', 'src', `${url} answered ${response.status} ${response.statusText}`);
    }
    return response.text();
}

/**
 * JSON from outside; the size is looked at before the text is.
 * @param {string} text
 * @param {string} name said in the refusal
 */
export function parseText(text, name) {
    if (text.length > largestDocument) {
        throw new KnotworkError('TOO_LARGE', '', `${name} is larger than a document may be (1 MiB).`);
    }
    try {
        return JSON.parse(text);
    } catch (error) {
        const reason = error instanceof Error ? error.message : String(error);
        throw new KnotworkError('SYNTAX', '', `${name} is not valid JSON: ${reason}`);
    }
}
