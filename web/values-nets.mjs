// Nets and meshes: the control points of a surface row by row, the vertices of a mesh page by page.

import { el, setText, uniqueId } from './dom.mjs';
import { Complaint } from './values-fields.mjs';
import { ListTable, pointList } from './values-lists.mjs';

/** @typedef {import('./values-fields.mjs').FieldDescription} FieldDescription */
/** @typedef {import('./values-fields.mjs').Surroundings} Surroundings */

/** Points that belong together: none can come or go alone. */
const boundPoints = { ...pointList, remove: null, append: null };

/**
 * The path of the net of which this field is a row, or '' for what is none.
 * @param {FieldDescription} field
 */
export function netOf({ kind, path }) {
    return kind === 'points' ? /^(.*)\[\d+\]$/.exec(path)?.[1] ?? '' : '';
}

/** The rows of a net, one at a time. */
export class NetTable {
    /** @type {Map<string, FieldDescription>} */
    #rows = new Map();
    #shown = '';
    /** @type {ListTable | undefined} */
    #table;

    /**
     * @param {FieldDescription[]} rows
     * @param {Surroundings} around
     */
    constructor(rows, around) {
        this.around = around;
        const { words } = around;
        for (const row of rows) this.#rows.set(row.path, row);
        const options = rows.map(({ path }, k) => el('option', { text: words.number(k + 1), attributes: { value: path } }));
        this.select = el('select', { attributes: { id: uniqueId('row') }, on: { change: () => this.#choose(this.select.value) } }, ...options);
        const label = words.label(rows[0].label.replace(/ \d+$/, ''));
        const size = `${rows.length} × ${rows[0].value?.length ?? 0}`;
        this.place = el('div');
        this.element = el('details', { class: 'list', attributes: { open: true } },
            el('summary', {}, el('h3', { text: label }), el('span', { class: 'count', text: size })),
            el('div', { class: 'field' }, el('label', { text: words.text('net.row'), attributes: { for: this.select.id } }),
                el('div', { class: 'controls' }, this.select)), this.place);
        this.#choose(rows[0].path);
    }

    /** @param {FieldDescription} row */
    update(row) {
        this.#rows.set(row.path, row);
        if (row.path === this.#shown) this.#table?.update(row);
    }

    /** @param {number} k @param {any} local @param {string} row its path */
    focusAt(k, local, row) {
        this.element.open = true;
        if (row !== this.#shown) this.#choose(row);
        this.select.value = row;
        return this.#table?.focusAt(k, local) ?? false;
    }

    /** @param {string} path */
    #choose(path) {
        const row = this.#rows.get(path);
        if (!row || !Array.isArray(row.value)) return;
        this.#shown = path;
        this.#table = new ListTable(row, this.around, boundPoints);
        this.#table.update(row);
        this.#table.element.setAttribute('open', '');
        this.place.replaceChildren(this.#table.element);
    }
}

/** A control mesh: a solid by its name, or vertices to be typed. */
export class MeshFields {
    /**
     * @param {FieldDescription} field
     * @param {Surroundings} around
     * @param {any} kw
     */
    constructor(field, around, kw) {
        this.around = around;
        this.kw = kw;
        /** As the document has it. @type {any} */
        this.value = field.value;
        this.path = `${around.address}.${field.path}`;
        this.complaint = new Complaint();
        const { words } = around;
        const solids = kw.solids.map((/** @type {any} */ { name, label }) => [name, words.label(label ?? name)]);
        const own = /** @type {[string, string]} */ (['', words.text('mesh.own')]);
        this.select = el('select', { attributes: { id: uniqueId('mesh'), disabled: around.readOnly }, on: { change: () => this.#choose() } },
            ...[own, ...solids].map(([value, text]) => el('option', { text, attributes: { value } })));
        this.vertices = new ListTable({ ...field, path: `${field.path}.vertices`, label: words.text('mesh.vertices'), value: [] }, around, boundPoints);
        this.faces = el('p', { class: 'shape' });
        this.element = el('div', { attributes: { 'data-path': field.path } }, el('div', { class: 'field' },
            el('label', { text: words.label(field.label), attributes: { for: this.select.id } }),
            el('div', { class: 'controls' }, this.select), this.complaint.element), this.faces, this.vertices.element);
    }

    /** @param {FieldDescription} field */
    update({ value }) {
        this.value = value;
        this.select.value = value?.solid ?? '';
        const vertices = Array.isArray(value?.vertices) && Array.isArray(value.vertices[0]) ? value.vertices : [];
        this.vertices.element.hidden = vertices.length === 0;
        this.vertices.update({ path: '', label: '', kind: 'points', value: vertices });
        this.faces.hidden = vertices.length === 0;
        setText(this.faces, this.around.words.text('mesh.faces', { count: value?.faces?.length ?? 0 }));
    }

    /** @param {number} k @param {any} local */
    focusAt(k, local) {
        return this.vertices.focusAt(k, local);
    }

    #choose() {
        const solid = this.select.value;
        const refusal = this.around.run({ set: this.path, value: solid === '' ? this.#spelledOut() : { solid } }, true);
        if (refusal) this.complaint.show(this.select, this.around.words.refusal(refusal));
        else this.complaint.clear(this.select);
    }

    /** The solid with its vertices, so that they can be moved. */
    #spelledOut() {
        const mesh = this.kw.mesh(this.value);
        const flat = mesh.vertices;
        const vertices = Array.from({ length: flat.length / 3 }, (_, k) => [...flat.subarray(3 * k, 3 * k + 3)]);
        const { faces } = mesh;
        mesh.dispose();
        return { vertices, faces };
    }
}
