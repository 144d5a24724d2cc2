// The gallery: every built-in scene with its picture, by topic, in a dialog.

import { openDialog } from './dialog.mjs';
import { el, setText } from './dom.mjs';
import { byTopic } from './topics.mjs';

/** @typedef {import('./words.mjs').Words} Words */
/** @typedef {{ id: string, title: string, description: string, document: any }} ListedScene */

/** As tools/bundle/gallery.mjs draws them. */
const size = { width: 480, height: 300 };

/**
 * @typedef {object} GalleryHost
 * @property {Words} words
 * @property {any} kw
 * @property {ListedScene[]} scenes
 * @property {string} shown id of the scene that is shown
 * @property {boolean} dark
 */

/** @param {GalleryHost} host */
export function openGallery(host) {
    const { words } = host;
    const groups = byTopic(host.scenes).map((group) => makeGroup(host, group));
    const found = el('p', { class: 'quiet', attributes: { role: 'status' } });
    const search = el('input', {
        class: 'search',
        attributes: { type: 'search', 'aria-label': words.text('gallery.search'), placeholder: words.text('gallery.search') },
        on: { input: () => filter(words, groups, search.value, found) },
    });
    const dialog = openDialog(words, words.text('page.scenes'), 'gallery', el('div', { class: 'finder' }, search), found,
        ...groups.map(({ element }) => element));
    dialog.addEventListener('click', (event) => {
        if (/** @type {Element} */ (event.target).closest('a')) dialog.close();
    });
    /** @type {HTMLElement | null} */ (dialog.querySelector('[aria-current]'))?.focus();
    if (standsAlone()) drawPictures(host, groups.flatMap(({ items }) => items));
    return dialog;
}

/**
 * @param {GalleryHost} host
 * @param {{ topic: string, scenes: ListedScene[] }} group
 */
function makeGroup(host, { topic, scenes }) {
    const items = scenes.map((scene) => makeItem(host, scene));
    const element = el('section', {}, el('h3', { text: host.words.text(`topic.${topic}`) }),
        el('ul', { class: 'cards' }, ...items.map((item) => item.element)));
    return { element, items };
}

/** @param {GalleryHost} host @param {ListedScene} scene */
function makeItem(host, scene) {
    const { id, title, description } = scene;
    const shownTitle = host.words.scene(id, 'title', title);
    const shownText = host.words.scene(id, 'description', description);
    const src = standsAlone() ? null : `gallery/${id}${host.dark ? '.dark' : ''}.svg`;
    const picture = el('img', { attributes: { src, loading: 'lazy', decoding: 'async', alt: '', ...size } });
    // A link with nothing but a fragment, before the first that leads away, passes for one that
    // skips to a place of the page.
    const [here] = location.href.split('#', 1);
    const link = el('a', {
        class: 'card',
        attributes: { href: `${here}#${id}`, 'aria-current': id === host.shown ? 'true' : null },
    }, picture, el('span', { class: 'card-title', text: shownTitle }), el('span', { class: 'card-text', text: shownText }));
    return { scene, picture, element: el('li', {}, link), text: `${shownTitle} ${shownText} ${id}`.toLowerCase() };
}

/** Whether the page is one file, with no pictures beside it. */
const standsAlone = () => document.getElementById('knotwork-wasm') !== null;

/**
 * Draws the pictures here and now, one a task, so that the page is never blocked for long.
 * @param {GalleryHost} host
 * @param {ReturnType<typeof makeItem>[]} items
 */
function drawPictures(host, [item, ...rest]) {
    if (!item?.element.isConnected) return;
    const scene = host.kw.scene(item.scene.document);
    const picture = scene.svg({ ...size, theme: host.dark ? 'dark' : 'light', background: 'none' });
    scene.dispose();
    item.picture.src = `data:image/svg+xml,${encodeURIComponent(picture)}`;
    setTimeout(() => drawPictures(host, rest));
}

/**
 * @param {Words} words
 * @param {ReturnType<typeof makeGroup>[]} groups
 * @param {string} sought
 * @param {HTMLElement} found
 */
function filter(words, groups, sought, found) {
    const parts = sought.toLowerCase().split(/\s+/);
    let count = 0;
    for (const { element, items } of groups) {
        const fitting = items.filter(({ text }) => parts.every((part) => text.includes(part)));
        for (const item of items) item.element.hidden = !fitting.includes(item);
        element.hidden = fitting.length === 0;
        count += fitting.length;
    }
    setText(found, sought.trim() === '' ? '' : words.text('gallery.found', { count }));
}
