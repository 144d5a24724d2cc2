// What a figure can be saved as.

import { isPlain } from './check.mjs';
import { KnotworkError } from './errors.mjs';

/** @typedef {{ scene: any, canvas: HTMLCanvasElement, theme: string }} Shown */

/** What the scene itself is written as. @type {Record<string, string>} */
const types = {
    svg: 'image/svg+xml', json: 'application/json', js: 'text/javascript', csv: 'text/csv',
    obj: 'model/obj', stl: 'model/stl', gltf: 'model/gltf+json', glb: 'model/gltf-binary',
};

/**
 * @param {Shown} figure
 * @param {string} format
 * @param {unknown} [options] as scene.exportAs() takes them; a picture has the size and the theme of
 * the figure unless they say otherwise
 * @returns {Promise<Blob>}
 */
export async function exportFigure(figure, format, options) {
    if (format === 'png') return picture(figure.canvas);
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
function asShown({ canvas, theme }) {
    const { clientWidth: width, clientHeight: height } = canvas;
    return width > 0 && height > 0 ? { width, height, theme } : { theme };
}

/** @param {HTMLCanvasElement} canvas @returns {Promise<Blob>} */
function picture(canvas) {
    return new Promise((resolve, reject) => {
        const failed = () => new KnotworkError('OUT_OF_MEMORY', 'format', 'The picture could not be made into a PNG.');
        canvas.toBlob((blob) => (blob ? resolve(blob) : reject(failed())), 'image/png');
    });
}
