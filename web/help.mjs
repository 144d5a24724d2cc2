// The help: what keys, mouse and fingers do.

import { openDialog } from './dialog.mjs';
import { el } from './dom.mjs';
import { mouseGestures, pageKeys, pictureKeys, touchGestures } from './keys.mjs';

/** @typedef {import('./words.mjs').Words} Words */

/** How keys are written on keyboards; letters are written as they are. @type {Record<string, string>} */
const caps = {
    ArrowLeft: '←', ArrowRight: '→', ArrowUp: '↑', ArrowDown: '↓', PageUp: 'Page Up', PageDown: 'Page Down', Escape: 'Esc',
};

/** @param {Words} words */
export function openHelp(words) {
    const gestures = (/** @type {{ how: string, does: string }[]} */ list) =>
        list.map(({ how, does }) => row(words, does, words.text(how)));
    const dialog = openDialog(words, words.text('page.help'), 'help',
        el('p', { text: words.text('help.lead') }),
        section(words, 'help.picture', pictureKeys.map((entry) => row(words, entry.does, ...keysOf(words, entry)))),
        section(words, 'help.page', pageKeys.map((entry) => row(words, entry.does, ...keysOf(words, entry)))),
        section(words, 'help.mouse', gestures(mouseGestures)),
        section(words, 'help.touch', gestures(touchGestures)));
    // There is nothing in it that takes the focus, and it must be scrolled by keys all the same.
    dialog.querySelector('.dialog-body')?.setAttribute('tabindex', '0');
    return dialog;
}

/** @param {Words} words @param {string} title @param {HTMLElement[]} rows */
function section(words, title, rows) {
    return el('table', { class: 'help-table' }, el('caption', { text: words.text(title) }), el('tbody', {}, ...rows));
}

/** @param {Words} words @param {string} does @param {...(Node | string)} how */
function row(words, does, ...how) {
    return el('tr', {}, el('th', { attributes: { scope: 'row' } }, ...how), el('td', { text: words.text(does) }));
}

/** @param {Words} words @param {import('./keys.mjs').KeyEntry} entry */
function keysOf(words, { keys, with: held = [] }) {
    const cap = (/** @type {string} */ text) => el('kbd', { text });
    const modifiers = held.flatMap((name) => [cap(name === 'command' ? words.text('help.command') : name), ' + ']);
    return [...modifiers, ...keys.flatMap((key, k) => [k > 0 ? ' ' : '', cap(nameOf(words, key))])];
}

/** @param {Words} words @param {string} key */
function nameOf(words, key) {
    if (key === ' ') return words.text('help.space');
    return caps[key] ?? (/^[a-z]$/.test(key) ? key.toUpperCase() : key);
}
