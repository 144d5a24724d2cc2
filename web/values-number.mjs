// A field for one number: typed with point or comma, or stepped with the arrow keys.

import { el, setAttributes } from './dom.mjs';

/**
 * @typedef {object} NumberLimits
 * @property {number} [min]
 * @property {number} [max]
 * @property {number} [step]
 */

export class NumberInput {
    #shown = '';

    /**
     * @param {import('./words.mjs').Words} words
     * @param {NumberLimits & { label?: string, readOnly: boolean }} options
     * @param {(value: number) => void} commit gets NaN for what is no number
     * @param {() => void} restored after Escape has put the former value back
     */
    constructor(words, options, commit, restored) {
        this.words = words;
        this.limits = options;
        this.commit = commit;
        this.restored = restored;
        this.value = 0;
        this.element = el('input', {
            attributes: {
                type: 'text', inputmode: 'decimal', autocomplete: 'off', spellcheck: 'false',
                role: 'spinbutton', 'aria-label': options.label,
                'aria-valuemin': finite(options.min), 'aria-valuemax': finite(options.max),
                readonly: options.readOnly,
            },
            on: {
                change: () => this.#typed(),
                keydown: (event) => this.#key(event),
            },
        });
    }

    /**
     * Shows a value; what is being typed, or has been refused, is left alone unless the value is new.
     * @param {number} value
     */
    show(value) {
        const text = this.words.editable(value);
        if (text === this.#shown) return;
        this.value = value;
        this.#shown = text;
        this.element.value = text;
        setAttributes(this.element, { 'aria-valuenow': value, 'aria-invalid': null });
    }

    /** Whether what stands in the field differs from the value that it is to show. */
    get edited() {
        return this.element.value !== this.#shown;
    }

    /** Puts back the value that was shown last. */
    restore() {
        this.element.value = this.#shown;
        setAttributes(this.element, { 'aria-invalid': null });
    }

    #typed() {
        if (this.edited) this.commit(this.words.parse(this.element.value));
    }

    /** @param {KeyboardEvent} event */
    #key(event) {
        if (event.key === 'Escape' && this.edited) {
            event.stopPropagation();
            this.restore();
            this.restored();
        }
        const steps = stepsOfKey[event.key];
        if (!steps || this.limits.readOnly || event.ctrlKey || event.metaKey || event.altKey) return;
        event.preventDefault();
        const from = this.words.parse(this.element.value);
        if (Number.isNaN(from)) return;
        this.commit(this.#clamp(from + steps * (event.shiftKey ? 10 : 1) * (this.limits.step ?? 0.1)));
    }

    /**
     * Stepping stops at the limits and keeps the sum of decimal steps decimal.
     * @param {number} value
     */
    #clamp(value) {
        const { min = -Infinity, max = Infinity } = this.limits;
        return Math.min(max, Math.max(min, Number(value.toPrecision(12))));
    }
}

/** @type {Record<string, number>} */
const stepsOfKey = { ArrowUp: 1, ArrowDown: -1, PageUp: 10, PageDown: -10 };

/** @param {number | undefined} value */
function finite(value) {
    return value !== undefined && Number.isFinite(value) ? value : null;
}
