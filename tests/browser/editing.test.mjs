// Hands and keys on a figure, and the same by fields.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';

import { assertSilent, documentOf, drag, figureReady, handlesOf, openPage, pictureOf, settle, useBrowser } from './support.mjs';

const running = useBrowser();

async function opened(scene = 'bspline-forms', options = {}) {
    const shown = await openPage(running, `#${scene}`, options);
    await figureReady(shown.page);
    await shown.page.evaluate(() => {
        globalThis.told = [];
        for (const type of ['input', 'change']) {
            document.addEventListener(type, (event) => {
                if (event.detail?.source) globalThis.told.push(`${type} by ${event.detail.source}`);
            });
        }
    });
    return shown;
}

const toldTo = (page) => page.evaluate(() => globalThis.told);
const splineOf = async (page) => (await documentOf(page)).objects[0];
const control = (page, name) => page.getByRole('spinbutton', { name, exact: true });

/** Control points, which lie above the basis, and handles of local curves, left of the B-function. */
const pointHandles = (page) => handles(page, 'grab', { to: [1, 0.55] });
const localHandles = (page) => handles(page, 'grab', { to: [0.55, 1] });
/** The knots on the knot line, which lies at the bottom. */
const knotHandles = (page) => handles(page, 'ew-resize', { from: [0, 0.8] });

async function handles(page, cursor, part) {
    return (await handlesOf(page, part)).filter((handle) => handle.cursor === cursor).sort((a, b) => a.x - b.x);
}

/** One undo brings document and picture back, when nothing is pointed at or selected any more. */
async function assertUndone(page, before, picture) {
    await page.mouse.move(2, 2);
    await page.getByRole('button', { name: 'Undo' }).click();
    assert.deepEqual(await documentOf(page), before);
    await page.locator('knotwork-figure .view').focus();
    await page.keyboard.press('Escape');
    await page.mouse.move(4, 2);
    await page.waitForTimeout(300);
    assert.ok((await pictureOf(page)).equals(picture), 'the picture is the former one');
}

describe('a hand', { timeout: 300_000 }, () => {
    it('drags a control point: document and picture follow, and one undo takes it back', async () => {
        const shown = await opened();
        const { page } = shown;
        const [before, picture] = [await documentOf(page), await pictureOf(page)];
        const points = await pointHandles(page);
        assert.equal(points.length, before.objects[0].points.length, 'every control point can be taken hold of');
        await drag(page, points[0], { x: points[0].x + 40, y: points[0].y - 60 });
        const { points: after } = await splineOf(page);
        const moved = after.map((point, k) => [k, point]).filter(([k, point]) =>
            String(point) !== String(before.objects[0].points[k]));
        assert.equal(moved.length, 1, 'one point has moved');
        const [k, [x, y]] = moved[0];
        assert.ok(x > before.objects[0].points[k][0] && y > before.objects[0].points[k][1], 'to the right and up');
        assert.ok(!(await pictureOf(page)).equals(picture), 'the picture has changed');
        const told = await toldTo(page);
        assert.ok(told.includes('input by pointer'));
        assert.deepEqual(told.filter((line) => line.startsWith('change')), ['change by pointer']);
        await assertUndone(page, before, picture);
        await assertSilent(shown);
        await shown.context.close();
    });

    it('drags a knot on the knot line, and one undo takes it back', async () => {
        const { page, context } = await opened();
        const before = await documentOf(page);
        const picture = await pictureOf(page);
        const knots = await knotHandles(page);
        const inner = knots[Math.floor(knots.length / 2)];
        await drag(page, inner, { x: inner.x + 25, y: inner.y });
        const { knots: after } = await splineOf(page);
        const moved = after.filter((knot, k) => knot !== before.objects[0].knots[k]);
        assert.equal(moved.length, 1, `one knot has moved: ${after}`);
        assert.ok(!(await pictureOf(page)).equals(picture), 'the picture has changed');
        await assertUndone(page, before, picture);
        await context.close();
    });

    it('drags a local curve of a blending curve by its handle', async () => {
        const { page, context } = await opened('b-functions');
        const before = (await splineOf(page)).poses;
        const [handle] = await localHandles(page);
        await drag(page, handle, { x: handle.x + 30, y: handle.y + 20 });
        assert.notDeepEqual((await splineOf(page)).poses, before);
        await context.close();
    });

    it('takes a drag back with Escape, leaving no step of history', async () => {
        const { page, context } = await opened();
        const before = await documentOf(page);
        const [point] = await pointHandles(page);
        await page.mouse.move(point.x, point.y);
        await page.mouse.down();
        await page.mouse.move(point.x + 50, point.y - 50, { steps: 5 });
        assert.notDeepEqual(await documentOf(page), before);
        await page.keyboard.press('Escape');
        await page.mouse.up();
        assert.deepEqual(await documentOf(page), before);
        assert.equal(await page.evaluate(() => document.querySelector('knotwork-figure').scene.canUndo), false);
        await context.close();
    });
});

describe('a finger', { timeout: 300_000 }, () => {
    async function stroke(page, context, from, to) {
        const session = await context.newCDPSession(page);
        const send = (type, ...touchPoints) => session.send('Input.dispatchTouchEvent', { type, touchPoints });
        await send('touchStart', from);
        for (let k = 1; k <= 8; k += 1) {
            await send('touchMove', { x: from.x + (to.x - from.x) * k / 8, y: from.y + (to.y - from.y) * k / 8 });
        }
        await send('touchEnd');
        await page.waitForTimeout(200);
    }

    it('scrolls the page, but drags a point that it hits', async () => {
        const { page, context } = await opened('bspline-forms', { hasTouch: true, viewport: { width: 700, height: 700 } });
        const before = await splineOf(page);
        const [point] = await pointHandles(page);
        await stroke(page, context, point, { x: point.x + 30, y: point.y - 60 });
        assert.equal(await page.evaluate(() => globalThis.scrollY), 0, 'the page stands still');
        const after = await splineOf(page);
        assert.notDeepEqual(after.points, before.points, 'a point has moved');
        const empty = { x: point.x + 3, y: point.y + 90 };
        await stroke(page, context, empty, { x: empty.x, y: empty.y - 120 });
        assert.deepEqual(await splineOf(page), after, 'nothing has moved');
        assert.ok(await page.evaluate(() => globalThis.scrollY) > 50, 'the page has scrolled');
        await context.close();
    });
});

describe('the keyboard', { timeout: 300_000 }, () => {
    it('chooses, moves and removes points, and undoes', async () => {
        const { page, context } = await opened();
        const { points } = await splineOf(page);
        await page.locator('knotwork-figure .view').focus();
        await page.keyboard.press('PageDown');
        await page.keyboard.press('PageDown');
        await page.keyboard.press('ArrowRight');
        const moved = (await splineOf(page)).points;
        assert.ok(moved[1][0] > points[1][0]);
        assert.deepEqual(moved.filter((_, k) => k !== 1), points.filter((_, k) => k !== 1));
        await page.keyboard.press('Delete');
        assert.equal((await splineOf(page)).points.length, points.length - 1);
        await page.keyboard.press('Control+z');
        await page.keyboard.press('Control+z');
        assert.deepEqual((await splineOf(page)).points, points);
        await context.close();
    });

    it('always leaves with Tab, forwards and backwards', async () => {
        const { page, context } = await opened();
        const focused = () => page.evaluate(() => {
            const inside = document.activeElement?.shadowRoot?.activeElement;
            return inside ? inside.className : document.activeElement?.tagName;
        });
        await page.locator('knotwork-figure .view').focus();
        await page.keyboard.press('PageDown');
        await page.keyboard.press('Tab');
        assert.notEqual(await focused(), 'view');
        await page.locator('knotwork-figure .view').focus();
        await page.keyboard.press('Shift+Tab');
        assert.notEqual(await focused(), 'view');
        await context.close();
    });

    it('plays and pauses with the space bar and does not scroll the page', async () => {
        const { page, context } = await opened('butterfly');
        const playing = () => page.evaluate(() => document.querySelector('knotwork-figure').playing);
        await page.locator('knotwork-figure .view').focus();
        await page.keyboard.press('Space');
        assert.equal(await playing(), true);
        await page.keyboard.press('Space');
        assert.equal(await playing(), false);
        assert.equal(await page.evaluate(() => globalThis.scrollY), 0);
        await context.close();
    });
});

describe('the values panel', { timeout: 300_000 }, () => {
    it('sets a number, and shows what a drag has set', async () => {
        const { page, context } = await opened();
        await control(page, 'Point 1, x').fill('-3.5');
        await control(page, 'Point 1, x').press('Enter');
        assert.equal((await splineOf(page)).points[0][0], -3.5);
        assert.deepEqual(await toldTo(page), ['change by field']);
        await page.evaluate(() => {
            document.querySelector('knotwork-figure').scene.execute({ move: 'objects[0].points[1]', to: [-3, 2.5] });
        });
        assert.equal(await control(page, 'Point 2, y').inputValue(), '2.5');
        await context.close();
    });

    it('says beside the field why a value is refused, and keeps the former state', async () => {
        const { page, context } = await opened();
        const before = await documentOf(page);
        const degree = control(page, 'Degree');
        const complaint = () => degree.evaluate((input) =>
            input.getRootNode().getElementById(input.getAttribute('aria-describedby'))?.textContent);
        for (const [typed, told] of [['99', /25/], ['2.5', /integer|whole/i], ['three', /Type a number/]]) {
            await degree.fill(typed);
            await degree.press('Enter');
            assert.equal(await degree.getAttribute('aria-invalid'), 'true');
            assert.match(await complaint(), told);
            assert.deepEqual(await documentOf(page), before);
        }
        await degree.press('Escape');
        assert.equal(await degree.inputValue(), '3');
        assert.equal(await degree.getAttribute('aria-invalid'), null);
        await context.close();
    });

    it('makes one step of history of a slider\'s whole way', async () => {
        const { page, context } = await opened('b-functions');
        const before = await documentOf(page);
        const slider = page.locator('knotwork-figure [data-path="bFunction.alpha"] input[type=range]');
        const box = await slider.boundingBox();
        const y = box.y + box.height / 2;
        await drag(page, { x: box.x + box.width / 3, y }, { x: box.x + box.width * 0.8, y });
        assert.ok((await splineOf(page)).bFunction.alpha > 1);
        await page.getByRole('button', { name: 'Undo' }).click();
        assert.deepEqual(await documentOf(page), before);
        await context.close();
    });

    it('adds and removes points and inserts a knot, and the focus stays near', async () => {
        const { page, context } = await opened();
        const before = await splineOf(page);
        await page.getByRole('button', { name: 'Add a point' }).click();
        const longer = await splineOf(page);
        assert.equal(longer.points.length, before.points.length + 1);
        assert.equal(longer.knots.length, before.knots.length + 1);
        await page.getByRole('button', { name: 'Remove point 8', exact: true }).click();
        assert.deepEqual((await splineOf(page)).points, before.points);
        const focused = () => page.evaluate(() =>
            document.querySelector('knotwork-figure').shadowRoot.activeElement?.getAttribute('aria-label'));
        assert.equal(await focused(), 'Remove point 7');
        await control(page, 'Insert a knot at').fill('1.5');
        await page.getByRole('button', { name: 'Insert', exact: true }).click();
        assert.ok((await splineOf(page)).knots.includes(1.5));
        await context.close();
    });

    it('follows the form and the family with the fields that they have', async () => {
        const { page, context } = await opened('b-functions');
        await page.getByRole('combobox', { name: 'Family' }).selectOption('rational');
        await control(page, 'power m').fill('4');
        await control(page, 'power m').press('Enter');
        assert.deepEqual((await splineOf(page)).bFunction, { family: 'rational', m: 4, c: 1 });
        await context.close();
    });

    it('tells the sum of the basis, the continuity and the point at t', async () => {
        const { page, context } = await opened();
        const readout = page.locator('knotwork-figure dl.readout');
        const text = await readout.innerText();
        assert.match(text, /Sum of the basis\s+1/);
        assert.match(text, /Continuity\s+C²/);
        const t = control(page, 't');
        await t.fill('0');
        await t.press('Enter');
        assert.match(await readout.innerText(), /Point\s+\(−4; −1.6\)/);
        await context.close();
    });
});
