// Values that live in the module until they are disposed of.

import { Core } from './core.mjs';
import { KnotworkError } from './errors.mjs';

/** Stands in for Symbol.dispose where the language does not have it yet. */
export const disposeSymbol = /** @type {typeof Symbol.dispose} */ (
    /** @type {any} */ (Symbol).dispose ?? Symbol.for('Symbol.dispose'));

export class Held {
    /** @type {Core} */
    #core;
    /** 0 once it is disposed of */
    #handle;

    /** @param {Core} core @param {number} handle */
    constructor(core, handle) {
        if (!(core instanceof Core)) {
            throw new KnotworkError('WRONG_TYPE', '', 'Such values are made by the functions of load().');
        }
        this.#core = core;
        this.#handle = handle;
        core.watch(this, handle);
    }

    /**
     * The core and the handle of a value that is still there.
     * @param {unknown} value
     * @returns {{ core: Core, handle: number }}
     */
    static of(value) {
        if (typeof value !== 'object' || value === null || !(#handle in value)) {
            throw new KnotworkError('WRONG_TYPE', 'this', 'Call this as a method of the value it belongs to.');
        }
        const held = /** @type {Held} */ (value);
        if (held.#handle === 0) {
            throw new KnotworkError('DISPOSED', '', 'The value was disposed of; make a new one.');
        }
        return { core: held.#core, handle: held.#handle };
    }

    /** Frees its memory. Whatever is asked of it afterwards is refused as DISPOSED. */
    dispose() {
        if (typeof this !== 'object' || this === null || !(#handle in this)) Held.of(this);
        if (this.#handle === 0) return;
        this.#core.dispose(this, this.#handle);
        this.#handle = 0;
    }

    [disposeSymbol]() {
        Held.prototype.dispose.call(this);
    }
}
