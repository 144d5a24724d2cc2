// The controls and the values panel of a figure, made anew when language or kind of controls change.

import { setAttributes } from './dom.mjs';
import { FigureToolbar } from './figure-toolbar.mjs';
import { TraceStrip } from './figure-trace.mjs';
import { ValuesPanel } from './values-panel.mjs';

/**
 * @typedef {object} ControlsHost
 * @property {import('./figure-toolbar.mjs').Actions} actions
 * @property {() => any} kw undefined until the module is there
 * @property {(command: any, final: boolean) => any} run
 * @property {(step: number) => void} setStep of the arrow keys
 * @property {(words: import('./words.mjs').Words, button: HTMLButtonElement | undefined, seams: boolean) => void}
 *     dressPanes the menu of panes belongs to this button from now on
 * @property {(step: { source: string, frame: number, frames: number }) => void} stepped
 */

/** Whether there is a panel of values among such controls. @param {string} controls */
export const hasValues = (controls) => controls === 'full' || controls === 'values';

export class FigureControls {
    /** @type {FigureToolbar | undefined} */
    #toolbar;
    /** @type {ValuesPanel | undefined} */
    #panel;
    /** @type {TraceStrip | undefined} */
    #trace;
    #made = '';
    #open = true;
    #shownRevision = -1;

    /**
     * @param {ReturnType<import('./figure-parts.mjs').makeParts>} parts
     * @param {ControlsHost} host
     */
    constructor(parts, host) {
        this.parts = parts;
        this.host = host;
    }

    /** @param {import('./figure.mjs').Wishes} wishes */
    apply(wishes) {
        const { words, controls, readOnly, ownTheme } = wishes;
        const made = JSON.stringify([words.language, controls, readOnly, ownTheme, Boolean(this.host.kw())]);
        if (made === this.#made) return;
        this.#made = made;
        this.#toolbar?.element.remove();
        this.#panel?.element.remove();
        this.#dropTrace();
        this.#toolbar = new FigureToolbar(words, this.host.actions, wishes);
        this.parts.column.append(this.#toolbar.element);
        this.#trace = this.#makeTrace(wishes);
        if (this.#trace) this.#toolbar.element.before(this.#trace.element);
        this.#panel = this.#makePanel(wishes);
        if (this.#panel) this.parts.column.after(this.#panel.element);
        this.#showPanel();
        this.host.dressPanes(words, this.#toolbar.button('panes'), ['full', 'values'].includes(controls));
    }

    toggleValues() {
        this.#open = !this.#open;
        this.#showPanel();
    }

    /**
     * @param {Omit<import('./figure-toolbar.mjs').Status, 'values'>} status
     */
    update(status) {
        this.#toolbar?.update({ ...status, values: this.#open });
    }

    /**
     * Shows the trace as the scene has it; answers the sentence of another step, or ''.
     * @param {any} document
     * @param {number} selected object
     */
    showTrace(document, selected) {
        return this.#trace?.update(document.objects, selected) ?? '';
    }

    /** Opens the fields of the selected object. @param {number} selected −1 for none */
    reveal(selected) {
        this.#panel?.reveal(selected);
    }

    /** @param {number} by */
    step(by) {
        this.#trace?.step(by, 'api');
    }

    /**
     * Brings the panel up to the scene; what it shows already is left alone.
     * @param {import('./figure-reading.mjs').Reading} read
     */
    showScene(read) {
        if (!this.#panel || !this.#open || read.revision === this.#shownRevision) return;
        this.#panel.update(read);
        this.#shownRevision = read.revision;
    }

    /** Another scene: the panel has shown nothing of it yet. */
    forget() {
        this.#shownRevision = -1;
    }

    /**
     * The exact values of what is selected: the focus goes to their first field.
     * @param {import('./figure-handles.mjs').Held} held
     */
    focusValues(held) {
        if (!this.#panel) return false;
        if (!this.#open) this.host.actions.toggleValues();
        return this.#panel.focusAt(held);
    }

    /** @param {number | undefined} step of the arrow keys; undefined where nothing is selected */
    showStep(step) {
        this.#panel?.step?.show(step);
    }

    /** @param {import('./figure.mjs').Wishes} wishes */
    #makePanel({ words, readOnly, controls }) {
        const kw = this.host.kw();
        if (!kw || !hasValues(controls)) return undefined;
        return new ValuesPanel({ words, kw, readOnly, run: this.host.run, setStep: this.host.setStep });
    }

    /** @param {import('./figure.mjs').Wishes} wishes */
    #makeTrace({ words, controls }) {
        const kw = this.host.kw();
        return kw && controls !== 'none' ? new TraceStrip({ ...this.host, words, kw }) : undefined;
    }

    #dropTrace() {
        this.#trace?.stop();
        this.#trace?.element.remove();
    }

    dispose() {
        this.#dropTrace();
    }

    #showPanel() {
        const shown = this.#open && this.#panel !== undefined;
        setAttributes(this.parts.frame, { 'data-values': shown });
        if (this.#panel) this.#panel.element.hidden = !shown;
        this.forget();
    }
}
