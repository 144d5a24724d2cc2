// What comes from outside into the page: files that are opened or dropped, and text that is pasted.

/** Bytes of a file; a document that is made of it has at most 1 MiB all the same. */
const largestFile = 4 * 1024 * 1024;

/**
 * @typedef {object} Incoming
 * @property {string} text
 * @property {string} name of the file, '' for what was pasted
 */

/**
 * The text of a file; throws { code, message } where it is too large.
 * @param {File} file
 * @param {import('./words.mjs').Words} words
 * @returns {Promise<Incoming>}
 */
export async function readFile(file, words) {
    if (file.size > largestFile) {
        throw { code: 'TOO_LARGE', path: '', message: words.text('page.file.size', { name: file.name }) };
    }
    return { text: await file.text(), name: file.name };
}

/**
 * The document of a text: a scene as it is, points, paths and meshes as objects of a new one. Words
 * that are none of these would pass for the heading of an empty table.
 * @param {any} kw
 * @param {Incoming} incoming
 * @param {import('./words.mjs').Words} words
 */
export function documentOf(kw, { text, name }, words) {
    const title = name.replace(/\.[^.]*$/, '');
    const isScene = /^\s*\{/.test(text);
    const document = kw.importDocument(text, isScene || title === '' ? {} : { title });
    if (isScene || document.objects.length > 0) return document;
    throw { code: 'SYNTAX', path: '', message: words.text('page.nothing') };
}

/**
 * Takes what is dropped anywhere on the page.
 * @param {(file: File) => void} open
 */
export function acceptDrops(open) {
    const over = (/** @type {boolean} */ on) => document.body.toggleAttribute('data-dropping', on);
    document.addEventListener('dragover', (event) => {
        event.preventDefault();
        over(true);
    });
    document.addEventListener('dragleave', (event) => {
        if (!event.relatedTarget) over(false);
    });
    document.addEventListener('drop', (event) => {
        event.preventDefault();
        over(false);
        const file = event.dataTransfer?.files[0];
        if (file) open(file);
    });
}

/**
 * Takes what is pasted while nothing that takes text has the focus.
 * @param {(incoming: Incoming | File) => void} open
 */
export function acceptPastes(open) {
    document.addEventListener('paste', (event) => {
        if (takesText(event.composedPath()[0]) || document.querySelector('dialog[open]')) return;
        const file = event.clipboardData?.files[0];
        const text = event.clipboardData?.getData('text/plain') ?? '';
        if (!file && text.trim() === '') return;
        event.preventDefault();
        open(file ?? { text, name: '' });
    });
}

/** @param {EventTarget | undefined} target */
export function takesText(target) {
    return target instanceof Element && target.matches('input, textarea, select, [contenteditable]');
}
