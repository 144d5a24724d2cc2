// Knotwork without a picture: load() gives the geometry core to Node, browsers and bundlers.

import createModule from 'knotwork-glue';

import { makeApi } from './api.mjs';
import { options } from './check.mjs';
import { KnotworkError } from './errors.mjs';
import { wasmBytes } from './wasm-bytes.mjs';

export { KnotworkError };

/** The module says nothing on its own; what it has to say is in the errors. */
const silent = () => {};

/** @param {{ wasm?: unknown }} [given] bytes, URL or path of the module instead of the default */
export async function load(given) {
    const { wasm } = options(given, ['wasm']);
    const wasmBinary = await wasmBytes(wasm, () => new URL('./knotwork.wasm', import.meta.url));
    return makeApi(await start(wasmBinary));
}

/** @param {Uint8Array<ArrayBuffer>} wasmBinary */
async function start(wasmBinary) {
    if (!WebAssembly.validate(wasmBinary)) {
        throw new KnotworkError('SYNTAX', 'wasm',
            'These bytes are not a WebAssembly module that runs here (fixed-width SIMD is needed).');
    }
    try {
        return await createModule({ wasmBinary, print: silent, printErr: silent });
    } catch {
        throw new KnotworkError('SYNTAX', 'wasm', 'This WebAssembly module is not the one that belongs here.');
    }
}
