// Lists of an object as tables: control points, knots and other numbers, poses of local curves.

import { el, icon, setText, uniqueId } from './dom.mjs';
import { icons } from './icons.mjs';
import { Complaint, numberInput } from './values-fields.mjs';
import { NumberInput } from './values-number.mjs';
import { Pager } from './values-pager.mjs';

/** @typedef {import('./values-fields.mjs').FieldDescription} FieldDescription */
/** @typedef {import('./values-fields.mjs').Surroundings} Surroundings */

/**
 * What a kind of list is made of.
 * @typedef {object} ListKind
 * @property {string} noun key of the word for one element
 * @property {(list: any[]) => string[]} columns keys of the headings
 * @property {(element: any) => number[]} numbers of one element, one a column
 * @property {(address: string, k: number, element: any, column: number, value: number) => any} edit
 * @property {((address: string, k: number) => any) | null} remove
 * @property {{ key: string, command: (address: string, list: any[], value: number) => any,
 *     suggest: (list: any[]) => number } | null} add a command from one number
 * @property {((address: string, list: any[]) => any) | null} append a command from none
 */

/**
 * @param {FieldDescription} field
 * @param {Surroundings} around
 * @returns {import('./values-fields.mjs').FieldControl | null}
 */
export function makeList(field, around) {
    const kind = listKind(field, around);
    return kind && Array.isArray(field.value) ? new ListTable(field, around, kind) : null;
}

/**
 * @param {FieldDescription} field
 * @param {Surroundings} around
 * @returns {ListKind | null}
 */
function listKind(field, around) {
    if (field.kind === 'points') return pointList;
    if (field.kind === 'poses') return poseList(around.id);
    if (field.kind !== 'numbers') return null;
    const knots = field.path === 'knots';
    if (knots && around.type === 'bspline-curve') return knotList(around.id);
    return { ...numberList, noun: knots ? 'knot' : 'number' };
}

/** @type {ListKind} */
export const pointList = {
    noun: 'point',
    columns: (list) => ['field.x', 'field.y', 'field.z'].slice(0, list[0]?.length ?? 2),
    numbers: (point) => point,
    edit: (address, k, point, column, value) => ({
        set: `${address}[${k}]`,
        value: point.map((/** @type {number} */ old, /** @type {number} */ c) => (c === column ? value : old)),
    }),
    remove: (address, k) => ({ remove: `${address}[${k}]` }),
    add: null,
    append: (address, list) => ({ insert: `${address}[${list.length}]`, value: nextPoint(list) }),
};

/**
 * A point that goes on where the last two lead.
 * @param {number[][]} list
 */
function nextPoint(list) {
    const last = list[list.length - 1] ?? [0, 0];
    const before = list[list.length - 2] ?? last.map((x) => x - 1);
    return last.map((x, c) => Number((x + (x - before[c]) / 2).toPrecision(6)));
}

/** @type {ListKind} */
const numberList = {
    noun: 'number',
    columns: () => ['list.value'],
    numbers: (value) => [value],
    edit: (address, k, _, __, value) => ({ set: `${address}[${k}]`, value }),
    remove: null,
    add: null,
    append: null,
};

/**
 * @param {string} object
 * @returns {ListKind}
 */
function knotList(object) {
    return {
        ...numberList,
        noun: 'knot',
        remove: (address, k) => ({ remove: `${address}[${k}]` }),
        add: {
            key: 'list.add.knot',
            command: (_, __, at) => ({ insertKnot: { object, at } }),
            suggest: widestMiddle,
        },
    };
}

/**
 * The middle of the widest gap, where a new knot helps most.
 * @param {number[]} knots
 */
function widestMiddle(knots) {
    let best = 0;
    for (let k = 1; k + 1 < knots.length; k += 1) {
        if (knots[k + 1] - knots[k] > knots[best + 1] - knots[best] + 1e-9) best = k;
    }
    return knots.length < 2 ? 0 : Number(((knots[best] + knots[best + 1]) / 2).toPrecision(6));
}

/**
 * @param {string} object
 * @returns {ListKind}
 */
function poseList(object) {
    return {
        noun: 'pose',
        columns: () => ['list.local', 'field.x', 'field.y', 'field.z', 'field.turn'],
        numbers: (pose) => [pose.local, ...poseNumbers(pose)],
        edit: (_, __, pose, column, value) => ({ pose: changedPose(object, pose, column, value) }),
        remove: (address, k) => ({ remove: `${address}[${k}]` }),
        add: {
            key: 'list.add.pose',
            command: (_, __, local) => ({ pose: { object, local, translate: [0.5, 0, 0] } }),
            suggest: (list) => list.reduce((free, pose) => Math.max(free, pose.local + 1), 0),
        },
        append: null,
    };
}

/** @param {any} pose */
function poseNumbers(pose) {
    const [x = 0, y = 0, z = 0] = pose.translate ?? [];
    return [x, y, z, pose.rotate?.angle ?? 0];
}

/**
 * @param {string} object
 * @param {any} pose
 * @param {number} column
 * @param {number} value
 */
function changedPose(object, pose, column, value) {
    const translate = [0, 1, 2].map((c) => pose.translate?.[c] ?? 0);
    const rotate = { axis: [0, 0, 1], angle: 0, ...pose.rotate };
    if (column === 0) return { ...pose, object, local: value };
    if (column === 4) rotate.angle = value;
    else translate[column - 1] = value;
    return { ...pose, object, translate, rotate };
}

const openedUpTo = 12;  // longer tables wait folded
const pageLength = 50;  // rows that are there at once, so that the page stays quick

/** A list as a table, as many rows at once as fit on a page of it. */
export class ListTable {
    /** @type {{ inputs: import('./values-number.mjs').NumberInput[] }[]} */
    #rows = [];
    #body = el('tbody');
    #count = el('span', { class: 'count' });
    #complaint = new Complaint();
    /** @type {any[]} */
    #list = [];
    #columns = 0;
    #suggested = NaN;
    /** The first element that is shown. */
    #first = 0;

    /**
     * @param {FieldDescription} field
     * @param {Surroundings} around
     * @param {ListKind} kind
     */
    constructor(field, around, kind) {
        this.around = around;
        this.kind = kind;
        this.address = `${around.address}.${field.path}`;
        this.noun = around.words.text(kind.noun);
        this.label = around.words.label(field.label);
        this.head = el('thead');
        this.table = el('table', { attributes: { 'aria-label': this.label } }, this.head, this.#body);
        this.adding = around.readOnly ? null : this.#makeAdding();
        const summary = el('summary', {}, el('h3', { text: this.label }), this.#count);
        this.pager = new Pager(around.words, pageLength, (first) => this.#turnTo(first));
        this.element = el('details', {
            class: 'list',
            attributes: { open: field.value.length <= openedUpTo, 'data-path': field.path },
        }, summary, this.pager.element, this.table, this.#complaint.element, this.adding);
    }

    /** @param {FieldDescription} field */
    update(field) {
        this.#list = field.value;
        const columns = this.kind.columns(this.#list);
        if (columns.length !== this.#columns) this.#buildHead(columns);
        this.#first = this.pager.show(this.#list.length);
        this.#showPage();
        this.table.hidden = this.#list.length === 0;
        setText(this.#count, String(this.#list.length));
        this.#suggest();
    }

    #showPage() {
        this.#resize();
        this.#rows.forEach(({ inputs }, r) => {
            const numbers = this.kind.numbers(this.#list[this.#first + r]);
            inputs.forEach((input, c) => input.show(numbers[c] ?? 0));
        });
    }

    /** Another page has rows of its own, whose labels say their numbers. @param {number} first */
    #turnTo(first) {
        this.#first = first;
        this.#rows = [];
        this.#body.replaceChildren();
        this.#complaint.clear(this.table);
        this.#showPage();
    }

    /**
     * Focuses the fields of an element, or what adds it where the list leaves it out.
     * @param {number} k
     * @param {any} local of a pose, which says where it stands
     */
    focusAt(k, local) {
        const named = JSON.stringify(local);
        const row = local === undefined ? k
            : this.#list.findIndex((pose) => JSON.stringify(pose.local) === named);
        this.element.open = true;
        if (row >= 0) this.pager.turnTo(row);
        const input = this.#rows[row - this.#first]?.inputs[0]?.element ?? this.newNumber?.element;
        if (row < 0 && typeof local === 'number') this.newNumber?.show(local);
        input?.focus();
        input?.select();
        return input !== undefined;
    }

    /** @param {string[]} columns */
    #buildHead(columns) {
        const { words } = this.around;
        this.#columns = columns.length;
        this.#rows = [];
        this.#body.replaceChildren();
        const cells = ['list.number', ...columns].map((key) => el('th', { text: words.text(key), attributes: { scope: 'col' } }));
        if (this.#removable) {
            cells.push(el('th', { attributes: { scope: 'col' } },
                el('span', { class: 'aside', text: words.text('list.actions') })));
        }
        this.head.replaceChildren(el('tr', {}, ...cells));
    }

    get #removable() {
        return this.kind.remove !== null && !this.around.readOnly;
    }

    #resize() {
        const wanted = Math.min(pageLength, this.#list.length - this.#first);
        while (this.#rows.length > wanted) {
            this.#rows.pop();
            this.#body.lastElementChild?.remove();
        }
        while (this.#rows.length < wanted) this.#addRow(this.#first + this.#rows.length);
    }

    /** @param {number} k */
    #addRow(k) {
        const { words } = this.around;
        const columns = this.kind.columns(this.#list);
        const row = words.number(k + 1);
        const inputs = columns.map((key, c) => {
            const label = words.text('field.part', { label: this.noun, row, part: words.text(key) });
            return numberInput(this.around, this.#complaint, { label, step: 0.1 }, (value) =>
                this.kind.edit(this.address, k, this.#list[k], c, value));
        });
        const cells = inputs.map((input) => el('td', {}, input.element));
        if (this.#removable) cells.push(el('td', { class: 'removal' }, this.#removeButton(k, row)));
        this.#rows.push({ inputs });
        this.#body.append(el('tr', {}, el('th', { text: row, attributes: { scope: 'row' } }), ...cells));
    }

    /**
     * @param {number} k
     * @param {string} row
     */
    #removeButton(k, row) {
        const label = this.around.words.text('list.remove', { label: this.noun.toLowerCase(), row });
        const button = el('button', {
            class: 'button small',
            attributes: { type: 'button', 'aria-label': label, title: label },
            on: { click: () => this.#remove(k, button) },
        }, icon(icons.remove));
        return button;
    }

    /**
     * The focus goes to the row that took the place of the removed one.
     * @param {number} k
     * @param {HTMLElement} button
     */
    #remove(k, button) {
        const command = this.kind.remove?.(this.address, k);
        if (!this.#run(command, button)) return;
        queueMicrotask(() => {  // the table has fewer rows by then
            const buttons = /** @type {NodeListOf<HTMLElement>} */ (this.#body.querySelectorAll('.small'));
            (buttons[Math.min(k - this.#first, buttons.length - 1)] ?? this.element.querySelector('summary'))?.focus();
        });
    }

    #makeAdding() {
        const { add, append } = this.kind;
        if (append) return el('div', { class: 'adding' }, this.#appendButton(append));
        return add ? this.#makeAddingOf(add) : null;
    }

    /** @param {(address: string, list: any[]) => any} append */
    #appendButton(append) {
        const button = el('button', {
            class: 'quiet-button',
            text: this.around.words.text(`list.add.${this.kind.noun}`),
            attributes: { type: 'button' },
            on: {
                click: () => {
                    if (!this.#run(append(this.address, this.#list), button)) return;
                    this.pager.turnTo(this.#list.length);
                    queueMicrotask(() => this.#focusLast());
                },
            },
        });
        return button;
    }

    /** @param {NonNullable<ListKind['add']>} add */
    #makeAddingOf(add) {
        const { words } = this.around;
        const input = new NumberInput(words, { step: 0.1, readOnly: false }, (value) => {
            if (!Number.isNaN(value)) input.show(value);
        }, () => this.#complaint.clear(input.element));
        const { element } = input;
        this.newNumber = input;
        element.id = uniqueId('add');
        element.addEventListener('keydown', (event) => {
            if (event.key === 'Enter') this.#insert(add, element);
        });
        const button = el('button', {
            class: 'quiet-button',
            text: words.text('list.add.do'),
            attributes: { type: 'button' },
            on: { click: () => this.#insert(add, element) },
        });
        return el('div', { class: 'adding' },
            el('label', { text: words.text(add.key), attributes: { for: element.id } }), element, button);
    }

    /**
     * @param {NonNullable<ListKind['add']>} add
     * @param {HTMLInputElement} element
     */
    #insert(add, element) {
        const { words } = this.around;
        const value = words.parse(element.value);
        if (Number.isNaN(value)) {
            const example = words.editable(0.5);
            this.#complaint.show(element, words.text('field.not-number', { example }));
        } else {
            this.#run(add.command(this.address, this.#list, value), element);
        }
    }

    #suggest() {
        if (!this.newNumber || !this.kind.add) return;
        const value = this.kind.add.suggest(this.#list);
        if (value !== this.#suggested) this.newNumber.show(value);
        this.#suggested = value;
    }

    #focusLast() {
        const row = this.#body.lastElementChild;
        /** @type {HTMLElement | null | undefined} */ (row?.querySelector('input'))?.focus();
    }

    /**
     * @param {any} command
     * @param {HTMLElement} control
     * @returns {boolean} whether it was done
     */
    #run(command, control) {
        const refusal = this.around.run(command, true);
        if (refusal) this.#complaint.show(control, this.around.words.refusal(refusal));
        else this.#complaint.clear(control);
        return !refusal;
    }
}
