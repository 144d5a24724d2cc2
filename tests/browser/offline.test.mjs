// The page without a network, once it has been there: kept whole, replaced whole, and only for itself.
import assert from 'node:assert/strict';
import { cp, mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import os from 'node:os';
import path from 'node:path';
import { describe, it } from 'node:test';

import { writeOffline } from '../../tools/bundle/offline.mjs';
import { serve } from '../../tools/serve.mjs';
import { distribution, figureReady, openFigure, openPage, pictureOf, until, useBrowser } from './support.mjs';

const running = useBrowser();
const allowed = { serviceWorkers: 'allow' };

/** Waits until a worker has kept everything. */
const kept = (page) => page.evaluate(async () => { await navigator.serviceWorker.ready; });

/** What was said of a network that was not there is as it should be. */
function forgive(said) {
    const rest = said.filter((line) => !/ERR_CONNECTION_REFUSED|^failed: /.test(line));
    said.length = 0;
    said.push(...rest);
}

const port = (url) => Number(new URL(url).port);

/** A page on a server of its own, which can go away. */
async function withOwnServer(act, options = {}) {
    const server = await serve(options);
    const shown = await openFigure({ ...running, server }, '#b-functions', allowed);
    await kept(shown.page);
    await act(shown, server);
    forgive(shown.said);
    await shown.context.close();
}

/** Another version of the page in the same folder: another title and another colour. */
async function nextVersion(directory) {
    for (const [name, from, to] of [['index.html', '</footer>', '<p id="next">Next</p></footer>'], ['page.css', 'body {', 'body { --next: 1;']]) {
        const text = await readFile(path.join(directory, name), 'utf8');
        assert.ok(text.includes(from), name);
        await writeFile(path.join(directory, name), text.replace(from, to));
    }
    await writeOffline(directory);
}

/** Of which version page and style are; they are of the same one always. */
const versionOf = (page) => page.evaluate(() => [
    document.getElementById('next') ? 'next' : 'first',
    getComputedStyle(document.body).getPropertyValue('--next') ? 'next' : 'first',
]);

describe('without a network', { timeout: 120_000 }, () => {
    it('the page opens with everything that belongs to it', async () => {
        await withOwnServer(async ({ page }, server) => {
            const before = await pictureOf(page);
            await server.close();
            await page.reload();
            await figureReady(page);
            assert.ok((await pictureOf(page)).equals(before));
            await page.getByRole('combobox', { name: 'Language' }).selectOption('nb');
            await page.getByRole('button', { name: 'Scener' }).click();
            await page.waitForFunction(() => {
                const pictures = [...document.querySelectorAll('.gallery img')];
                return pictures.length > 20 && pictures.every(({ complete, naturalWidth }) => complete && naturalWidth > 0);
            });
            await page.goto(`${server.url}?src=missing.json#rose`);
            await figureReady(page);
            assert.equal(await page.locator('h1').innerText(), 'Rose');
        }, { directory: distribution });
    });

    it('a newer version takes the place of the older one as a whole', async () => {
        const directory = await mkdtemp(path.join(os.tmpdir(), 'knotwork-'));
        await cp(distribution, directory, { recursive: true });
        await withOwnServer(async ({ page }, server) => {
            assert.deepEqual(await versionOf(page), ['first', 'first']);
            const [first] = await page.evaluate(() => caches.keys());
            await nextVersion(directory);
            await page.reload();
            await figureReady(page);
            assert.deepEqual(await versionOf(page), ['next', 'next'], 'the network has it');
            await until(page, async (former) => {
                const names = await caches.keys();
                return names.length === 1 && names[0] !== former;
            }, first);
            await server.close();
            await page.reload();
            await figureReady(page);
            assert.deepEqual(await versionOf(page), ['next', 'next'], 'and so has the worker');
        }, { directory });
        await rm(directory, { recursive: true });
    });

    it('what another server says in the same place is not touched', async () => {
        const directory = await mkdtemp(path.join(os.tmpdir(), 'knotwork-'));
        await writeFile(path.join(directory, 'index.html'), '<!doctype html><title>Another</title><link rel="icon" href="favicon.svg">'
            + '<link rel="stylesheet" href="page.css">');
        await writeFile(path.join(directory, 'page.css'), 'body { --next: 1 }');
        await writeFile(path.join(directory, 'favicon.svg'), '<svg xmlns="http://www.w3.org/2000/svg"/>');
        await withOwnServer(async ({ page }, server) => {
            await server.close();
            const other = await serve({ directory, port: port(server.url) });
            await page.reload();
            assert.equal(await page.title(), 'Another');
            assert.equal((await versionOf(page))[1], 'next');
            await other.close();
        }, { directory: distribution });
        await rm(directory, { recursive: true });
    });
});

describe('nothing is kept', { timeout: 120_000 }, () => {
    const registrations = (page) => page.evaluate(async () => {
        await new Promise((done) => { setTimeout(done, 1500); });
        return (await navigator.serviceWorker.getRegistrations()).length;
    });

    it('for figures in other pages, for the page in a frame, and for the one-file page', async () => {
        const places = {
            'figure.html': '<knotwork-figure scene="rose"></knotwork-figure>',
            'frame.html': '<iframe src="index.html" title="Knotwork" width="900" height="700"></iframe>',
            'standalone.html': undefined,
        };
        for (const [name, html] of Object.entries(places)) {
            const { page, context } = await openPage(running, name, { ...allowed, html });
            await page.waitForTimeout(500);
            assert.equal(await registrations(page), 0, name);
            await context.close();
        }
    });
});

describe('the page', { timeout: 60_000 }, () => {
    it('can be installed, with an icon of its own in every size', async () => {
        const { page, context } = await openFigure(running, '', allowed);
        await kept(page);
        const devtools = await context.newCDPSession(page);
        const { errors, url } = await devtools.send('Page.getAppManifest');
        assert.deepEqual([errors, url], [[], `${running.server.url}manifest.json`]);
        const { installabilityErrors } = await devtools.send('Page.getInstallabilityErrors');
        assert.deepEqual(installabilityErrors.filter(({ errorId }) => errorId !== 'in-incognito'), []);
        const sizes = await page.evaluate(async () => {
            const { icons } = await (await fetch('manifest.json')).json();
            return Promise.all(icons.filter(({ type }) => type === 'image/png').map(async ({ src, sizes: told }) => {
                const picture = await createImageBitmap(await (await fetch(src)).blob());
                return `${picture.width}x${picture.height}` === told;
            }));
        });
        assert.deepEqual(sizes, [true, true, true]);
        await context.close();
    });
});
