// How far something is that takes a while: a name, a bar and a button that ends it.

import { el, setText } from './dom.mjs';

/** What is over sooner, in milliseconds, needs no bar. */
const patience = 300;

export class Progress {
    #began = 0;

    /**
     * @param {string} look class of the button
     * @param {{ shown?: (name: string) => void }} [listener] hears when the bar comes into sight
     */
    constructor(look, listener = {}) {
        this.listener = listener;
        this.name = el('span', { class: 'progress-name' });
        this.bar = el('progress', { attributes: { max: 1 } });
        this.button = el('button', { class: look, attributes: { type: 'button' }, on: { click: () => this.cancel() } });
        this.element = el('div', { class: 'progress', attributes: { hidden: true } }, this.name, this.bar, this.button);
    }

    get shown() {
        return !this.element.hidden;
    }

    /**
     * Something begins; its bar comes into sight once it has taken a while.
     * @param {import('./words.mjs').Words} words
     * @param {string} name
     * @param {() => void} cancel
     */
    begin(words, name, cancel) {
        this.#began = performance.now();
        this.cancel = cancel;
        setText(this.name, name);
        setText(this.button, words.text('work.cancel'));
        this.bar.setAttribute('aria-label', name);
        this.bar.removeAttribute('value');  // nobody knows yet
    }

    /** @param {number} fraction */
    advance(fraction) {
        if (fraction > 0) this.bar.value = Math.max(this.bar.value, fraction);
        if (this.shown || performance.now() - this.#began < patience) return;
        this.element.hidden = false;
        this.listener.shown?.(this.name.textContent ?? '');
    }

    end() {
        this.element.hidden = true;
        this.cancel = () => {};
    }

    /** What the button does. */
    cancel = () => {};
}
