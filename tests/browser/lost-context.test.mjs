// A graphics context that is lost while something goes on: in an animation, in a drag, twice.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';

import { assertSilent, documentOf, figureReady, handlesOf, openPage, pictureOf, settle, useBrowser } from './support.mjs';

const running = useBrowser();

/** Loses the one context of the page and gives it back. */
async function lose(page) {
    await page.evaluate(async () => {
        const [context] = globalThis.observed.contexts;
        const extension = context.getExtension('WEBGL_lose_context');
        const happened = (type) => new Promise((done) => { context.canvas.addEventListener(type, done, { once: true }); });
        const lost = happened('webglcontextlost');
        extension.loseContext();
        await lost;
        const restored = happened('webglcontextrestored');
        await new Promise((done) => { setTimeout(done, 50); });
        extension.restoreContext();
        await restored;
    });
    await settle(page);
}

describe('a lost context', { timeout: 60_000 }, () => {
    it('stops an animation only until it is back, also the second time', async () => {
        const shown = await openPage(running, '#butterfly');
        const { page } = shown;
        await figureReady(page);
        await page.evaluate(() => document.querySelector('knotwork-figure').play());
        for (let time = 0; time < 2; time += 1) {
            await lose(page);
            const before = await pictureOf(page);
            await page.waitForTimeout(300);
            assert.ok(!(await pictureOf(page)).equals(before), 'it moves again');
        }
        await assertSilent(shown);
        await shown.context.close();
    });

    it('does not end a drag', async () => {
        const shown = await openPage(running, '#bspline-forms');
        const { page } = shown;
        await figureReady(page);
        const [from] = (await handlesOf(page, { to: [1, 0.5] })).filter(({ cursor }) => cursor === 'grab');
        await page.mouse.move(from.x, from.y);
        await page.mouse.down();
        await page.mouse.move(from.x + 30, from.y + 20, { steps: 3 });
        const during = await documentOf(page);
        await lose(page);
        await page.mouse.move(from.x + 60, from.y + 40, { steps: 3 });
        await page.mouse.up();
        assert.notDeepEqual((await documentOf(page)).objects, during.objects, 'the drag went on');
        const steps = await page.evaluate(() => {
            const { scene } = document.querySelector('knotwork-figure');
            return [scene.undo(), scene.undo()];
        });
        assert.deepEqual(steps, [true, false], 'and is one step of history');
        await assertSilent(shown);
        await shown.context.close();
    });
});
