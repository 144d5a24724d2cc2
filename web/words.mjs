// Words and numbers in the reader's language.

import en from './locales/en.json' with { type: 'json' };
import nb from './locales/nb.json' with { type: 'json' };

/** @type {Record<string, Record<string, any>>} */
const tables = { en, nb };

export const languages = ['en', 'nb'];

/**
 * The language of ours that serves a BCP 47 tag best.
 * @param {string | null | undefined} tag
 */
export function languageFor(tag) {
    const primary = (tag ?? '').toLowerCase().split('-')[0];
    return ['nb', 'no', 'nn'].includes(primary) ? 'nb' : 'en';
}

/** @type {Record<string, string>} */
const superscripts = {
    '-': '⁻', 0: '⁰', 1: '¹', 2: '²', 3: '³', 4: '⁴', 5: '⁵', 6: '⁶', 7: '⁷', 8: '⁸', 9: '⁹',
};

export class Words {
    /** @param {string} language */
    constructor(language) {
        this.language = languages.includes(language) ? language : 'en';
        this.reading = new Intl.NumberFormat(this.language, { maximumSignificantDigits: 6, useGrouping: false });
    }

    /**
     * The sentence `key` with its `{names}` filled in; `count` chooses between `key.one` and
     * `key.other`.
     * @param {string} key
     * @param {Record<string, string | number>} [values]
     */
    text(key, values = {}) {
        const plural = `${key}.${values.count === 1 ? 'one' : 'other'}`;
        const sentence = this.#find(key) ?? this.#find(plural) ?? key;
        return sentence.replace(/\{(\w+)\}/g, (_, name) => this.#insert(values[name]));
    }

    /**
     * The translation of a label that the core gives in English, such as the name of a field or group.
     * @param {string} english
     */
    label(english) {
        return english.split(' · ').map((part) => this.#labelPart(part)).join(' · ');
    }

    /**
     * "Local curves 3" is a label with a number behind it.
     * @param {string} part
     */
    #labelPart(part) {
        const { labels } = tables[this.language];
        const [, name, number] = /^(.*?)( \d+)?$/.exec(part) ?? [];
        return labels[part] ?? (labels[name] ?? name) + (number ?? '');
    }

    /**
     * Title or description of a built-in scene; a document of the reader's own keeps its words.
     * @param {string} id
     * @param {'title' | 'description'} part
     * @param {string} english
     */
    scene(id, part, english) {
        return tables[this.language].scenes[id]?.[part] ?? english;
    }

    /**
     * What to say about a refusal: the core's sentence, led in by one in the reader's language.
     * @param {{ code?: string, message?: string }} error
     */
    refusal(error) {
        const lead = tables[this.language].refusals[error.code ?? ''];
        const message = error.message ?? '';
        return lead ? `${lead} (${message})` : message;
    }

    /**
     * A number to be read, six digits.
     * @param {number} value
     */
    number(value) {
        if (value === Infinity) return '∞';
        const size = Math.abs(value);
        if (size < 5e-13) return this.reading.format(0);
        if (size < 1e-4 || size >= 1e7) return `${value < 0 ? '−' : ''}${this.scientific(size)}`;
        return this.reading.format(value).replace('-', '−');
    }

    /**
     * A small number by its power of ten: 2.2·10⁻¹⁶.
     * @param {number} value
     */
    scientific(value) {
        const [digits, exponent] = value.toExponential(1).split('e');
        const raised = [...String(Number(exponent))].map((sign) => superscripts[sign]).join('');
        return `${this.#decimal(digits)}·10${raised}`;
    }

    /**
     * A number to be edited: every digit that it has, but for the last two of a sum that has been
     * rounded, so that 2.1 − 3 reads as −0.9.
     * @param {number} value
     */
    editable(value) {
        const short = Number(value.toPrecision(14));
        const same = Math.abs(short - value) <= 2 * Number.EPSILON * Math.abs(value);
        return this.#decimal(String(same ? short : value));
    }

    /**
     * What was typed, with decimal point or comma; NaN when it is no number.
     * @param {string} text
     */
    parse(text) {
        const plain = text.trim().replace(/[−–]/g, '-');
        const separators = plain.match(/[.,]/g) ?? [];
        if (separators.length > 1) return NaN;
        const dotted = plain.replace(',', '.');
        return /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(dotted) ? Number(dotted) : NaN;
    }

    /** What the picture itself says, and its panel. */
    picture() {
        return {
            order: this.text('picture.order', { 0: '{0}', 1: '{1}' }),
            decimalPoint: this.#decimal('.'),
            undo: this.text('undo'),
            redo: this.text('redo'),
            add: this.text('picture.add'),
            remove: this.text('picture.remove'),
            local: this.label('Local curve'),
        };
    }

    /** @param {string} text */
    #decimal(text) {
        return this.language === 'nb' ? text.replace('.', ',') : text;
    }

    /** @param {string} key */
    #find(key) {
        const found = tables[this.language].words[key] ?? tables.en.words[key];
        return typeof found === 'string' ? found : undefined;
    }

    /** @param {string | number | undefined} value */
    #insert(value) {
        if (value === undefined) return '';
        return typeof value === 'number' ? this.number(value) : value;
    }
}
