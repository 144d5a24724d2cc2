// What someone hears who does not see the picture: the order of the tab key and the tree that a
// screen reader is given.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';

import { openFigure, useBrowser } from './support.mjs';

const running = useBrowser();

const opened = (scene) => openFigure(running, `#${scene}`);

const select = (page, path) => page.evaluate((p) => document.querySelector('knotwork-figure').focusPoint(p), path);
const pictureOf = (page) => page.locator('knotwork-figure .view').ariaSnapshot();

/** Where the focus is: in the page, or in the figure. */
const focused = (page) => page.evaluate(() => {
    const outer = document.activeElement;
    const inner = outer?.shadowRoot?.activeElement ?? outer;
    const name = inner?.getAttribute('aria-label') ?? inner?.textContent?.trim().slice(0, 40) ?? '';
    return outer === document.body ? 'nothing' : `${inner?.closest('.values') ? 'values' : outer?.localName} ${inner?.type ?? inner?.localName} ${name}`;
});

describe('the tab key', { timeout: 60_000 }, () => {
    it('goes through the page, the picture, its controls and the values, and out again', async () => {
        const { page, context } = await opened('bspline-forms');
        const stops = [];
        for (let k = 0; k < 120; k += 1) {
            await page.keyboard.press('Tab');
            const stop = await focused(page);
            if (stop === 'nothing') break;
            stops.push(stop);
        }
        const picture = stops.findIndex((stop) => stop.startsWith('knotwork-figure div'));
        const undo = stops.findIndex((stop) => /Undo/.test(stop));
        const values = stops.findIndex((stop) => stop.startsWith('values'));
        assert.match(stops[0], /Skip to the figure/);
        assert.ok(picture > 0 && undo > picture && values > undo, stops.join('\n'));
        assert.equal(stops.filter((stop) => stop.startsWith('knotwork-figure div')).length, 1, 'the picture is one stop');
        assert.ok(stops.length < 120, 'nothing traps it');
        await context.close();
    });

    it('skips to the picture, and what is shown stays', async () => {
        const { page, context } = await opened('bspline-forms');
        await page.keyboard.press('Tab');
        await page.keyboard.press('Enter');
        assert.match(await focused(page), /^knotwork-figure div/);
        assert.match(page.url(), /#bspline-forms$/);
        await context.close();
    });
});

describe('the tree of a screen reader', { timeout: 60_000 }, () => {
    it('has the selected control point of a curve as sliders', async () => {
        const { page, context } = await opened('bspline-forms');
        await select(page, 'objects[0].points[2]');
        assert.match(await pictureOf(page), /group "Control point 3 of 7":\s+- slider "x"[^\n]*\s+- slider "y"/);
        await context.close();
    });

    it('has the selected knot and the selected local curve by their names', async () => {
        const { page, context } = await opened('bspline-forms');
        await select(page, 'objects[0].knots[4]');
        assert.match(await pictureOf(page), /group "Knot 5 of 11":\s+- slider "t"/);
        await context.close();
        const other = await opened('b-functions');
        await select(other.page, 'objects[0].poses[1]');
        assert.match(await pictureOf(other.page), /group "Local curve 2 of \d+":\s+- slider "x"[^\n]*\s+- slider "y"/);
        await other.context.close();
    });

    it('says of a net in which row and column a point is, with three coordinates', async () => {
        const { page, context } = await opened('bspline-forms');
        await page.evaluate(() => {
            const points = [0, 1, 2].map((i) => [0, 1, 2, 3].map((j) => [i, j, (i - 1) * (j - 1)]));
            document.querySelector('knotwork-figure').value = { knotwork: 1, objects: [{ type: 'bspline-surface', degree: [2, 2], points }] };
        });
        await select(page, 'objects[0].points[1][2]');
        assert.match(await pictureOf(page), /group "Control point \d+ of \d+, row 2, column 3":(\s+- slider "[xyz]"[^\n]*){3}/);
        await context.close();
    });

    it('has a text in place of the picture that follows the state', async () => {
        const { page, context } = await opened('bspline-forms');
        const about = () => page.evaluate(() => {
            const { shadowRoot } = document.querySelector('knotwork-figure');
            return shadowRoot.getElementById(shadowRoot.querySelector('.view').getAttribute('aria-describedby')).textContent;
        });
        assert.match(await about(), /degree 3, 7 points, clamped, C²/);
        await page.evaluate(() => document.querySelector('knotwork-figure').scene.execute({ remove: 'objects[0].points[6]' }));
        assert.match(await about(), /degree 3, 6 points, clamped, C²/);
        assert.equal(await page.locator('knotwork-figure canvas:not([aria-hidden=true])').count(), 0, 'the canvas itself is silent');
        await context.close();
    });
});
