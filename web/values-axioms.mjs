// The axioms of a B-function as a live checklist, a formula to try them on, and a second B-function
// to compare with: the picture shows both curves and both functions, here are the axioms of both.

import { el, icon, setText, uniqueId } from './dom.mjs';
import { icons } from './icons.mjs';
import { Complaint } from './values-fields.mjs';
import { comparedOf, graphsOf } from './values-graphs.mjs';

/** @typedef {import('./values-fields.mjs').Surroundings} Surroundings */
/** @typedef {{ axiom: string, holds: boolean, t?: number | null, found?: number | null }} Verdict */

export class AxiomsSection {
    #spec = '';
    #graphed = '';
    /** @type {string[]} */
    #panes = [];
    /** As the canonical document has it. @type {any} */
    #object = null;

    /**
     * @param {Surroundings} around
     * @param {any} kw
     */
    constructor(around, kw) {
        this.around = around;
        this.kw = kw;
        const { words } = around;
        this.count = el('span', { class: 'count' });
        this.own = el('div');
        this.tried = new TriedFormula(around, kw);
        this.complaint = new Complaint();
        const summary = el('summary', {}, el('h3', { text: words.text('axioms') }), this.count);
        this.details = el('details', {
            class: 'list axioms', attributes: { open: around.type === 'b-function' }, on: { toggle: () => this.#show() },
        }, summary, this.own, this.tried.element);
        this.graphs = el('div');
        const comparing = around.readOnly || around.type === 'b-function' ? null : this.#makeComparing();
        this.element = el('div', {}, this.details, comparing, this.complaint.element, this.graphs);
    }

    /**
     * @param {any} object as the canonical document has it
     * @param {any} document that it stands in
     */
    update(object, document) {
        this.#object = object;
        this.#panes = document.view.panes;
        if (object.type !== 'b-function') this.#showGraphs(document.objects);
        const spec = JSON.stringify(object.bFunction);
        if (spec === this.#spec) return;
        this.#spec = spec;
        this.complaint.clear(this.details);
        this.#show();
    }

    /** A folded list shows only how many hold. */
    #show() {
        if (!this.#object) return;  // its object is folded and has told nothing yet
        const functions = [this.#object.bFunction].flat();
        const verdicts = functions.map((spec) => this.kw.axioms(spec));
        const all = verdicts.flat();
        const held = all.filter(({ holds }) => holds).length;
        setText(this.count, this.around.words.text('axioms.held', { held, of: all.length }));
        if (!this.details.open) return;
        const lists = verdicts.map((list, k) => checklist(this.around.words, list, verdicts.length > 1 ? 'uv'[k] : ''));
        this.own.replaceChildren(...lists);
    }

    /** @param {any[]} objects */
    #showGraphs(objects) {
        const shown = JSON.stringify(objects.map(({ id, bFunction, style }) => [id, bFunction, style?.colour, style?.dashed]));
        if (shown === this.#graphed) return;
        this.#graphed = shown;
        const { words } = this.around;
        const graphs = graphsOf(words, this.kw, objects);
        this.graphs.replaceChildren(...(graphs ? [graphs, axiomTable(words, this.kw, comparedOf(objects))] : []));
    }

    #makeComparing() {
        const { words } = this.around;
        const families = this.kw.bFunctions.filter(
            (/** @type {any} */ { family, operands }) => operands.length === 0 && !['formula', 'tabulated'].includes(family));
        const select = el('select', { attributes: { id: uniqueId('compare') } },
            ...families.map((/** @type {any} */ { family, label }) => el('option', { text: words.label(label), attributes: { value: family } })));
        const button = el('button', {
            class: 'quiet-button', text: words.text('compare.do'), attributes: { type: 'button' },
            on: { click: () => this.#compare(select.value, button) },
        });
        return el('div', { class: 'adding' },
            el('label', { text: words.text('compare.with'), attributes: { for: select.id } }), select, button);
    }

    /** @param {string} family @param {HTMLElement} button */
    #compare(family, button) {
        const command = comparison(this.#object, this.around.address, this.#panes, { family });
        const refusal = this.around.run(command, true);
        if (refusal) this.complaint.show(button, this.around.words.refusal(refusal));
        else this.complaint.clear(button);
    }
}

/** Told apart by people who see few colours, too. */
const colours = ['#d55e00', '#0072b2', '#009e73', '#cc79a7'];

/**
 * What puts the same object under another B-function beside it, with an id of its own, and both
 * functions into the pane of B-functions.
 * @param {any} own object
 * @param {string} address of it
 * @param {string[]} panes
 * @param {any} bFunction
 */
function comparison(own, address, panes, bFunction) {
    const { id, ...object } = own;
    const colour = colours.find((other) => other !== object.style?.colour);
    const style = { ...object.style, colour, dashed: !object.style?.dashed };
    const all = [{ add: { ...object, bFunction, style, show: { ...object.show, bFunction: true } } }];
    if (!own.show.bFunction) all.push(/** @type {any} */ ({ set: `${address}.show.bFunction`, value: true }));
    if (!panes.includes('bFunction')) all.push(/** @type {any} */ ({ set: 'view.panes', value: [...panes, 'bFunction'] }));
    return all.length > 1 ? { all } : all[0];
}

/**
 * A column for each function, a row for each axiom.
 * @param {import('./words.mjs').Words} words
 * @param {any} kw
 * @param {any[]} objects that are compared
 */
function axiomTable(words, kw, objects) {
    /** @type {Verdict[][]} */
    const verdicts = objects.map(({ bFunction }) => kw.axioms(bFunction));
    const names = objects.map(({ id }) => el('th', { text: id, attributes: { scope: 'col' } }));
    const rows = verdicts[0].map(({ axiom }, k) => el('tr', {},
        el('th', { attributes: { scope: 'row' } }, el('b', { text: axiom }), ` ${words.text(`axiom.${axiom}`)}`),
        ...verdicts.map((list) => el('td', {}, verdictMark(words, list[k].holds)))));
    return el('table', { class: 'axiom-table', attributes: { 'aria-label': words.text('axioms.compared') } },
        el('thead', {}, el('tr', {}, el('td'), ...names)), el('tbody', {}, ...rows));
}

/** A mark that does not rely on colour. @param {import('./words.mjs').Words} words @param {boolean} holds */
function verdictMark(words, holds) {
    return el('span', { class: 'mark', attributes: { 'data-holds': String(holds) } },
        icon(holds ? icons.holds : icons.remove), el('span', { class: 'aside', text: words.text(holds ? 'axioms.holds' : 'axioms.fails') }));
}

/**
 * Each axiom with a mark that does not rely on colour, and where it fails, the place and the number.
 * @param {import('./words.mjs').Words} words
 * @param {Verdict[]} verdicts
 * @param {string} name '' where there is but one function
 */
function checklist(words, verdicts, name) {
    const items = verdicts.map((verdict) => {
        const { axiom, holds } = verdict;
        const detail = holds ? '' : breach(words, verdict);
        return el('li', {}, verdictMark(words, holds), el('b', { text: axiom }),
            el('span', { text: words.text(`axiom.${axiom}`) }), detail ? el('span', { class: 'breach', text: detail }) : null);
    });
    const label = name ? `${words.text('axioms')}, ${name}` : words.text('axioms');
    return el('ul', { class: 'checklist', attributes: { 'aria-label': label } }, ...items);
}

/** @param {import('./words.mjs').Words} words @param {Verdict} verdict */
function breach(words, { axiom, t, found }) {
    if (typeof t !== 'number' || typeof found !== 'number') return '';
    const place = words.number(Number(t.toPrecision(4)));
    const value = words.number(Number(found.toPrecision(4)));
    if (axiom === 'D5') return `B(${place}) + B(1 − ${place}) = ${value}`;
    const slope = found < 0 && ['D1', 'D4'].includes(axiom);
    return `${slope ? 'B′' : 'B'}(${place}) = ${value}`;
}

/** A formula that is tried without being put into the scene. */
class TriedFormula {
    /** @param {Surroundings} around @param {any} kw */
    constructor(around, kw) {
        this.around = around;
        this.kw = kw;
        const { words } = around;
        this.complaint = new Complaint();
        this.verdicts = el('div', { attributes: { role: 'status' } });
        this.input = el('input', {
            attributes: { id: uniqueId('try'), type: 'text', autocomplete: 'off', spellcheck: 'false', placeholder: 'sin(pi*t)^2' },
            on: { input: () => this.#check() },
        });
        const use = around.readOnly ? null : el('button', {
            class: 'quiet-button', text: words.text('axioms.use'), attributes: { type: 'button' }, on: { click: () => this.#use() },
        });
        this.element = el('div', {}, el('div', { class: 'adding trying' },
            el('label', { text: words.text('axioms.try'), attributes: { for: this.input.id } }), this.input, use),
        this.complaint.element, this.verdicts);
    }

    get #spec() {
        return { family: 'formula', expression: this.input.value };
    }

    #check() {
        this.verdicts.replaceChildren();
        this.complaint.clear(this.input);
        if (this.input.value.trim() === '') return;
        try {
            this.verdicts.append(checklist(this.around.words, this.kw.axioms(this.#spec), this.input.value));
        } catch (error) {
            this.#refuse(error);
        }
    }

    #use() {
        const refusal = this.around.run({ set: `${this.around.address}.bFunction`, value: this.#spec }, true);
        if (refusal) this.#refuse(refusal);
        else this.complaint.clear(this.input);
    }

    /** The formula again, cut where it goes wrong. @param {any} error */
    #refuse(error) {
        this.complaint.show(this.input, this.around.words.refusal(error));
        const column = Number(/column (\d+)/.exec(error.message ?? '')?.[1] ?? 0);
        if (column === 0) return;
        const text = this.input.value;
        const mark = el('mark', { text: text.slice(column - 1) || '␣' });
        this.complaint.element.append(el('code', { class: 'pointed' }, text.slice(0, column - 1), mark));
    }
}
