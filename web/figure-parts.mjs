// The elements that every figure is made of, before it shows anything.

import { el, uniqueId } from './dom.mjs';

export function makeParts() {
    const description = uniqueId('about');
    const wrapper = el('div', {
        class: 'view',
        attributes: { role: 'application', tabindex: 0, 'aria-describedby': description },
    });
    const message = el('p', { class: 'waiting' });
    const fallback = el('div', { class: 'fallback' }, el('slot'), message);
    const refusal = el('div', { class: 'refusal', attributes: { role: 'alert', hidden: true } });
    const about = el('p', { class: 'aside', attributes: { id: description } });
    const announcer = el('div', { class: 'aside', attributes: { role: 'status', 'aria-live': 'polite' } });
    const picture = el('div', { class: 'stage' }, fallback, wrapper, refusal);
    const column = el('div', { class: 'column' }, picture);
    const frame = el('div', { class: 'frame' }, column, about, announcer);
    return { frame, column, picture, wrapper, fallback, message, refusal, about, announcer };
}

const announcementPause = 700;  // milliseconds: a run of changes is told once, when it is over

/** One polite voice, which waits until there is a pause. */
export class Announcer {
    /** @type {ReturnType<typeof setTimeout> | undefined} */
    #timer;

    /** @param {Element} region */
    constructor(region) {
        this.region = region;
    }

    /** @param {string} sentence */
    say(sentence) {
        clearTimeout(this.#timer);
        this.#timer = setTimeout(() => { this.region.textContent = sentence; }, announcementPause);
    }

    silence() {
        clearTimeout(this.#timer);
    }
}

/** A promise with its resolver. */
export function deferred() {
    /** @type {(value: unknown) => void} */
    let resolve = () => {};
    const promise = new Promise((settle) => { resolve = settle; });
    return { promise, resolve };
}

/**
 * Hears of every change that is made through the scene's own methods, whoever calls them.
 * @param {any} scene
 * @param {(what: string, command: any, answer: any) => void} changed
 */
export function watch(scene, changed) {
    for (const name of ['execute', 'undo', 'redo']) {
        const original = scene[name];
        const heard = (/** @type {any} */ command) => {
            const answer = original.call(scene, command);
            if (answer !== false) changed(name, command, answer);
            return answer;
        };
        Object.defineProperty(scene, name, { value: heard, configurable: true });
    }
}
