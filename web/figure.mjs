// A figure at work: picture, controls, values panel and scene inside one shadow root. It lives from
// the moment its element is connected until it is removed for good.

import { setText } from './dom.mjs';
import { FigureControls } from './figure-controls.mjs';
import { FigureHands } from './figure-hands.mjs';
import { FigureInput } from './figure-input.mjs';
import { Announcer, deferred, makeParts, watch } from './figure-parts.mjs';
import { doneSentence } from './figure-sentences.mjs';
import { describe, selectFirst, showFailure, showRefusal } from './figure-telling.mjs';
import { readSource } from './figure-source.mjs';
import { figureSheet } from './figure-style.mjs';
import { FigureView } from './figure-view.mjs';
import { sharedStage } from './stage.mjs';

/**
 * What the element has been asked for, in plain words.
 * @typedef {object} Wishes
 * @property {import('./words.mjs').Words} words
 * @property {string} controls
 * @property {boolean} readOnly
 * @property {'light' | 'dark' | 'contrast'} theme
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
    #source = 'api';
    #final = true;
    #loading = 0;
    #refreshing = false;
    #toldRevision = -1;
    #expert = false;
    #disposed = false;
    /** @type {FigureInput | undefined} */
    #input;
    /** @type {FigureHands | undefined} */
    #hands;
    /** The change that was told last. @type {{ source: string, command: any, what?: string }} */
    #done = { source: '', command: null };
    /** @type {(() => void)[]} */
    #awaitingPicture = [];
    /** Whether it can be seen is known; it can be seen. */
    #lookedFor = deferred();
    #inSight = deferred();

    /**
     * @param {ShadowRoot} root
     * @param {FigureHost} host
     */
    constructor(root, host) {
        this.root = root;
        this.host = host;
        root.adoptedStyleSheets = [figureSheet()];
        root.replaceChildren(this.#parts.frame);
        this.controls = new FigureControls(this.#parts, {
            actions: this.#actions(),
            kw: () => this.kw,
            run: (command, final) => this.#run(command, final),
            setStep: (step) => {
                this.#stage?.app.setStep(this.view.id, step);
                this.#follow();
            },
            stepped: (step) => this.host.emit('step', step),
        });
        this.view = new FigureView(this.#parts.wrapper, {
            ticked: () => this.#ticked(),
            failed: (message) => this.#showFailure(message),
            painted: () => this.#painted(),
            crossed: (onScreen) => {
                this.#lookedFor.resolve(undefined);
                if (onScreen) this.#inSight.resolve(undefined);
            },
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
        return this.#stage?.app.playing(this.view.id) ?? false;
    }

    get phase() {
        return this.#stage?.app.phase(this.view.id) ?? 0;
    }

    /** Resolves as soon as the element has come into sight for the first time. */
    get seen() {
        return this.#inSight.promise;
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
        watch(scene, (what, command, answer) => this.#changed(what, command, answer));
        app.setPhase(this.view.id, 0);
        app.setPlaying(this.view.id, this.#moves && !this.host.wishes().still);
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
        const hands = new FigureHands(this.#parts, {
            app: stage.app, id,
            wishes: () => this.host.wishes(),
            say: (sentence) => this.#announcer.say(sentence),
            acted: () => this.#acted(),
            ran: () => this.#input?.run(),
            openValues: (held) => this.controls.focusValues(held),
        });
        this.#hands = hands;
        this.#input = new FigureInput(this.#parts.wrapper, {
            app: stage.app, id,
            before: (event) => hands.before(event),
            pressed: (key) => hands.pressed(key),
            places: (x, y) => hands.places(x, y),
            acted: () => this.#acted(),
            readOnly: () => this.host.wishes().readOnly,
            wheelZoom: () => this.host.wishes().wheelZoom,
            shortcut: (event) => this.#shortcut(event),
        });
        this.applyWishes();
        if (stage.unavailable) this.#showFailure(stage.unavailable);
        return stage;
    }

    // Commands

    undo() {
        this.#input?.settle();
        return this.#as('history', () => this.#scene?.undo() ?? false);
    }

    redo() {
        this.#input?.settle();
        return this.#as('history', () => this.#scene?.redo() ?? false);
    }

    /** @param {boolean} playing */
    setPlaying(playing) {
        if (!this.#stage || !this.#moves) return;
        const { app } = this.#stage;
        app.setPlaying(this.view.id, playing);
        const { words } = this.host.wishes();
        const value = words.number(Math.round(app.phase(this.view.id) * 100) / 100);
        this.#announcer.say(words.text(playing ? 'said.playing' : 'said.paused', { value }));
        this.#refreshToolbar();
        this.#request();
    }

    /** @param {number} phase */
    seek(phase) {
        this.#stage?.app.setPlaying(this.view.id, false);
        this.#stage?.app.setPhase(this.view.id, phase);
        this.#refreshToolbar();
        this.#request();
    }

    /** Everything as it was when the document was opened; redo brings the changes back. */
    reset() {
        this.#as('history', () => {
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

    /** @returns {import('./figure-toolbar.mjs').Actions} */
    #actions() {
        return {
            undo: () => this.undo(),
            redo: () => this.redo(),
            togglePlay: () => this.setPlaying(!this.playing),
            reset: () => this.reset(),
            fit: () => this.fit(),
            toggleExpert: () => this.#toggleExpert(),
            toggleValues: () => {
                this.controls.toggleValues();
                this.#refresh();
            },
            nextTheme: () => this.host.nextTheme(),
            seek: (phase) => this.seek(phase),
        };
    }

    /**
     * Executes a command that was typed; answers its refusal.
     * @param {any} command
     * @param {boolean} final whether the gesture, if it is one, ends here
     */
    #run(command, final) {
        this.#final = final;
        try {
            this.#as('field', () => this.#scene.execute(command));
            return null;
        } catch (error) {
            return error;
        } finally {
            this.#final = true;
        }
    }

    /**
     * @template T
     * @param {string} source
     * @param {() => T} act
     * @returns {T}
     */
    #as(source, act) {
        const former = this.#source;
        this.#source = source;
        try {
            return act();
        } finally {
            this.#source = former;
        }
    }

    // What follows from changes

    /**
     * @param {string} what
     * @param {any} command
     * @param {any} answer what the scene said to it
     */
    #changed(what, command, answer) {
        const source = what === 'execute' ? this.#source : 'history';
        this.host.emit(this.#final ? 'change' : 'input', { source, path: answer?.path ?? '', command: command ?? null });
        this.#done = { source, command, what };
        this.#refreshSoon();
        this.#request();
    }

    /** After input that the application has seen. */
    #acted() {
        this.#tellEvents();
        this.controls.reveal(this.selection?.object ?? -1);
        this.#follow();
        this.#request();
    }

    #tellEvents() {
        const text = this.#stage?.app.takeEvents(this.view.id);
        if (!text || text === '[]') return;
        for (const { type, ...detail } of JSON.parse(text)) {
            this.host.emit(type, detail);
            this.#done = detail;
        }
        this.#refreshSoon();
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
        this.#showPicture();
    }

    #showPicture() {
        for (const resolve of this.#awaitingPicture.splice(0)) resolve();
    }

    /** Waits for the first picture, where there is anyone to see it. */
    async #picture() {
        if (document.visibilityState === 'hidden' || this.#stage?.unavailable) return;
        await this.#lookedFor.promise;
        if (!this.view.onScreen || this.#disposed) return;
        const painted = new Promise((resolve) => { this.#awaitingPicture.push(() => resolve(undefined)); });
        this.#request();
        await painted;
    }

    #request() {
        this.#stage?.request();
    }

    /** The panel follows once per task, however many commands there were. */
    #refreshSoon() {
        if (this.#refreshing) return;
        this.#refreshing = true;
        queueMicrotask(() => {
            this.#refreshing = false;
            this.#refresh();
        });
    }

    #refresh() {
        const scene = this.#scene;
        if (!scene) return;
        this.#refreshToolbar();
        this.controls.showScene(scene);
        if (scene.revision === this.#toldRevision) return;
        const opened = this.#toldRevision < 0;
        this.#toldRevision = scene.revision;
        const { document } = scene;
        const sentence = describe(this.#parts, this.host.wishes().words, scene, document, this.#sceneName);
        const step = this.controls.showTrace(document, this.selection?.object ?? -1);
        if (opened) return;
        this.#announcer.say(step || doneSentence(this.host.wishes().words, this.#done, document, sentence));
    }

    #refreshToolbar() {
        if (!this.#stage) return;
        this.#input?.follow();
        this.controls.update({
            moves: this.#moves,
            playing: this.playing,
            phase: this.#stage.app.phase(this.view.id),
            canUndo: this.#scene?.canUndo ?? false,
            canRedo: this.#scene?.canRedo ?? false,
            expert: this.#expert,
        });
    }

    get #moves() {
        return (this.#stage?.app.period(this.view.id) ?? 0) > 0;
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
        const { app } = this.#stage;
        app.setTheme(this.view.id, wishes.theme);
        app.setWords(this.view.id, JSON.stringify(wishes.words.picture()));
        app.setReadOnly(this.view.id, wishes.readOnly);
        app.setReducedMotion(this.view.id, wishes.still);
        if (wishes.still) app.setPlaying(this.view.id, false);
        if (this.view.onScreen) this.#stage.paint(this.view.id);  // with the colours around it
        this.#request();
    }

    #toggleExpert() {
        this.#expert = !this.#expert;
        this.#stage?.app.focus(this.view.id);
        this.#stage?.app.setPanel(this.view.id, this.#expert);
        this.#refreshToolbar();
        this.#request();
    }

    /**
     * Keys of the figure that the application has no use for.
     * @param {KeyboardEvent} event
     */
    #shortcut(event) {
        const command = event.ctrlKey || event.metaKey;
        const key = event.key.toLowerCase();
        if (key === ' ' && this.#moves) this.setPlaying(!this.playing);
        else if (key === 'pagedown' || key === 'pageup') return this.#selectFirst();
        else if (command && key === 'z' && !event.shiftKey) this.undo();
        else if (command && (key === 'y' || key === 'z')) this.redo();
        else return false;
        return true;
    }

    #selectFirst() {
        if (this.selection || !this.#scene || !this.#stage) return false;
        if (!selectFirst(this.#stage.app, this.view.id, this.#scene.document)) return false;
        this.#hands?.follow(false);
        this.#hands?.tell();
        return true;
    }

    /** @param {string} reason */
    #showFailure(reason) {
        showFailure(this.#parts, this.host.wishes().words, reason);
        this.#showPicture();
    }

    /** @param {any} error why a document was refused */
    showRefusal(error) {
        showRefusal(this.#parts, this.host.wishes().words, error, this.#scene !== undefined);
    }

    dispose() {
        this.#disposed = true;
        this.#announcer.silence();
        this.controls.dispose();
        this.#lookedFor.resolve(undefined);
        this.#inSight.resolve(undefined);
        this.#showPicture();
        this.#input?.dispose();
        this.view.leave();
        this.#scene?.dispose();
        this.#scene = undefined;
        this.#stage = undefined;
        this.root.replaceChildren();
    }
}
