// Playing, pausing and seeking in the animation of a figure.

/**
 * @typedef {object} PlaybackHost
 * @property {() => import('./words.mjs').Words} words
 * @property {(sentence: string) => void} say
 * @property {() => void} moved the phase, or whether it moves, is another one
 */

export class Playback {
    /** @type {import('./page-module.mjs').App | undefined} */
    #app;
    #id = 0;

    /** @param {PlaybackHost} host */
    constructor(host) {
        this.host = host;
    }

    /**
     * @param {import('./page-module.mjs').App} app
     * @param {number} id of the view
     */
    join(app, id) {
        this.#app = app;
        this.#id = id;
    }

    leave() {
        this.#app = undefined;
    }

    /** Whether there is anything to play. */
    get moves() {
        return (this.#app?.period(this.#id) ?? 0) > 0;
    }

    get playing() {
        return this.#app?.playing(this.#id) ?? false;
    }

    get phase() {
        return this.#app?.phase(this.#id) ?? 0;
    }

    /** A scene just opened begins at its beginning. @param {boolean} still whether it rests there */
    begin(still) {
        this.#app?.setPhase(this.#id, 0);
        this.#app?.setPlaying(this.#id, this.moves && !still);
    }

    /** @param {boolean} playing */
    play(playing) {
        if (!this.#app || !this.moves) return;
        this.#app.setPlaying(this.#id, playing);
        const words = this.host.words();
        const value = words.number(Math.round(this.phase * 100) / 100);
        this.host.say(words.text(playing ? 'said.playing' : 'said.paused', { value }));
        this.host.moved();
    }

    /** @param {number} phase */
    seek(phase) {
        this.#app?.setPlaying(this.#id, false);
        this.#app?.setPhase(this.#id, phase);
        this.host.moved();
    }
}
