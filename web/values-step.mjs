// How far an arrow key moves what is selected: shown by the values panel, and set there.

import { el, uniqueId } from './dom.mjs';
import { NumberInput } from './values-number.mjs';

export class StepField {
    /**
     * @param {import('./words.mjs').Words} words
     * @param {(step: number) => void} set gets 0 where the zoom is to decide
     */
    constructor(words, set) {
        this.input = new NumberInput(words, { min: 0, readOnly: false }, (value) => {
            if (value >= 0 && value < Infinity) set(value);
            this.input.restore();
        }, () => {});
        const { element } = this.input;
        element.id = uniqueId('step');
        this.element = el('div', { class: 'field step', attributes: { hidden: true } },
            el('label', { text: words.text('step'), attributes: { for: element.id } }),
            el('div', { class: 'controls' }, element));
    }

    /** @param {number | undefined} step undefined where nothing is selected */
    show(step) {
        this.element.hidden = step === undefined && !this.element.matches(':focus-within');
        if (step !== undefined) this.input.show(step);
    }
}
