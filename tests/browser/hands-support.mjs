// Hands of every kind on one figure, and what comes of what they do.
import assert from 'node:assert/strict';

import { drag, figureReady, openPage, settle } from './support.mjs';

export const runPause = 900;  // after which a run of arrow keys is over

/** A page with its figure, which keeps what it tells. */
export async function openHands(running, scene = 'bspline-forms', options = {}) {
    const shown = await openPage(running, `#${scene}`, options);
    await figureReady(shown.page);
    await shown.page.evaluate(() => {
        const figure = document.querySelector('knotwork-figure');
        globalThis.told = [];
        for (const type of ['input', 'change']) {
            figure.addEventListener(type, ({ detail }) => { if (detail?.source) globalThis.told.push({ type, ...detail }); });
        }
        globalThis.start = figure.value;
    });
    return shown;
}

/** Everything as it was opened, nothing told. */
export async function anew(page) {
    await page.evaluate(() => {
        const figure = document.querySelector('knotwork-figure');
        figure.value = globalThis.start;
        globalThis.told.length = 0;
    });
    await settle(page);
}

/** Document, steps of history and the finished changes without source and name of gesture. */
export const outcome = (page) => page.evaluate(() => {
    const figure = document.querySelector('knotwork-figure');
    const document_ = figure.value;
    let steps = 0;
    const finished = globalThis.told.filter(({ type }) => type === 'change');
    const changes = finished.map(({ path, command }) => ({ path, command: { ...command, gesture: undefined } }));
    const sources = [...new Set(finished.map(({ source }) => source))];
    while (figure.scene.undo()) steps += 1;
    return { same: JSON.parse(JSON.stringify({ document: document_, steps, changes })), sources };
});

export const focus = (page, path) => page.evaluate((p) => document.querySelector('knotwork-figure').focusPoint(p), path);

/** Where an element of the document is seen, in pixels of the page. */
export async function placeOf(page, path) {
    await focus(page, path);
    const place = await page.evaluate(() => {
        const { shadowRoot } = document.querySelector('knotwork-figure');
        const [x, y] = shadowRoot.querySelector('.handle').style.translate.split(' ').map(parseFloat);
        const box = shadowRoot.querySelector('.view').getBoundingClientRect();
        return { x: box.left + x, y: box.top + y };
    });
    await page.keyboard.press('Escape');
    return place;
}

export async function dragged(page, path, to) {
    const from = await placeOf(page, path);
    await drag(page, from, to);
}

export async function clicked(page, path, to, button = 'Move') {
    await focus(page, path);
    await page.getByRole('group', { name: 'By clicks' }).getByRole('button', { name: button, exact: true }).click();
    await page.mouse.click(to.x, to.y);
}

export async function pressed(page, path, ...keys) {
    await focus(page, path);
    for (const key of keys) await page.keyboard.press(key);
    await page.waitForTimeout(runPause);
}

export const executed = (page, command) => page.evaluate((c) => document.querySelector('knotwork-figure').scene.execute(c), command);
export const field = (page, name) => page.getByRole('spinbutton', { name, exact: true });

export async function typed(page, name, value) {
    await field(page, name).fill(value);
    await field(page, name).press('Enter');
}

/** Runs a command each way; all come to the same, and each says whose hand it was. */
export async function assertSame(page, ways) {
    let first;
    for (const [source, way] of ways) {
        await anew(page);
        await way();
        const { same, sources } = await outcome(page);
        assert.deepEqual(sources, [source], 'the source');
        assert.equal(same.steps, 1, `one step of history by ${source}`);
        first ??= same;
        assert.deepEqual(same, first, `by ${source}`);
    }
    const before = await page.evaluate(() => globalThis.start);
    assert.notDeepEqual(first.document, before, 'something has changed');
}
