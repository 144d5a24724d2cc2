// The one kind of error that leaves this package.

/** @typedef {{ code: string, path: string, message: string }} Problem */

export class KnotworkError extends Error {
    #problems;

    /**
     * @param {string} code one of the codes of the public interface
     * @param {string} path where in the input, such as `knots[3]`; empty for the whole of it
     * @param {string} message what was given, what is allowed, what to do
     * @param {Problem[]} [problems] all that is wrong, this first, where more was found
     */
    constructor(code, path, message, problems = []) {
        super(message);
        this.code = code;
        this.path = path;
        this.#problems = problems.length > 0 ? problems : [{ code, path, message }];
    }

    /** This and, of a document, all else that is wrong with it, in the order of reading. */
    get problems() {
        return this.#problems;
    }
}
Object.defineProperty(KnotworkError.prototype, 'name', {
    value: 'KnotworkError', configurable: true, writable: true,
});

/**
 * A value as a message names it. Never runs code of the value's own.
 * @param {unknown} value
 */
export function describe(value) {
    switch (typeof value) {
        case 'string': return value.length > 40 ? 'a long string' : `the string ${JSON.stringify(value)}`;
        case 'number': return `the number ${value}`;
        case 'bigint': return 'a bigint';
        case 'boolean': return `${value}`;
        case 'undefined': return 'nothing';
        case 'function': return 'a function';
        case 'symbol': return 'a symbol';
        default: return value === null ? 'null' : 'an object';
    }
}

/**
 * Runs what may run code of the caller's (getters, proxies): whatever that throws becomes a refusal.
 * @template T
 * @param {() => string} path
 * @param {() => T} read
 * @returns {T}
 */
export function reading(path, read) {
    try {
        return read();
    } catch (problem) {
        if (problem instanceof KnotworkError) throw problem;
        throw new KnotworkError('WRONG_TYPE', path(), 'Reading this value failed; give plain data.');
    }
}
