// The page's gallery and tools: scenes to choose from, files out and in, help, and what is kept.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { describe, it } from 'node:test';

import { PNG } from 'pngjs';

import { pageKeys, pictureKeys } from '../../web/keys.mjs';
import { assertSilent, axeViolations, documentOf, figureReady, openFigure, settle, useBrowser } from './support.mjs';

const running = useBrowser();
const read = (file) => readFile(new URL(`../../${file}`, import.meta.url), 'utf8');

const opened = (path = '', options = {}) => openFigure(running, path, options);

const titled = (page, title) => page.waitForFunction((text) => document.querySelector('h1').textContent === text, title);

describe('the gallery', { timeout: 300_000 }, () => {
    it('has every scene with its picture in a topic of its own', async () => {
        const shown = await opened('#rose');
        const { page } = shown;
        await page.getByRole('button', { name: 'Scenes' }).click();
        const gallery = page.getByRole('dialog', { name: 'Scenes' });
        const scenes = await page.evaluate(async () =>
            (await customElements.get('knotwork-figure').api()).scenes.map(({ id }) => id));
        const links = await gallery.locator('a').evaluateAll((all) => all.map((link) => link.hash.slice(1)));
        assert.deepEqual([...links].sort(), scenes.sort());
        assert.equal(await gallery.getByRole('heading', { name: 'Others', exact: true }).count(), 0, 'every scene has a topic');
        assert.equal(await page.evaluate(() => document.activeElement.hash), '#rose', 'the one that is shown has the focus');
        await gallery.locator('a').last().scrollIntoViewIfNeeded();
        await page.waitForFunction(() => [...document.querySelectorAll('.gallery img')].at(-1).naturalWidth > 0);
        await assertSilent(shown);
        await shown.context.close();
    });

    it('is searched by text', async () => {
        const { page, context } = await opened();
        await page.getByRole('button', { name: 'Scenes' }).click();
        await page.getByRole('searchbox').fill('oslo');
        assert.deepEqual(await page.locator('.gallery .card-title:visible').allInnerTexts(), ['The Oslo algorithm']);
        assert.equal(await page.locator('.gallery [role=status]').innerText(), '1 scene');
        await page.keyboard.press('Tab');
        await page.keyboard.press('Enter');
        await titled(page, 'The Oslo algorithm');
        assert.equal(await page.getByRole('dialog').count(), 0);
        await context.close();
    });

    it('leads to the scene before and after, round and round', async () => {
        const { page, context } = await opened('#butterfly');
        await page.getByRole('button', { name: 'Next scene' }).click();
        await titled(page, 'Rose');
        await page.getByRole('button', { name: 'Previous scene' }).click();
        await titled(page, 'Butterfly');
        await page.getByRole('button', { name: 'Previous scene' }).click();
        await page.waitForFunction(() => !['', '#butterfly'].includes(location.hash) && document.title.length > 10);
        const last = await page.evaluate(() => location.hash);
        await page.getByRole('button', { name: 'Scenes' }).click();
        assert.equal(await page.locator('.gallery a').last().evaluate((link) => link.hash), last);
        await context.close();
    });
});

describe('the dialogs', { timeout: 300_000 }, () => {
    it('have nothing that axe objects to, and fit on a phone', async () => {
        for (const options of [{ colorScheme: 'light' }, { colorScheme: 'dark', viewport: { width: 320, height: 640 } }]) {
            const { page, context } = await opened('#blending-surface', options);
            for (const name of ['Scenes', 'Export', 'Help']) {
                await page.getByRole('button', { name }).click();
                const dialog = page.getByRole('dialog', { name });
                assert.deepEqual(await axeViolations(page), [], name);
                const { scrollWidth, clientWidth } = await dialog.locator('.dialog-body').evaluate((body) =>
                    ({ scrollWidth: body.scrollWidth, clientWidth: body.clientWidth }));
                assert.ok(scrollWidth <= clientWidth, `${name}: ${scrollWidth} in ${clientWidth}`);
                await page.keyboard.press('Escape');
                assert.equal(await dialog.count(), 0, `${name} is closed by Escape`);
            }
            await context.close();
        }
    });
});

describe('export', { timeout: 300_000 }, () => {
    async function saved(page, name) {
        const [download] = await Promise.all([
            page.waitForEvent('download'), page.getByRole('button', { name: `Save as ${name}`, exact: true }).click()]);
        return [download.suggestedFilename(), await readFile(await download.path())];
    }

    it('saves what is shown in every format', async () => {
        const shown = await opened('#blending-surface');
        const { page } = shown;
        await page.getByRole('button', { name: 'Export' }).click();
        for (const [name, extension, begins] of [['SVG', 'svg', /^<svg/], ['JSON', 'json', /^\{/], ['CSV', 'csv', /^\w+,/],
            ['OBJ', 'obj', /(^|\n)v /], ['STL', 'stl', /^/], ['glTF', 'gltf', /"asset"/]]) {
            const [file, bytes] = await saved(page, name);
            assert.equal(file, `a-cylinder-that-bulges.${extension}`);
            assert.match(bytes.toString('utf8'), begins);
            assert.ok(bytes.length > 200, `${name}: ${bytes.length}`);
        }
        await assertSilent(shown);
        await shown.context.close();
    });

    it('saves a picture of the size that was asked for, and leaves the one on the page alone', async () => {
        const { page, context } = await opened('#bspline-forms');
        await page.getByRole('button', { name: 'Export' }).click();
        await page.getByLabel('Width in pixels').fill('640');
        const size = () => page.evaluate(() => {
            const { width, height } = document.querySelector('knotwork-figure').shadowRoot.querySelector('canvas');
            return [width, height];
        });
        const before = await size();
        const [file, bytes] = await saved(page, 'PNG');
        const picture = PNG.sync.read(bytes);
        assert.equal(file, 'b-spline-three-forms.png');
        assert.deepEqual([picture.width, picture.height], [640, Math.round(before[1] * 640 / before[0])]);
        assert.deepEqual(await size(), before);
        await context.close();
    });

    it('offers meshes only where there are surfaces, and copies the calls as JavaScript', async () => {
        const { page, context } = await opened('#bspline-forms', { permissions: ['clipboard-read', 'clipboard-write'] });
        await page.getByRole('button', { name: 'Export' }).click();
        assert.equal(await page.getByRole('button', { name: 'Save as OBJ' }).count(), 0);
        await page.getByRole('button', { name: 'Copy as JavaScript' }).click();
        await page.getByText('The code is on the clipboard.').waitFor();
        assert.match(await page.evaluate(() => navigator.clipboard.readText()), /kw\.curve\(/);
        await context.close();
    });
});

describe('what comes in', { timeout: 300_000 }, () => {
    const cube = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n';
    const opens = [
        ['points.csv', 'x,y\n0,0\n1,2\n2,0\n3,1\n', 'point-cloud'],
        ['path.svg', '<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0C1 2 2 2 3 0"/></svg>', 'bspline-curve'],
        ['body.obj', cube, 'subdivision-surface'],
    ];

    it('is opened as a file: points, a path, a mesh', async () => {
        const shown = await opened();
        for (const [name, text, type] of opens) {
            await shown.page.locator('input[type=file]').setInputFiles({ name, mimeType: 'text/plain', buffer: Buffer.from(text) });
            await titled(shown.page, name.split('.')[0]);
            assert.equal((await documentOf(shown.page)).objects[0].type, type);
        }
        await assertSilent(shown);
        await shown.context.close();
    });

    const pasted = (page, text, selector) => page.evaluate(([content, name]) => {
        const data = new DataTransfer();
        data.setData('text/plain', content);
        document.querySelector(name).dispatchEvent(new ClipboardEvent('paste', { clipboardData: data, bubbles: true, composed: true, cancelable: true }));
    }, [text, selector]);

    it('is pasted where no field has the focus, and dropped', async () => {
        const { page, context } = await opened('#bspline-forms');
        await page.getByRole('spinbutton', { name: 'Degree', exact: true }).evaluate((input, text) => {
            const clipboardData = new DataTransfer();
            clipboardData.setData('text/plain', text);
            input.dispatchEvent(new ClipboardEvent('paste', { clipboardData, bubbles: true, composed: true, cancelable: true }));
        }, opens[0][1]);
        await settle(page);
        assert.equal((await documentOf(page)).objects[0].type, 'bspline-curve', 'a field keeps what is pasted into it');
        await pasted(page, opens[0][1], 'body');
        await titled(page, 'Your document');
        assert.equal((await documentOf(page)).objects[0].type, 'point-cloud');
        await page.evaluate((text) => {
            const dataTransfer = new DataTransfer();
            dataTransfer.items.add(new File([text], 'path.svg', { type: 'image/svg+xml' }));
            document.body.dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }));
        }, opens[1][1]);
        await titled(page, 'path');
        await context.close();
    });

    it('is refused with a reason, and what was there stays', async () => {
        const { page, context } = await opened('#bspline-forms');
        const before = await documentOf(page);
        await pasted(page, 'nothing but words', 'body');
        await page.locator('#refusal').getByText('This document cannot be shown.').waitFor();
        assert.deepEqual(await documentOf(page), before);
        await context.close();
    });
});

describe('the help', { timeout: 300_000 }, () => {
    it('names exactly the keys that are taken', async () => {
        const view = await read('src/app/view_keys.cpp');
        const taken = new Set([...view.matchAll(/name == "([^"]+)"/g)].map(([, key]) => key.replace(/^[A-Z]$/, (k) => k.toLowerCase())));
        for (const [, key] of (await read('web/figure-commands.mjs')).matchAll(/key === '([^']+)'/g)) {
            taken.add({ pagedown: 'PageDown', pageup: 'PageUp' }[key] ?? key);
        }
        for (const [, key] of (await read('web/page.mjs')).matchAll(/key !== '([^']+)'/g)) taken.add(key);
        for (const [, key] of (await read('web/figure-hands.mjs')).matchAll(/event\.key === '([^']+)'/g)) taken.add(key);
        for (const end of ['Home', 'End']) taken.delete(end);  // kept from the sliders, to no effect
        taken.add('v');  // the browser's own command for pasting
        const told = new Set([...pictureKeys, ...pageKeys].flatMap(({ keys }) => keys));
        assert.deepEqual([...told].sort(), [...taken].sort());
    });

    it('tells of each of them', async () => {
        const { page, context } = await opened();
        await page.getByRole('button', { name: 'Help' }).click();
        const rows = await page.getByRole('dialog', { name: 'Help' }).getByRole('row').allInnerTexts();
        assert.ok(rows.length >= pictureKeys.length + pageKeys.length);
        assert.ok(rows.every((row) => !/help\./.test(row)), 'every row has its words');
        assert.ok(rows.some((row) => /Ctrl or ⌘ \+ Z\s+Undo/.test(row)), rows.join('; '));
        await context.close();
    });

    it('is right about undo, wherever the focus is', async () => {
        const { page, context } = await opened('#bspline-forms');
        await page.evaluate(() => document.querySelector('knotwork-figure').scene.execute({ set: 'objects[0].degree', value: 2 }));
        await page.getByRole('button', { name: 'Next scene' }).focus();
        await page.keyboard.press('Control+z');
        assert.equal((await documentOf(page)).objects[0].degree, 3);
        await page.keyboard.press('Control+y');
        assert.equal((await documentOf(page)).objects[0].degree, 2);
        await context.close();
    });
});

describe('what was shown last', { timeout: 300_000 }, () => {
    const change = (page) => page.evaluate(() =>
        document.querySelector('knotwork-figure').scene.execute({ set: 'objects[0].degree', value: 2 }));

    it('comes back, with a way to start anew', async () => {
        const shown = await opened('#bspline-forms');
        const { page, context } = shown;
        await change(page);
        await page.goto('about:blank');
        await page.goto(running.server.url);
        await figureReady(page);
        assert.equal((await documentOf(page)).objects[0].degree, 2);
        assert.equal(await page.locator('h1').innerText(), 'B-spline: three forms');
        await page.getByRole('button', { name: 'Start anew' }).click();
        await page.waitForFunction(() => document.querySelector('knotwork-figure').value.objects[0].degree === 3);
        assert.equal(await page.locator('#notice').innerText(), '');
        await page.reload();
        await figureReady(page);
        assert.equal(await page.locator('h1').innerText(), 'Butterfly', 'nothing is kept any more');
        await assertSilent(shown);
        await context.close();
    });

    it('does not stand in the way of an address', async () => {
        const { page, context } = await opened('#bspline-forms');
        await change(page);
        await page.goto('about:blank');
        await page.goto(`${running.server.url}#rose`);
        await figureReady(page);
        await titled(page, 'Rose');
        assert.equal(await page.locator('#notice').innerText(), '');
        await context.close();
    });

    it('is not kept where storage is forbidden, and nothing is said', async () => {
        const shown = await opened('#bspline-forms', {
            script: () => Object.defineProperty(globalThis, 'localStorage', { get() { throw new DOMException('no', 'SecurityError'); } }),
        });
        await change(shown.page);
        await settle(shown.page);
        await shown.page.waitForTimeout(500);
        await assertSilent(shown);
        await shown.context.close();
    });
});
