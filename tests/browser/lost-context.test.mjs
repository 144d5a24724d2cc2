// A graphics context that is lost while something goes on: at rest, in an animation, in a drag, twice,
// and while it is being restored. The pictures afterwards are those that there would have been.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';

import { documentOf, handlesOf, openFigure, pictureOf, settle, useBrowser } from './support.mjs';

const running = useBrowser();

/** Loses the one context of the page, gives it back, and so on; the drag of a hand may lie between. */
const lose = (page) => page.evaluate(async () => {
    const [context] = globalThis.observed.contexts;
    globalThis.extension ??= context.getExtension('WEBGL_lose_context');
    const lost = new Promise((done) => { context.canvas.addEventListener('webglcontextlost', done, { once: true }); });
    globalThis.extension.loseContext();
    await lost;
});

const restore = (page) => page.evaluate(async () => {
    const [{ canvas }] = globalThis.observed.contexts;
    const restored = new Promise((done) => { canvas.addEventListener('webglcontextrestored', done, { once: true }); });
    await new Promise((done) => { setTimeout(done, 50); });
    globalThis.extension.restoreContext();
    await restored;
    await new Promise((done) => { requestAnimationFrame(() => requestAnimationFrame(done)); });
});

async function loseAndRestore(page, times = 1) {
    for (let time = 0; time < times; time += 1) {
        await lose(page);
        await restore(page);
    }
}

/** Runs before the page's own scripts: the context is lost again before anyone hears that it is back. */
function loseWhileRestoring() {
    const { getContext } = OffscreenCanvas.prototype;
    OffscreenCanvas.prototype.getContext = function watched(kind, ...rest) {
        if (kind === 'webgl2') {
            this.addEventListener('webglcontextrestored', () => {
                if (globalThis.losses > 0) globalThis.extension.loseContext();
                globalThis.losses -= 1;
            });
        }
        return getContext.call(this, kind, ...rest);
    };
}

/** The picture, drawn anew on a canvas that was wiped. */
async function drawnAnew(page) {
    await page.evaluate(() => {
        const figure = document.querySelector('knotwork-figure');
        figure.shadowRoot.querySelector('canvas').getContext('bitmaprenderer').transferFromImageBitmap(null);
        for (const theme of ['dark', 'light']) figure.setAttribute('theme', theme);
    });
    await settle(page);
    return pictureOf(page);
}

const opened = async (scene, options) => {
    const shown = await openFigure(running, `#${scene}`, { viewport: { width: 900, height: 700 }, ...options });
    await drawnAnew(shown.page);  // in the theme that later pictures have
    return shown;
};

const seek = (page, phase) => page.evaluate((to) => {
    const scrubber = document.querySelector('knotwork-figure').shadowRoot.querySelector('.scrubber');
    scrubber.value = String(to);
    scrubber.dispatchEvent(new Event('input', { bubbles: true }));
}, phase);

/** Drags the first handle, with something in the middle of it. */
async function dragged(page, between) {
    const [from] = (await handlesOf(page, { to: [1, 0.5] })).filter(({ cursor }) => cursor === 'grab');
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    await page.mouse.move(from.x + 30, from.y + 20, { steps: 3 });
    await between();
    await page.mouse.move(from.x + 60, from.y + 40, { steps: 3 });
    await page.mouse.up();
    await page.mouse.move(5, 5);
    await settle(page);
    const { objects } = await documentOf(page);
    return { objects, picture: await drawnAnew(page) };
}

describe('a lost context', { timeout: 120_000 }, () => {
    it('comes back with the same picture at rest, however often it is lost', async () => {
        const { page, context } = await opened('blending-surface');
        const before = await pictureOf(page);
        await loseAndRestore(page, 3);
        assert.ok((await drawnAnew(page)).equals(before));
        await context.close();
    });

    it('comes back also when it is lost again while it is being restored', async () => {
        const { page, context } = await opened('b-functions', { script: loseWhileRestoring });
        const before = await pictureOf(page);
        await page.evaluate(() => { globalThis.losses = 2; });
        await lose(page);
        for (let time = 0; time < 3; time += 1) {
            await restore(page);
            assert.ok(await page.locator('knotwork-figure .fallback').isHidden(), 'nothing is said about it');
        }
        assert.ok((await drawnAnew(page)).equals(before));
        await context.close();
    });

    it('stops an animation only until it is back, and each phase looks as before', async () => {
        const { page, context } = await opened('butterfly');
        await seek(page, 0.3);
        const before = await drawnAnew(page);
        await page.evaluate(() => document.querySelector('knotwork-figure').play());
        for (let time = 0; time < 2; time += 1) {
            await loseAndRestore(page);
            const then = await pictureOf(page);
            await page.waitForTimeout(300);
            assert.ok(!(await pictureOf(page)).equals(then), 'it moves again');
        }
        await seek(page, 0.3);
        assert.ok((await drawnAnew(page)).equals(before));
        await context.close();
    });

    it('neither ends a drag nor changes what comes of it', async () => {
        const ways = {
            undisturbed: async () => {},
            twice: (page) => loseAndRestore(page, 2),
            'until the end': (page) => lose(page),
        };
        const outcomes = [];
        for (const [way, between] of Object.entries(ways)) {
            const { page, context } = await opened('bspline-forms');
            const { objects, picture } = await dragged(page, () => between(page));
            if (way === 'until the end') await restore(page);
            outcomes.push({ way, objects, picture: way === 'until the end' ? await drawnAnew(page) : picture });
            const steps = await page.evaluate(() => {
                const { scene } = document.querySelector('knotwork-figure');
                return [scene.undo(), scene.undo()];
            });
            assert.deepEqual(steps, [true, false], `${way}: one step of history`);
            await context.close();
        }
        const [undisturbed, ...others] = outcomes;
        for (const { way, objects, picture } of others) {
            assert.deepEqual(objects, undisturbed.objects, way);
            assert.ok(picture.equals(undisturbed.picture), `${way}: the picture`);
        }
    });
});
