// Fetches the module that computes and draws, once per page.

import createModule from 'knotwork-page-glue';

import { makeApi } from './api.mjs';

/**
 * The application of the page's module, as src/app/app.hpp describes it.
 * @typedef {object} App
 * @property {() => string} start
 * @property {() => void} contextLost
 * @property {() => string} contextRestored
 * @property {() => number} addView
 * @property {(id: number) => void} removeView
 * @property {(id: number, width: number, height: number, pixelRatio: number) => void} resize
 * @property {(id: number, scene: number) => void} attach
 * @property {(id: number, theme: string) => void} setTheme
 * @property {(id: number, shown: boolean) => void} setPanel
 * @property {(id: number, json: string) => void} setWords
 * @property {(id: number, readOnly: boolean) => void} setReadOnly
 * @property {(id: number, reduced: boolean) => void} setReducedMotion
 * @property {(id: number) => void} focus
 * @property {(id: number) => void} fit
 * @property {(id: number, kind: string, x: number, y: number, buttons: number, modifiers: number,
 *     type: string) => boolean} pointer
 * @property {(id: number, x: number, y: number, dx: number, dy: number, factor: number) => boolean} pinch
 * @property {(id: number, x: number, y: number, dx: number, dy: number, modifiers: number) => boolean} wheel
 * @property {(id: number, key: string, down: boolean, modifiers: number) => boolean} key
 * @property {(id: number, text: string) => void} text
 * @property {(id: number, x: number, y: number, type: string) => boolean} hits
 * @property {(id: number) => string} cursor
 * @property {(id: number) => boolean} spatial
 * @property {(id: number, playing: boolean) => void} setPlaying
 * @property {(id: number) => boolean} playing
 * @property {(id: number, phase: number) => void} setPhase
 * @property {(id: number) => number} phase
 * @property {(id: number) => number} period
 * @property {(id: number, seconds: number) => void} tick
 * @property {(id: number) => boolean} needsFrame
 * @property {(id: number) => void} render
 * @property {(id: number) => string} labels
 * @property {(id: number) => string} takeEvents
 * @property {(id: number) => string} selection
 * @property {(id: number, path: string) => void} select
 * @property {(id: number) => boolean} selectAll
 * @property {(id: number, gathering: boolean) => void} setGathering
 * @property {(id: number) => string} held
 * @property {(id: number, step: number) => void} setStep
 * @property {(id: number, dx: number, dy: number, dz: number) => boolean} shift
 * @property {(id: number, x: number, y: number, how: string) => boolean} place
 * @property {(id: number) => string} panes
 * @property {(id: number, name: string, share: number) => boolean} moveSeam
 * @property {() => string} stats
 * @property {() => void} delete
 */

/**
 * @typedef {object} PageModule
 * @property {new (session: any) => App} App
 * @property {{ registerContext: (context: any, attributes: object) => number,
 *     makeContextCurrent: (handle: number) => boolean }} GL
 */

/** @returns {Promise<{ module: PageModule, kw: any }>} */
export async function loadPageModule() {
    const wasmBinary = embeddedBytes() ?? fetchBytes(new URL('./knotwork-page.wasm', import.meta.url));
    const module = await createModule({ wasmBinary: await wasmBinary });
    return { module, kw: makeApi(module) };
}

/** @param {URL} url */
async function fetchBytes(url) {
    const response = await fetch(url);
    if (!response.ok) throw new Error(`${url} answered ${response.status}`);
    return response.arrayBuffer();
}

/** The module as the one-file page carries it: gzip in base64, inside a script that is no script. */
function embeddedBytes() {
    const text = document.getElementById('knotwork-wasm')?.textContent;
    if (!text) return undefined;
    const bytes = Uint8Array.from(atob(text.trim()), (letter) => letter.charCodeAt(0));
    const plain = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
    return new Response(plain).arrayBuffer();
}
