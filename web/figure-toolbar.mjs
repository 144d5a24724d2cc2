// The controls under a figure's picture: native buttons and a slider, in the order of the tab key.

import { el, icon, setAttributes } from './dom.mjs';
import { icons } from './icons.mjs';

/**
 * What the controls act on.
 * @typedef {object} Actions
 * @property {() => void} undo
 * @property {() => void} redo
 * @property {() => void} togglePlay
 * @property {() => void} reset
 * @property {() => void} fit
 * @property {() => void} toggleExpert
 * @property {() => void} toggleValues
 * @property {() => void} nextTheme
 * @property {() => void} togglePanes
 * @property {(phase: number) => void} seek
 */

/**
 * What the controls show.
 * @typedef {object} Status
 * @property {boolean} moves whether the scene has an animation
 * @property {boolean} playing
 * @property {number} phase
 * @property {boolean} canUndo
 * @property {boolean} canRedo
 * @property {boolean} expert
 * @property {boolean} values
 */

/**
 * Which controls each value of the attribute `controls` gives.
 * @type {Record<string, string[]>}
 */
const sets = {
    full: ['play', 'undo', 'redo', 'reset', 'fit', 'panes', 'expert', 'theme', 'values'],
    values: ['play', 'undo', 'redo', 'reset', 'fit', 'panes', 'values'],
    minimal: ['play', 'undo', 'redo', 'reset'],
    none: [],
};

const phaseSteps = 1000;

/** Where the caption is shorter than the label. @type {Record<string, string>} */
const captions = { expert: 'expert.short', fit: 'fit.short' };

export class FigureToolbar {
    /** @type {Map<string, HTMLButtonElement>} */
    #buttons = new Map();
    #scrubber = el('input', {
        class: 'scrubber',
        attributes: { type: 'range', min: 0, max: phaseSteps, step: 1 },
    });

    /**
     * @param {import('./words.mjs').Words} words
     * @param {Actions} actions
     * @param {{ controls: string, readOnly: boolean, ownTheme: boolean }} options
     */
    constructor(words, actions, options) {
        this.words = words;
        const wanted = (/** @type {string} */ name) => wantedIn(options, name);
        const act = listeners(actions);
        const add = (/** @type {string} */ name) => (wanted(name) ? this.#add(name, act[name]) : null);
        this.#scrubber.setAttribute('aria-label', words.text('phase'));
        this.#scrubber.addEventListener('input', () => actions.seek(this.#scrubber.valueAsNumber / phaseSteps));
        this.motion = wanted('play') ? el('div', { class: 'motion' }, add('play'), this.#scrubber) : null;
        this.element = el('div', {
            class: 'toolbar',
            attributes: { role: 'group', 'aria-label': words.text('controls') },
        }, this.motion, el('span', { class: 'spring' }),
        ...['undo', 'redo', 'reset', 'fit', 'theme', 'panes', 'expert', 'values'].map(add));
        this.element.hidden = sets[options.controls].length === 0;
    }

    /** @param {string} name */
    button(name) {
        return this.#buttons.get(name);
    }

    /** @param {Status} status */
    update(status) {
        if (this.motion) this.motion.hidden = !status.moves;
        this.#showPlay(status.playing);
        this.#showPhase(status.phase);
        this.#enable('undo', status.canUndo);
        this.#enable('redo', status.canRedo);
        this.#mark('expert', 'aria-pressed', status.expert);
        this.#mark('values', 'aria-expanded', status.values);
    }

    /**
     * @param {string} name
     * @param {() => void} act
     */
    #add(name, act) {
        const label = this.words.text(name);
        const button = el('button', {
            class: name === 'values' ? 'button captioned' : 'button roomy',
            attributes: { type: 'button', title: label, 'aria-label': label },
            on: { click: act },
        }, icon(icons[name]));
        if (name !== 'play') button.append(el('span', { class: 'caption', text: this.words.text(captions[name] ?? name) }));
        this.#buttons.set(name, button);
        return button;
    }

    /** @param {boolean} playing */
    #showPlay(playing) {
        const button = this.#buttons.get('play');
        const name = playing ? 'pause' : 'play';
        if (!button || button.dataset.shows === name) return;
        button.dataset.shows = name;
        const label = this.words.text(name);
        setAttributes(button, { title: label, 'aria-label': label });
        button.replaceChildren(icon(icons[name]));
    }

    /** @param {number} phase */
    #showPhase(phase) {
        const step = String(Math.round(phase * phaseSteps));
        if (this.#scrubber.value === step && this.#scrubber.hasAttribute('aria-valuetext')) return;
        this.#scrubber.value = step;
        const value = this.words.number(Math.round(phase * 100) / 100);
        this.#scrubber.setAttribute('aria-valuetext', this.words.text('phase.value', { value }));
    }

    /**
     * A button that cannot act stays focusable, or the focus would fall off it after the last undo.
     * @param {string} name
     * @param {boolean} able
     */
    #enable(name, able) {
        const button = this.#buttons.get(name);
        if (button) setAttributes(button, { 'aria-disabled': able ? null : 'true' });
    }

    /**
     * @param {string} name
     * @param {string} attribute
     * @param {boolean} on
     */
    #mark(name, attribute, on) {
        const button = this.#buttons.get(name);
        if (button) setAttributes(button, { [attribute]: String(on) });
    }
}

/**
 * A figure that may only be looked at has nothing to undo; a page that sets the theme itself has no
 * need of a second button.
 * @param {{ controls: string, readOnly: boolean, ownTheme: boolean }} options
 * @param {string} name
 */
function wantedIn({ controls, readOnly, ownTheme }, name) {
    if (readOnly && ['undo', 'redo', 'panes', 'expert'].includes(name)) return false;
    if (name === 'theme' && !ownTheme) return false;
    return sets[controls].includes(name);
}

/**
 * @param {Actions} actions
 * @returns {Record<string, () => void>}
 */
function listeners(actions) {
    return {
        play: actions.togglePlay,
        undo: actions.undo,
        redo: actions.redo,
        reset: actions.reset,
        fit: actions.fit,
        expert: actions.toggleExpert,
        values: actions.toggleValues,
        theme: actions.nextTheme,
        panes: actions.togglePanes,
    };
}

/** @param {string | null} value of the attribute `controls` */
export function controlsFor(value) {
    return value !== null && value in sets ? value : 'values';
}
