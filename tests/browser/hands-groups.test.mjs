// Several points or local curves at once: chosen and moved by every hand to the same end.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';

import {
    assertSame, executed, field, focus, openHands, placeOf, runPause, typed,
} from './hands-support.mjs';
import { assertSilent, documentOf, drag, useBrowser } from './support.mjs';

const running = useBrowser();
const opened = (scene, options) => openHands(running, scene, options);
const point = (k) => `objects[0].points[${k}]`;
const bar = (page) => page.getByRole('group', { name: 'By clicks' });
const button = (page, name) => bar(page).getByRole('button', { name, exact: true });
const selected = (page) => page.evaluate(() => document.querySelector('knotwork-figure').selection?.paths ?? []);
const group = (page) => page.locator('knotwork-figure .handle').getAttribute('aria-label');

async function gathered(page, places) {
    await page.keyboard.down('Control');
    for (const { x, y } of places) await page.mouse.click(x, y);
    await page.keyboard.up('Control');
}

async function run(page, ...keys) {
    for (const key of keys) await page.keyboard.press(key);
    await page.waitForTimeout(runPause);
}

describe('several points by every hand', { timeout: 120_000 }, () => {
    it('are moved', async () => {
        const shown = await opened();
        const { page } = shown;
        const { points } = (await documentOf(page)).objects[0];
        const places = [await placeOf(page, point(1)), await placeOf(page, point(2))];
        const unit = (places[1].x - places[0].x) / (points[2][0] - points[1][0]);
        const by = (at) => ({ x: at.x + 0.3 * unit, y: at.y });
        const centre = { x: (places[0].x + places[1].x) / 2, y: (places[0].y + places[1].y) / 2 };
        const byKeys = async () => {
            await focus(page, point(1));
            await page.keyboard.press('Shift+PageDown');
            assert.equal(await group(page), '2 points selected');
        };
        await assertSame(page, [
            ['pointer', async () => { await gathered(page, places); await drag(page, places[1], by(places[1])); }],
            ['pointer', async () => {
                await gathered(page, places);
                await button(page, 'Move').click();
                await page.mouse.click(by(centre).x, by(centre).y);
            }],
            ['pointer', async () => {
                await focus(page, point(1));
                await button(page, 'Several').click();
                await page.mouse.click(places[1].x, places[1].y);
                await button(page, 'Move').click();
                await page.mouse.click(by(centre).x, by(centre).y);
            }],
            ['key', async () => { await byKeys(); await run(page, 'ArrowRight', 'ArrowRight', 'ArrowRight'); }],
            ['key', async () => {
                await byKeys();
                await typed(page, 'Step of the arrow keys', '0.3');
                await page.locator('knotwork-figure .handle input').first().focus();
                await run(page, 'ArrowRight');
                await field(page, 'Step of the arrow keys').fill('');
                await field(page, 'Step of the arrow keys').press('Enter');
            }],
            ['api', () => executed(page, { move: [point(1), point(2)], by: [0.3, 0] })],
        ]);
        await assertSilent(shown);
        await shown.context.close();
    });

    it('are turned and scaled', async () => {
        const { page, context } = await opened();
        const gather = async () => { await focus(page, point(1)); await page.keyboard.press('Shift+PageDown'); };
        const ring = async (angle, radius = 32) => {
            const [x, y] = await page.evaluate(() => {
                const { shadowRoot } = document.querySelector('knotwork-figure');
                const box = shadowRoot.querySelector('.view').getBoundingClientRect();
                const [px, py] = shadowRoot.querySelector('.handle').style.translate.split(' ').map(parseFloat);
                return [box.left + px, box.top + py];
            });
            return { x: x + radius * Math.cos(angle), y: y - radius * Math.sin(angle) };
        };
        let command;
        const fifteen = Math.PI / 12;
        await assertSame(page, [
            ['key', async () => {
                await gather();
                await run(page, 'r');
                command = await page.evaluate(() => globalThis.told.at(-1).command);
            }],
            ['pointer', async () => {
                await gather();
                await page.keyboard.down('Control');
                await drag(page, await ring(0.6), await ring(0.6 + fifteen));
                await page.keyboard.up('Control');
            }],
            ['api', () => executed(page, { set: command.set, value: command.value })],
        ]);
        await assertSame(page, [
            ['key', async () => {
                await gather();
                await run(page, 's', 's', 'Shift+S', 's', 'Shift+S');
                command = await page.evaluate(() => globalThis.told.at(-1).command);
            }],
            ['pointer', async () => {
                await gather();
                const at = await ring(0, 84);
                const out = await ring(0, 84 * 1.1);
                await page.mouse.move(at.x, at.y);
                await page.mouse.down();
                await page.keyboard.down('Shift');
                await page.mouse.move(out.x + 20, out.y, { steps: 3 });
                await page.mouse.move(out.x, out.y, { steps: 3 });
                await page.mouse.up();
                await page.keyboard.up('Shift');
            }],
            ['api', () => executed(page, { set: command.set, value: command.value })],
        ]);
        await context.close();
    });

    it('are removed', async () => {
        const { page, context } = await opened();
        const places = [await placeOf(page, point(1)), await placeOf(page, point(2))];
        await assertSame(page, [
            ['key', async () => { await focus(page, point(1)); await run(page, 'Shift+PageDown', 'Delete'); }],
            ['key', async () => { await gathered(page, places); await run(page, 'Delete'); }],
            ['api', () => executed(page, { all: [{ remove: point(2) }, { remove: point(1) }] })],
        ]);
        await context.close();
    });

    it('are chosen by a band, all at once, and let go', async () => {
        const { page, context } = await opened();
        const [a, b] = [await placeOf(page, point(0)), await placeOf(page, point(1))];
        await page.keyboard.down('Shift');
        await drag(page, { x: Math.min(a.x, b.x) - 30, y: Math.max(a.y, b.y) + 30 }, { x: Math.max(a.x, b.x) + 30, y: Math.min(a.y, b.y) - 30 });
        await page.keyboard.up('Shift');
        assert.deepEqual(await selected(page), [point(0), point(1)]);
        await page.waitForTimeout(runPause);
        assert.equal(await page.locator('knotwork-figure [role=status]').first().textContent(), '2 points selected');
        await page.keyboard.press('Control+a');
        assert.equal(await group(page), '7 points selected');
        await page.keyboard.press('Escape');
        assert.deepEqual(await selected(page), []);
        await focus(page, point(3));
        await button(page, 'Several').click();
        await button(page, 'All').click();
        assert.equal((await selected(page)).length, 7);
        await page.keyboard.press('Escape');
        assert.equal(await button(page, 'Several').getAttribute('aria-pressed'), 'false');
        await context.close();
    });
});

describe('several local curves by every hand', { timeout: 120_000 }, () => {
    it('are moved, turned and scaled', async () => {
        const { page, context } = await opened('b-functions');
        const [first, second] = ['objects[0].poses[0]', 'objects[0].poses[1]'];
        const places = [await placeOf(page, first), await placeOf(page, second)];
        let command;
        const again = () => executed(page, { pose: command.pose });
        const both = async () => { await focus(page, first); await page.keyboard.press('Shift+PageDown'); };
        const kept = async () => { command = await page.evaluate(() => globalThis.told.at(-1).command); };
        await assertSame(page, [
            ['pointer', async () => {
                await gathered(page, places);
                await drag(page, places[0], { x: places[0].x + 30, y: places[0].y - 20 });
                await kept();
            }],
            ['api', again],
        ]);
        assert.deepEqual(command.pose.locals, [0, 1]);
        for (const key of ['r', 's']) {
            await assertSame(page, [['key', async () => { await both(); await run(page, key, key); await kept(); }], ['api', again]]);
        }
        await context.close();
    });
});

describe('a finger', { timeout: 120_000 }, () => {
    const phone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };

    it('places what is selected with two taps', async () => {
        const { page, context } = await opened('bspline-forms', phone);
        const at = await placeOf(page, point(2));
        const before = (await documentOf(page)).objects[0].points[2];
        await page.touchscreen.tap(at.x, at.y);
        await button(page, 'Move').tap();
        await page.touchscreen.tap(at.x + 20, at.y + 10);
        const after = (await documentOf(page)).objects[0].points[2];
        assert.ok(after[0] > before[0] && after[1] < before[1], `${before} to ${after}`);
        await context.close();
    });

    it('chooses several by taps', async () => {
        const { page, context } = await opened('bspline-forms', phone);
        const places = [await placeOf(page, point(1)), await placeOf(page, point(2)), await placeOf(page, point(5))];
        await page.touchscreen.tap(places[0].x, places[0].y);
        await button(page, 'Several').tap();
        for (const { x, y } of places.slice(1)) await page.touchscreen.tap(x, y);
        assert.deepEqual(await selected(page), [point(1), point(2), point(5)]);
        await page.touchscreen.tap(places[1].x, places[1].y);
        assert.deepEqual(await selected(page), [point(1), point(5)]);
        await context.close();
    });
});
