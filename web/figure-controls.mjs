// The controls and the values panel of a figure, made anew when language or kind of controls change.

import { setAttributes } from './dom.mjs';
import { FigureToolbar } from './figure-toolbar.mjs';
import { ValuesPanel } from './values-panel.mjs';

/**
 * @typedef {object} ControlsHost
 * @property {import('./figure-toolbar.mjs').Actions} actions
 * @property {() => any} kw undefined until the module is there
 * @property {(command: any, final: boolean) => any} run
 */

export class FigureControls {
    /** @type {FigureToolbar | undefined} */
    #toolbar;
    /** @type {ValuesPanel | undefined} */
    #panel;
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
        this.#toolbar = new FigureToolbar(words, this.host.actions, wishes);
        this.parts.column.append(this.#toolbar.element);
        this.#panel = this.#makePanel(wishes);
        if (this.#panel) this.parts.column.after(this.#panel.element);
        this.#showPanel();
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
     * Brings the panel up to the scene; what it shows already is left alone.
     * @param {any} scene
     */
    showScene(scene) {
        if (!this.#panel || !this.#open || scene.revision === this.#shownRevision) return;
        this.#panel.update(scene);
        this.#shownRevision = scene.revision;
    }

    /** Another scene: the panel has shown nothing of it yet. */
    forget() {
        this.#shownRevision = -1;
    }

    /** @param {import('./figure.mjs').Wishes} wishes */
    #makePanel({ words, readOnly, controls }) {
        const kw = this.host.kw();
        if (!kw || !['full', 'values'].includes(controls)) return undefined;
        return new ValuesPanel({ words, kw, readOnly, run: this.host.run });
    }

    #showPanel() {
        const shown = this.#open && this.#panel !== undefined;
        setAttributes(this.parts.frame, { 'data-values': shown });
        if (this.#panel) this.#panel.element.hidden = !shown;
        this.forget();
    }
}
