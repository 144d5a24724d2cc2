// The steps of an algorithm under the picture: the sentence and the formula of the frame that is
// shown, and buttons to go through them. Every step is a command, so undo and links know of it.

import { el, icon, setAttributes, setText } from './dom.mjs';
import { icons } from './icons.mjs';
import { formulaOf } from './mathml.mjs';
import { traceArguments } from './traces.mjs';
import { newGesture } from './values-fields.mjs';

/** @typedef {import('./words.mjs').Words} Words */

const perFrame = 2200;  // milliseconds: time to read a sentence

/**
 * @typedef {object} TraceHost
 * @property {Words} words
 * @property {any} kw
 * @property {(command: any, final: boolean) => any} run executes a command, answers its refusal
 * @property {(step: { source: string, frame: number, frames: number }) => void} stepped
 */

export class TraceStrip {
    /** Of the object whose trace is shown, in the scene's list; −1 for none. */
    #index = -1;
    #frame = 0;
    /** @type {any[]} */
    #frames = [];
    #asked = '';
    #shown = '';
    #gesture = '';
    /** @type {ReturnType<typeof setTimeout> | undefined} */
    #timer;

    /** @param {TraceHost} host */
    constructor(host) {
        this.host = host;
        const { words } = host;
        this.name = el('h2');
        this.previous = this.#button('previous', 'trace.previous', () => this.step(-1));
        this.play = this.#button('play', 'trace.play', () => this.#togglePlay());
        this.next = this.#button('next', 'trace.next', () => this.step(1));
        this.slider = el('input', {
            attributes: { type: 'range', min: 0, step: 1, 'aria-label': words.text('trace.step.label') },
            on: { input: () => this.#scrub(false), change: () => this.#scrub(true) },
        });
        this.count = el('span', { class: 'count' });
        const close = this.#button('remove', 'trace.close', () => this.#close());
        const bar = el('div', { class: 'trace-bar' }, this.name,
            el('div', { class: 'trace-steps' }, this.previous, this.play, this.next, this.slider, this.count), close);
        this.title = el('h3');
        this.text = el('p');
        this.formula = el('div', { class: 'formula' });
        // The sentences are the core's own, in English.
        this.body = el('div', { class: 'trace-body', attributes: { lang: 'en' } },
            el('div', {}, this.title, this.text), this.formula);
        this.element = el('section', { class: 'trace', attributes: { 'aria-label': words.text('trace'), hidden: true } }, bar, this.body);
    }

    /**
     * Shows the trace of the selected object, or of the first that has one; answers the sentence of
     * a step that was not shown before, '' otherwise.
     * @param {any[]} objects of the canonical document
     * @param {number} selected
     */
    update(objects, selected) {
        const index = objects[selected]?.trace ? selected : objects.findIndex(({ trace }) => trace);
        this.#index = index;
        this.element.hidden = index < 0;
        if (index < 0) {
            this.stop();
            this.#shown = '';
            return '';
        }
        this.#find(objects[index]);
        return this.#show(objects[index]);
    }

    /** @param {number} by @param {string} [source] as events tell it */
    step(by, source = 'field') {
        this.stop();
        this.#goTo(this.#frame + by, true, source);
    }

    /** Ends playing, as when the figure goes away. */
    stop() {
        clearTimeout(this.#timer);
        this.#timer = undefined;
        this.#showPlay(false);
    }

    /** @param {any} object */
    #find(object) {
        const asked = JSON.stringify([object.id, { ...object, style: null, show: null, trace: { ...object.trace, frame: 0 } }]);
        if (asked === this.#asked) return;
        this.#asked = asked;
        this.#shown = '';
        try {
            this.#frames = this.host.kw.trace(traceArguments(this.host.kw, object)).frames;
        } catch {
            this.#frames = [];  // the scene shows none either
        }
    }

    /** @param {any} object */
    #show({ trace }) {
        const last = this.#frames.length - 1;
        this.#frame = Math.max(0, Math.min(trace.frame ?? 0, last));
        const frame = this.#frames[this.#frame];
        const shown = `${this.#asked} ${this.#frame}`;
        if (!frame || shown === this.#shown) return '';
        const first = this.#shown === '';
        this.#shown = shown;
        this.#showBar(trace.algorithm, last);
        setText(this.title, frame.title);
        setText(this.text, frame.text);
        const formula = formulaOf(frame.formula);
        this.formula.replaceChildren(...(formula ? [formula] : []));
        this.body.scrollTop = 0;
        // What cannot be seen whole is scrolled with keys, too.
        const { scrollHeight, clientHeight, scrollWidth, clientWidth } = this.body;
        const whole = scrollHeight <= clientHeight + 1 && scrollWidth <= clientWidth + 1;
        setAttributes(this.body, { tabindex: whole ? null : 0 });
        return first ? '' : `${frame.title}. ${frame.text}`;
    }

    /** @param {string} algorithm @param {number} last */
    #showBar(algorithm, last) {
        const { words } = this.host;
        setText(this.name, words.text(`trace.${algorithm}`));
        const told = words.text('trace.step', { step: this.#frame + 1, steps: last + 1 });
        setText(this.count, told);
        this.slider.max = String(last);
        this.slider.valueAsNumber = this.#frame;
        this.slider.setAttribute('aria-valuetext', told);
        setAttributes(this.previous, { 'aria-disabled': this.#frame === 0 ? 'true' : null });
        setAttributes(this.next, { 'aria-disabled': this.#frame === last ? 'true' : null });
    }

    /** @param {boolean} final */
    #scrub(final) {
        this.stop();
        this.#gesture ||= newGesture();
        this.#goTo(this.slider.valueAsNumber, final);
    }

    /**
     * @param {number} frame
     * @param {boolean} final whether the gesture, if it is one, ends here
     * @param {string} [source]
     */
    #goTo(frame, final, source = 'field') {
        const path = `objects[${this.#index}].trace.frame`;
        const inside = frame >= 0 && frame < this.#frames.length && this.#index >= 0;
        if (inside && (frame !== this.#frame || final)) {
            const command = { set: path, value: frame };
            this.host.run(this.#gesture ? { ...command, gesture: this.#gesture } : command, final);
            this.host.stepped({ source, frame, frames: this.#frames.length });
        }
        if (final) this.#gesture = '';
    }

    #togglePlay() {
        if (this.#timer) {
            this.stop();
            this.#gesture = '';
            return;
        }
        this.#gesture = newGesture();  // all that is played is one step of history
        this.#goTo(this.#frame === this.#frames.length - 1 ? 0 : this.#frame + 1, false);
        this.#showPlay(true);
        this.#timer = setTimeout(() => this.#playOn(), perFrame);
    }

    #playOn() {
        const last = this.#frames.length - 1;
        this.#goTo(this.#frame + 1, this.#frame + 1 >= last);
        if (this.#frame + 1 < last && !document.hidden) this.#timer = setTimeout(() => this.#playOn(), perFrame);
        else this.stop();
    }

    #close() {
        this.stop();
        this.host.run({ remove: `objects[${this.#index}].trace` }, true);
    }

    /** @param {boolean} playing */
    #showPlay(playing) {
        const name = playing ? 'pause' : 'play';
        if (this.play.dataset.shows === name) return;
        this.play.dataset.shows = name;
        const label = this.host.words.text(playing ? 'trace.pause' : 'trace.play');
        setAttributes(this.play, { title: label, 'aria-label': label });
        this.play.replaceChildren(icon(icons[name]));
    }

    /** @param {string} name of the icon @param {string} key of the words @param {() => void} act */
    #button(name, key, act) {
        const label = this.host.words.text(key);
        return el('button', {
            class: 'button', attributes: { type: 'button', title: label, 'aria-label': label }, on: { click: act },
        }, icon(icons[name]));
    }
}
