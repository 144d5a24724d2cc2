// The dialog in which what is shown is saved as a file.

import { openDialog } from './dialog.mjs';
import { el, setAttributes, setText, uniqueId } from './dom.mjs';
import { Progress } from './progress.mjs';

/** @typedef {import('./words.mjs').Words} Words */
/** @typedef {import('./element-class.mjs').KnotworkFigure} KnotworkFigure */

/** What can be saved; bodies are surfaces and meshes. @type {{ format: string, bodies?: boolean }[]} */
const files = [
    { format: 'svg' }, { format: 'png' }, { format: 'json' }, { format: 'csv' },
    { format: 'obj', bodies: true }, { format: 'stl', bodies: true }, { format: 'gltf', bodies: true },
];

/** Pixels across of a picture; beyond the largest some browsers have no canvas. */
const widths = { least: 16, usual: 1920, most: 8192 };

/**
 * @param {Words} words
 * @param {KnotworkFigure} figure
 */
export function openExport(words, figure) {
    const told = el('p', { class: 'told', attributes: { role: 'status' } });
    const hasBodies = figure.value.objects.some((/** @type {{ type: string }} */ { type }) => /surface|triangle/.test(type));
    const width = widthField(words);
    const options = (/** @type {string} */ format) => ({
        ...(['svg', 'csv', 'obj', 'stl', 'gltf'].includes(format) ? { phase: figure.phase } : {}),
        ...(format === 'png' ? { width: width.value() } : {}),
    });
    const writer = new FileWriter(words, told);
    const rows = files.filter(({ bodies }) => hasBodies || !bodies).map(({ format }) => row(words, format,
        () => writer.write(fileName(figure, format), async (name, watch) =>
            save(words, await figure.exportAs(format, options(format), watch), name)),
        format === 'png' ? width.element : null));
    const copy = row(words, 'js', () => writer.write(fileName(figure, 'mjs'), (name, watch) =>
        copyCode(words, figure, name, watch)), null);
    const dialog = openDialog(words, words.text('page.export'), 'export',
        el('ul', { class: 'formats' }, ...rows, copy), told, writer.progress.element);
    writer.follow(dialog);
    return dialog;
}

/** Writes one file at a time, with a bar in place of the sentence that says how it went. */
class FileWriter {
    progress = new Progress('button-plain', { shown: (name) => setText(this.told, this.words.text('work.begun', { name })) });
    /** @type {AbortController | undefined} */
    #busy;

    /** @param {Words} words @param {Element} told */
    constructor(words, told) {
        this.words = words;
        this.told = told;
    }

    /** While a file is written Escape ends that, and only then the dialog. @param {HTMLDialogElement} dialog */
    follow(dialog) {
        this.dialog = dialog;
        dialog.addEventListener('cancel', (event) => {
            if (!this.#busy) return;
            event.preventDefault();
            this.#busy.abort();
        });
        dialog.addEventListener('close', () => this.#busy?.abort());
    }

    /**
     * @param {string} file its name
     * @param {(file: string, watch: import('./slices.mjs').Watch) => Promise<string>} work
     */
    async write(file, work) {
        if (this.#busy) return;
        const { words, progress } = this;
        const name = words.text('work.file', { name: file });
        const busy = this.#busy = new AbortController();
        setText(this.told, '');
        progress.begin(words, name, () => busy.abort());
        this.#show(true);
        const watch = { signal: busy.signal, progress: (/** @type {number} */ done) => progress.advance(done) };
        const failed = (/** @type {any} */ error) =>
            (busy.signal.aborted ? words.text('work.cancelled') : words.refusal(error));
        const said = await work(file, watch).catch(failed);
        this.#busy = undefined;
        progress.end();
        this.#show(false);
        setText(this.told, said);
    }

    /** @param {boolean} busy whether no other file may be begun */
    #show(busy) {
        for (const button of this.dialog?.querySelectorAll('.format button') ?? []) {
            setAttributes(button, { 'aria-disabled': busy ? 'true' : null });
        }
    }
}

/**
 * @param {Words} words
 * @param {string} format
 * @param {() => void} act
 * @param {HTMLElement | null} more
 */
function row(words, format, act, more) {
    const id = uniqueId('format');
    const name = words.text(`export.${format}`);
    const button = el('button', {
        class: 'button-plain', text: words.text(format === 'js' ? 'export.copy' : 'export.save'),
        attributes: { type: 'button', 'aria-describedby': id, 'aria-label': words.text(format === 'js' ? 'export.copy.label' : 'export.save.label', { name }) },
        on: { click: act },
    });
    return el('li', { class: 'format' }, el('div', {}, el('strong', { text: name }),
        el('span', { class: 'quiet', text: words.text(`export.${format}.about`), attributes: { id } }), more), button);
}

/** @param {Words} words */
function widthField(words) {
    const input = el('input', {
        attributes: { type: 'number', min: widths.least, max: widths.most, step: 1, value: widths.usual, inputmode: 'numeric' },
    });
    const element = el('label', { class: 'width-field' }, `${words.text('export.width')} `, input);
    return {
        element,
        value: () => Math.min(widths.most, Math.max(widths.least, Math.round(input.valueAsNumber || widths.usual))),
    };
}

/** @param {Words} words @param {Blob} blob @param {string} name */
function save(words, blob, name) {
    const address = URL.createObjectURL(blob);
    el('a', { attributes: { href: address, download: name } }).click();
    setTimeout(() => URL.revokeObjectURL(address), 60_000);  // some browsers fetch it late
    return words.text('export.saved', { name });
}

/**
 * @param {Words} words
 * @param {KnotworkFigure} figure
 * @param {string} name of a file, where nothing can be copied
 * @param {import('./slices.mjs').Watch} watch
 */
async function copyCode(words, figure, name, watch) {
    const code = await (await figure.exportAs('js', undefined, watch)).text();
    const copied = await navigator.clipboard?.writeText(code).then(() => true, () => false);
    if (copied) return words.text('export.copied');
    return save(words, new Blob([code], { type: 'text/javascript' }), name);
}

/** @param {KnotworkFigure} figure @param {string} extension */
function fileName(figure, extension) {
    const plain = (figure.value.title ?? '').normalize('NFKD').toLowerCase().replace(/[^a-z0-9]+/g, '-').replace(/^-|-$/g, '');
    return `${plain || 'knotwork'}.${extension}`;
}
