// What a figure does that takes a while, one thing after the other: each with a bar over the picture
// while it lasts, ended by its button, by Escape, by whoever asked for it, or with the figure.

import { Progress } from './progress.mjs';

/** @typedef {import('./slices.mjs').Watch} Watch */

/**
 * @typedef {object} WorkHost
 * @property {() => import('./words.mjs').Words} words
 * @property {(sentence: string) => void} say
 */

export class FigureWork {
    /** @type {Promise<unknown>} */
    #former = Promise.resolve();
    #gone = new AbortController();

    /**
     * @param {{ picture: HTMLElement, frame: HTMLElement }} parts
     * @param {WorkHost} host
     */
    constructor({ picture, frame }, host) {
        this.host = host;
        this.progress = new Progress('quiet-button', { shown: (name) => this.#say('work.begun', { name }) });
        picture.append(this.progress.element);
        frame.addEventListener('keydown', (event) => this.#key(event), { capture: true });
    }

    /**
     * Does something that takes a while, after what was begun before. Rejects with the reason of the
     * signal that has ended it. Whoever follows it has a bar of their own.
     * @template T
     * @param {string} name
     * @param {(watch: Watch) => Promise<T>} work
     * @param {Watch} [given]
     * @returns {Promise<T>}
     */
    async run(name, work, { signal, progress } = {}) {
        const mine = new AbortController();
        const former = this.#former;
        const done = former.then(() => this.#follow(name, work, { signal: any(mine.signal, this.#gone.signal, signal), progress }, mine));
        this.#former = done.catch(() => {});
        return done;
    }

    /**
     * @template T
     * @param {string} name
     * @param {(watch: Watch) => Promise<T>} work
     * @param {Watch} watch
     * @param {AbortController} mine
     */
    async #follow(name, work, { signal, progress }, mine) {
        if (progress) return work({ signal, progress });
        this.progress.begin(this.host.words(), name, () => mine.abort());
        try {
            return await work({ signal, progress: (fraction) => this.progress.advance(fraction) });
        } catch (error) {
            if (mine.signal.aborted) this.#say('work.cancelled');
            throw error;
        } finally {
            this.progress.end();
        }
    }

    /** @param {KeyboardEvent} event */
    #key(event) {
        if (event.key !== 'Escape' || !this.progress.shown) return;
        event.preventDefault();
        event.stopPropagation();
        this.progress.cancel();
    }

    /** @param {string} key @param {Record<string, string>} [values] */
    #say(key, values = {}) {
        this.host.say(this.host.words().text(key, values));
    }

    /** Ends all of it. */
    dispose() {
        this.#gone.abort();
    }
}

/**
 * A signal that follows the first of these; AbortSignal.any() is younger than some browsers.
 * @param {...(AbortSignal | undefined)} signals
 */
function any(...signals) {
    const both = new AbortController();
    for (const signal of signals) {
        if (signal?.aborted) both.abort(signal.reason);
        else signal?.addEventListener('abort', () => both.abort(signal.reason), { once: true, signal: both.signal });
    }
    return both.signal;
}
