// One command, many hands: by mouse, by keys, by single clicks, in fields and by code it is the same
// document, the same step of history and the same report.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';

import {
    assertSame, clicked, dragged, executed, field, focus, openHands, outcome, placeOf, pressed, runPause, typed,
} from './hands-support.mjs';
import { assertSilent, documentOf, useBrowser } from './support.mjs';

const running = useBrowser();
const opened = (scene, options) => openHands(running, scene, options);

describe('the same by every hand', { timeout: 120_000 }, () => {
    it('moves a point', async () => {
        const shown = await opened();
        const { page } = shown;
        const path = 'objects[0].points[2]';
        const [x, y] = (await documentOf(page)).objects[0].points[2];
        const at = await placeOf(page, path);
        const other = await placeOf(page, 'objects[0].points[3]');
        const pixels = (other.x - at.x) / ((await documentOf(page)).objects[0].points[3][0] - x);
        const target = { x: at.x + 0.3 * pixels, y: at.y };
        const to = [Number((x + 0.3).toFixed(6)), y];
        await assertSame(page, [
            ['pointer', () => dragged(page, path, target)],
            ['pointer', () => clicked(page, path, target)],
            ['key', () => pressed(page, path, 'ArrowRight', 'ArrowRight', 'ArrowRight')],
            ['api', () => executed(page, { move: path, to })],
        ]);
        await assertSilent(shown);
        await shown.context.close();
    });

    it('moves a knot, and lets it meet another', async () => {
        const { page, context } = await opened();
        const { knots } = (await documentOf(page)).objects[0];
        const path = 'objects[0].knots[4]';
        const [at, next] = [await placeOf(page, path), await placeOf(page, 'objects[0].knots[5]')];
        const halfway = { x: (at.x + next.x) / 2, y: at.y };
        const middle = (knots[4] + knots[5]) / 2;
        const half = async () => {
            await focus(page, path);
            await typed(page, 'Step of the arrow keys', String(middle - knots[4]));
        };
        await assertSame(page, [
            ['pointer', () => dragged(page, path, halfway)],
            ['pointer', () => clicked(page, path, halfway)],
            ['key', async () => { await half(); await pressed(page, path, 'ArrowRight'); }],
            ['api', () => executed(page, { move: path, to: middle })],
        ]);
        await assertSame(page, [
            ['pointer', () => dragged(page, path, next)],
            ['pointer', () => clicked(page, path, next)],
            ['key', () => pressed(page, path, 'ArrowRight', 'ArrowRight')],
            ['api', () => executed(page, { move: path, to: knots[5] })],
        ]);
        await context.close();
    });

    it('poses a local curve', async () => {
        const { page, context } = await opened('b-functions');
        const path = 'objects[0].poses[0]';
        const at = await placeOf(page, path);
        const target = { x: at.x + 40, y: at.y - 20 };
        let command;
        await assertSame(page, [
            ['pointer', async () => {
                await dragged(page, path, target);
                command = await page.evaluate(() => globalThis.told.at(-1).command);
            }],
            ['pointer', () => clicked(page, path, target)],
            ['api', () => executed(page, { pose: command.pose })],
        ]);
        await context.close();
    });

    it('removes a point', async () => {
        const { page, context } = await opened();
        await assertSame(page, [
            ['key', () => pressed(page, 'objects[0].points[2]', 'Delete')],
            ['field', () => page.getByRole('button', { name: 'Remove point 3', exact: true }).click()],
            ['api', () => executed(page, { remove: 'objects[0].points[2]' })],
        ]);
        await context.close();
    });

    it('adds a point and inserts a knot', async () => {
        const { page, context } = await opened();
        let value;
        const add = page.getByRole('button', { name: 'Add a point' });
        await assertSame(page, [
            ['field', async () => {
                await add.click();
                value = (await documentOf(page)).objects[0].points.at(-1);
            }],
            ['field', () => add.press('Enter')],
            ['api', async () => executed(page, { insert: `objects[0].points[${(await documentOf(page)).objects[0].points.length}]`, value })],
        ]);
        const { id } = (await documentOf(page)).objects[0];
        const insert = page.getByRole('button', { name: 'Insert', exact: true });
        await assertSame(page, [
            ['field', async () => { await field(page, 'Insert a knot at').fill('1.5'); await insert.click(); }],
            ['field', () => typed(page, 'Insert a knot at', '1.5')],
            ['api', () => executed(page, { insertKnot: { object: id, at: 1.5 } })],
        ]);
        await context.close();
    });

    it('sets degree and form', async () => {
        const { page, context } = await opened();
        await assertSame(page, [
            ['field', () => typed(page, 'Degree', '2')],
            ['field', () => field(page, 'Degree').press('ArrowDown')],
            ['api', () => executed(page, { set: 'objects[0].degree', value: 2 })],
        ]);
        await assertSame(page, [
            ['field', () => page.locator('knotwork-figure [data-path="form"] select').selectOption('closed')],
            ['api', () => executed(page, { set: 'objects[0].form', value: 'closed' })],
        ]);
        await context.close();
    });
});

describe('what is selected', { timeout: 120_000 }, () => {
    const focused = (page) => page.evaluate(() => {
        const { activeElement } = document.querySelector('knotwork-figure').shadowRoot;
        return { type: activeElement?.type, group: activeElement?.parentElement?.getAttribute('aria-label'),
            label: activeElement?.getAttribute('aria-label'), text: activeElement?.getAttribute('aria-valuetext') };
    });

    it('is a group of sliders that says which it is and where it stands', async () => {
        const { page, context } = await opened();
        const [[x, y]] = (await documentOf(page)).objects[0].points;
        await page.locator('knotwork-figure .view').focus();
        await page.keyboard.press('PageDown');
        const minus = (value) => String(value).replace('-', '−');
        assert.deepEqual(await focused(page), { type: 'range', group: 'Control point 1 of 7', label: 'x', text: `x ${minus(x)}, y ${minus(y)}` });
        await page.keyboard.press('ArrowUp');
        assert.equal((await focused(page)).label, 'y');
        await page.keyboard.press('PageDown');
        assert.equal((await focused(page)).group, 'Control point 2 of 7');
        await page.keyboard.press('Enter');
        assert.equal((await focused(page)).label, 'Point 2, x');
        await focus(page, 'objects[0].points[6]');
        await page.keyboard.press('Delete');
        assert.equal((await focused(page)).group, 'Control point 6 of 6');
        await page.keyboard.press('Escape');
        assert.equal((await focused(page)).type, undefined);
        await context.close();
    });

    it('is one tab stop with the picture', async () => {
        const { page, context } = await opened();
        const stops = () => page.evaluate(() => [...document.querySelector('knotwork-figure').shadowRoot
            .querySelectorAll('.view, .view *')].filter((node) => node.tabIndex === 0 && node.getClientRects().length > 0).length);
        assert.equal(await stops(), 1);
        await focus(page, 'objects[0].points[2]');
        assert.equal(await stops(), 1);
        await context.close();
    });

    it('follows a slider that a screen reader moves, as one step of history', async () => {
        const { page, context } = await opened();
        await focus(page, 'objects[0].points[2]');
        const [x] = (await documentOf(page)).objects[0].points[2];
        await page.evaluate(() => {
            const slider = document.querySelector('knotwork-figure').shadowRoot.activeElement;
            for (let k = 0; k < 2; k += 1) {
                slider.stepUp();
                slider.dispatchEvent(new Event('input', { bubbles: true }));
            }
        });
        await page.waitForTimeout(runPause);
        const { same, sources } = await outcome(page);
        assert.ok(Math.abs(same.document.objects[0].points[2][0] - x - 0.2) < 1e-12);
        assert.deepEqual([same.steps, same.changes.length, sources], [1, 1, ['key']]);
        await context.close();
    });

    it('has decimal commas in bokmål, and what was done is said', async () => {
        const { page, context } = await opened('bspline-forms', { locale: 'nb-NO' });
        await executed(page, { move: 'objects[0].points[1]', to: [-3.25, 2.5] });
        await focus(page, 'objects[0].points[1]');
        assert.deepEqual(await focused(page), { type: 'range', group: 'Kontrollpunkt 2 av 7', label: 'x', text: 'x −3,25, y 2,5' });
        await page.waitForTimeout(runPause);
        assert.equal(await page.locator('knotwork-figure [role=status]').first().textContent(), 'Punkt 2 flyttet til x −3,25, y 2,5.');
        await context.close();
    });

    it('stays where it is while Escape leaves the mode of clicks', async () => {
        const { page, context } = await opened();
        const before = await documentOf(page);
        await focus(page, 'objects[0].points[2]');
        const move = page.getByRole('group', { name: 'By clicks' }).getByRole('button', { name: 'Move', exact: true });
        await move.click();
        assert.equal(await move.getAttribute('aria-pressed'), 'true');
        await page.keyboard.press('Escape');
        assert.equal(await move.getAttribute('aria-pressed'), 'false');
        assert.deepEqual(await documentOf(page), before);
        await context.close();
    });
});
