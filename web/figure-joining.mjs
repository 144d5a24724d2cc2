// How the parts of a figure take hold of its view in the application.

import { FigureHands } from './figure-hands.mjs';
import { FigureInput } from './figure-input.mjs';

/** @typedef {import('./page-module.mjs').App} App */

/**
 * @typedef {object} JoiningHost
 * @property {() => import('./figure.mjs').Wishes} wishes
 * @property {(sentence: string) => void} say
 * @property {() => void} acted after the application was told something
 * @property {(held: import('./figure-handles.mjs').Held) => boolean} openValues
 * @property {(event: KeyboardEvent) => boolean} shortcut
 */

/**
 * Hands and input that work on this view.
 * @param {ReturnType<import('./figure-parts.mjs').makeParts>} parts
 * @param {{ app: App, id: number }} view
 * @param {JoiningHost} host
 */
export function joinHands(parts, { app, id }, { wishes, say, acted, openValues, shortcut }) {
    const hands = new FigureHands(parts, { app, id, wishes, say, acted, openValues, ran: () => input.run() });
    const input = new FigureInput(parts.wrapper, {
        app, id, acted, shortcut,
        before: (event) => hands.before(event),
        pressed: (key) => hands.pressed(key),
        places: (x, y) => hands.places(x, y),
        readOnly: () => wishes().readOnly,
        wheelZoom: () => wishes().wheelZoom,
    });
    return { hands, input };
}

/**
 * The application draws as the figure was asked to.
 * @param {App} app
 * @param {number} id of the view
 * @param {import('./figure.mjs').Wishes} wishes
 */
export function dressView(app, id, wishes) {
    app.setTheme(id, wishes.theme);
    app.setWords(id, JSON.stringify(wishes.words.picture()));
    app.setReadOnly(id, wishes.readOnly);
    app.setReducedMotion(id, wishes.still);
    if (wishes.still) app.setPlaying(id, false);
}
