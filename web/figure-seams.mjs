// The seams between the panes of a figure as separators that are dragged, moved by keys, and put back
// by a double click. The application knows where they stand; here they are only taken hold of.

import { el, setAttributes } from './dom.mjs';

/**
 * A seam as App::panes tells it.
 * @typedef {object} Seam
 * @property {string} name
 * @property {boolean} upright
 * @property {[number, number, number, number]} box
 * @property {number} share of what it parts, on its left or above it
 * @property {number} least
 * @property {number} most
 * @property {number} length CSS pixels of what it parts
 */

const keyStep = 0.02;
const times = 5;  // with the shift key

export class SeamLayer {
    /** @type {Map<string, { element: HTMLElement, seam: Seam }>} */
    #seams = new Map();
    #told = '';
    /** A drag: what it began with. @type {{ name: string, pointer: number, from: number, share: number } | null} */
    #drag = null;

    /**
     * @param {HTMLElement} picture
     * @param {(name: string, share: number) => void} move NaN puts it where it stands by itself
     */
    constructor(picture, move) {
        this.picture = picture;
        this.move = move;
        /** @type {import('./words.mjs').Words | undefined} */
        this.words = undefined;
    }

    /** @param {import('./words.mjs').Words} words */
    dress(words) {
        this.words = words;
        for (const [name, { element }] of this.#seams) element.setAttribute('aria-label', words.text(`seam.${name}`));
    }

    /** @param {Seam[]} seams as they stand now */
    show(seams) {
        const told = JSON.stringify(seams);
        if (told === this.#told) return;
        this.#told = told;
        for (const seam of seams) this.#place(this.#seams.get(seam.name)?.element ?? this.#make(seam.name), seam);
        for (const [name, { element }] of this.#seams) {
            if (seams.some((seam) => seam.name === name)) continue;
            element.remove();
            this.#seams.delete(name);
        }
    }

    /** @param {string} name */
    #make(name) {
        const element = el('hr', {
            class: 'seam',
            attributes: { tabindex: 0, 'aria-label': this.words?.text(`seam.${name}`) },
            on: {
                pointerdown: (event) => this.#press(name, event),
                pointermove: (event) => this.#follow(event),
                pointerup: () => { this.#drag = null; },
                pointercancel: () => this.#putBack(),
                dblclick: () => this.move(name, NaN),
                keydown: (event) => this.#key(name, event),
            },
        });
        this.picture.append(element);
        return element;
    }

    /** @param {HTMLElement} element @param {Seam} seam */
    #place(element, seam) {
        this.#seams.set(seam.name, { element, seam });
        const [x, y, width, height] = seam.box;
        const { style } = element;
        style.translate = `${x}px ${y}px`;
        style.width = seam.upright ? '' : `${width}px`;
        style.height = seam.upright ? `${height}px` : '';
        setAttributes(element, {
            'aria-orientation': seam.upright ? 'vertical' : 'horizontal',
            'aria-valuenow': percent(seam.share),
            'aria-valuemin': percent(seam.least),
            'aria-valuemax': percent(seam.most),
            'aria-valuetext': `${percent(seam.share)} %`,
        });
    }

    /** @param {string} name @param {PointerEvent} event */
    #press(name, event) {
        const held = this.#seams.get(name);
        if (!held || event.button !== 0) return;
        event.preventDefault();  // or words around would be selected
        held.element.focus({ preventScroll: true });
        held.element.setPointerCapture(event.pointerId);
        const { seam } = held;
        this.#drag = { name, pointer: event.pointerId, from: placeOf(seam, event), share: seam.share };
    }

    /** @param {PointerEvent} event */
    #follow(event) {
        const drag = this.#drag;
        const seam = drag && this.#seams.get(drag.name)?.seam;
        if (!drag || !seam || event.pointerId !== drag.pointer) return;
        const by = (placeOf(seam, event) - drag.from) / seam.length;
        if (by !== 0) this.move(drag.name, drag.share + by);
    }

    #putBack() {
        if (this.#drag) this.move(this.#drag.name, this.#drag.share);
        this.#drag = null;
    }

    /** @param {string} name @param {KeyboardEvent} event */
    #key(name, event) {
        const seam = this.#seams.get(name)?.seam;
        if (!seam || event.ctrlKey || event.metaKey || event.altKey) return;
        if (event.key === 'Escape' && this.#drag) {
            this.#putBack();
        } else {
            const share = shareAfter(seam, event);
            if (share === undefined) return;
            this.move(name, share);
        }
        event.preventDefault();
    }
}

/** @param {Seam} seam @param {{ clientX: number, clientY: number }} event */
function placeOf({ upright }, { clientX, clientY }) {
    return upright ? clientX : clientY;
}

/**
 * Where a key puts a seam, or undefined for a key that is none of its own.
 * @param {Seam} seam
 * @param {KeyboardEvent} event
 */
function shareAfter({ upright, share, least, most }, { key, shiftKey }) {
    const step = shiftKey ? times * keyStep : keyStep;
    switch (key) {
        case upright ? 'ArrowLeft' : 'ArrowUp': return Math.max(least, share - step);
        case upright ? 'ArrowRight' : 'ArrowDown': return Math.min(most, share + step);
        case 'Home': return least;
        case 'End': return most;
        case 'Enter': return NaN;
        default: return undefined;
    }
}

/** @param {number} share */
function percent(share) {
    return Math.round(100 * share);
}
