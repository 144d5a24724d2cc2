// Several figures on one page of somebody else's.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';

import { PNG } from 'pngjs';

import { assertSilent, documentOf, figureReady, openPage, pictureOf, settle, until, useBrowser } from './support.mjs';

const running = useBrowser();

const css = 'body { margin: 0; width: 600px } .tall { height: 3000px } knotwork-figure { --knotwork-height: 320px }';
const two = `<knotwork-figure id="a" scene="butterfly" controls="none"></knotwork-figure>
    <knotwork-figure id="b" scene="bspline-forms" controls="minimal"></knotwork-figure>`;

async function opened(html, options = {}) {
    const shown = await openPage(running, 'embedding.html', { html, css, ...options });
    return shown;
}

async function openedTwo(options) {
    const shown = await opened(two, options);
    await figureReady(shown.page, '#a');
    await figureReady(shown.page, '#b');
    return shown;
}

/** How many different colours a picture has. */
function colours(png) {
    const { data } = PNG.sync.read(png);
    const found = new Set();
    for (let k = 0; k < data.length; k += 4) found.add(data.readUInt32BE(k));
    return found.size;
}

const stats = (page) => page.evaluate(async () => customElements.get('knotwork-figure').stats());

describe('figures on one page', { timeout: 300_000 }, () => {
    it('share one module and one WebGL context, and both draw', async () => {
        const shown = await openedTwo();
        assert.equal(shown.fetched.filter((url) => url.endsWith('.wasm')).length, 1);
        assert.equal(await shown.page.evaluate(() => globalThis.observed.contexts.length), 1);
        const pictures = [await pictureOf(shown.page, '#a'), await pictureOf(shown.page, '#b')];
        for (const picture of pictures) assert.ok(colours(picture) > 50, 'lines with smooth edges');
        assert.ok(!pictures[0].equals(pictures[1]));
        assert.equal((await stats(shown.page)).views, 2);
        await assertSilent(shown);
        await shown.context.close();
    });

    it('all draw when there are more than a browser grants contexts', async () => {
        const count = 24;
        const scenes = ['butterfly', 'bspline-forms', 'b-functions'];
        const figures = Array.from({ length: count }, (_, k) =>
            `<knotwork-figure id="f${k}" scene="${scenes[k % 3]}" controls="none"></knotwork-figure>`);
        const shown = await opened(figures.join(''), { viewport: { width: 700, height: 330 * count } });
        for (let k = 0; k < count; k += 1) await figureReady(shown.page, `#f${k}`);
        const pictures = [];
        for (let k = 0; k < count; k += 1) pictures.push(await pictureOf(shown.page, `#f${k}`));
        assert.ok(colours(pictures[0]) > 50);
        for (let k = 3; k < count; k += 1) assert.ok(pictures[k].equals(pictures[k % 3]), `figure ${k}`);
        assert.equal(await shown.page.evaluate(() => globalThis.observed.contexts.length), 1);
        await assertSilent(shown);
        await shown.context.close();
    });

    it('are the same where a browser cannot hand pictures over', async () => {
        const shown = await openedTwo();
        const plain = await openedTwo({ script: 'delete globalThis.OffscreenCanvas;' });
        for (const selector of ['#a', '#b']) {
            // as pixels: files of canvases of different kinds differ
            const [copied, handed] = [await pictureOf(plain.page, selector), await pictureOf(shown.page, selector)]
                .map((picture) => PNG.sync.read(picture).data);
            assert.ok(copied.equals(handed), selector);
        }
        assert.ok(await plain.page.evaluate(() => globalThis.observed.contexts[0].canvas instanceof HTMLCanvasElement));
        await assertSilent(plain);
        await plain.context.close();
        await shown.context.close();
    });

    it('draw the same pictures again after a lost context', async () => {
        const shown = await openedTwo();
        const { page } = shown;
        const before = [await pictureOf(page, '#a'), await pictureOf(page, '#b')];
        await page.evaluate(async () => {
            const canvas = globalThis.observed.contexts[0].canvas;
            const extension = globalThis.observed.contexts[0].getExtension('WEBGL_lose_context');
            const happened = (type) => new Promise((done) => { canvas.addEventListener(type, done, { once: true }); });
            const lost = happened('webglcontextlost');
            extension.loseContext();
            await lost;
            const restored = happened('webglcontextrestored');
            await new Promise((done) => { setTimeout(done, 100); });
            extension.restoreContext();
            await restored;
        });
        await settle(page);
        const copies = await page.evaluate(() => {
            for (const figure of document.querySelectorAll('knotwork-figure')) {
                figure.shadowRoot.querySelector('canvas').getContext('bitmaprenderer').transferFromImageBitmap(null);
                figure.setAttribute('theme', 'dark');
                figure.setAttribute('theme', 'light');
            }
            return globalThis.observed.copies;
        });
        await settle(page);
        assert.ok(copies > 0);
        assert.ok((await pictureOf(page, '#a')).equals(before[0]), 'the first');
        assert.ok((await pictureOf(page, '#b')).equals(before[1]), 'the second');
        await shown.context.close();
    });

    it('leave nothing behind when they are removed, and live on when they are moved', async () => {
        const { page, context } = await openedTwo();
        const before = await stats(page);
        const picture = await pictureOf(page, '#a');
        await page.evaluate(() => document.body.append(document.getElementById('a')));
        await settle(page);
        assert.equal((await stats(page)).views, 2, 'moved');
        assert.ok((await pictureOf(page, '#a')).equals(picture));
        await page.evaluate(() => document.getElementById('b').remove());
        await settle(page);
        assert.deepEqual([(await stats(page)).views, (await stats(page)).held], [1, before.held - 1]);
        await page.evaluate(() => document.getElementById('a').remove());
        await settle(page);
        const after = await stats(page);
        assert.deepEqual([after.views, after.held], [0, before.held - 2]);
        await context.close();
    });

    it('are drawn only while they can be seen', async () => {
        const { page, context } = await opened(`<div class="tall"></div>
            <knotwork-figure id="a" scene="butterfly" controls="none"></knotwork-figure>`, { reducedMotion: 'no-preference' });
        await figureReady(page, '#a');
        await page.waitForTimeout(300);
        const pictures = async () => (await stats(page)).pictures;
        const before = await pictures();
        await page.waitForTimeout(500);
        assert.equal(await pictures(), before, 'off screen');
        await page.evaluate(() => document.getElementById('a').scrollIntoView());
        await until(page, async (count) =>
            (await customElements.get('knotwork-figure').stats()).pictures > count + 3, before);
        await context.close();
    });

    it('let the wheel scroll the page, and zoom with Ctrl', async () => {
        const { page, context } = await opened(`${two}<div class="tall"></div>`);
        await figureReady(page, '#a');
        const picture = await pictureOf(page, '#a');
        await page.mouse.move(300, 150);
        await page.keyboard.down('Control');
        await page.mouse.wheel(0, -200);
        await page.keyboard.up('Control');
        await page.waitForTimeout(300);
        assert.equal(await page.evaluate(() => globalThis.scrollY), 0);
        assert.ok(!(await pictureOf(page, '#a')).equals(picture), 'zoomed');
        await page.mouse.wheel(0, 200);
        await page.waitForTimeout(300);
        assert.ok(await page.evaluate(() => globalThis.scrollY) > 0, 'scrolled');
        await context.close();
    });

    it('follow the pixel ratio exactly', async () => {
        const { page, context } = await openedTwo({ deviceScaleFactor: 1.5 });
        const sizes = await page.evaluate(() => {
            const view = document.getElementById('a').shadowRoot.querySelector('.view');
            const canvas = view.querySelector('canvas');
            return [canvas.width, Math.round(view.clientWidth * 1.5)];
        });
        assert.equal(sizes[0], sizes[1]);
        await context.close();
    });
});

describe('an element', { timeout: 300_000 }, () => {
    it('takes a document silently, tells of changes, and refuses with a code', async () => {
        const shown = await openedTwo();
        const answer = await shown.page.evaluate(async () => {
            const figure = document.getElementById('b');
            const told = [];
            document.body.addEventListener('change', (event) => told.push(event.detail.source));
            const { value } = figure;
            figure.value = { ...value, title: 'Mine' };
            const silent = told.length === 0;
            figure.scene.execute({ set: 'objects[0].degree', value: 2 });
            figure.undo();
            figure.redo();
            let code = '';
            try {
                figure.value = { knotwork: 1, objects: [{ type: 'no-such-curve' }] };
            } catch (error) {
                code = error.code;
            }
            return { silent, told, code, title: figure.value.title, degree: figure.value.objects[0].degree };
        });
        assert.deepEqual(answer, { silent: true, told: ['api', 'history', 'history'], code: 'UNKNOWN_NAME', title: 'Mine', degree: 2 });
        await assertSilent(shown);
        await shown.context.close();
    });

    it('says in its place why it shows nothing', async () => {
        const { page, context } = await opened('<knotwork-figure id="a" scene="no-such-scene"></knotwork-figure>');
        const code = await page.evaluate(() => document.getElementById('a').ready.catch((error) => error.code));
        assert.equal(code, 'UNKNOWN_NAME');
        assert.match(await page.locator('#a .refusal').innerText(), /no-such-scene/);
        await context.close();
    });

    it('reads a document that stands inside it', async () => {
        const { page, context } = await opened(`<knotwork-figure id="a"><script type="application/json">
            {"knotwork": 1, "title": "Inside", "objects": [{"type": "parametric-curve", "name": "circle"}]}
            </script></knotwork-figure>`);
        await figureReady(page, '#a');
        assert.equal((await documentOf(page, '#a')).title, 'Inside');
        await context.close();
    });

    it('changes nothing when it is only to be read', async () => {
        const { page, context } = await opened('<knotwork-figure id="a" scene="bspline-forms" readonly></knotwork-figure>');
        await figureReady(page, '#a');
        assert.equal(await page.getByRole('button', { name: 'Undo' }).count(), 0);
        assert.equal(await page.locator('#a .values input:not([readonly]):not([disabled]):not(.readout *)').count(), 2, 'only t can be moved');
        await context.close();
    });
});
