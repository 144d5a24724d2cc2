// The border to the wasm module: data in, numbers out, refusals as KnotworkError.

import { Encoder } from './cbor.mjs';
import { copyInto } from './check.mjs';
import { KnotworkError } from './errors.mjs';

const utf8 = new TextEncoder();

/** As many points as the session's block holds. */
export const blockPoints = 1024;

/**
 * What of an Emscripten module is used here.
 * @typedef {object} Module
 * @property {new () => Session} Session
 * @property {Uint8Array} HEAPU8
 * @property {Float64Array} HEAPF64
 */

/**
 * The session of src/bindings/session.hpp: functions over numbers and strings.
 * @typedef {Record<string, (...args: any[]) => any>} Session
 */

export class Core {
    #module;
    #encoder = new Encoder();
    #blockStart;
    #normalsStart;
    #parametersStart;
    #integersStart;
    #roomStart = 0;
    #roomSize = 0;
    #ended = false;
    /** @type {FinalizationRegistry<number> | undefined} */
    #registry;

    /** @param {Module} module */
    constructor(module) {
        this.#module = module;
        this.session = new module.Session();
        this.#blockStart = this.session.block() / 8;
        this.#normalsStart = this.session.normals() / 8;
        this.#parametersStart = this.session.parameters() / 8;
        this.#integersStart = this.session.integers();
        if (typeof FinalizationRegistry === 'function') {
            this.#registry = new FinalizationRegistry((handle) => this.release(handle));
        }
    }

    /**
     * Calls a function of the session. Whatever comes out of wasm as an exception is its end.
     * @param {string} name
     * @param {any[]} args
     * @returns {any}
     */
    call(name, ...args) {
        if (this.#ended) throw this.#outOfMemory();
        try {
            return this.session[name](...args);
        } catch {
            this.#ended = true;
            throw this.#outOfMemory();
        }
    }

    /**
     * Calls a function whose refusal is 0, false or ''.
     * @param {string} name
     * @param {any[]} args
     * @returns {any}
     */
    ask(name, ...args) {
        const answer = this.call(name, ...args);
        if (!answer) throw this.#refusal();
        return answer;
    }

    /**
     * The scene of the document that was sent; a refusal tells all that is wrong with it.
     * @param {number} size
     * @returns {number}
     */
    openScene(size) {
        const handle = this.call('openScene', size);
        if (handle) return handle;
        const { code, path, message } = this.#refusal();
        throw new KnotworkError(code, path, message, this.problems(size));
    }

    /**
     * The document that was sent with its defaults filled in.
     * @param {number} size
     * @returns {any}
     */
    canonicalDocument(size) {
        const handle = this.openScene(size);
        try {
            return this.json('sceneDocument', handle);
        } finally {
            this.release(handle);
        }
    }

    /**
     * What is wrong with the document that was sent.
     * @param {number} size
     * @returns {import('./errors.mjs').Problem[]}
     */
    problems(size) {
        return this.json('ask', 'validate', size).problems;
    }

    /**
     * Calls a function whose refusal is negative.
     * @param {string} name
     * @param {any[]} args
     * @returns {number}
     */
    count(name, ...args) {
        const answer = this.call(name, ...args);
        if (answer < 0) throw this.#refusal();
        return answer;
    }

    /**
     * Calls a function that answers with JSON.
     * @param {string} name
     * @param {any[]} args
     * @returns {any}
     */
    json(name, ...args) {
        return JSON.parse(this.ask(name, ...args));
    }

    /**
     * Puts plain data where the next call reads it, and answers how many bytes it takes.
     * @param {unknown} value
     * @returns {number}
     */
    send(value) {
        const encoder = this.#encoder.busy ? new Encoder() : this.#encoder;
        const size = encoder.encode(value);
        this.#makeRoom(size);
        encoder.write(this.#module.HEAPU8, this.#roomStart);
        return size;
    }

    /**
     * Puts numbers, as they are, where the next call reads them.
     * @param {Float64Array} numbers
     */
    sendNumbers(numbers) {
        this.#makeRoom(numbers.byteLength);
        copyInto(this.#module.HEAPF64, numbers, this.#roomStart / 8);
    }

    /** @param {number} bytes */
    #makeRoom(bytes) {
        if (bytes <= this.#roomSize) return;
        this.#roomStart = this.call('room', 2 * bytes);
        this.#roomSize = 2 * bytes;
    }

    /**
     * A number of the block.
     * @param {number} i
     */
    number(i) {
        return this.#module.HEAPF64[this.#blockStart + i];
    }

    /**
     * A point of the block.
     * @param {number} row
     * @returns {[number, number, number]}
     */
    point(row) {
        const at = this.#blockStart + 3 * row;
        const heap = this.#module.HEAPF64;
        return [heap[at], heap[at + 1], heap[at + 2]];
    }

    /**
     * The block's first numbers, as a view that lasts until the next call.
     * @param {number} from
     * @param {number} count
     */
    block(from, count) {
        const start = this.#blockStart + from;
        return this.#module.HEAPF64.subarray(start, start + count);
    }

    /**
     * The normals beside the points of the block, likewise.
     * @param {number} count
     */
    normals(count) {
        return this.#module.HEAPF64.subarray(this.#normalsStart, this.#normalsStart + count);
    }

    /**
     * The first integers of the last call, likewise.
     * @param {number} count
     */
    integers(count) {
        return new Int32Array(this.#module.HEAPU8.buffer, this.#integersStart, count);
    }

    /** @param {Float64Array} parameters at most 1024 */
    sendParameters(parameters) {
        copyInto(this.#module.HEAPF64, parameters, this.#parametersStart);
    }

    /**
     * The first numbers of the last list, copied.
     * @param {number} count
     * @returns {Float64Array}
     */
    bulk(count) {
        return this.copy(this.call('bulk'), count);
    }

    /**
     * The same as a view that lasts until the next call.
     * @param {number} count
     */
    bulkView(count) {
        const start = this.call('bulk') / 8;
        return this.#module.HEAPF64.subarray(start, start + count);
    }

    /**
     * Numbers at an address of wasm memory, copied.
     * @param {number} address
     * @param {number} count
     * @returns {Float64Array}
     */
    copy(address, count) {
        const start = address / 8;
        return this.#module.HEAPF64.slice(start, start + count);
    }

    /**
     * Numbers, or unsigned integers, at an address of wasm memory: a view that lasts until the next call.
     * @param {number} address
     * @param {number} count
     */
    doubles(address, count) {
        return this.#module.HEAPF64.subarray(address / 8, address / 8 + count);
    }

    /** @param {number} address @param {number} count */
    indices(address, count) {
        return new Uint32Array(this.#module.HEAPU8.buffer, address, count);
    }

    /**
     * Bytes at an address of wasm memory, copied.
     * @param {number} address
     * @param {number} count
     */
    bytes(address, count) {
        return this.#module.HEAPU8.slice(address, address + count);
    }

    /**
     * Puts a text where the next call reads it.
     * @param {string} text
     */
    sendText(text) {
        const bytes = utf8.encode(text);
        const start = this.call('textRoom', bytes.length);
        this.#module.HEAPU8.set(bytes, start);
    }

    /**
     * Has `handle` released when `owner` is collected without having been disposed of.
     * @param {object} owner
     * @param {number} handle
     */
    watch(owner, handle) {
        this.#registry?.register(owner, handle, owner);
    }

    /** @param {object} owner @param {number} handle */
    dispose(owner, handle) {
        this.#registry?.unregister(owner);
        this.release(handle);
    }

    /** @param {number} handle */
    release(handle) {
        if (!this.#ended) this.call('release', handle);
    }

    #refusal() {
        const { code, path, message } = JSON.parse(this.call('error'));
        return new KnotworkError(code, path, message);
    }

    #outOfMemory() {
        return new KnotworkError('OUT_OF_MEMORY', '',
            'The module ran out of memory and has ended; load() gives a fresh one.');
    }
}
