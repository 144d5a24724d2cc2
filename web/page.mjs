// The page: chooses what its one figure shows, and lets people open, share, and read it in their
// language and light.

import { KnotworkFigure } from './element.mjs';
import { el, icon, setText } from './dom.mjs';
import { parseText } from './figure-source.mjs';
import { icons } from './icons.mjs';
import { remember, remembered } from './preferences.mjs';
import { languageFor, languages, Words } from './words.mjs';

const firstScene = 'butterfly';
const themes = ['auto', 'light', 'dark'];
const largestFile = 1024 * 1024;  // bytes: what a document may have

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

    constructor() {
        this.words = new Words(remembered('language', languages) ?? languageFor(navigator.language));
        this.#setTheme(remembered('theme', themes) ?? 'auto');
        this.#speak();
        this.#acceptDrops();
        window.addEventListener('hashchange', () => this.route());
        this.figure.addEventListener('change', () => this.#title());
    }

    async start() {
        try {
            this.kw = await KnotworkFigure.api();
        } catch (error) {
            this.#refuse(error);
            return;
        }
        this.scenes = this.kw.scenes;
        this.#listScenes();
        await this.route();
    }

    /** Shows what the address asks for; the butterfly stands in for what cannot be shown. */
    async route() {
        const asked = decodeURIComponent(location.hash.slice(1));
        const src = new URLSearchParams(location.search).get('src');
        if (/^v\d+\./.test(asked)) await this.#show(async () => this.kw.decodeLink(location.hash));
        else if (this.#isScene(asked)) await this.#show(async () => asked);
        else if (src) await this.#show(() => fetchDocument(this.words, src));
        else await this.#show(async () => firstScene);
        if (!this.figure.scene) await this.figure.show(firstScene).then(() => this.#shown(firstScene), () => {});
    }

    /** @param {string} name */
    #isScene(name) {
        return this.scenes.some(({ id }) => id === name);
    }

    /** @param {() => Promise<any>} find a document, or the name of a scene */
    async #show(find) {
        try {
            const found = await find();
            await this.figure.show(found);
            this.#dismiss();
            this.#shown(typeof found === 'string' ? found : '');
        } catch (error) {
            this.#refuse(error);
        }
    }

    /** @param {string} name */
    #shown(name) {
        this.sceneName = name;
        this.#title();
        for (const link of byId('scenes').querySelectorAll('a')) {
            const here = link.hash === `#${name}`;
            if (here) link.setAttribute('aria-current', 'true');
            else link.removeAttribute('aria-current');
            if (here) bringIntoSight(byId('scenes'), link);
        }
    }

    #title() {
        const { title, description } = this.figure.value ?? {};
        const shown = this.words.scene(this.sceneName, 'title', title || this.words.text('page.own'));
        setText(byId('title'), shown);
        setText(byId('description'), this.words.scene(this.sceneName, 'description', description ?? ''));
        document.title = `${shown} – Knotwork`;
    }

    #listScenes() {
        // A link with nothing but a fragment, before the first that leads away, passes for one that
        // skips to a place of the page.
        const [here] = location.href.split('#', 1);
        byId('scenes').replaceChildren(...this.scenes.map(({ id, title }) => el('a', {
            text: this.words.scene(id, 'title', title), attributes: { href: `${here}#${id}` },
        })));
    }

    // Opening and sharing

    /** @param {File} file */
    async open(file) {
        await this.#show(async () => {
            if (file.size > largestFile) {
                throw { code: 'TOO_LARGE', message: this.words.text('page.file.size', { name: file.name }) };
            }
            return parseText(await file.text(), file.name);
        });
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

    #acceptDrops() {
        const over = (/** @type {boolean} */ on) => document.body.toggleAttribute('data-dropping', on);
        document.addEventListener('dragover', (event) => {
            event.preventDefault();
            over(true);
        });
        document.addEventListener('dragleave', (event) => {
            if (!event.relatedTarget) over(false);
        });
        document.addEventListener('drop', (event) => {
            event.preventDefault();
            over(false);
            const file = event.dataTransfer?.files[0];
            if (file) this.open(file);
        });
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
        this.#buildTools();
        if (this.scenes.length > 0) this.#listScenes();
        if (this.figure.scene) this.#shown(this.sceneName);
    }

    #buildTools() {
        const { words } = this;
        const file = el('input', {
            class: 'aside',
            attributes: { type: 'file', accept: '.json,application/json', 'aria-label': words.text('page.open.label') },
            on: {
                change: () => {
                    if (file.files?.[0]) this.open(file.files[0]);
                    file.value = '';
                },
            },
        });
        const open = el('label', { class: 'tool' }, icon(icons.open), el('span', { text: words.text('page.open') }), file);
        const share = el('button', { class: 'tool', attributes: { type: 'button' }, on: { click: () => this.#share() } },
            icon(icons.share), el('span', { text: words.text('page.share') }));
        byId('tools').replaceChildren(open, share, this.#languageMenu(), this.#themeMenu());
    }

    #languageMenu() {
        const names = { en: 'English', nb: 'Norsk' };
        return menu(this.words.text('page.language'), Object.entries(names), this.words.language, (language) => {
            remember('language', language);
            this.words = new Words(language);
            this.#speak();
            byId('tools').querySelector('select')?.focus();
        });
    }

    #themeMenu() {
        const entries = themes.map((theme) => /** @type {[string, string]} */ ([theme, this.words.text(`theme.${theme}`)]));
        return menu(this.words.text('theme'), entries, this.theme ?? 'auto', (theme) => {
            remember('theme', theme);
            this.#setTheme(theme);
        });
    }

    /** @param {string | undefined} theme */
    #setTheme(theme = 'auto') {
        this.theme = theme;
        document.documentElement.dataset.theme = theme;
        this.figure.setAttribute('theme', theme);
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
        this.sayTimer = setTimeout(() => byId('said').classList.remove('shown'), 4000);
    }

    /** @type {ReturnType<typeof setTimeout> | undefined} */
    sayTimer;
}

/**
 * Scrolls a row, and nothing else, so far that this item of it can be seen.
 * @param {HTMLElement} row
 * @param {HTMLElement} item
 */
function bringIntoSight(row, item) {
    const [outer, inner] = [row.getBoundingClientRect(), item.getBoundingClientRect()];
    if (inner.left < outer.left) row.scrollLeft += inner.left - outer.left;
    else if (inner.right > outer.right) row.scrollLeft += inner.right - outer.right;
}

/**
 * @param {string} label
 * @param {[string, string][]} entries value and text
 * @param {string} chosen
 * @param {(value: string) => void} choose
 */
function menu(label, entries, chosen, choose) {
    const options = entries.map(([value, text]) => el('option', { text, attributes: { value, selected: value === chosen } }));
    const select = el('select', {
        class: 'tool', attributes: { 'aria-label': label, title: label },
        on: { change: () => choose(select.value) },
    }, ...options);
    return select;
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
