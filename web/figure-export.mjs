// What a figure can be saved as.

import { integer, isPlain, options as optionsOf } from './check.mjs';
import { KnotworkError } from './errors.mjs';
import { inSlices } from './slices.mjs';

/** @typedef {{ scene: any, view: import('./figure-view.mjs').FigureView, theme: string }} Shown */

/** Bytes that are handed to the browser at once; what it has got need not stay in the page's memory. */
const atOnce = 2 ** 22;

/** Pixels across of a PNG; some browsers have no larger canvas. */
const widest = 8192;

/** Milliseconds after which one hears again that a picture is not ready yet. */
const beatEvery = 100;

/** What the scene itself is written as. @type {Record<string, string>} */
const types = {
    svg: 'image/svg+xml', json: 'application/json', js: 'text/javascript', csv: 'text/csv',
    obj: 'model/obj', stl: 'model/stl', gltf: 'model/gltf+json', glb: 'model/gltf-binary',
};

/**
 * Begins to write a file of what is shown now, and answers what goes on with it to its end. A refusal
 * is thrown at once where the options are wrong.
 * @param {Shown} figure
 * @param {string} format
 * @param {unknown} [options] as scene.exportAs() takes them; a picture has the size and the theme of
 * the figure unless they say otherwise; a PNG takes `width` and `height` in pixels
 * @returns {(watch: import('./slices.mjs').Watch) => Promise<Blob>}
 */
export function beginFile(figure, format, options) {
    if (format === 'png') return (watch) => picture(figure.view, options, watch);
    if (!Object.hasOwn(types, format)) {
        const known = ['png', ...Object.keys(types)].join(', ');
        throw new KnotworkError('NOT_SUPPORTED', 'format', `"${format}" cannot be exported; ${known} can.`);
    }
    const chosen = format === 'svg' && (options === undefined || isPlainObject(options))
        ? { ...asShown(figure), ...options } : options;
    const work = figure.scene.exporting(format, chosen);
    return (watch) => written(work, types[format], watch);
}

/**
 * @param {import('./exports.mjs').Exporting} work
 * @param {string} type
 * @param {import('./slices.mjs').Watch} watch
 */
async function written(work, type, watch) {
    /** @type {Blob[]} */
    const parts = [];
    /** @type {Uint8Array[]} */
    let waiting = [];
    let size = 0;
    const handOver = () => {
        parts.push(new Blob(/** @type {any[]} */ (waiting)));
        waiting = [];
        size = 0;
    };
    try {
        await inSlices(() => {
            const { more, fraction, bytes } = work.advance();
            waiting.push(bytes);
            size += bytes.length;
            if (size > atOnce || !more) handOver();
            return { more, fraction };
        }, watch);
        return new Blob(parts, { type });
    } finally {
        work.dispose();
    }
}

/** @param {unknown} value @returns {value is object} */
const isPlainObject = (value) => typeof value === 'object' && value !== null && isPlain(value);

/** @param {Shown} figure */
function asShown({ view, theme }) {
    const { clientWidth: width, clientHeight: height } = view.canvas;
    // Files have one theme of more contrast, on white as they are printed.
    const own = { theme: theme.startsWith('contrast') ? 'contrast' : theme };
    return width > 0 && height > 0 ? { width, height, ...own } : own;
}

/**
 * The browser paints and packs it by itself, and tells nothing before it has done.
 * @param {import('./figure-view.mjs').FigureView} view
 * @param {unknown} given
 * @param {import('./slices.mjs').Watch} watch
 * @returns {Promise<Blob>}
 */
async function picture(view, given, { signal, progress }) {
    const { width, height } = optionsOf(given, ['width', 'height']);
    const pixels = (/** @type {unknown} */ size, /** @type {string} */ name) =>
        (size === undefined ? undefined : integer(size, name, 1, widest));
    const canvas = view.shot(pixels(width, 'width'), pixels(height, 'height'));
    signal?.throwIfAborted();
    const beat = setInterval(() => progress?.(0), beatEvery);
    try {
        return await new Promise((resolve, reject) => {
            signal?.addEventListener('abort', () => reject(signal.reason), { once: true });
            const failed = () => new KnotworkError('OUT_OF_MEMORY', 'format', 'The picture could not be made into a PNG.');
            canvas.toBlob((blob) => (blob ? resolve(blob) : reject(failed())), 'image/png');
        });
    } finally {
        clearInterval(beat);
    }
}
