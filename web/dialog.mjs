// Dialogs of the page: modal, closed by Escape, by their button, or by a press beside them.

import { el, icon, uniqueId } from './dom.mjs';
import { icons } from './icons.mjs';

/**
 * A dialog that is there as long as it is open, with a heading that names it.
 * @param {import('./words.mjs').Words} words
 * @param {string} title
 * @param {string} kind its class
 * @param {...Node} content
 */
export function openDialog(words, title, kind, ...content) {
    const id = uniqueId('dialog');
    const close = el('button', {
        class: 'tool', on: { click: () => dialog.close() },
        attributes: { type: 'button', 'aria-label': words.text('page.close'), title: words.text('page.close') },
    }, icon(icons.remove));
    const head = el('header', { class: 'dialog-head' }, el('h2', { text: title, attributes: { id } }), close);
    const dialog = el('dialog', { class: `dialog ${kind}`, attributes: { 'aria-labelledby': id } },
        head, el('div', { class: 'dialog-body' }, ...content));
    dialog.addEventListener('pointerdown', (event) => {
        if (event.target === dialog && isBeside(dialog, event)) dialog.close();
    });
    dialog.addEventListener('close', () => dialog.remove());
    document.body.append(dialog);
    dialog.showModal();
    return dialog;
}

/** @param {HTMLElement} element @param {PointerEvent} event */
function isBeside(element, { clientX, clientY }) {
    const { left, right, top, bottom } = element.getBoundingClientRect();
    return clientX < left || clientX > right || clientY < top || clientY > bottom;
}
