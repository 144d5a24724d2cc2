// A figure at work: picture, controls, values panel and scene inside one shadow root. It lives from
// the moment its element is connected until it is removed for good.

import { setText } from './dom.mjs';
import { Changes } from './figure-changes.mjs';
import { buttonActions, pressKey } from './figure-commands.mjs';
import { FigureControls } from './figure-controls.mjs';
import { dressView, joinHands } from './figure-joining.mjs';
import { FigurePanes } from './figure-panes.mjs';
import { Announcer, makeParts, watch } from './figure-parts.mjs';
import { Playback } from './figure-playback.mjs';
import { Follower, Reading } from './figure-reading.mjs';
import { doneSentence } from './figure-sentences.mjs';
import { Sight } from './figure-sight.mjs';
import { readSource } from './figure-source.mjs';
import { figureSheet } from './figure-style.mjs';
import { describe, selectFirst, showFailure, showRefusal } from './figure-telling.mjs';
import { FigureView } from './figure-view.mjs';
import { FigureWork } from './figure-work.mjs';
import { sharedStage } from './stage.mjs';

/**
 * What the element has been asked for, in plain words.
 * @typedef {object} Wishes
 * @property {import('./words.mjs').Words} words
 * @property {string} controls
 * @property {boolean} readOnly
 * @property {'light' | 'dark' | 'contrast' | 'contrast-dark'} theme
 * @property {boolean} ownTheme whether the figure chooses its theme itself
 * @property {boolean} still whether motion is to be reduced
 * @property {string} wheelZoom
 * @property {string} aspect a CSS aspect ratio
 */

/**
 * @typedef {object} FigureHost
 * @property {() => Wishes} wishes
 * @property {(type: string, detail: any) => void} emit
 * @property {() => void} nextTheme
 */

export class Figure {
    #parts = makeParts();
    #announcer = new Announcer(this.#parts.announcer);
    /** @type {import('./stage.mjs').Stage | undefined} */
    #stage;
    /** @type {any} */
    #scene;
    #sceneName = '';
    #loading = 0;
    #follower = new Follower(() => this.#refresh());
    #toldRevision = -1;
    #expert = false;
    #disposed = false;
    /** @type {import('./figure-input.mjs').FigureInput | undefined} */
    #input;
    /** @type {import('./figure-hands.mjs').FigureHands | undefined} */
    #hands;
    #sight = new Sight();
    #changes = new Changes({
        emit: (type, detail) => this.host.emit(type, detail),
        changed: () => this.#follower.soon(),
    });
    #playback = new Playback({
        words: () => this.host.wishes().words,
        say: (sentence) => this.#announcer.say(sentence),
        moved: () => {
            this.#refreshToolbar();
            this.#request();
        },
    });

    /**
     * @param {ShadowRoot} root
     * @param {FigureHost} host
     */
    constructor(root, host) {
        this.root = root;
        this.host = host;
        root.adoptedStyleSheets = [figureSheet()];
        root.replaceChildren(this.#parts.frame);
        const run = (/** @type {any} */ command, final = true) => this.#changes.run(this.#scene, command, final);
        this.panes = new FigurePanes(this.#parts, {
            run,
            selected: () => this.selection?.object ?? -1,
            panes: () => this.#stage?.app.panes(this.view.id) ?? '',
            moveSeam: (name, share) => {
                this.#stage?.app.moveSeam(this.view.id, name, share);
                this.#request();
            },
        });
        this.controls = new FigureControls(this.#parts, {
            actions: buttonActions(this),
            kw: () => this.kw,
            run,
            dressPanes: (words, button, seams) => this.panes.dress(words, button, seams),
            setStep: (step) => {
                this.#stage?.app.setStep(this.view.id, step);
                this.#follow();
            },
            stepped: (step) => this.host.emit('step', step),
        });
        this.work = new FigureWork(this.#parts, {
            words: () => this.host.wishes().words,
            say: (sentence) => this.#announcer.say(sentence),
        });
        this.view = new FigureView(this.#parts.wrapper, {
            ticked: () => this.#ticked(),
            failed: (message) => this.#showFailure(message),
            painted: () => this.#painted(),
            crossed: (onScreen) => this.#sight.crossed(onScreen),
        });
        this.applyWishes();
    }

    get scene() {
        return this.#scene;
    }

    get kw() {
        return this.#stage?.kw;
    }

    get selection() {
        const text = this.#stage?.app.selection(this.view.id);
        return text ? JSON.parse(text) : null;
    }

    get playing() {
        return this.#playback.playing;
    }

    get phase() {
        return this.#playback.phase;
    }

    get moves() {
        return this.#playback.moves;
    }

    /** Resolves as soon as the element has come into sight for the first time. */
    get seen() {
        return this.#sight.seen;
    }

    // Scenes

    /**
     * Fetches and shows a document; a later call overtakes an earlier one. The answer says whether
     * this one is shown now; a refusal is thrown, and what was shown before stays.
     * @param {import('./figure-source.mjs').Source} source
     * @returns {Promise<boolean>}
     */
    async load(source) {
        this.#loading += 1;
        const turn = this.#loading;
        const stage = await this.#join();
        const document = stage && await readSource(source, stage.kw);
        if (document === undefined || turn !== this.#loading || this.#disposed) return false;
        this.open(document, source.kind === 'scene' ? source.text : '');
        await this.#picture();
        return !this.#disposed;
    }

    /**
     * Shows a document at once; throws KnotworkError when it is refused.
     * @param {any} document
     * @param {string} [name] of a built-in scene
     */
    open(document, name = '') {
        if (!this.#stage) throw new Error('The figure is not ready yet.');
        const { app, kw } = this.#stage;
        const scene = kw.scene(document);
        const former = this.#scene;
        this.#loading += 1;
        this.#sceneName = name;
        this.#scene = scene;
        app.attach(this.view.id, scene.handle);
        former?.dispose();
        watch(scene, (what, command, answer) => {
            this.#changes.heard(what, command, answer);
            this.#request();
        });
        this.#playback.begin(this.host.wishes().still);
        this.#toldRevision = -1;
        this.#parts.refusal.hidden = true;
        this.controls.forget();
        this.#refresh();
        this.#request();
    }

    async #join() {
        const stage = this.#stage ?? await sharedStage();
        if (this.#disposed || this.#stage) return this.#stage;
        this.#stage = stage;
        const id = this.view.join(stage);
        this.#playback.join(stage.app, id);
        const { hands, input } = joinHands(this.#parts, { app: stage.app, id }, {
            wishes: () => this.host.wishes(),
            say: (sentence) => this.#announcer.say(sentence),
            acted: () => this.#acted(),
            openValues: (held) => this.controls.focusValues(held),
            shortcut: (event) => pressKey(this, event),
        });
        this.#hands = hands;
        this.#input = input;
        this.applyWishes();
        if (stage.unavailable) this.#showFailure(stage.unavailable);
        return stage;
    }

    // Commands

    undo() {
        this.#input?.settle();
        return this.#changes.as('history', () => this.#scene?.undo() ?? false);
    }

    redo() {
        this.#input?.settle();
        return this.#changes.as('history', () => this.#scene?.redo() ?? false);
    }

    /** @param {boolean} playing */
    setPlaying(playing) {
        this.#playback.play(playing);
    }

    /** @param {number} phase */
    seek(phase) {
        this.#playback.seek(phase);
    }

    /** Everything as it was when the document was opened; redo brings the changes back. */
    reset() {
        this.#changes.as('history', () => {
            while (this.#scene?.undo());
        });
        this.seek(0);
        this.fit();
    }

    /** @param {number} by */
    step(by) {
        this.controls.step(by);
    }

    /** @param {FocusOptions} [options] */
    focus(options) {
        this.#parts.wrapper.focus(options);
    }

    /** @param {string} path of what is to be selected and focused */
    focusPoint(path) {
        this.#stage?.app.select(this.view.id, path);
        this.#request();
        return this.#hands?.focus() ?? false;
    }

    fit() {
        this.#stage?.app.fit(this.view.id);
        this.#request();
    }

    toggleValues() {
        this.controls.toggleValues();
        this.#refresh();
    }

    toggleExpert() {
        this.#expert = !this.#expert;
        this.#stage?.app.focus(this.view.id);
        this.#stage?.app.setPanel(this.view.id, this.#expert);
        this.#refreshToolbar();
        this.#request();
    }

    /** Selects what comes first where nothing is selected; answers whether it did. */
    selectFirst() {
        if (this.selection || !this.#scene || !this.#stage) return false;
        if (!selectFirst(this.#stage.app, this.view.id, this.#scene.document)) return false;
        this.#hands?.follow(false);
        this.#hands?.tell();
        return true;
    }

    // What follows from changes

    /** After input that the application has seen. */
    #acted() {
        this.#tellEvents();
        this.controls.reveal(this.selection?.object ?? -1);
        this.#follow();
        this.#request();
    }

    #tellEvents() {
        if (this.#stage) this.#changes.tellEvents(this.#stage.app, this.view.id);
    }

    #follow() {
        this.#hands?.follow(this.#input?.busy ?? false);
        this.controls.showStep(this.#hands?.held?.step);
    }

    #ticked() {
        this.#tellEvents();
        this.#follow();
        this.#refreshToolbar();
    }

    #painted() {
        this.#parts.fallback.hidden = true;
        this.panes.follow();
        this.#sight.painted();
    }

    /** Waits for the first picture, where there is anyone to see it. */
    async #picture() {
        if (document.visibilityState === 'hidden' || this.#stage?.unavailable) return;
        await this.#sight.looked;
        if (!this.view.onScreen || this.#disposed) return;
        const painted = this.#sight.painting();
        this.#request();
        await painted;
    }

    #request() {
        this.#stage?.request();
    }

    #refresh() {
        const scene = this.#scene;
        if (!scene) return;
        const read = new Reading(scene);
        this.#refreshToolbar();
        this.controls.showScene(read);
        this.panes.update(scene);
        if (read.revision === this.#toldRevision) return;
        const opened = this.#toldRevision < 0;
        this.#toldRevision = read.revision;
        const { document } = read;
        const sentence = describe(this.#parts, this.host.wishes(), read, this.#sceneName);
        const step = this.controls.showTrace(document, this.selection?.object ?? -1);
        if (opened) return;
        this.#announcer.say(step || doneSentence(this.host.wishes().words, this.#changes.last, document, sentence, this.kw));
    }

    #refreshToolbar() {
        if (!this.#stage) return;
        this.#input?.follow();
        this.controls.update({
            moves: this.moves,
            playing: this.playing,
            phase: this.phase,
            canUndo: this.#scene?.canUndo ?? false,
            canRedo: this.#scene?.canRedo ?? false,
            expert: this.#expert,
        });
    }

    // Dressing

    /** Makes everything as the element's attributes and the reader's system ask for. */
    applyWishes() {
        const wishes = this.host.wishes();
        this.#parts.frame.dataset.theme = wishes.theme;
        this.#parts.picture.style.aspectRatio = wishes.aspect;
        if (!this.#scene) setText(this.#parts.message, wishes.words.text('loading'));
        this.controls.apply(wishes);
        this.#hands?.dress();
        this.#toldRevision = -1;
        this.#refresh();
        if (!this.#stage) return;
        dressView(this.#stage.app, this.view.id, wishes);
        if (this.view.onScreen) this.#stage.paint(this.view.id);  // with the colours around it
        this.#request();
    }

    /** @param {string} reason */
    #showFailure(reason) {
        showFailure(this.#parts, this.host.wishes().words, reason);
        this.#sight.painted();
    }

    /** @param {any} error why a document was refused */
    showRefusal(error) {
        showRefusal(this.#parts, this.host.wishes().words, error, this.#scene !== undefined);
    }

    dispose() {
        this.#disposed = true;
        this.work.dispose();
        this.#follower.end();
        this.#announcer.silence();
        this.controls.dispose();
        this.#sight.end();
        this.#playback.leave();
        this.#input?.dispose();
        this.view.leave();
        this.#scene?.dispose();
        this.#scene = undefined;
        this.#stage = undefined;
        this.root.replaceChildren();
    }
}
