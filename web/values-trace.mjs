// The choice of an algorithm that is shown step by step on an object.

import { el, uniqueId } from './dom.mjs';
import { algorithmsFor } from './traces.mjs';
import { Complaint } from './values-fields.mjs';

export class TraceChoice {
    #offered = '';

    /** @param {import('./values-fields.mjs').Surroundings} around */
    constructor(around) {
        this.around = around;
        this.complaint = new Complaint();
        this.select = el('select', {
            attributes: { id: uniqueId('trace'), disabled: around.readOnly }, on: { change: () => this.#choose() },
        });
        const label = el('label', { text: around.words.text('trace.through'), attributes: { for: this.select.id } });
        this.element = el('div', { class: 'field' }, label, el('div', { class: 'controls' }, this.select), this.complaint.element);
    }

    /** @param {any} object as the canonical document has it */
    update(object) {
        const algorithms = algorithmsFor(object);
        this.element.hidden = algorithms.length === 0;
        if (String(algorithms) !== this.#offered) this.#offer(algorithms);
        this.select.value = object.trace?.algorithm ?? '';
    }

    /** @param {string[]} algorithms */
    #offer(algorithms) {
        const { words } = this.around;
        this.#offered = String(algorithms);
        this.select.replaceChildren(...['', ...algorithms].map((value) => el('option', {
            text: words.text(value === '' ? 'trace.none' : `trace.${value}`), attributes: { value },
        })));
    }

    #choose() {
        const path = `${this.around.address}.trace`;
        const { value } = this.select;
        const command = value === '' ? { remove: path } : { set: path, value: { algorithm: value } };
        const refusal = this.around.run(command, true);
        if (refusal) this.complaint.show(this.select, this.around.words.refusal(refusal));
        else this.complaint.clear(this.select);
    }
}
