// The values panel: everything that can be dragged, as fields to be typed. It is made from the same
// descriptions as the panel in the picture and makes the same commands.

import { el, setText } from './dom.mjs';
import { shapeSentence } from './shape.mjs';
import { AxiomsSection } from './values-axioms.mjs';
import { makeField } from './values-fields.mjs';
import { makeList } from './values-lists.mjs';
import { MeshFields, netOf, NetTable } from './values-nets.mjs';
import { PatchPoses } from './values-poses.mjs';
import { Readout } from './values-readout.mjs';
import { StepField } from './values-step.mjs';
import { TraceChoice } from './values-trace.mjs';

/** @typedef {import('./values-fields.mjs').FieldDescription} FieldDescription */
/** @typedef {{ object: string, type: string, label: string, fields: FieldDescription[] }} ObjectDescription */

/**
 * What the panel works on.
 * @typedef {object} PanelHost
 * @property {import('./words.mjs').Words} words
 * @property {any} kw
 * @property {boolean} readOnly
 * @property {(command: any, final: boolean) => any} run executes a command, answers its refusal
 * @property {(step: number) => void} setStep of the arrow keys, 0 where the zoom is to decide
 */

export class ValuesPanel {
    #structure = '';
    /** @type {ObjectSection[]} */
    #sections = [];

    /** @param {PanelHost} host */
    constructor(host) {
        this.host = host;
        this.inner = el('div', { class: 'values-inner' });
        this.element = el('section', {
            class: 'values',
            attributes: { 'aria-label': host.words.text('values') },
        }, this.inner);
        this.step = host.readOnly ? undefined : new StepField(host.words, host.setStep);
        if (this.step) this.element.append(this.step.element);
    }

    /**
     * Shows the scene as it is now; controls are made anew only when there are others than before.
     * @param {import('./figure-reading.mjs').Reading} read
     */
    update(read) {
        /** @type {ObjectDescription[]} */
        const objects = read.schema;
        const structure = JSON.stringify(objects.map(structureOf));
        if (structure !== this.#structure) this.#build(objects);
        this.#structure = structure;
        const { document } = read;
        objects.forEach((object, k) => this.#sections[k].update(object, document.objects[k], document));
    }

    /** Opens the fields of the object that has been selected. @param {number} index */
    reveal(index) {
        if (index === this.#revealed) return;
        this.#revealed = index;
        this.#sections[index]?.open();
    }

    #revealed = -1;

    /**
     * Focuses the fields of an element of a list; answers whether there are any.
     * @param {import('./figure-handles.mjs').Held} held
     */
    focusAt({ path, local }) {
        const [, object, list, row] = /^objects\[(\d+)\]\.(.+)\[(\d+)\]$/.exec(path) ?? [];
        this.#sections[Number(object)]?.open();
        const controls = this.#sections[Number(object)]?.controls;
        const control = controls?.get(list) ?? controls?.get(list.replace(/\.\w+$/, ''));
        return control?.focusAt?.(Number(row), local, list) ?? false;
    }

    /** @param {ObjectDescription[]} objects */
    #build(objects) {
        const open = new Set(this.#sections.filter(({ isOpen }) => isOpen).map(({ id }) => id));
        const alone = objects.length === 1;
        this.#sections = objects.map((object, k) => new ObjectSection(this.host, object, k, alone));
        const kept = this.#sections.filter(({ id }) => open.has(id));
        for (const section of kept.length > 0 ? kept : this.#sections.slice(0, 1)) section.open();
        const sections = this.#sections.map((section) => section.element);
        this.inner.replaceChildren(...sections);
        if (objects.length === 0) this.inner.append(el('p', { text: this.host.words.text('values.none') }));
    }
}

/**
 * What of an object decides which controls there are.
 * @param {ObjectDescription} object
 */
function structureOf({ object, type, fields }) {
    return [object, type, fields.map(({ path, kind, min, max, choices, value }) =>
        [path, kind, min, max, choices, Array.isArray(value), kind === 'point' && value?.length])];
}

/** Fields whose controls stand elsewhere: above the others, and under the picture. */
const ownControls = ['trace.algorithm', 'trace.frame'];

/** The fields of one object under its name, and its readout. */
class ObjectSection {
    /**
     * @param {PanelHost} host
     * @param {ObjectDescription} object
     * @param {number} index among the scene's objects
     * @param {boolean} alone
     */
    constructor(host, object, index, alone) {
        this.host = host;
        this.id = object.object;
        /** What was told last, for a section that is opened later. @type {[ObjectDescription, any, any[]] | undefined} */
        this.told = undefined;
        this.label = object.label ?? object.type;
        /** Of what has a B-function. @type {AxiomsSection | undefined} */
        this.axioms = undefined;
        /** @type {Map<string, import('./values-fields.mjs').FieldControl>} */
        this.controls = new Map();
        this.shape = el('p', { class: 'shape' });
        this.readout = new Readout(host.words, host.kw);
        const around = {
            words: host.words, readOnly: host.readOnly, run: host.run,
            address: `objects[${index}]`, id: object.object, type: object.type,
        };
        this.trace = new TraceChoice(around);
        const title = el('h2', { text: object.object });
        const content = [this.shape, this.trace.element, ...this.#groups(object, around), this.readout.element];
        this.element = alone ? el('div', {}, title, ...content) : el('details', { class: 'object', on: { toggle: () => this.#show() } },
            el('summary', {}, title), ...content);
    }

    /**
     * @param {ObjectDescription} object
     * @param {any} spec of the object in the canonical document
     * @param {any} document canonical
     */
    update(object, spec, document) {
        this.told = [object, spec, document];
        if (this.isOpen) this.#show();
    }

    get isOpen() {
        return !(this.element instanceof HTMLDetailsElement) || this.element.open;
    }

    open() {
        if (this.element instanceof HTMLDetailsElement) this.element.open = true;
    }

    #show() {
        if (!this.told || !this.isOpen) return;
        const [object, spec, document] = this.told;
        for (const field of object.fields) this.controls.get(field.path)?.update(field);
        setText(this.shape, shapeSentence(this.host.words, spec, this.label));
        if (spec.bFunction) this.axioms?.update(spec, document);
        this.trace.update(spec);
        this.readout.update(spec);
    }

    /**
     * @param {ObjectDescription} object
     * @param {import('./values-fields.mjs').Surroundings} around
     */
    #groups(object, around) {
        /** @type {Map<string, FieldDescription[]>} */
        const groups = new Map();
        for (const field of object.fields.filter(({ path }) => !ownControls.includes(path))) {
            const name = field.group ?? '';
            groups.set(name, [...(groups.get(name) ?? []), field]);
        }
        return [...groups].map(([name, fields]) => this.#group(name, fields, around));
    }

    /**
     * @param {FieldDescription} field
     * @param {FieldDescription[]} fields of its group
     * @param {import('./values-fields.mjs').Surroundings} around
     * @returns {import('./values-fields.mjs').FieldControl | null}
     */
    #control(field, fields, around) {
        const net = netOf(field);
        if (net) {
            const rows = fields.filter((other) => netOf(other) === net);
            const table = new NetTable(rows, around);
            for (const { path } of rows) this.controls.set(path, table);
            return table;
        }
        if (field.kind === 'mesh') return new MeshFields(field, around, this.host.kw);
        if (field.kind === 'list' && field.path === 'poses') return new PatchPoses(field, around);
        return makeField(field, around) ?? makeList(field, around);
    }

    /**
     * @param {string} name
     * @param {FieldDescription[]} fields
     * @param {import('./values-fields.mjs').Surroundings} around
     */
    #group(name, fields, around) {
        const flags = el('div', { class: 'flags' });
        const rows = [];
        for (const field of fields) {
            if (this.controls.has(field.path)) continue;  // a row of a net
            const control = this.#control(field, fields, around);
            if (!control) continue;
            this.controls.set(field.path, control);
            if (field.kind === 'flag') flags.append(control.element);
            else rows.push(control.element);
        }
        if (flags.childElementCount > 0) rows.push(flags);
        if (name === 'B-function') {
            this.axioms = new AxiomsSection(around, this.host.kw);
            rows.push(this.axioms.element);
        }
        if (!name) return el('div', { class: 'group' }, ...rows);
        return el('fieldset', { class: 'group' }, el('legend', { text: around.words.label(name) }), ...rows);
    }
}
