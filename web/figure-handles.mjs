// The focus layer over the picture: what is selected as a labelled group of native sliders, one a
// coordinate, that lies where it is seen. Of picture and sliders one at a time is a tab stop.

import { el, setAttributes } from './dom.mjs';
import { heldName, heldValues } from './figure-sentences.mjs';

/**
 * What is selected, as App::held tells it.
 * @typedef {object} Held
 * @property {string} path
 * @property {'point' | 'knot' | 'pose' | 'line' | 'group' | 'parameter' | 'effect'} kind
 * @property {string} [of] a group's: point, local or patch
 * @property {number} number
 * @property {number} count
 * @property {[number, number]} pixel
 * @property {number} step
 * @property {any} value
 * @property {any} [local]
 * @property {boolean} [spatial]
 */

const stepsEitherWay = 1000;  // that a slider can be moved without being laid out anew

export class HandleLayer {
    /** @type {HTMLInputElement[]} */
    #sliders = [];
    #axis = 0;
    /** What the sliders were laid out for. */
    #laid = '';
    /** @type {Held | null} */
    #held = null;
    /** @type {number[]} what each slider stands at */
    #stands = [];

    /**
     * @param {HTMLElement} wrapper
     * @param {(by: [number, number, number]) => void} shift by so many units along the axes
     */
    constructor(wrapper, shift) {
        this.wrapper = wrapper;
        this.shift = shift;
        this.group = el('div', { class: 'handle', attributes: { role: 'group', hidden: true } });
        this.wrapper.append(this.group);
    }

    /**
     * Follows the selection; the focus goes with it, from the picture and back.
     * @param {Held | null} held
     * @param {import('./words.mjs').Words} words
     * @param {boolean} readOnly
     */
    show(held, words, readOnly) {
        const former = this.#held;
        this.#held = held;
        if (!held) {
            if (former) this.#leave();
            return;
        }
        this.group.hidden = false;
        const [x, y] = held.pixel;
        this.group.style.translate = `${x}px ${y}px`;
        setAttributes(this.group, { 'aria-label': heldName(words, held) });
        this.#layOut(held, words, readOnly);
        this.wrapper.tabIndex = -1;
        if (this.#root.activeElement === this.wrapper) this.focus();
    }

    focus() {
        this.#sliders[this.#axis]?.focus({ preventScroll: true });
    }

    /**
     * The slider of this coordinate is the tab stop now.
     * @param {number} axis
     */
    turnTo(axis) {
        if (axis >= this.#sliders.length) return;
        const focused = this.#sliders.includes(/** @type {any} */ (this.#root.activeElement));
        this.#axis = axis;
        this.#sliders.forEach((slider, k) => { slider.tabIndex = k === axis ? 0 : -1; });
        if (focused) this.focus();
    }

    get #root() {
        return /** @type {ShadowRoot} */ (this.wrapper.getRootNode());
    }

    #leave() {
        this.wrapper.tabIndex = 0;
        if (this.group.contains(this.#root.activeElement)) this.wrapper.focus({ preventScroll: true });
        this.group.hidden = true;
        this.#laid = '';
    }

    /**
     * @param {Held} held
     * @param {import('./words.mjs').Words} words
     * @param {boolean} readOnly
     */
    #layOut(held, words, readOnly) {
        const values = coordinatesOf(held);
        const one = held.kind === 'knot' ? 't' : heldName(words, held);
        const names = typeof held.value === 'number' ? [one] : ['x', 'y', 'z'].slice(0, values.length);
        this.#makeSliders(names.length);
        const laid = JSON.stringify([held.path, held.kind, held.step, values.length, readOnly]);
        const same = laid === this.#laid;
        this.#laid = laid;
        const text = heldValues(words, held);
        this.#sliders.forEach((slider, k) => {
            const inside = values[k] >= Number(slider.min) && values[k] <= Number(slider.max);
            if (!same || !inside) layOutSlider(slider, values[k], held.step);
            slider.value = String(values[k]);
            this.#stands[k] = slider.valueAsNumber;
            setAttributes(slider, {
                'aria-label': names[k], 'aria-valuetext': text, 'aria-readonly': readOnly ? 'true' : null,
            });
        });
    }

    /** @param {number} count */
    #makeSliders(count) {
        if (this.#sliders.length === count) return;
        const focused = this.group.contains(this.#root.activeElement);
        this.#axis = Math.min(this.#axis, count - 1);
        this.#sliders = Array.from({ length: count }, (_, k) => el('input', {
            attributes: { type: 'range', tabindex: k === this.#axis ? 0 : -1 },
            on: { input: () => this.#moved(k) },
        }));
        this.group.replaceChildren(...this.#sliders);
        if (focused) this.focus();
    }

    /**
     * Someone moved the slider itself, as screen readers do.
     * @param {number} axis
     */
    #moved(axis) {
        const step = this.#held?.step ?? 0;
        const steps = Math.round((this.#sliders[axis].valueAsNumber - this.#stands[axis]) / step);
        /** @type {[number, number, number]} */
        const by = [0, 0, 0];
        by[axis] = Number((steps * step).toPrecision(12));
        this.#axis = axis;
        this.shift(by);
    }
}

/**
 * @param {HTMLInputElement} slider
 * @param {number} value
 * @param {number} step
 */
function layOutSlider(slider, value, step) {
    setAttributes(slider, { min: value - stepsEitherWay * step, max: value + stepsEitherWay * step, step });
}

/** @param {Held} held */
function coordinatesOf({ kind, value, spatial }) {
    if (typeof value === 'number') return [value];
    if (kind === 'point' || kind === 'line') return value;
    if (kind === 'group' || kind === 'effect') return value.slice(0, spatial ? 3 : 2);
    return value.translate.slice(0, spatial ? 3 : 2);
}
