// Scenes in space under the hand: turned, moved, and taken hold of.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';

import { assertSilent, documentOf, drag, figureReady, handlesOf, openPage, pictureOf, settle, useBrowser } from './support.mjs';

const running = useBrowser();

const net = {
    knotwork: 1,
    view: { mode: '3d', panes: ['curve'] },
    objects: [{
        id: 'net', type: 'bspline-surface', degree: [2, 2],
        points: [0, 1, 2].map((x) => [0, 1, 2].map((y) => [x, y, x === 1 && y === 1 ? 2 : 0])),
        show: { points: true, polygon: true },
    }],
};

async function opened(options = {}) {
    const shown = await openPage(running, 'space.html', {
        html: `<knotwork-figure controls="none"><script type="application/json">
            ${JSON.stringify(net)}</script></knotwork-figure><div class="tall"></div>`,
        css: '.tall { height: 2000px } knotwork-figure { width: 680px; --knotwork-height: 440px }',
        viewport: { width: 720, height: 600 },
        ...options,
    });
    await figureReady(shown.page);
    return shown;
}

const pointsOf = async (page) => (await documentOf(page)).objects[0].points;

async function placeOf(page, across, down) {
    const box = await page.locator('knotwork-figure .view').boundingBox();
    return { x: box.x + across * box.width, y: box.y + down * box.height };
}

async function strokes(page, context, paths) {
    const session = await context.newCDPSession(page);
    const at = (share) => paths.map(([from, to], id) => ({
        id, x: from.x + share * (to.x - from.x), y: from.y + share * (to.y - from.y),
    }));
    await session.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: at(0) });
    for (let k = 1; k <= 8; k += 1) {
        await session.send('Input.dispatchTouchEvent', { type: 'touchMove', touchPoints: at(k / 8) });
    }
    await session.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
    await page.waitForTimeout(200);
}

describe('a scene in space', { timeout: 300_000 }, () => {
    it('is turned by a drag of nothing, which changes the picture and not the document', async () => {
        const shown = await opened();
        const { page } = shown;
        const [before, picture] = [await documentOf(page), await pictureOf(page)];
        const from = await placeOf(page, 0.05, 0.1);
        await drag(page, from, { x: from.x + 120, y: from.y + 30 });
        await settle(page);
        assert.ok(!(await pictureOf(page)).equals(picture), 'the picture has turned');
        assert.deepEqual(await documentOf(page), before);
        await page.locator('knotwork-figure .view').focus();
        await page.keyboard.press('0');
        await page.mouse.move(2, 2);
        await settle(page);
        assert.ok((await pictureOf(page)).equals(picture), 'and 0 turns it back');
        await assertSilent(shown);
        await shown.context.close();
    });

    it('lets every point of a net be dragged, as one step of history', async () => {
        const { page, context } = await opened();
        const before = await pointsOf(page);
        const handles = (await handlesOf(page)).filter(({ cursor }) => cursor === 'grab');
        assert.equal(handles.length, 9);
        const lowest = handles.reduce((a, b) => (a.y > b.y ? a : b));
        await drag(page, lowest, { x: lowest.x + 40, y: lowest.y - 30 });
        const after = await pointsOf(page);
        const moved = after.flat().filter((point, k) => String(point) !== String(before.flat()[k]));
        assert.equal(moved.length, 1);
        await page.evaluate(() => document.querySelector('knotwork-figure').undo());
        assert.deepEqual(await pointsOf(page), before);
        await context.close();
    });

    it('is turned by a finger that goes across, and scrolls the page under one that goes down', async () => {
        const { page, context } = await opened({ hasTouch: true });
        const picture = await pictureOf(page);
        const from = await placeOf(page, 0.3, 0.9);
        await strokes(page, context, [[from, { x: from.x + 150, y: from.y + 4 }]]);
        assert.equal(await page.evaluate(() => globalThis.scrollY), 0);
        const turned = await pictureOf(page);
        assert.ok(!turned.equals(picture), 'it has turned');
        await strokes(page, context, [[from, { x: from.x, y: from.y - 150 }]]);
        assert.ok(await page.evaluate(() => globalThis.scrollY) > 50, 'the page has scrolled');
        assert.ok((await pictureOf(page)).equals(turned), 'and nothing else');
        await context.close();
    });

    it('is scaled by two fingers, under which the page stands still', async () => {
        const { page, context } = await opened({ hasTouch: true });
        const picture = await pictureOf(page);
        const middle = await placeOf(page, 0.5, 0.5);
        const finger = (dx) => ({ x: middle.x + dx, y: middle.y - 150 });
        await strokes(page, context, [[finger(-40), finger(-120)], [finger(40), finger(120)]]);
        assert.ok(!(await pictureOf(page)).equals(picture), 'the picture is larger');
        const { scale, scrollY } = await page.evaluate(() => ({ scale: visualViewport.scale, scrollY: globalThis.scrollY }));
        assert.deepEqual([scale, scrollY], [1, 0]);
        assert.deepEqual(await pointsOf(page), net.objects[0].points);
        await context.close();
    });
});
