// Long lists are shown page by page.

import { el, icon, setAttributes, setText } from './dom.mjs';
import { icons } from './icons.mjs';

export class Pager {
    #first = 0;
    #count = 0;

    /**
     * @param {import('./words.mjs').Words} words
     * @param {number} length of a page
     * @param {(first: number) => void} turned what to do when another page is asked for
     */
    constructor(words, length, turned) {
        this.words = words;
        this.length = length;
        this.turned = turned;
        this.previous = this.#button('previous', 'pager.previous', -1);
        this.next = this.#button('next', 'pager.next', 1);
        this.range = el('span', { class: 'count' });
        this.element = el('div', { class: 'pager', attributes: { role: 'group', 'aria-label': words.text('pager'), hidden: true } },
            this.previous, this.range, this.next);
    }

    /**
     * Says how many elements there are; answers the first that is shown.
     * @param {number} count
     */
    show(count) {
        this.#count = count;
        this.#first = Math.min(this.#first, this.#lastPage);
        this.element.hidden = count <= this.length;
        const { words } = this;
        const to = Math.min(count, this.#first + this.length);
        setText(this.range, words.text('pager.range', { from: this.#first + 1, to, count }));
        setAttributes(this.previous, { 'aria-disabled': this.#first === 0 ? 'true' : null });
        setAttributes(this.next, { 'aria-disabled': this.#first >= this.#lastPage ? 'true' : null });
        return this.#first;
    }

    /** Turns to the page of this element. @param {number} index */
    turnTo(index) {
        const page = Math.floor(Math.max(0, Math.min(index, this.#count)) / this.length) * this.length;
        if (page === this.#first) return;
        this.#first = page;
        if (this.#first > this.#lastPage) return;  // an element that is about to come
        this.show(this.#count);
        this.turned(this.#first);
    }

    get #lastPage() {
        return Math.max(0, Math.floor((this.#count - 1) / this.length) * this.length);
    }

    /** @param {string} name @param {string} key @param {number} step */
    #button(name, key, step) {
        const label = this.words.text(key);
        return el('button', {
            class: 'button small', attributes: { type: 'button', title: label, 'aria-label': label },
            on: { click: () => this.turnTo(Math.min(this.#first + step * this.length, this.#lastPage)) },
        }, icon(icons[name]));
    }
}
