// Scenes as files for other programs.

import { choice, options } from './check.mjs';

/** @typedef {import('./core.mjs').Core} Core */

/** In the order of the core's formats. */
export const exportFormats = /** @type {const} */ (['svg', 'json', 'js', 'csv', 'obj', 'stl', 'gltf', 'glb']);

const binary = ['stl', 'glb'];
const moments = ['phase', 'time'];
const pictureOptions = [...moments, 'width', 'height', 'theme', 'title', 'description', 'background', 'panes'];
const geometryOptions = [...moments, 'tolerance'];

const utf8 = new TextDecoder();

/**
 * @param {Core} core
 * @param {number} handle of a scene
 * @param {unknown} format
 * @param {unknown} given
 * @returns {string | Uint8Array}
 */
export function exportScene(core, handle, format, given) {
    const name = choice(format, 'format', exportFormats);
    const fields = options(given, name === 'svg' ? pictureOptions : geometryOptions);
    core.ask('sceneExport', handle, exportFormats.indexOf(name), core.send(fields));
    const bytes = core.bytes(core.number(0), core.number(1));
    core.call('dropExport');
    return binary.includes(name) ? bytes : utf8.decode(bytes);
}
