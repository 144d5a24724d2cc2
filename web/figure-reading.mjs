// What a figure reads of its scene, and when. Reading a document of a megabyte takes longer than a
// picture of it, so each state of a scene is read once at most, and a large one only once it rests.

/** The document and the schema of a scene, as they were when they were first asked for. */
export class Reading {
    /** @type {any} */
    #document;
    /** @type {any} */
    #schema;

    /** @param {any} scene */
    constructor(scene) {
        this.scene = scene;
        this.revision = scene.revision;
    }

    get document() {
        this.#document ??= this.scene.document;
        return this.#document;
    }

    get schema() {
        this.#schema ??= this.scene.schema;
        return this.#schema;
    }
}

/** Milliseconds that following a change may take of every change of a gesture … */
const light = 20;
/** … and the share of the time that it may take where it takes longer. */
const share = 1 / 6;

/**
 * Follows changes at the end of the task; where that takes long, the first change at once and those of
 * a gesture from time to time, the last of them always.
 */
export class Follower {
    #waiting = false;
    /** When the next change may be followed at once. */
    #free = 0;
    /** @type {ReturnType<typeof setTimeout> | undefined} */
    #timer;

    /** @param {() => void} follow */
    constructor(follow) {
        this.follow = follow;
    }

    /** After a change; many of one task are one. */
    soon() {
        if (this.#waiting) return;
        this.#waiting = true;
        const wait = this.#free - performance.now();
        if (wait > 0) this.#timer = setTimeout(() => this.now(), wait);
        else queueMicrotask(() => this.now());
    }

    now() {
        clearTimeout(this.#timer);
        this.#waiting = false;
        const began = performance.now();
        this.follow();
        const ended = performance.now();
        const cost = ended - began;
        this.#free = cost > light ? ended + cost * (1 / share - 1) : 0;
    }

    end() {
        clearTimeout(this.#timer);
    }
}
