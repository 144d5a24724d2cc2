// The poses of the patches of a surface: each moved, turned and scaled by fields of its own.

import { el, icon, setText } from './dom.mjs';
import { icons } from './icons.mjs';
import { Complaint, numberInput } from './values-fields.mjs';
import { Pager } from './values-pager.mjs';

/** @typedef {import('./values-fields.mjs').FieldDescription} FieldDescription */
/** @typedef {import('./values-fields.mjs').Surroundings} Surroundings */

const pageLength = 10;
const axes = ['x', 'y', 'z'];

/** The numbers of a pose: where they stand in it, and what it is called. */
const parts = [
    { key: 'patch', names: ['u', 'v'], read: (/** @type {any} */ pose) => pose.local, write: (/** @type {any} */ pose, /** @type {any} */ local) => ({ ...pose, local }) },
    { key: 'move', names: axes, read: (/** @type {any} */ pose) => pose.translate ?? [0, 0, 0], write: (/** @type {any} */ pose, /** @type {any} */ translate) => ({ ...pose, translate }) },
    { key: 'turn', names: ['angle'], read: (/** @type {any} */ pose) => [pose.rotate?.angle ?? 0], write: (/** @type {any} */ pose, /** @type {any} */ [angle]) => ({ ...pose, rotate: { axis: [0, 0, 1], ...pose.rotate, angle } }) },
    { key: 'axis', names: axes, read: (/** @type {any} */ pose) => pose.rotate?.axis ?? [0, 0, 1], write: (/** @type {any} */ pose, /** @type {any} */ axis) => ({ ...pose, rotate: { angle: 0, ...pose.rotate, axis } }) },
    { key: 'scale', names: axes, read: (/** @type {any} */ pose) => scales(pose.scale), write: (/** @type {any} */ pose, /** @type {any} */ scale) => ({ ...pose, scale }) },
];

/** @param {number | number[] | undefined} scale one factor, or one for each axis */
const scales = (scale = 1) => (Array.isArray(scale) ? scale : [scale, scale, scale]);

export class PatchPoses {
    /** @type {any[]} */
    #list = [];
    #first = 0;
    /** @type {{ inputs: import('./values-number.mjs').NumberInput[][], element: HTMLElement }[]} */
    #cards = [];

    /** @param {FieldDescription} field @param {Surroundings} around */
    constructor(field, around) {
        this.around = around;
        this.address = `${around.address}.${field.path}`;
        this.complaint = new Complaint();
        const { words } = around;
        this.count = el('span', { class: 'count' });
        this.place = el('div');
        this.pager = new Pager(words, pageLength, (first) => this.#turnTo(first));
        const add = around.readOnly ? null : el('button', {
            class: 'quiet-button', text: words.text('list.add.patch'), attributes: { type: 'button' }, on: { click: () => this.#add(add) },
        });
        this.element = el('details', { class: 'list', attributes: { open: true, 'data-path': field.path } },
            el('summary', {}, el('h3', { text: words.label(field.label) }), this.count),
            this.pager.element, this.place, this.complaint.element, el('div', { class: 'adding' }, add));
    }

    /** @param {FieldDescription} field */
    update({ value }) {
        this.#list = value ?? [];
        setText(this.count, String(this.#list.length));
        this.#first = this.pager.show(this.#list.length);
        this.#showPage();
    }

    /**
     * Focuses the fields of a patch's pose, or what poses another where it stands as the model has it.
     * @param {number} _
     * @param {any} local the patch
     */
    focusAt(_, local) {
        this.element.open = true;
        const k = this.#list.findIndex((pose) => String(pose.local) === String(local));
        if (k >= 0) this.pager.turnTo(k);
        const input = this.#cards[k - this.#first]?.inputs[1][0].element ?? this.element.querySelector('button.quiet-button');
        /** @type {HTMLElement | null} */ (input)?.focus();
        return input !== null;
    }

    /** @param {number} first */
    #turnTo(first) {
        this.#first = first;
        this.#cards = [];
        this.place.replaceChildren();
        this.#showPage();
    }

    #showPage() {
        const wanted = Math.max(0, Math.min(pageLength, this.#list.length - this.#first));
        while (this.#cards.length > wanted) this.#cards.pop()?.element.remove();
        while (this.#cards.length < wanted) this.#addCard(this.#first + this.#cards.length);
        this.#cards.forEach(({ inputs }, r) => parts.forEach(({ read }, p) => {
            const numbers = read(this.#list[this.#first + r]);
            inputs[p].forEach((input, c) => input.show(numbers[c] ?? 0));
        }));
    }

    /** @param {number} k */
    #addCard(k) {
        const { words } = this.around;
        const name = words.text('field.row', { label: words.text('pose'), row: words.number(k + 1) });
        const inputs = parts.map((_, p) => this.#inputs(k, p, name));
        const rows = parts.map(({ key }, p) => el('div', { class: 'field' }, el('span', { class: 'name', text: words.text(`pose.${key}`) }),
            el('div', { class: 'controls' }, ...inputs[p].map((input) => input.element))));
        const remove = words.text('list.remove', { label: words.text('pose').toLowerCase(), row: words.number(k + 1) });
        const button = this.around.readOnly ? null : el('button', {
            class: 'button small', attributes: { type: 'button', title: remove, 'aria-label': remove },
            on: { click: () => this.#run({ remove: `${this.address}[${k}]` }, this.element.querySelector('summary') ?? this.element) },
        }, icon(icons.remove));
        const element = el('div', { class: 'pose', attributes: { role: 'group', 'aria-label': name } },
            el('div', { class: 'pose-head' }, el('h4', { text: name }), button), ...rows);
        this.#cards.push({ inputs, element });
        this.place.append(element);
    }

    /** @param {number} k @param {number} p @param {string} name */
    #inputs(k, p, name) {
        const { words } = this.around;
        const { key, names, read, write } = parts[p];
        return names.map((part, c) => {
            const label = `${name}, ${words.text(`pose.${key}`)}${names.length > 1 ? ` ${part}` : ''}`;
            return numberInput(this.around, this.complaint, { label, step: key === 'patch' ? 1 : 0.1 }, (value) => {
                const pose = this.#list[k];
                const numbers = read(pose).map((/** @type {number} */ old, /** @type {number} */ i) => (i === c ? value : old));
                return { set: `${this.address}[${k}]`, value: write(pose, numbers) };
            });
        });
    }

    /** Poses the first patch that stands where the model has it. @param {HTMLElement | null} button */
    #add(button) {
        const taken = new Set(this.#list.map(({ local }) => String(local)));
        let local = [0, 0];
        while (taken.has(String(local))) local = [local[0], local[1] + 1];
        const added = this.#run({ pose: { object: this.around.id, local, translate: [0, 0, 0.5] } }, button ?? this.element);
        if (added) this.pager.turnTo(this.#list.length);
    }

    /** @param {any} command @param {HTMLElement} control */
    #run(command, control) {
        const refusal = this.around.run(command, true);
        if (refusal) this.complaint.show(control, this.around.words.refusal(refusal));
        else this.complaint.clear(control);
        return !refusal;
    }
}
