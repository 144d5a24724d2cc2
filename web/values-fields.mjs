// One field of an object as a control of the page: label, control, and room for a complaint.

import { el, setAttributes, setText, uniqueId } from './dom.mjs';
import { NumberInput } from './values-number.mjs';

/**
 * A field as `scene.schema` describes it.
 * @typedef {object} FieldDescription
 * @property {string} path relative to its object
 * @property {string} label
 * @property {string} kind
 * @property {number | null} [min]
 * @property {number | null} [max]
 * @property {boolean} [minOpen]
 * @property {number} [low] ends of a slider, where one makes sense
 * @property {number} [high]
 * @property {({ value: string, label: string } | [string, string])[]} [choices]
 * @property {string} [group]
 * @property {string} [help]
 * @property {any} value
 */

/**
 * The surroundings of a field. `run` executes a command and answers its refusal, if any; a gesture
 * that goes on is not `final`.
 * @typedef {object} Surroundings
 * @property {import('./words.mjs').Words} words
 * @property {boolean} readOnly
 * @property {string} address path of the object
 * @property {string} id of the object
 * @property {string} type of the object
 * @property {(command: any, final: boolean) => any} run
 */

/**
 * @typedef {object} FieldControl
 * @property {HTMLElement} element
 * @property {(field: FieldDescription) => void} update
 * @property {(k: number, local: any, list: string) => boolean} [focusAt] of a
 *     list: focuses an element's fields
 */

/** The place beside a control where a refused command says why. */
export class Complaint {
    constructor() {
        this.id = uniqueId('complaint');
        this.element = el('p', { class: 'complaint', attributes: { id: this.id } });
    }

    /**
     * @param {HTMLElement} control
     * @param {string} message
     */
    show(control, message) {
        setText(this.element, message);
        setAttributes(control, { 'aria-invalid': 'true', 'aria-describedby': this.id });
    }

    /** @param {HTMLElement[]} controls */
    clear(...controls) {
        setText(this.element, '');
        for (const control of controls) {
            setAttributes(control, { 'aria-invalid': null, 'aria-describedby': null });
        }
    }
}

let lastGesture = 0;

/** Names a gesture, all commands of which are one step of history. */
export function newGesture() {
    lastGesture += 1;
    return `field-${lastGesture}`;
}

/**
 * A number input that executes `command(value)` and complains into `complaint`.
 * @param {Surroundings} around
 * @param {Complaint} complaint
 * @param {import('./values-number.mjs').NumberLimits & { label?: string }} options
 * @param {(value: number) => any} command
 */
export function numberInput(around, complaint, options, command) {
    const input = new NumberInput(around.words, { ...options, readOnly: around.readOnly }, (value) => {
        if (Number.isNaN(value)) {
            const example = around.words.editable(0.5);
            complaint.show(input.element, around.words.text('field.not-number', { example }));
            return;
        }
        const refusal = around.run(command(value), true);
        if (refusal) complaint.show(input.element, around.words.refusal(refusal));
        else complaint.clear(input.element);
    }, () => complaint.clear(input.element));
    return input;
}

/**
 * @param {FieldDescription} field
 * @param {Surroundings} around
 * @returns {FieldControl | null} null for what is no field to be typed by itself
 */
export function makeField(field, around) {
    const kind = field.kind === 'scale' && typeof field.value === 'number' ? 'number' : field.kind;
    const make = makers[kind];
    return make ? make(field, around) : null;
}

/** @type {Record<string, (field: FieldDescription, around: Surroundings) => FieldControl>} */
const makers = {
    number: makeNumber,
    integer: makeNumber,
    flag: makeFlag,
    choice: makeChoice,
    text: makeText,
    colour: makeColour,
    point: (field, around) => makeParts(field, around, ['x', 'y', 'z']),
    interval: (field, around) => makeParts(field, around, ['from', 'to']),
};

/**
 * @param {FieldDescription} field
 * @param {Surroundings} around
 * @param {HTMLElement} labelled
 * @param {HTMLElement[]} controls
 * @param {Complaint} complaint
 */
function row(field, around, labelled, controls, complaint) {
    labelled.id = uniqueId('field');
    const label = el('label', {
        text: around.words.label(field.label),
        attributes: { for: labelled.id, title: field.help ? around.words.label(field.help) : null },
    });
    return el('div', { class: 'field', attributes: { 'data-path': field.path } }, label,
        el('div', { class: 'controls' }, ...controls), complaint.element);
}

/** @param {FieldDescription} field @param {Surroundings} around @param {any} value */
const setCommand = (field, around, value) => ({ set: `${around.address}.${field.path}`, value });

/** @param {FieldDescription} field @param {Surroundings} around */
function makeNumber(field, around) {
    const complaint = new Complaint();
    const limits = limitsOf(field);
    const input = numberInput(around, complaint, limits, (value) => setCommand(field, around, value));
    const slider = slides(field) ? makeSlider(field, around, complaint) : null;
    const controls = slider ? [slider, input.element] : [input.element];
    return {
        element: row(field, around, input.element, controls, complaint),
        update: (/** @type {FieldDescription} */ now) => {
            if (now.value !== input.value) complaint.clear(input.element);
            input.show(now.value);
            if (slider) slider.valueAsNumber = now.value;
        },
    };
}

const widestSlider = 1000;  // where a step of a hand would pass over everything, there is none

/** @param {FieldDescription} field */
function slides({ low, high }) {
    return low !== undefined && high !== undefined && high - low <= widestSlider;
}

/** @param {FieldDescription} field */
function limitsOf(field) {
    const [min, max] = [field.min ?? -Infinity, field.max ?? Infinity];
    const step = stepOf(field);
    return { min: field.minOpen ? min + step : min, max, step };
}

/**
 * About a hundredth of the slider's range, a power of ten.
 * @param {FieldDescription} field
 */
function stepOf({ kind, low, high }) {
    if (kind === 'integer') return 1;
    if (low === undefined || high === undefined) return 0.1;
    return 10 ** Math.floor(Math.log10((high - low) / 50));
}

/**
 * @param {FieldDescription} field
 * @param {Surroundings} around
 * @param {Complaint} complaint
 */
function makeSlider(field, around, complaint) {
    let gesture = '';
    const run = (/** @type {boolean} */ final) => {
        gesture ||= newGesture();
        const command = { ...setCommand(field, around, slider.valueAsNumber), gesture };
        const refusal = around.run(command, final);
        if (refusal) complaint.show(slider, around.words.refusal(refusal));
        else complaint.clear(slider);
        if (final) gesture = '';
    };
    const label = around.words.label(field.label);
    const slider = el('input', {
        attributes: {
            type: 'range', min: limitOpen(field), max: field.high, step: stepOf(field), disabled: around.readOnly,
            'aria-label': around.words.text('field.slider', { label }),
        },
        on: { input: () => run(false), change: () => run(true) },
    });
    return slider;
}

/**
 * A slider cannot leave out its end, so it starts one step later where the end is not allowed.
 * @param {FieldDescription} field
 */
function limitOpen(field) {
    const low = field.low ?? 0;
    return field.minOpen && low === field.min ? low + stepOf(field) : low;
}

/** @param {FieldDescription} field @param {Surroundings} around */
function makeFlag(field, around) {
    const complaint = new Complaint();
    const box = el('input', {
        attributes: { type: 'checkbox', disabled: around.readOnly },
        on: {
            change: () => {
                const refusal = around.run(setCommand(field, around, box.checked), true);
                if (refusal) complaint.show(box, around.words.refusal(refusal));
                else complaint.clear(box);
            },
        },
    });
    const title = field.help ? around.words.label(field.help) : null;
    const label = el('label', { class: 'flag', attributes: { title, 'data-path': field.path } },
        box, around.words.label(field.label));
    return {
        element: el('div', {}, label, complaint.element),
        update: (/** @type {FieldDescription} */ now) => { box.checked = now.value === true; },
    };
}

/** @param {FieldDescription} field @param {Surroundings} around */
function makeChoice(field, around) {
    const complaint = new Complaint();
    const options = (field.choices ?? []).map((choice) => {
        const [value, label] = Array.isArray(choice) ? choice : [choice.value, choice.label];
        return el('option', { text: around.words.label(label), attributes: { value } });
    });
    const select = el('select', {
        attributes: { disabled: around.readOnly },
        on: {
            change: () => {
                const refusal = around.run(setCommand(field, around, select.value), true);
                if (!refusal) return complaint.clear(select);
                complaint.show(select, around.words.refusal(refusal));
                return undefined;
            },
        },
    }, ...options);
    return {
        element: row(field, around, select, [select], complaint),
        update: (/** @type {FieldDescription} */ now) => {
            if (select.value === String(now.value)) return;
            select.value = String(now.value);
            complaint.clear(select);
        },
    };
}

/** @param {FieldDescription} field @param {Surroundings} around */
function makeText(field, around) {
    const complaint = new Complaint();
    const input = el('input', {
        attributes: { type: 'text', readonly: around.readOnly, autocomplete: 'off', spellcheck: 'false' },
        on: {
            change: () => {
                const refusal = around.run(setCommand(field, around, input.value), true);
                if (refusal) complaint.show(input, around.words.refusal(refusal));
                else complaint.clear(input);
            },
        },
    });
    let shown = '';
    return {
        element: row(field, around, input, [input], complaint),
        update: (/** @type {FieldDescription} */ now) => {
            const text = now.value ?? '';
            if (text === shown) return;
            shown = text;
            input.value = text;
            complaint.clear(input);
        },
    };
}

/** @param {FieldDescription} field @param {Surroundings} around */
function makeColour(field, around) {
    const complaint = new Complaint();
    let gesture = '';
    const run = (/** @type {boolean} */ final) => {
        gesture ||= newGesture();
        const refusal = around.run({ ...setCommand(field, around, input.value), gesture }, final);
        if (refusal) complaint.show(input, around.words.refusal(refusal));
        else complaint.clear(input);
        if (final) gesture = '';
    };
    const input = el('input', {
        attributes: { type: 'color', disabled: around.readOnly },
        on: { input: () => run(false), change: () => run(true) },
    });
    return {
        element: row(field, around, input, [input], complaint),
        update: (/** @type {FieldDescription} */ now) => { input.value = now.value; },
    };
}

/**
 * A short list of numbers with a name each, such as a point or an interval.
 * @param {FieldDescription} field
 * @param {Surroundings} around
 * @param {string[]} names
 */
function makeParts(field, around, names) {
    const complaint = new Complaint();
    /** @type {number[]} */
    let value = field.value ?? [];
    const inputs = value.map((_, part) => {
        const label = `${around.words.label(field.label)}, ${around.words.text(`field.${names[part]}`)}`;
        return numberInput(around, complaint, { label, step: 0.1 }, (number) =>
            setCommand(field, around, value.map((old, k) => (k === part ? number : old))));
    });
    const name = el('span', { class: 'name', text: around.words.label(field.label) });
    return {
        element: el('div', { class: 'field', attributes: { 'data-path': field.path } }, name,
            el('div', { class: 'controls' }, ...inputs.map((input) => input.element)), complaint.element),
        update: (/** @type {FieldDescription} */ now) => {
            value = now.value ?? [];
            inputs.forEach((input, part) => input.show(value[part] ?? 0));
        },
    };
}
