// The page: chooses what its one figure shows, and lets people open, share, save, and read it in
// their language and light.

import { forgetKept, keepNow, keepSoon, kept } from './autosave.mjs';
import { el, setText } from './dom.mjs';
import { KnotworkFigure } from './element.mjs';
import { openExport } from './export-dialog.mjs';
import { parseText } from './figure-source.mjs';
import { openGallery } from './gallery.mjs';
import { openHelp } from './help.mjs';
import { acceptDrops, acceptPastes, documentOf, readFile, takesText } from './incoming.mjs';
import { keepForOffline } from './offline.mjs';
import { sceneButtons, themes, toolButtons } from './page-bar.mjs';
import { remember, remembered } from './preferences.mjs';
import { byTopic } from './topics.mjs';
import { languageFor, languages, Words } from './words.mjs';

const firstScene = 'butterfly';
const sayFor = 4000;  // milliseconds

/**
 * @template {HTMLElement} T
 * @param {string} id
 * @returns {T}
 */
const byId = (id) => /** @type {T} */ (document.getElementById(id));

class Page {
    figure = /** @type {KnotworkFigure} */ (byId('figure'));
    /** The built-in scene that is shown, '' for a document of the reader's own. */
    sceneName = '';
    /** @type {any[]} */
    scenes = [];
    theme = remembered('theme', themes) ?? 'auto';
    /** @type {ReturnType<typeof setTimeout> | undefined} */
    sayTimer;

    constructor() {
        this.words = new Words(remembered('language', languages) ?? languageFor(navigator.language));
        this.#dress(this.theme);
        this.#speak();
        acceptDrops((file) => this.open(file));
        acceptPastes((incoming) => this.open(incoming));
        document.addEventListener('keydown', (event) => this.#key(event));
        window.addEventListener('hashchange', () => this.route());
        window.addEventListener('pagehide', () => keepNow());
        this.figure.addEventListener('change', (event) => this.#changed(/** @type {CustomEvent} */ (event).detail.path));
        document.querySelector('.skip')?.addEventListener('click', (event) => {
            event.preventDefault();  // the address names the scene
            this.figure.focus();
        });
    }

    async start() {
        try {
            this.kw = await KnotworkFigure.api();
        } catch (error) {
            this.#refuse(error);
            return;
        }
        this.scenes = byTopic(this.kw.scenes).flatMap(({ scenes }) => scenes);
        const last = location.hash || location.search ? undefined : kept();
        if (last) await this.#restore(last);
        else await this.route();
    }

    // What is shown

    /** Shows what the address asks for; the butterfly stands in for what cannot be shown. */
    async route() {
        const asked = decodeURIComponent(location.hash.slice(1));
        const src = new URLSearchParams(location.search).get('src');
        if (/^v\d+\./.test(asked)) await this.#show(async () => this.kw.decodeLink(location.hash));
        else if (this.#isScene(asked)) await this.#show(async () => asked);
        else if (src) await this.#show(() => fetchDocument(this.words, src));
        else await this.#show(async () => firstScene);
        await this.#showAnything();
    }

    async #showAnything() {
        if (!this.figure.scene) await this.figure.show(firstScene).then(() => this.#shown(firstScene), () => {});
    }

    /** @param {string} name */
    #isScene(name) {
        return this.scenes.some(({ id }) => id === name);
    }

    /**
     * @param {() => Promise<any>} find a document, or the name of a scene
     * @param {string} [of] the built-in scene that the document was
     */
    async #show(find, of = '') {
        try {
            const found = await find();
            await this.figure.show(found);
            this.#dismiss();
            byId('notice').replaceChildren();
            this.#shown(typeof found === 'string' ? found : of);
            return true;
        } catch (error) {
            this.#refuse(error);
            return false;
        }
    }

    /** @param {{ document: any, name: string }} last */
    async #restore(last) {
        if (!await this.#show(async () => last.document, last.name)) {
            forgetKept();
            await this.#showAnything();
            return;
        }
        const anew = el('button', {
            class: 'button-plain', text: this.words.text('page.anew'), attributes: { type: 'button' },
            on: { click: () => this.#startAnew() },
        });
        byId('notice').replaceChildren(el('p', { text: this.words.text('page.restored') }), anew);
    }

    async #startAnew() {
        forgetKept();
        await this.#show(async () => (this.#isScene(this.sceneName) ? this.sceneName : firstScene));
        byId('current').closest('button')?.focus();
    }

    /** @param {string} name */
    #shown(name) {
        this.sceneName = name;
        this.#title();
    }

    /** @param {string} path of what is other than before, '' for anything */
    #changed(path) {
        if (!/^(objects|effects|view)\b/.test(path)) this.#title();
        this.#keep();
    }

    #keep() {
        keepSoon(() => ({ document: this.figure.value, name: this.sceneName }));
    }

    #title() {
        const { title, description } = this.figure.value ?? {};
        const shown = this.words.scene(this.sceneName, 'title', title || this.words.text('page.own'));
        setText(byId('title'), shown);
        setText(byId('current'), shown);
        setText(byId('description'), this.words.scene(this.sceneName, 'description', description ?? ''));
        document.title = `${shown} – Knotwork`;
    }

    /** @param {number} step */
    #goBy(step) {
        const count = this.scenes.length;
        const here = this.scenes.findIndex(({ id }) => id === this.sceneName);
        const next = here < 0 ? (step < 0 ? count - 1 : 0) : (here + step + count) % count;
        if (count > 0) location.hash = this.scenes[next].id;
    }

    #openGallery() {
        if (!this.kw) return;
        const { words, kw, scenes, sceneName: shown } = this;
        openGallery({ words, kw, scenes, shown, dark: this.#isDark() });
    }

    // Coming in and going out

    /** @param {File | import('./incoming.mjs').Incoming} incoming */
    async open(incoming) {
        const shown = await this.#show(async () => {
            const read = incoming instanceof File ? await readFile(incoming, this.words) : incoming;
            return documentOf(this.kw, read, this.words);
        });
        if (!shown) return;
        history.replaceState(null, '', location.pathname + location.search);
        this.#keep();
    }

    async #share() {
        const link = await this.kw.encodeLink(this.figure.value);
        try {
            history.replaceState(null, '', link);
        } catch {
            location.hash = link;  // a page without an origin of its own may not touch its history
        }
        const copied = await navigator.clipboard?.writeText(location.href).then(() => true, () => false);
        this.#say(this.words.text(copied ? 'page.share.done' : 'page.share.shown'));
    }

    /** @param {KeyboardEvent} event */
    #key(event) {
        if (event.defaultPrevented || !(event.ctrlKey || event.metaKey) || event.altKey) return;
        if (takesText(event.composedPath()[0]) || document.querySelector('dialog[open]')) return;
        const key = event.key.toLowerCase();
        if (key !== 'z' && key !== 'y') return;
        event.preventDefault();
        if (key === 'y' || event.shiftKey) this.figure.redo();
        else this.figure.undo();
    }

    // Language and light

    #speak() {
        document.documentElement.lang = this.words.language;
        this.figure.setAttribute('lang', this.words.language);
        for (const element of document.querySelectorAll('[data-words]')) {
            setText(element, this.words.text(element.getAttribute('data-words') ?? ''));
        }
        for (const element of document.querySelectorAll('[data-words-label]')) {
            element.setAttribute('aria-label', this.words.text(element.getAttribute('data-words-label') ?? ''));
        }
        document.body.dataset.dropHere = this.words.text('page.drop');
        const actions = this.#actions();
        byId('where').replaceChildren(...sceneButtons(this.words, actions));
        byId('tools').replaceChildren(...toolButtons(this.words, actions, this.theme));
        if (this.figure.scene) this.#title();
    }

    /** @returns {import('./page-bar.mjs').BarActions} */
    #actions() {
        return {
            gallery: () => this.#openGallery(),
            step: (step) => this.#goBy(step),
            open: (file) => this.open(file),
            share: () => this.#share(),
            save: () => this.figure.scene && openExport(this.words, this.figure),
            fullScreen: () => this.figure.requestFullscreen().catch((error) => this.#say(String(error.message))),
            help: () => openHelp(this.words),
            speak: (language) => {
                remember('language', language);
                this.words = new Words(language);
                this.#speak();
                byId('tools').querySelector('select')?.focus();
            },
            dress: (theme) => {
                remember('theme', theme);
                this.#dress(theme);
            },
        };
    }

    /** @param {string} theme */
    #dress(theme) {
        this.theme = theme;
        document.documentElement.dataset.theme = theme;
        this.figure.setAttribute('theme', theme);
    }

    #isDark() {
        return this.theme === 'dark' || (this.theme === 'auto' && matchMedia('(prefers-color-scheme: dark)').matches);
    }

    // Telling

    /** @param {any} error */
    #refuse(error) {
        const { words } = this;
        const lines = [el('p', { class: 'lead', text: words.text('refused.scene') }), el('p', { text: words.refusal(error) })];
        const where = [error.code, error.path].filter(Boolean).join(' · ');
        if (where) lines.push(el('p', {}, el('code', { text: where })));
        if (this.figure.scene) lines.push(el('p', { text: words.text('refused.kept') }));
        const dismiss = el('button', {
            class: 'tool', text: words.text('page.dismiss'), attributes: { type: 'button' },
            on: { click: () => this.#dismiss() },
        });
        byId('refusal').replaceChildren(el('div', {}, ...lines), dismiss);
    }

    #dismiss() {
        byId('refusal').replaceChildren();
    }

    /** @param {string} sentence */
    #say(sentence) {
        setText(byId('said'), sentence);
        byId('said').classList.add('shown');
        clearTimeout(this.sayTimer);
        this.sayTimer = setTimeout(() => byId('said').classList.remove('shown'), sayFor);
    }
}

/**
 * @param {Words} words
 * @param {string} address
 */
async function fetchDocument(words, address) {
    const url = new URL(address, document.baseURI).href;
    let reason = '';
    try {
        const response = await fetch(url);
        if (response.ok) return parseText(await response.text(), url);
        reason = `${response.status} ${response.statusText}`;
    } catch (error) {
        if (!(error instanceof TypeError)) throw error;
        reason = error.message;
    }
    throw { code: '', path: '', message: words.text('page.fetch', { url, reason }) };
}

await new Page().start();
keepForOffline();
