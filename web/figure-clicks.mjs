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
    #gathers = false;
    /** @type {Map<How, HTMLButtonElement>} */
    #buttons = new Map();

    /**
     * @param {HTMLElement} picture
     * @param {import('./words.mjs').Words} words
     * @param {{ told: (sentence: string) => void, left: () => void, gather: (several: boolean) => void,
     *     all: () => void }} listener `left` is told when Escape gives the focus back to the picture,
     *     `gather` whether clicks select several from now on, `all` that all are to be selected
     */
    constructor(picture, words, listener) {
        this.words = words;
        this.listener = listener;
        this.picture = picture;
        this.name = el('span', { class: 'clicks-name' });
        this.hint = el('span', { class: 'clicks-hint' });
        this.several = this.#button('several', () => this.gather(!this.#gathers));
        this.all = this.#button('all', () => listener.all());
        setAttributes(this.all, { 'aria-pressed': null });
        this.element = el('div', {
            class: 'clicks',
            attributes: { role: 'group', 'aria-label': words.text('clicks'), hidden: true },
            on: { keydown: (event) => this.#key(event) },
        }, this.name, ...hows.map((how) => this.#makeButton(how)), this.several, this.all, this.hint);
        picture.append(this.element);
    }

    get how() {
        return this.#how;
    }

    /** Whether clicks add to what is selected. */
    get gathers() {
        return this.#gathers;
    }

    /** @param {boolean} several */
    gather(several) {
        if (several === this.#gathers) return;
        this.#gathers = several;
        if (several) this.choose(null);
        setAttributes(this.several, { 'aria-pressed': String(several) });
        this.all.hidden = !several;
        this.#hint(several ? 'several' : '');
        this.listener.gather(several);
    }

    /** @param {Held | null} held */
    show(held) {
        if (!held || held.path !== this.#path) this.choose(null);
        const several = held !== null && ['point', 'pose', 'group'].includes(held.kind);
        if (!several) this.gather(false);
        this.#path = held?.path ?? '';
        if (!held && this.element.contains(this.#root.activeElement)) this.listener.left();
        this.element.hidden = !held;
        if (!held) return;
        setText(this.name, heldName(this.words, held));
        for (const [how, button] of this.#buttons) button.hidden = how !== 'move' && held.kind !== 'pose' && held.kind !== 'group';
        this.several.hidden = !several;
        this.all.hidden = !this.#gathers;
        setAttributes(this.element, { 'data-busy': null, 'data-at': this.#corner(held.pixel) });
    }

    /** Out of the way of what is selected. @param {[number, number]} pixel */
    #corner([x, y]) {
        const { clientWidth: width } = this.picture;
        if (this.#gathers && width < narrow) return 'below';
        if (y > rim || (width >= narrow && x < width / 2)) return null;
        return width < narrow ? 'below' : 'left';
    }

    /** @param {How | null} how */
    choose(how) {
        if (how === this.#how) return;
        if (how) this.gather(false);
        this.#how = how;
        for (const [name, button] of this.#buttons) setAttributes(button, { 'aria-pressed': String(name === how) });
        setAttributes(this.picture, { 'data-placing': how !== null });
        this.#hint(how ?? '');
    }

    /** What the next click will do. @param {string} name */
    #hint(name) {
        const hint = name ? this.words.text(`clicks.${name}.hint`) : '';
        setText(this.hint, hint);
        if (hint) this.listener.told(hint);
    }

    /** Leaves what clicks were to do; answers whether they were to do something. */
    leave() {
        const leaves = this.#how !== null || this.#gathers;
        this.choose(null);
        this.gather(false);
        return leaves;
    }

    get #root() {
        return /** @type {ShadowRoot} */ (this.picture.getRootNode());
    }

    /** @param {How} how */
    #makeButton(how) {
        const button = this.#button(how, () => this.choose(this.#how === how ? null : how));
        this.#buttons.set(how, button);
        return button;
    }

    /**
     * @param {string} name
     * @param {() => void} click
     */
    #button(name, click) {
        return el('button', {
            class: 'quiet-button',
            text: this.words.text(`clicks.${name}`),
            attributes: { type: 'button', 'aria-pressed': 'false', title: this.words.text(`clicks.${name}.hint`) },
            on: { click },
        });
    }

    /** @param {KeyboardEvent} event */
    #key(event) {
        if (event.key !== 'Escape') return;
        event.preventDefault();
        if (!this.leave()) this.listener.left();
    }
}

/** @type {How[]} */
const hows = ['move', 'turn', 'scale'];
