// <knotwork-figure>: a figure as an element. Importing this module touches no DOM and registers
// nothing; defineFigure() does, and may be called any number of times.

import { KnotworkError } from './errors.mjs';
import { beginFile } from './figure-export.mjs';
import { Figure } from './figure.mjs';
import { sourceOf } from './figure-source.mjs';
import { controlsFor } from './figure-toolbar.mjs';
import { sharedStage } from './stage.mjs';
import { languageFor, Words } from './words.mjs';

const tagName = 'knotwork-figure';

/** Where there is no DOM, as in Node, the class is there to be looked at and not to be made. */
const Base = /** @type {typeof HTMLElement} */ (globalThis.HTMLElement ?? class {});

const ofDocument = ['scene', 'src', 'state'];
const ofLook = ['controls', 'aspect', 'theme', 'lang', 'readonly', 'motion', 'wheel-zoom'];
const themes = ['auto', 'light', 'dark', 'contrast'];

export class KnotworkFigure extends Base {
    static get observedAttributes() {
        return [...ofDocument, ...ofLook];
    }

    /** @type {Figure | undefined} */
    #figure;
    #ready = deferredReady();
    /** What to show when the element comes back into a page. @type {any} */
    #kept = undefined;
    #loadRequested = false;
    #preferences = new AbortController();

    /** The canonical document; setting it is silent and throws KnotworkError when it is refused. */
    get value() {
        return this.#figure?.scene?.document ?? this.#kept;
    }

    set value(document) {
        if (this.#figure?.kw) {
            this.#figure.open(document);
            this.#ready.resolve(this);
        } else {
            this.#kept = structuredClone(document);
            if (this.#figure) this.#loadSoon();
        }
    }

    /**
     * Shows a document, or the built-in scene of this name, and resolves when its picture is there;
     * rejects with KnotworkError, and keeps what was shown, when it is refused.
     * @param {any} documentOrName
     */
    async show(documentOrName) {
        const figure = this.#figure;
        if (!figure) throw new Error('The element is not in a page.');
        this.#loadRequested = false;
        const source = typeof documentOrName === 'string'
            ? { kind: /** @type {const} */ ('scene'), text: documentOrName }
            : { kind: /** @type {const} */ ('inline'), text: JSON.stringify(documentOrName) };
        if (await figure.load(source)) this.#succeeded();
    }

    /** The interface that the figures of this page share, as `load()` gives it. */
    static async api() {
        return (await sharedStage()).kw;
    }

    /** Resolves with the element when its first picture is there, or rejects with the refusal. */
    get ready() {
        return this.#ready.promise;
    }

    /** The scene that is shown, as `kw.scene()` gives it. */
    get scene() {
        return this.#figure?.scene;
    }

    /** What the figures of this page hold and have done: views, GL objects, bytes, frames, pictures. */
    static async stats() {
        const stage = await sharedStage();
        const { session } = stage.kw;
        const [held, memory] = [session.held(), session.memoryInUse()];
        return { ...JSON.parse(stage.app.stats()), pictures: stage.painted, held, memory };
    }

    /** What is selected in the picture, or null. */
    get selection() {
        return this.#figure?.selection ?? null;
    }

    get playing() {
        return this.#figure?.playing ?? false;
    }

    /** Where the animation is, in [0, 1); 0 where nothing moves. */
    get phase() {
        return this.#figure?.phase ?? 0;
    }

    undo() {
        this.#figure?.undo();
    }

    redo() {
        this.#figure?.redo();
    }

    play() {
        this.#figure?.setPlaying(true);
    }

    pause() {
        this.#figure?.setPlaying(false);
    }

    /** Goes on in the algorithm whose steps are shown, or back. @param {number} [by] */
    step(by = 1) {
        this.#figure?.step(by);
    }

    reset() {
        this.#figure?.reset();
    }

    /** The picture has the keyboard. @override @param {FocusOptions} [options] */
    focus(options) {
        this.#figure?.focus(options);
    }

    /**
     * Selects an element of the document, such as `objects[0].points[2]`, and gives it the focus;
     * answers whether the picture shows it.
     * @param {string} path
     */
    focusPoint(path) {
        return this.#figure?.focusPoint(String(path)) ?? false;
    }

    /**
     * What is shown as a file: the picture as `png` or `svg`, the document as `json`, the calls that
     * make its objects as `js`, and the objects as `csv`, `obj`, `stl`, `gltf` or `glb`.
     * @param {string} format
     * @param {object} [options] as scene.exportAs() takes them
     * @param {import('./slices.mjs').Watch} [watch] `signal` ends it, and it rejects with the reason of
     *     that; `progress` is called with how much is done, 0 to 1, in place of the figure's own bar
     */
    async exportAs(format, options, watch) {
        const figure = this.#figure;
        const scene = figure?.scene;
        if (!figure || !scene) throw new KnotworkError('DISPOSED', '', 'The figure shows nothing yet.');
        const write = beginFile({ scene, view: figure.view, theme: this.#wishes().theme }, format, options);
        return figure.work.run(this.#words().text('work.export'), write, watch);
    }

    /** Frees everything at once; an element put into a page again begins anew. */
    dispose() {
        this.#kept = this.value;
        this.#preferences.abort();
        this.#figure?.dispose();
        this.#figure = undefined;
    }

    connectedCallback() {
        if (this.#figure) return;  // moved within the page
        const root = this.shadowRoot ?? this.attachShadow({ mode: 'open' });
        this.#figure = new Figure(root, {
            wishes: () => this.#wishes(),
            emit: (type, detail) => this.#emit(type, detail),
            nextTheme: () => this.#nextTheme(),
        });
        this.#followPreferences();
        this.#loadSoon();
    }

    /** An element that is moved is connected again by the end of the task, and lives on. */
    disconnectedCallback() {
        queueMicrotask(() => {
            if (!this.isConnected) this.dispose();
        });
    }

    /**
     * @param {string} name
     * @param {string | null} before
     * @param {string | null} now
     */
    attributeChangedCallback(name, before, now) {
        if (before === now || !this.#figure) return;
        if (ofLook.includes(name)) {
            this.#figure.applyWishes();
        } else {
            this.#kept = undefined;
            this.#loadSoon();
        }
    }

    /** Several attributes set in one task are one document. */
    #loadSoon() {
        if (this.#loadRequested) return;
        this.#loadRequested = true;
        queueMicrotask(async () => {
            await this.#wanted();
            this.#loadRequested = false;
            await this.#load();
        });
    }

    /** A figure further down waits until it is scrolled to, if it is told to. */
    async #wanted() {
        if (this.getAttribute('loading') === 'lazy') await this.#figure?.seen;
    }

    async #load() {
        const figure = this.#figure;
        if (!figure) return;
        this.#ready.again();
        try {
            const kept = this.#kept;
            const source = kept ? { kind: /** @type {const} */ ('inline'), text: JSON.stringify(kept) } : sourceOf(this);
            if (await figure.load(source)) this.#succeeded();
        } catch (error) {
            if (figure === this.#figure) this.#failed(error);
        }
    }

    #succeeded() {
        this.#ready.resolve(this);
        this.#emit('ready', { source: 'api' });
    }

    /** @param {any} error */
    #failed(error) {
        this.#figure?.showRefusal(error);
        this.#ready.reject(error);
        const { code = '', path = '', message } = error;
        this.#emit('error', { source: 'api', code, path, message });
    }

    /**
     * @param {string} type
     * @param {any} detail
     */
    #emit(type, detail) {
        this.dispatchEvent(new CustomEvent(type, { bubbles: true, composed: true, detail }));
    }

    /** @returns {import('./figure.mjs').Wishes} */
    #wishes() {
        const theme = this.getAttribute('theme') ?? this.#chosenTheme;
        return {
            words: this.#words(),
            controls: controlsFor(this.getAttribute('controls')),
            readOnly: this.hasAttribute('readonly'),
            theme: shownTheme(theme),
            ownTheme: !this.hasAttribute('theme'),
            still: this.getAttribute('motion') === 'reduce' || matches('(prefers-reduced-motion: reduce)'),
            wheelZoom: this.getAttribute('wheel-zoom') ?? 'modifier',
            aspect: aspectOf(this.getAttribute('aspect')),
        };
    }

    #chosenTheme = 'auto';

    #nextTheme() {
        this.#chosenTheme = themes[(themes.indexOf(this.#chosenTheme) + 1) % themes.length];
        this.#figure?.applyWishes();
    }

    #words() {
        const language = languageFor(this.closest('[lang]')?.getAttribute('lang'));
        if (this.#language?.language !== language) this.#language = new Words(language);
        return this.#language;
    }

    /** @type {Words | undefined} */
    #language;

    #followPreferences() {
        this.#preferences = new AbortController();
        for (const query of [darkScheme, moreContrast, '(prefers-reduced-motion: reduce)', 'print']) {
            matchMedia(query).addEventListener('change', () => this.#figure?.applyWishes(),
                { signal: this.#preferences.signal });
        }
    }
}

/** Registers the element, once, where there is a registry. */
export function defineFigure() {
    const registry = globalThis.customElements;
    if (registry && !registry.get(tagName)) registry.define(tagName, KnotworkFigure);
}

const darkScheme = '(prefers-color-scheme: dark)';
const moreContrast = '(prefers-contrast: more), (forced-colors: active)';

/**
 * What a wish for a theme comes to; paper is light. Where the system forces its colours, whatever is
 * asked for has them round the picture, and so the picture has the nearest that there are.
 * @param {string} theme
 * @returns {'light' | 'dark' | 'contrast' | 'contrast-dark'}
 */
function shownTheme(theme) {
    if (theme === 'contrast') return 'contrast';
    const forced = matches('(forced-colors: active)');
    const asSystem = forced || (theme !== 'dark' && theme !== 'light');
    const wantsDark = !matches('print') && (asSystem ? matches(darkScheme) : theme === 'dark');
    if (asSystem && matches(moreContrast)) return wantsDark ? 'contrast-dark' : 'contrast';
    return wantsDark ? 'dark' : 'light';
}

/** @param {string} query */
function matches(query) {
    return matchMedia(query).matches;
}

/**
 * `16/9`, `4 / 3` or `1.5` as CSS has it; the usual one for anything else.
 * @param {string | null} text
 */
function aspectOf(text) {
    const found = /^\s*(\d+(?:\.\d+)?)\s*(?:[/:]\s*(\d+(?:\.\d+)?))?\s*$/.exec(text ?? '');
    return found ? `${found[1]} / ${found[2] ?? 1}` : '16 / 9';
}

/** A promise that is made anew for each document, and whose refusal need not be listened to. */
function deferredReady() {
    /** @type {(figure: KnotworkFigure) => void} */
    let resolve = () => {};
    /** @type {(error: any) => void} */
    let reject = () => {};
    let settled = false;
    const make = () => {
        /** @type {Promise<KnotworkFigure>} */
        const promise = new Promise((yes, no) => { [resolve, reject] = [yes, no]; });
        promise.catch(() => {});
        settled = false;
        return promise;
    };
    let promise = make();
    return {
        get promise() { return promise; },
        again() { if (settled) promise = make(); },
        /** @param {KnotworkFigure} figure */
        resolve(figure) { settled = true; resolve(figure); },
        /** @param {any} error */
        reject(error) { settled = true; reject(error); },
    };
}
