// The menu of a figure's panes: a box to tick for each, and a slider for each seam between them, so
// that single clicks do what drags do.

import { el, setAttributes, setText, uniqueId } from './dom.mjs';
import { SeamLayer } from './figure-seams.mjs';
import { paneCommand, paneStates } from './panes.mjs';

/** @typedef {import('./figure-seams.mjs').Seam} Seam */
/** @typedef {import('./words.mjs').Words} Words */

/**
 * @typedef {object} PanesHost
 * @property {(command: any) => any} run
 * @property {() => number} selected object, −1 for none
 * @property {() => string} panes as App::panes tells them, '' where there is no application yet
 * @property {(name: string, share: number) => void} moveSeam
 */

export class FigurePanes {
    /** @type {any} */
    #scene;
    #revision = -1;
    #told = '';
    /** @type {Words | undefined} */
    #words;
    /** @type {Map<string, HTMLInputElement>} */
    #boxes = new Map();
    /** @type {Map<string, HTMLInputElement>} */
    #sliders = new Map();
    /** @type {HTMLButtonElement | undefined} */
    #button;
    #moving = false;

    /**
     * @param {ReturnType<import('./figure-parts.mjs').makeParts>} parts
     * @param {PanesHost} host
     */
    constructor(parts, host) {
        this.parts = parts;
        this.host = host;
        this.seams = new SeamLayer(parts.picture, (name, share) => this.#move(name, share));
        this.list = el('div', { class: 'panes-list' });
        this.sizes = el('div', { class: 'panes-sizes' });
        this.name = el('h2');
        this.menu = el('div', {
            class: 'panes', attributes: { role: 'group', hidden: true, id: uniqueId('panes') },
            on: { keydown: (event) => this.#key(event), focusout: (event) => this.#left(event) },
        }, this.name, this.list, this.sizes);
    }

    /**
     * In these words, opened by this button of the toolbar.
     * @param {Words} words
     * @param {HTMLButtonElement | undefined} button
     * @param {boolean} moving whether there are seams to be moved
     */
    dress(words, button, moving) {
        this.close();
        this.#words = words;
        this.#button = button;
        this.seams.dress(words);
        setText(this.name, words.text('panes'));
        this.menu.setAttribute('aria-label', words.text('panes'));
        if (button) {
            setAttributes(button, { 'aria-expanded': 'false', 'aria-controls': this.menu.id });
            button.after(this.menu);
        }
        this.#boxes.clear();
        this.#sliders.clear();
        this.list.replaceChildren();
        this.sizes.replaceChildren();
        this.#revision = -1;
        this.#moving = moving;
        this.#told = '';
    }

    /** @param {any} scene */
    update(scene) {
        if (scene !== this.#scene) this.#revision = -1;
        this.#scene = scene;
        if (!this.menu.hidden) this.#showBoxes();
    }

    /** Brings seams and sliders to where the picture has them. */
    follow() {
        const told = this.host.panes();
        if (told === this.#told) return;
        this.#told = told;
        const { seams } = this.#now;
        this.seams.show(this.#moving ? seams : []);
        if (this.menu.hidden) return;
        this.#showSizes(seams);
        this.#showCrowded();
    }

    toggle() {
        if (!this.menu.hidden) return this.close();
        if (!this.#scene || !this.#button) return;
        this.menu.hidden = false;
        this.menu.style.maxHeight = `${Math.max(120, this.parts.picture.clientHeight - 8)}px`;
        this.#button.setAttribute('aria-expanded', 'true');
        this.#showBoxes();
        this.#showSizes(this.#now.seams);
        this.menu.querySelector('input')?.focus();
    }

    close() {
        if (this.menu.hidden) return;
        const root = /** @type {ShadowRoot} */ (this.menu.getRootNode());
        if (this.menu.contains(root.activeElement)) this.#button?.focus();
        this.menu.hidden = true;
        this.#button?.setAttribute('aria-expanded', 'false');
    }

    /** @returns {{ shown: string[], seams: Seam[] }} */
    get #now() {
        return JSON.parse(this.#told || 'null') ?? { shown: [], seams: [] };
    }

    #showBoxes() {
        const words = this.#words;
        if (!words || this.#scene.revision === this.#revision) return;
        this.#revision = this.#scene.revision;
        const states = paneStates(this.#scene.document, this.#scene.schema);
        if (String(states.map(({ name }) => name)) !== String([...this.#boxes.keys()])) {
            this.#boxes = new Map(states.map(({ name }) => [name, this.#makeBox(name)]));
            this.list.replaceChildren(...states.map(({ name }) => el('label', { class: 'flag' },
                /** @type {HTMLInputElement} */ (this.#boxes.get(name)), el('span', { text: words.text(`pane.${name}`) }),
                el('span', { class: 'count' }))));
        }
        for (const { name, shown, fixed } of states) {
            const box = /** @type {HTMLInputElement} */ (this.#boxes.get(name));
            box.checked = shown;
            setAttributes(box, { 'aria-disabled': fixed ? 'true' : null });
        }
        this.#showCrowded();
    }

    /** Which of the panes that are asked for are left out of a picture too small for them. */
    #showCrowded() {
        const shown = this.#now.shown;
        for (const [name, box] of this.#boxes) {
            const crowded = box.checked && name !== 'trace' && !shown.includes(name);
            const note = /** @type {HTMLElement} */ (box.parentElement?.querySelector('.count'));
            setText(note, crowded ? this.#words?.text('panes.crowded') ?? '' : '');
        }
    }

    /** @param {string} name */
    #makeBox(name) {
        return el('input', {
            attributes: { type: 'checkbox', value: name }, on: { change: (event) => this.#tick(name, event.target) },
        });
    }

    /** @param {string} name @param {HTMLInputElement} box */
    #tick(name, box) {
        const { document, schema } = this.#scene;
        const fixed = box.getAttribute('aria-disabled') === 'true';
        if (!fixed) this.host.run(paneCommand(document, schema, name, box.checked, this.host.selected()));
        this.#revision = -1;
        this.#showBoxes();  // also where it was refused
    }

    /** @param {Seam[]} seams */
    #showSizes(seams) {
        const names = seams.map(({ name }) => name);
        if (String(names) !== String([...this.#sliders.keys()])) {
            this.#sliders = new Map(names.map((name) => [name, this.#makeSlider(name)]));
            this.sizes.replaceChildren(...names.map((name) => this.#sizeRow(name)));
        }
        for (const { name, share, least, most } of seams) {
            const slider = /** @type {HTMLInputElement} */ (this.#sliders.get(name));
            setAttributes(slider, { min: Math.round(100 * least), max: Math.round(100 * most) });
            slider.valueAsNumber = Math.round(100 * share);
            slider.setAttribute('aria-valuetext', `${slider.value} %`);
        }
    }

    /** @param {string} name */
    #makeSlider(name) {
        return el('input', {
            attributes: { type: 'range', step: 1, id: uniqueId('seam') },
            on: { input: (event) => this.#move(name, event.target.valueAsNumber / 100), dblclick: () => this.#move(name, NaN) },
        });
    }

    /** @param {string} name */
    #sizeRow(name) {
        const slider = /** @type {HTMLInputElement} */ (this.#sliders.get(name));
        return el('div', { class: 'panes-size' },
            el('label', { text: this.#words?.text(`seam.${name}`), attributes: { for: slider.id } }), slider);
    }

    /** @param {string} name @param {number} share */
    #move(name, share) {
        this.host.moveSeam(name, share);
        this.follow();
    }

    /** @param {KeyboardEvent} event */
    #key(event) {
        if (event.key !== 'Escape') return;
        event.preventDefault();
        event.stopPropagation();
        this.close();
    }

    /** @param {FocusEvent} event the focus goes elsewhere */
    #left(event) {
        const to = /** @type {Node | null} */ (event.relatedTarget);
        if (to === this.#button || this.menu.contains(to) || !to) return;
        this.menu.hidden = true;
        this.#button?.setAttribute('aria-expanded', 'false');
    }
}
