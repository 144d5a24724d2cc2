// The accessibility trees of pages and figures against those that were read and found good.
// UPDATE_GOLDENS=1 writes them anew; read what has changed afterwards.
import assert from 'node:assert/strict';
import { readFile, writeFile } from 'node:fs/promises';
import { describe, it } from 'node:test';

import { openFigure, settle, useBrowser } from './support.mjs';
import { accessibilityTree } from './tree.mjs';

const running = useBrowser();
const locales = { en: 'en-GB', nb: 'nb-NO' };

async function compare(page, name) {
    const file = new URL(`trees/${name}.txt`, import.meta.url);
    const tree = await accessibilityTree(page);
    if (process.env.UPDATE_GOLDENS === '1') await writeFile(file, tree);
    assert.equal(tree, await readFile(file, 'utf8'));
}

/** The page as it opens on a scene, and what people do next in it. */
const pages = {
    'bspline-forms': async () => {},
    'blending-compare': async () => {},
    'b-function-axioms': async () => {},
    'subdivision-surfaces': async () => {},
    'knot-insertion': (page) => page.evaluate(() => document.querySelector('knotwork-figure').step(2)),
    'local-control': (page) => page.evaluate(() => {
        document.querySelector('knotwork-figure').focusPoint('objects[1].points[2]');
    }),
};

const names = {
    en: { scenes: 'Scenes', help: 'Help' },
    nb: { scenes: 'Scener', help: 'Hjelp' },
};

/** What opens over the page. */
const dialogs = {
    gallery: (page, words) => page.getByRole('button', { name: words.scenes }).click(),
    help: (page, words) => page.getByRole('button', { name: words.help }).click(),
};

const figures = {
    'figure-minimal': '<knotwork-figure scene="butterfly" controls="minimal"></knotwork-figure>',
    'figure-readonly': '<knotwork-figure scene="bspline-forms" readonly></knotwork-figure>',
    'figure-alone': '<knotwork-figure scene="blending-surface" controls="none"></knotwork-figure>',
};

for (const [language, locale] of Object.entries(locales)) {
    describe(`the accessibility tree in ${language}`, { timeout: 120_000 }, () => {
        for (const [scene, act] of Object.entries(pages)) {
            it(`of the page that shows ${scene} is as it was found good`, async () => {
                const { page, context } = await openFigure(running, `#${scene}`, { locale });
                await act(page);
                await settle(page);
                await compare(page, `${scene}.${language}`);
                await context.close();
            });
        }

        it('of what opens over the page is as it was found good', async () => {
            const { page, context } = await openFigure(running, '#bspline-forms', { locale });
            for (const [name, open] of Object.entries(dialogs)) {
                await open(page, names[language]);
                await page.locator('dialog[open]').waitFor();
                await compare(page, `${name}.${language}`);
                await page.keyboard.press('Escape');
            }
            await context.close();
        });

        it('of figures in the page of somebody else is as it was found good', async () => {
            for (const [name, markup] of Object.entries(figures)) {
                const html = `<div lang="${language}">${markup}</div>`;
                const { page, context } = await openFigure(running, 'figure.html', { html, locale });
                await compare(page, `${name}.${language}`);
                await context.close();
            }
        });
    });
}
