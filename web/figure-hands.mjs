// Other hands than a pointer that drags: keys, sliders over the picture, and clicks that place.

import { ClickBar } from './figure-clicks.mjs';
import { HandleLayer } from './figure-handles.mjs';
import { heldName, heldValues } from './figure-sentences.mjs';

/** @typedef {import('./figure-handles.mjs').Held} Held */

/**
 * @typedef {object} HandsHost
 * @property {import('./page-module.mjs').App} app
 * @property {number} id of the view
 * @property {() => { words: import('./words.mjs').Words, readOnly: boolean, controls: string }} wishes
 * @property {(sentence: string) => void} say
 * @property {() => void} acted after the application was told something
 * @property {() => void} ran after a press of an arrow key, or what stands for one
 * @property {(held: Held) => boolean} openValues focuses the fields of what is selected
 */

export class FigureHands {
    /** @type {Held | null} */
    #held = null;
    /** @type {ClickBar | undefined} */
    #bar;
    #dressed = '';

    /**
     * @param {ReturnType<import('./figure-parts.mjs').makeParts>} parts
     * @param {HandsHost} host
     */
    constructor(parts, host) {
        this.parts = parts;
        this.host = host;
        this.layer = new HandleLayer(parts.wrapper, ([x, y, z]) => {
            if (host.app.shift(host.id, x, y, z)) host.ran();
            this.follow(false);  // a slider that may not move goes back
            host.acted();
        });
    }

    get held() {
        return this.#held;
    }

    /** In the words of now; nothing is offered where nothing may be changed. */
    dress() {
        const { words, readOnly, controls } = this.host.wishes();
        const dressed = JSON.stringify([words.language, readOnly, controls]);
        if (dressed === this.#dressed) return;
        this.#dressed = dressed;
        this.#bar?.element.remove();
        this.#bar = undefined;
        if (!readOnly && controls !== 'none') {
            this.#bar = this.#makeBar(words);
        }
        this.follow(false);
    }

    /** @param {import('./words.mjs').Words} words */
    #makeBar(words) {
        const { app, id, say, acted } = this.host;
        return new ClickBar(this.parts.picture, words, {
            told: say,
            left: () => this.#return(),
            gather: (several) => app.setGathering(id, several),
            all: () => {
                app.selectAll(id);
                acted();
            },
        });
    }

    /**
     * Layer and bar as the selection is now; a hand at work is not watched.
     * @param {boolean} busy
     */
    follow(busy) {
        if (busy) {
            this.#bar?.element.toggleAttribute('data-busy', true);
            return;
        }
        const { app, id, wishes } = this.host;
        if (!this.#held && app.selection(id) === 'null') return;
        const former = this.#held;
        this.#held = JSON.parse(app.held(id) || 'null');
        const { words, readOnly } = wishes();
        const grew = this.#held?.kind === 'group' && (former?.kind !== 'group' || former.count !== this.#held.count);
        if (grew) this.host.say(heldName(words, /** @type {Held} */ (this.#held)));
        this.#bar?.show(this.#held);
        this.layer.show(this.#held, words, readOnly);
    }

    /**
     * Keys that mean something before the application has them.
     * @param {KeyboardEvent} event
     */
    before(event) {
        if (event.key === 'Escape' && this.#bar?.leave()) return true;
        if (!this.#held || event.ctrlKey || event.metaKey || event.altKey) return false;
        if (event.key === 'Enter') return this.host.openValues(this.#held);
        // A slider would go to its end.
        return event.key === 'Home' || event.key === 'End';
    }

    /**
     * After a key that the application took.
     * @param {string} key
     */
    pressed(key) {
        const former = this.#held;
        this.follow(false);
        if (key === 'ArrowLeft' || key === 'ArrowRight') this.layer.turnTo(0);
        if (key === 'ArrowUp' || key === 'ArrowDown') this.layer.turnTo(1);
        if (key === 'PageUp' || key === 'PageDown') this.tell();
        if ((key === 'Delete' || key === 'Backspace') && former && !this.#held) this.#selectNear(former);
    }

    /** Gives the focus to what is selected; answers whether something is. */
    focus() {
        this.follow(false);
        this.layer.focus();
        return this.#held !== null;
    }

    /** Says what is selected. */
    tell() {
        const held = this.#held;
        const { words } = this.host.wishes();
        if (held) this.host.say(`${heldName(words, held)}: ${heldValues(words, held)}`);
    }

    /**
     * A press of the pointer, if it was one to place what is selected.
     * @param {number} x
     * @param {number} y
     */
    places(x, y) {
        const { app, id } = this.host;
        const how = this.#bar?.how;
        if (!how) return false;
        if (app.place(id, x, y, how)) {
            this.#bar?.choose(null);
            this.layer.focus();
        }
        return true;
    }

    /** What stands in the place of the removed one, or the last. @param {Held} former */
    #selectNear({ kind, path, number, count }) {
        const { app, id } = this.host;
        if (count < 2 || kind === 'group') return;
        const last = number === count;
        app.select(id, last ? path.replace(/\d+(?=\]$)/, (k) => String(Number(k) - 1)) : path);
        this.follow(false);
    }

    #return() {
        if (this.#held) this.layer.focus();
        else this.parts.wrapper.focus({ preventScroll: true });
    }
}
