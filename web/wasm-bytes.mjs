// Where the bytes of the module come from.

import { describe, KnotworkError } from './errors.mjs';

const inNode = typeof process === 'object' && Boolean(process.versions?.node);
const withScheme = /^[a-z][a-z0-9+.-]+:/i;

/**
 * @param {unknown} given bytes, URL, path, or nothing for the default
 * @param {() => URL} usual
 * @returns {Promise<Uint8Array<ArrayBuffer>>}
 */
export async function wasmBytes(given, usual) {
    if (given === undefined) return read(usual());
    if (given instanceof ArrayBuffer) return new Uint8Array(given);
    if (ArrayBuffer.isView(given)) {
        // A copy, since the memory may be shared and browsers compile only what cannot change.
        return new Uint8Array(given.buffer, given.byteOffset, given.byteLength).slice();
    }
    if (given instanceof URL) return read(given);
    if (typeof given === 'string' && given !== '') return read(inNode ? nodeAddress(given) : given);
    throw new KnotworkError('WRONG_TYPE', 'wasm',
        `wasm is ${describe(given)}; give the bytes of the module, its URL or its path.`);
}

/** In Node a string without a scheme is a path. @param {string} text */
function nodeAddress(text) {
    return withScheme.test(text) ? new URL(text) : text;
}

/** @param {URL | string} address */
async function read(address) {
    try {
        const local = inNode && (typeof address === 'string' || address.protocol === 'file:');
        return await (local ? readFile(address) : fetchBytes(address));
    } catch (problem) {
        throw new KnotworkError('UNKNOWN_NAME', 'wasm',
            `The module at ${address} cannot be read: ${/** @type {Error} */ (problem).message}.`);
    }
}

/** @param {URL | string} address */
async function readFile(address) {
    const files = await import(/* webpackIgnore: true */ /* @vite-ignore */ 'node:fs/promises');
    return new Uint8Array(await files.readFile(address));
}

/** @param {URL | string} address */
async function fetchBytes(address) {
    const response = await fetch(address);
    if (!response.ok) throw new Error(`the answer is ${response.status}`);
    return new Uint8Array(await response.arrayBuffer());
}
