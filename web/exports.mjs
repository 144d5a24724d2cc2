// Scenes as files for other programs.

import { choice, finite, options } from './check.mjs';
import { Held } from './held.mjs';

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
    core.ask('sceneExport', handle, exportFormats.indexOf(name), core.send(optionsOf(name, given)));
    const bytes = core.bytes(core.number(0), core.number(1));
    core.call('dropExport');
    return binary.includes(name) ? bytes : utf8.decode(bytes);
}

/** @param {string} format @param {unknown} given */
const optionsOf = (format, given) => options(given, format === 'svg' ? pictureOptions : geometryOptions);

/** An export that is written in slices, of the scene as it was when it began. */
export class Exporting extends Held {
    /**
     * Goes on by about so many numbers that are written as text.
     * @param {number} [numbers]
     */
    advance(numbers = 8000) {
        const { core, handle } = Held.of(this);
        core.ask('exportAdvance', handle, finite(numbers, 'numbers'));
        return { more: core.number(0) === 1, fraction: core.number(1), bytes: core.bytes(core.number(2), core.number(3)) };
    }
}

/**
 * @param {Core} core
 * @param {number} handle of a scene
 * @param {unknown} format
 * @param {unknown} given
 */
export function beginExport(core, handle, format, given) {
    const name = choice(format, 'format', exportFormats);
    const fields = optionsOf(name, given);
    return new Exporting(core, core.ask('sceneExporting', handle, exportFormats.indexOf(name), core.send(fields)));
}
