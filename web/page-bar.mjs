// The bar of the page: which scene is shown and how to come to another, and the page's own tools.

import { el, icon } from './dom.mjs';
import { icons } from './icons.mjs';

/** @typedef {import('./words.mjs').Words} Words */

/** The page's themes; the last one is for eyes that need more contrast. */
export const themes = ['auto', 'light', 'dark', 'contrast'];

const languageNames = { en: 'English', nb: 'Norsk' };

/**
 * @typedef {object} BarActions
 * @property {() => void} gallery
 * @property {(step: number) => void} step to the scene before or after
 * @property {(file: File) => void} open
 * @property {() => void} share
 * @property {() => void} save
 * @property {() => void} fullScreen
 * @property {() => void} help
 * @property {(language: string) => void} speak
 * @property {(theme: string) => void} dress
 */

/** @param {Words} words @param {BarActions} actions */
export function sceneButtons(words, actions) {
    const scenes = el('button', {
        class: 'tool scenes', attributes: { type: 'button', 'aria-haspopup': 'dialog' }, on: { click: actions.gallery },
    }, icon(icons.scenes), el('span', { class: 'word', text: words.text('page.scenes') }),
    el('span', { class: 'current', attributes: { id: 'current' } }));
    return [scenes, tool(words, 'previous', 'page.previous', () => actions.step(-1)),
        tool(words, 'next', 'page.next', () => actions.step(1))];
}

/** @param {Words} words @param {BarActions} actions @param {string} theme */
export function toolButtons(words, actions, theme) {
    const languages = Object.entries(languageNames);
    const lights = themes.map((name) => /** @type {[string, string]} */ ([name, words.text(`theme.${name}`)]));
    return [
        openTool(words, actions.open),
        tool(words, 'share', 'page.share', actions.share, true),
        tool(words, 'save', 'page.export', actions.save, true),
        menu(words.text('page.language'), 'language', languages, words.language, actions.speak),
        menu(words.text('theme'), 'theme', lights, theme, actions.dress),
        document.fullscreenEnabled ? tool(words, 'fullScreen', 'page.fullscreen', actions.fullScreen) : null,
        tool(words, 'help', 'page.help', actions.help),
    ].filter((element) => element !== null);
}

/**
 * @param {Words} words
 * @param {string} name of the icon
 * @param {string} key of the words
 * @param {() => void} act
 * @param {boolean} [captioned]
 */
function tool(words, name, key, act, captioned = false) {
    const text = words.text(key);
    const caption = captioned ? el('span', { class: 'word', text }) : null;
    return el('button', {
        class: 'tool', attributes: { type: 'button', title: text, 'aria-label': captioned ? null : text, 'data-tool': name },
        on: { click: act },
    }, icon(icons[name]), caption);
}

/** @param {Words} words @param {(file: File) => void} open */
function openTool(words, open) {
    const file = el('input', {
        class: 'aside',
        attributes: {
            type: 'file', accept: '.json,.csv,.txt,.tsv,.svg,.obj', 'aria-label': words.text('page.open.label'),
        },
        on: {
            change: () => {
                if (file.files?.[0]) open(file.files[0]);
                file.value = '';
            },
        },
    });
    return el('label', { class: 'tool', attributes: { title: words.text('page.open.label') } },
        icon(icons.open), el('span', { class: 'word', text: words.text('page.open') }), file);
}

/**
 * @param {string} label
 * @param {string} name of the icon
 * @param {[string, string][]} entries value and text
 * @param {string} chosen
 * @param {(value: string) => void} choose
 */
function menu(label, name, entries, chosen, choose) {
    const options = entries.map(([value, text]) => el('option', { text, attributes: { value, selected: value === chosen } }));
    const select = el('select', {
        attributes: { 'aria-label': label, title: label }, on: { change: () => choose(select.value) },
    }, ...options);
    return el('span', { class: 'tool menu' }, icon(icons[name]), select);
}
