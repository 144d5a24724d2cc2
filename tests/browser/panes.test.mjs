// The panes of a figure: shown, hidden and sized by hands of every kind.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';

import { assertSilent, axeViolations, documentOf, drag, openFigure, settle, useBrowser } from './support.mjs';

const running = useBrowser();
const phone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };

const menuButton = (page) => page.getByRole('button', { name: 'Panes', exact: true });
const box = (page, name) => page.getByRole('group', { name: 'Panes', exact: true }).getByRole('checkbox', { name, exact: true });
const seam = (page, name) => page.getByRole('separator', { name, exact: true });
const shareOf = async (page, name) => Number(await seam(page, name).getAttribute('aria-valuenow'));

async function middleOf(locator) {
    const { x, y, width, height } = await locator.boundingBox();
    return { x: x + width / 2, y: y + height / 2 };
}

describe('the menu of panes', { timeout: 300_000 }, () => {
    it('shows and hides them, by mouse, by keys and by touch the same document in one step', async () => {
        const outcomes = [];
        for (const hand of ['mouse', 'keys', 'touch']) {
            const shown = await openFigure(running, '#bspline-forms', hand === 'touch' ? { hasTouch: true } : {});
            const { page } = shown;
            if (hand === 'mouse') {
                await menuButton(page).click();
                await box(page, 'Curvature').click();
                await box(page, 'Basis functions').click();
            } else if (hand === 'touch') {
                await menuButton(page).tap();
                await box(page, 'Curvature').tap();
                await box(page, 'Basis functions').tap();
            } else {
                await menuButton(page).focus();
                await page.keyboard.press('Enter');
                await box(page, 'Curvature').focus();
                await page.keyboard.press('Space');
                await box(page, 'Basis functions').focus();
                await page.keyboard.press('Space');
            }
            const document_ = await documentOf(page);
            assert.deepEqual(document_.view.panes, ['curve', 'knots', 'curvature']);
            assert.equal(document_.objects[0].show.curvature, true);
            assert.equal(await box(page, 'Basis functions').isChecked(), false);
            await page.keyboard.press('Escape');
            assert.equal(await menuButton(page).getAttribute('aria-expanded'), 'false');
            outcomes.push(document_);
            const steps = await page.evaluate(() => {
                const { scene } = document.querySelector('knotwork-figure');
                let count = 0;
                while (scene.undo()) count += 1;
                return count;
            });
            assert.equal(steps, 2);
            await assertSilent(shown);
            await shown.context.close();
        }
        assert.deepEqual(outcomes[1], outcomes[0]);
        assert.deepEqual(outcomes[2], outcomes[0]);
    });

    it('offers what the scene can have, keeps one pane, and shows steps of an algorithm', async () => {
        const { page, context } = await openFigure(running, '#butterfly');
        await menuButton(page).click();
        const names = await page.locator('.panes label.flag').allInnerTexts();
        assert.ok(names.includes('Curve') && names.includes('Hodograph') && names.includes('Curvature'), String(names));
        assert.ok(!names.includes('Knot line') || names.includes('B-function and derivatives'));
        await page.evaluate(() => { location.hash = '#local-control'; });
        await page.waitForFunction(() => document.querySelector('knotwork-figure').value?.objects?.[0]?.type === 'bspline-curve');
        await settle(page);
        if (await menuButton(page).getAttribute('aria-expanded') === 'false') await menuButton(page).click();
        await box(page, 'Steps of an algorithm').check();
        assert.equal((await documentOf(page)).objects.some(({ trace }) => trace?.algorithm === 'de-boor'), true);
        await box(page, 'Steps of an algorithm').uncheck();
        assert.equal((await documentOf(page)).objects.some(({ trace }) => trace), false);
        for (const name of ['Basis functions', 'Knot line']) {
            if (await box(page, name).isChecked()) await box(page, name).uncheck();
        }
        assert.equal(await box(page, 'Curve').getAttribute('aria-disabled'), 'true');
        await box(page, 'Curve').click({ force: true });
        assert.ok((await documentOf(page)).view.panes.includes('curve'));
        assert.equal(await box(page, 'Curve').isChecked(), true);
        await context.close();
    });
});

describe('a seam between panes', { timeout: 300_000 }, () => {
    const name = 'Curve and plots';

    it('is dragged, moved by keys and by a slider to the same place', async () => {
        const { page, context, ...shown } = await openFigure(running, '#bspline-forms');
        const before = await shareOf(page, name);
        const from = await middleOf(seam(page, name));
        const view = await page.locator('knotwork-figure .view').boundingBox();
        await drag(page, from, { x: from.x, y: from.y - 0.1 * view.height });
        assert.equal(await shareOf(page, name), before - 10);
        const after = await middleOf(seam(page, name));
        assert.ok(Math.abs(after.y - (from.y - 0.1 * view.height)) < 1.5);
        await seam(page, name).dblclick();
        await settle(page);
        assert.equal(await shareOf(page, name), before);
        await page.keyboard.press('Shift+ArrowUp');
        await settle(page);
        assert.equal(await shareOf(page, name), before - 10);
        await page.keyboard.press('Enter');
        await settle(page);
        assert.equal(await shareOf(page, name), before);
        await menuButton(page).click();
        const slider = page.getByRole('slider', { name, exact: true });
        const track = await slider.boundingBox();
        await page.mouse.click(track.x + track.width * 0.25, track.y + track.height / 2);
        await settle(page);
        assert.ok(await shareOf(page, name) < before);
        assert.equal(await slider.inputValue(), String(await shareOf(page, name)));
        assert.deepEqual((await documentOf(page)).view.panes, ['curve', 'basis', 'knots']);
        assert.equal(await page.evaluate(() => document.querySelector('knotwork-figure').scene.canUndo), false);
        await assertSilent({ page, ...shown });
        await context.close();
    });

    it('leaves every pane its least size, and Escape puts it back where it was', async () => {
        const { page, context } = await openFigure(running, '#bspline-forms');
        await seam(page, name).focus();
        for (const [key, limit] of [['Home', 'aria-valuemin'], ['End', 'aria-valuemax']]) {
            await page.keyboard.press(key);
            await settle(page);
            assert.equal(await shareOf(page, name), Number(await seam(page, name).getAttribute(limit)));
        }
        await page.keyboard.press('Enter');
        await settle(page);
        const before = await shareOf(page, name);
        const from = await middleOf(seam(page, name));
        await page.mouse.move(from.x, from.y);
        await page.mouse.down();
        await page.mouse.move(from.x, from.y - 90, { steps: 3 });
        await settle(page);
        assert.notEqual(await shareOf(page, name), before);
        await page.keyboard.press('Escape');
        await settle(page);
        assert.equal(await shareOf(page, name), before);
        await page.mouse.up();
        assert.equal(await seam(page, name).getAttribute('aria-orientation'), 'horizontal');
        await context.close();
    });

    it('stays where it is from scene to scene', async () => {
        const { page, context } = await openFigure(running, '#bspline-forms');
        await seam(page, name).focus();
        await page.keyboard.press('Shift+ArrowUp');
        await settle(page);
        const moved = await shareOf(page, name);
        await page.evaluate(() => { location.hash = '#local-control'; });
        await page.waitForFunction(() => document.querySelector('h1').textContent !== 'B-spline: three forms');
        await settle(page);
        assert.ok(Math.abs(await shareOf(page, name) - moved) <= 1);
        await context.close();
    });

    it('is as good on a phone, in the dark and to axe', async () => {
        const { page, context } = await openFigure(running, '#bspline-forms', { ...phone, colorScheme: 'dark' });
        const { height } = await seam(page, name).boundingBox();
        assert.ok(height >= 24, `${height} CSS pixels to take hold of`);
        await menuButton(page).tap();
        const menu = await page.locator('.panes').boundingBox();
        assert.ok(menu.x >= 0 && menu.x + menu.width <= 390 && menu.y >= 0, JSON.stringify(menu));
        assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390);
        assert.deepEqual(await axeViolations(page), []);
        await context.close();
    });
});

describe('the line that counts crossings', { timeout: 300_000 }, () => {
    it('counts while it moves, in the picture, in the readout and aloud', async () => {
        const { page, context, ...shown } = await openFigure(running, '#bspline-forms');
        await page.evaluate(() => document.querySelector('knotwork-figure').scene.execute({ set: 'objects[0].show.crossings', value: true }));
        await settle(page);
        const counts = () => page.evaluate(async () => {
            const figure = document.querySelector('knotwork-figure');
            const { id, style, show, line, ...spec } = figure.value.objects[0];
            const kw = await customElements.get('knotwork-figure').api();
            const { curve, polygon } = kw.curve(spec).crossings(...line);
            return { curve: curve.length, polygon: polygon.length };
        });
        const readout = () => page.locator('knotwork-figure .readout dt', { hasText: 'Line crosses' }).locator('+ dd').innerText();
        const first = await counts();
        assert.equal(await readout(), `the curve ${first.curve} ×, its polygon ${first.polygon} ×`);
        assert.ok(await page.evaluate((text) => globalThis.observed.texts.includes(text), `${first.curve} ≤ ${first.polygon}`));
        await page.evaluate(() => document.querySelector('knotwork-figure').focusPoint('objects[0].line[0]'));
        for (let i = 0; i < 4; ++i) await page.keyboard.press('Shift+ArrowUp');
        await page.waitForTimeout(1700);
        const later = await counts();
        assert.notDeepEqual(later, first);
        assert.equal(await readout(), `the curve ${later.curve} ×, its polygon ${later.polygon} ×`);
        assert.match(await page.locator('knotwork-figure [role=status][aria-live]').first().textContent(), new RegExp(`crosses the curve ${later.curve} times and its polygon ${later.polygon} times`));
        await assertSilent({ page, ...shown });
        await context.close();
    });
});

describe('two B-functions on one curve', { timeout: 300_000 }, () => {
    it('stand side by side: two curves, two functions with a legend, the axioms of both', async () => {
        const { page, context, ...shown } = await openFigure(running, '#blending-curve');
        const before = (await documentOf(page)).objects;
        await page.getByLabel('Compare with').first().selectOption('linear');
        await page.getByRole('button', { name: 'Compare', exact: true }).first().click();
        await settle(page);
        const { objects } = await documentOf(page);
        assert.equal(objects.length, before.length + 1);
        const [first, second] = [objects[0], objects.at(-1)];
        assert.equal(second.style.dashed, true);
        assert.notEqual(second.style.colour, first.style.colour);
        assert.deepEqual({ ...second, id: '', style: 0, bFunction: 0 }, { ...first, id: '', style: 0, bFunction: 0 });
        assert.equal(first.show.bFunction, true);
        const texts = await page.evaluate(() => globalThis.observed.texts);
        for (const { id } of [first, second]) assert.ok(texts.some((text) => text.startsWith(`${id}: order`)), id);
        const table = page.getByRole('table', { name: 'Axioms compared' }).first();
        assert.equal(await table.locator('tbody tr').count(), 5);
        assert.ok(await table.locator('.mark').count() >= 10);
        assert.deepEqual(await axeViolations(page), []);
        await assertSilent({ page, ...shown });
        await context.close();
    });
});
