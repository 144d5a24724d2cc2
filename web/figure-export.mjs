// What a figure can be saved as.

import { integer, isPlain, options as optionsOf } from './check.mjs';
import { KnotworkError } from './errors.mjs';

/** @typedef {{ scene: any, view: import('./figure-view.mjs').FigureView, theme: string }} Shown */

/** Pixels across of a PNG; some browsers have no larger canvas. */
const widest = 8192;

/** What the scene itself is written as. @type {Record<string, string>} */
const types = {
    svg: 'image/svg+xml', json: 'application/json', js: 'text/javascript', csv: 'text/csv',
    obj: 'model/obj', stl: 'model/stl', gltf: 'model/gltf+json', glb: 'model/gltf-binary',
};

/**
 * @param {Shown} figure
 * @param {string} format
 * @param {unknown} [options] as scene.exportAs() takes them; a picture has the size and the theme of
 * the figure unless they say otherwise; a PNG takes `width` and `height` in pixels
 * @returns {Promise<Blob>}
 */
export async function exportFigure(figure, format, options) {
    if (format === 'png') return picture(figure.view, options);
    if (!Object.hasOwn(types, format)) {
        const known = ['png', ...Object.keys(types)].join(', ');
        throw new KnotworkError('NOT_SUPPORTED', 'format', `"${format}" cannot be exported; ${known} can.`);
    }
    const chosen = format === 'svg' && (options === undefined || isPlainObject(options))
        ? { ...asShown(figure), ...options } : options;
    return new Blob([figure.scene.exportAs(format, chosen)], { type: types[format] });
}

/** @param {unknown} value @returns {value is object} */
const isPlainObject = (value) => typeof value === 'object' && value !== null && isPlain(value);

/** @param {Shown} figure */
function asShown({ view, theme }) {
    const { clientWidth: width, clientHeight: height } = view.canvas;
    return width > 0 && height > 0 ? { width, height, theme } : { theme };
}

/**
 * @param {import('./figure-view.mjs').FigureView} view
 * @param {unknown} given
 * @returns {Promise<Blob>}
 */
function picture(view, given) {
    const { width, height } = optionsOf(given, ['width', 'height']);
    const pixels = (/** @type {unknown} */ size, /** @type {string} */ name) =>
        (size === undefined ? undefined : integer(size, name, 1, widest));
    const canvas = view.shot(pixels(width, 'width'), pixels(height, 'height'));
    return new Promise((resolve, reject) => {
        const failed = () => new KnotworkError('OUT_OF_MEMORY', 'format', 'The picture could not be made into a PNG.');
        canvas.toBlob((blob) => (blob ? resolve(blob) : reject(failed())), 'image/png');
    });
}
