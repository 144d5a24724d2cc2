// The page as one file, where nothing else can be loaded.
import assert from 'node:assert/strict';
import path from 'node:path';
import { describe, it } from 'node:test';
import { pathToFileURL } from 'node:url';

import { assertSilent, distribution, figureReady, openPage, pictureOf, useBrowser } from './support.mjs';

const running = useBrowser();

describe('the one-file page', { timeout: 120_000 }, () => {
    it('draws from a stick, without a word on the console', async () => {
        const server = { url: pathToFileURL(path.join(distribution, path.sep)).href };
        const shown = await openPage({ ...running, server }, 'standalone.html');
        await figureReady(shown.page);
        assert.ok((await pictureOf(shown.page)).length > 5000, 'there is something in the picture');
        assert.deepEqual(shown.fetched.filter((url) => !url.startsWith('data:')), [`${server.url}standalone.html`]);
        await assertSilent(shown);
        await shown.context.close();
    });

    it('draws the pictures of its gallery itself', async () => {
        const server = { url: pathToFileURL(path.join(distribution, path.sep)).href };
        const shown = await openPage({ ...running, server }, 'standalone.html');
        await figureReady(shown.page);
        await shown.page.getByRole('button', { name: 'Scenes' }).click();
        await shown.page.waitForFunction(() => {
            const pictures = [...document.querySelectorAll('.gallery img')];
            return pictures.length > 20 && pictures.every(({ src }) => src.startsWith('data:')) && pictures[0].naturalWidth > 0;
        });
        await assertSilent(shown);
        await shown.context.close();
    });

    it('draws in a frame that may do nothing but run scripts', async () => {
        const { page, context, said } = await openPage(running, 'frame.html', {
            html: '<iframe sandbox="allow-scripts" src="standalone.html" title="Knotwork" width="900" height="700"></iframe>',
            serviceWorkers: 'allow',  // to block them, scripts would have to be run that such a frame forbids
        });
        const frame = await (await page.waitForSelector('iframe')).contentFrame();
        await figureReady(frame);
        assert.ok((await pictureOf(frame)).length > 5000);
        assert.deepEqual(said, []);
        await context.close();
    });
});
