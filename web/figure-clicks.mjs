// Single clicks in place of drags: the bar over the picture offers to put what is selected where the
// next click will be.

import { el, setAttributes, setText } from './dom.mjs';
import { heldName } from './figure-sentences.mjs';

/** @typedef {import('./figure-handles.mjs').Held} Held */
/** @typedef {'move' | 'turn' | 'scale'} How */

const rim = 72;      // CSS pixels: what is selected nearer to the upper edge may lie under the bar
const narrow = 640;  // a picture that has no room for the bar beside what is selected

export class ClickBar {
    /** @type {How | null} what the next click does */
    #how = null;
    #path = '';
    /** @type {Map<How, HTMLButtonElement>} */
    #buttons = new Map();

    /**
     * @param {HTMLElement} picture
     * @param {import('./words.mjs').Words} words
     * @param {{ told: (sentence: string) => void, left: () => void }} listener `left` is told when
     *     Escape gives the focus back to the picture
     */
    constructor(picture, words, listener) {
        this.words = words;
        this.listener = listener;
        this.picture = picture;
        this.name = el('span', { class: 'clicks-name' });
        this.hint = el('span', { class: 'clicks-hint' });
        this.element = el('div', {
            class: 'clicks',
            attributes: { role: 'group', 'aria-label': words.text('clicks'), hidden: true },
            on: { keydown: (event) => this.#key(event) },
        }, this.name, ...hows.map((how) => this.#makeButton(how)), this.hint);
        picture.append(this.element);
    }

    get how() {
        return this.#how;
    }

    /** @param {Held | null} held */
    show(held) {
        if (!held || held.path !== this.#path) this.choose(null);
        this.#path = held?.path ?? '';
        if (!held && this.element.contains(this.#root.activeElement)) this.listener.left();
        this.element.hidden = !held;
        if (!held) return;
        setText(this.name, heldName(this.words, held));
        for (const [how, button] of this.#buttons) button.hidden = how !== 'move' && held.kind !== 'pose';
        setAttributes(this.element, { 'data-busy': null, 'data-at': this.#corner(held.pixel) });
    }

    /** Out of the way of what is selected. @param {[number, number]} pixel */
    #corner([x, y]) {
        const { clientWidth: width } = this.picture;
        if (y > rim || (width >= narrow && x < width / 2)) return null;
        return width < narrow ? 'below' : 'left';
    }

    /** @param {How | null} how */
    choose(how) {
        if (how === this.#how) return;
        this.#how = how;
        for (const [name, button] of this.#buttons) setAttributes(button, { 'aria-pressed': String(name === how) });
        setAttributes(this.picture, { 'data-placing': how !== null });
        const hint = how ? this.words.text(`clicks.${how}.hint`) : '';
        setText(this.hint, hint);
        if (hint) this.listener.told(hint);
    }

    get #root() {
        return /** @type {ShadowRoot} */ (this.picture.getRootNode());
    }

    /** @param {How} how */
    #makeButton(how) {
        const button = el('button', {
            class: 'quiet-button',
            text: this.words.text(`clicks.${how}`),
            attributes: { type: 'button', 'aria-pressed': 'false', title: this.words.text(`clicks.${how}.hint`) },
            on: { click: () => this.choose(this.#how === how ? null : how) },
        });
        this.#buttons.set(how, button);
        return button;
    }

    /** @param {KeyboardEvent} event */
    #key(event) {
        if (event.key !== 'Escape') return;
        event.preventDefault();
        if (this.#how) this.choose(null);
        else this.listener.left();
    }
}

/** @type {How[]} */
const hows = ['move', 'turn', 'scale'];
