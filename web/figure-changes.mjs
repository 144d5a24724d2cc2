// Who changes the scene of a figure, and what is told of it: `input` while a gesture goes on,
// `change` when it is done.

/** @typedef {{ source: string, command: any, what?: string }} Done a change that was told */

/**
 * @typedef {object} ChangesHost
 * @property {(type: string, detail: any) => void} emit
 * @property {() => void} changed the scene is another one now
 */

export class Changes {
    #source = 'api';
    #final = true;
    /** @type {Done} */
    #last = { source: '', command: null };

    /** @param {ChangesHost} host */
    constructor(host) {
        this.host = host;
    }

    /** What was told last. */
    get last() {
        return this.#last;
    }

    /**
     * Acts in the name of this source.
     * @template T
     * @param {string} source
     * @param {() => T} act
     * @returns {T}
     */
    as(source, act) {
        const former = this.#source;
        this.#source = source;
        try {
            return act();
        } finally {
            this.#source = former;
        }
    }

    /**
     * Executes a command that was typed; answers its refusal.
     * @param {any} scene
     * @param {any} command
     * @param {boolean} final whether the gesture, if it is one, ends here
     */
    run(scene, command, final) {
        this.#final = final;
        try {
            this.as('field', () => scene.execute(command));
            return null;
        } catch (error) {
            return error;
        } finally {
            this.#final = true;
        }
    }

    /**
     * Tells of what the scene's own methods did.
     * @param {string} what
     * @param {any} command
     * @param {any} answer what the scene said to it
     */
    heard(what, command, answer) {
        const source = what === 'execute' ? this.#source : 'history';
        this.host.emit(this.#final ? 'change' : 'input', { source, path: answer?.path ?? '', command: command ?? null });
        this.#last = { source, command, what };
        this.host.changed();
    }

    /**
     * Tells of what hands did in the picture.
     * @param {import('./page-module.mjs').App} app
     * @param {number} id of the view
     */
    tellEvents(app, id) {
        const text = app.takeEvents(id);
        if (!text || text === '[]') return;
        for (const { type, ...detail } of JSON.parse(text)) {
            this.host.emit(type, detail);
            this.#last = detail;
        }
        this.host.changed();
    }
}
