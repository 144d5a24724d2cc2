// The readout of an object: what the curve is, and where it stands at a parameter that one can move.

import { el, setText, uniqueId } from './dom.mjs';
import { crossingsOf } from './figure-sentences.mjs';
import { bare, className, continuityText, localCount, pointCount } from './shape.mjs';
import { NumberInput } from './values-number.mjs';

/** @typedef {import('./words.mjs').Words} Words */

const sliderSteps = 1000;

export class Readout {
    /** The place of t in the domain, from 0 to 1: it stays where it is when the domain changes. */
    #place = 0.5;
    /** @type {any} */
    #object = null;
    /** @type {[number, number]} */
    #domain = [0, 1];

    /**
     * @param {Words} words
     * @param {any} kw
     */
    constructor(words, kw) {
        this.words = words;
        this.kw = kw;
        this.slider = el('input', {
            attributes: { type: 'range', min: 0, max: sliderSteps, 'aria-label': words.text('field.slider', { label: words.text('readout.at.label') }) },
            on: { input: () => this.#moveTo(this.slider.valueAsNumber / sliderSteps) },
        });
        this.number = new NumberInput(words, { readOnly: false }, (value) => this.#typed(value), () => {});
        this.number.element.id = uniqueId('readout');
        const label = el('label', { text: words.text('readout.at'), attributes: { for: this.number.element.id } });
        this.list = el('dl', { class: 'readout' });
        const name = el('legend', { text: words.text('readout') });
        this.element = el('fieldset', { class: 'group' }, name,
            el('div', { class: 'field' }, label,
                el('div', { class: 'controls' }, this.slider, this.number.element)), this.list);
    }

    /** @param {any} object as the canonical document has it */
    update(object) {
        const { type } = object;
        // Only curves have one parameter.
        this.element.hidden = !type.endsWith('-curve');
        if (this.element.hidden) return;
        this.#object = object;
        this.#refresh();
    }

    /** @param {number} place */
    #moveTo(place) {
        this.#place = Math.min(1, Math.max(0, place));
        this.#refresh();
    }

    /** @param {number} t */
    #typed(t) {
        const [a, b] = this.#domain;
        if (!Number.isNaN(t)) this.#moveTo((t - a) / (b - a));
    }

    #refresh() {
        const rows = this.#measure();
        this.slider.valueAsNumber = Math.round(this.#place * sliderSteps);
        const [a, b] = this.#domain;
        this.number.limits.step = (b - a) / 100;
        this.number.show(Number(this.#parameter().toPrecision(6)));
        this.slider.setAttribute('aria-valuetext', `t = ${this.words.number(this.#parameter())}`);
        this.#showRows(rows);
    }

    #parameter() {
        const [a, b] = this.#domain;
        return this.#place === 1 ? b : a + (b - a) * this.#place;
    }

    /** @returns {[string, string][]} keys of words, and what stands beside them */
    #measure() {
        const spec = bare(this.#object);
        const curve = this.kw.curve(spec);
        try {
            this.#domain = curve.domain;
            return [
                ...this.#ofAnyCurve(curve),
                ...this.#ofBspline(spec, curve),
                ...this.#ofBlending(spec),
                ...this.#ofLine(),
            ];
        } finally {
            curve.dispose();
        }
    }

    /**
     * @param {any} curve
     * @returns {[string, string][]}
     */
    #ofAnyCurve(curve) {
        const [point, first, second] = curve.derivatives(this.#parameter(), 2);
        const tuple = (/** @type {number[]} */ p) => this.#tuple(p.slice(0, curve.dimension));
        return [
            ['readout.domain', `[${curve.domain.map((/** @type {number} */ t) => this.words.number(t)).join('; ')}]`],
            ['readout.point', tuple(point)],
            ['readout.first', tuple(first)],
            ['readout.second', tuple(second)],
        ];
    }

    /**
     * @param {any} spec
     * @param {any} curve
     * @returns {[string, string][]}
     */
    #ofBspline(spec, curve) {
        if (spec.type !== 'bspline-curve') return [];
        /** @type {number[]} */
        const basis = curve.basis(this.#parameter())[0];
        const sum = basis.reduce((total, value) => total + value, 0);
        return [
            ['readout.degree', this.words.number(spec.degree)],
            ['readout.points', this.words.number(pointCount(spec.points))],
            ['readout.continuity', continuityText(this.words, spec)],
            ['readout.sum', this.#sumText(sum)],
        ];
    }

    /**
     * The sum with its deviation from 1, which is shown and not claimed.
     * @param {number} sum
     */
    #sumText(sum) {
        const off = sum - 1;
        if (off === 0) return '1';
        const sign = off > 0 ? '+' : '−';
        return `1 ${sign} ${this.words.scientific(Math.abs(off))}`;
    }

    /**
     * @param {any} spec
     * @returns {[string, string][]}
     */
    #ofBlending(spec) {
        if (spec.type !== 'blending-curve') return [];
        const b = this.kw.bFunction(spec.bFunction);
        const [start, end] = b.order;
        const yesNo = b.symmetric ? 'readout.yes' : 'readout.no';
        b.dispose();
        return [
            ['readout.locals', this.words.number(localCount(spec))],
            ['readout.hermite', `${this.words.number(start)}; ${this.words.number(end)}`],
            ['readout.continuity', className(this.words, Math.min(start, end))],
            ['readout.symmetric', this.words.text(yesNo)],
        ];
    }

    /** @returns {[string, string][]} */
    #ofLine() {
        const counted = crossingsOf(this.kw, this.#object);
        return counted ? [['readout.crossings', this.words.text('crossings.count', counted)]] : [];
    }

    /** @param {number[]} numbers */
    #tuple(numbers) {
        return `(${numbers.map((x) => this.words.number(x)).join('; ')})`;
    }

    /** @param {[string, string][]} rows */
    #showRows(rows) {
        if (this.list.children.length !== rows.length * 2) {
            this.list.replaceChildren(...rows.flatMap(([key]) => [
                el('dt', { text: this.words.text(key) }), el('dd')]));
        }
        rows.forEach(([, text], k) => setText(this.list.children[2 * k + 1], text));
    }
}
