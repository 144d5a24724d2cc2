// Whether a figure can be seen, and when its next picture is there.

import { deferred } from './figure-parts.mjs';

export class Sight {
    /** @type {(() => void)[]} */
    #waiting = [];
    /** Whether it can be seen is known; it can be seen. */
    #looked = deferred();
    #seen = deferred();

    /** Resolves as soon as the figure has come into sight for the first time. */
    get seen() {
        return this.#seen.promise;
    }

    /** Resolves as soon as it is known whether the figure can be seen. */
    get looked() {
        return this.#looked.promise;
    }

    /** @param {boolean} onScreen */
    crossed(onScreen) {
        this.#looked.resolve(undefined);
        if (onScreen) this.#seen.resolve(undefined);
    }

    /** Resolves with the next picture. @returns {Promise<void>} */
    painting() {
        return new Promise((resolve) => { this.#waiting.push(resolve); });
    }

    painted() {
        for (const resolve of this.#waiting.splice(0)) resolve();
    }

    /** Nobody waits for what will not come. */
    end() {
        this.#looked.resolve(undefined);
        this.#seen.resolve(undefined);
        this.painted();
    }
}
