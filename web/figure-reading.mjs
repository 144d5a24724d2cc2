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
/** … and after how many without a change it follows where it takes longer. */
const rest = 200;

/** Follows changes: at the end of the task, or in the first pause where that has taken long before. */
export class Follower {
    #waiting = false;
    #cost = 0;
    /** @type {ReturnType<typeof setTimeout> | undefined} */
    #timer;

    /** @param {() => void} follow */
    constructor(follow) {
        this.follow = follow;
    }

    /** After a change; many of one task are one. */
    soon() {
        if (this.#cost > light) {
            clearTimeout(this.#timer);
            this.#timer = setTimeout(() => this.now(), rest);
        } else if (!this.#waiting) {
            this.#waiting = true;
            queueMicrotask(() => this.now());
        }
    }

    now() {
        clearTimeout(this.#timer);
        this.#waiting = false;
        const began = performance.now();
        this.follow();
        this.#cost = performance.now() - began;
    }

    end() {
        clearTimeout(this.#timer);
    }
}
