// What a figure can be saved as.

import { KnotworkError } from './errors.mjs';

/** @type {Record<string, (figure: { scene: any, canvas: HTMLCanvasElement }) => Promise<Blob>>} */
const formats = {
    json: async ({ scene }) =>
        new Blob([`${JSON.stringify(scene.document, null, 2)}\n`], { type: 'application/json' }),
    png: ({ canvas }) => new Promise((resolve, reject) => {
        const failed = () => new KnotworkError('OUT_OF_MEMORY', 'format', 'The picture could not be made into a PNG.');
        canvas.toBlob((blob) => (blob ? resolve(blob) : reject(failed())), 'image/png');
    }),
};

/**
 * @param {{ scene: any, canvas: HTMLCanvasElement }} figure
 * @param {string} format
 * @returns {Promise<Blob>}
 */
export async function exportFigure(figure, format) {
    if (Object.hasOwn(formats, format)) return formats[format](figure);
    const known = Object.keys(formats).join(' and ');
    throw new KnotworkError('NOT_SUPPORTED', 'format', `"${format}" cannot be exported; ${known} can.`);
}
