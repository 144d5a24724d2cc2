// Scenes and figures that come and go leave nothing behind: no memory of the module, no objects of
// WebGL, no elements and listeners, nothing on JavaScript's heap.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { describe, it } from 'node:test';

import { figureReady, openPage, useBrowser } from './support.mjs';

const running = useBrowser();
const scenes = readFileSync(new URL('../../src/scene/builtin/order.txt', import.meta.url), 'utf8').trim().split('\n');
const warmth = 2;             // rounds through all scenes before anything is counted
const looks = 4;
const heapSlack = 800_000;    // bytes: engines keep more and more compiled code, half of this in a thousand times
const nodeSlack = 20;         // of the browser's own fields
const moduleSlack = 20_000;   // bytes: what the allocator keeps in pieces

const css = 'body { margin: 0 } knotwork-figure { width: 320px; --knotwork-height: 100px }';

/** Runs before the page's own scripts: objects of WebGL that were made and not deleted. */
function countObjects() {
    globalThis.living = {};
    const { prototype } = WebGL2RenderingContext;
    for (const name of Object.keys(Object.getOwnPropertyDescriptors(prototype))) {
        const [, verb, kind] = /^(create|delete|fence)(\w+)$/.exec(name) ?? [];
        if (!verb) continue;
        const original = prototype[name];
        const by = verb === 'delete' ? -1 : 1;
        prototype[name] = function counted(...args) {
            if (by > 0 || args[0]) globalThis.living[kind] = (globalThis.living[kind] ?? 0) + by;
            return original.apply(this, args);
        };
    }
}

async function opened(html) {
    const shown = await openPage(running, 'flat.html', { html, css, script: countObjects, viewport: { width: 340, height: 700 } });
    const devtools = await shown.context.newCDPSession(shown.page);
    return { ...shown, devtools };
}

/** All that must not grow, after everything that nobody holds is gone. */
async function held({ page, devtools }) {
    await page.waitForTimeout(800);  // the announcer has spoken
    for (let k = 0; k < 3; k += 1) await devtools.send('HeapProfiler.collectGarbage');
    const { usedSize: heap } = await devtools.send('Runtime.getHeapUsage');
    const { nodes, jsEventListeners: listeners } = await devtools.send('Memory.getDOMCounters');
    const { living, stats } = await page.evaluate(async () => ({
        living: globalThis.living, stats: await customElements.get('knotwork-figure').stats(),
    }));
    const objects = Object.values(living).reduce((sum, count) => sum + count, 0);
    const { views, held: handles, glObjects, memory } = stats;
    return { exact: { objects, views, handles, glObjects }, listeners, nodes, heap, memory };
}

function assertFlat(before, after) {
    assert.ok(before.exact.objects > 5, 'objects are counted');
    assert.deepEqual(after.exact, before.exact);
    // Those before may include some of figures that are not collected yet.
    assert.ok(after.listeners <= before.listeners, `${after.listeners - before.listeners} listeners more`);
    assert.ok(after.nodes <= before.nodes + nodeSlack, `${after.nodes - before.nodes} nodes more`);
    assert.ok(after.memory - before.memory < moduleSlack, `module: ${after.memory - before.memory} bytes more`);
    assert.ok(after.heap - before.heap < heapSlack, `heap: ${after.heap - before.heap} bytes more`);
}

/** What grows while this function of the page acts so many times, beyond a few rounds of warmth. */
async function growth(html, act, count) {
    const shown = await opened(html);
    await figureReady(shown.page);
    await shown.page.evaluate(act, [scenes, warmth * scenes.length]);
    const before = await held(shown);
    await shown.page.evaluate(act, [scenes, count]);
    for (let look = 1; look < looks && !isFlat(before, await held(shown)); look += 1);
    assertFlat(before, await held(shown));
    await shown.context.close();
}

async function changeScenes([names, count]) {
    const figure = document.querySelector('knotwork-figure');
    for (let k = 0; k < count; k += 1) await figure.show(names[k % names.length]);
    await figure.show(names[0]);
}

async function changeFigures([names, count]) {
    for (let k = 0; k < count; k += 1) {
        const figure = document.createElement('knotwork-figure');
        figure.setAttribute('scene', names[k % names.length]);
        figure.setAttribute('controls', 'minimal');
        document.body.prepend(figure);
        await figure.ready;
        if (k % 2) figure.dispose();
        figure.remove();
    }
}

const figure = (controls) => `<knotwork-figure scene="bspline-forms" controls="${controls}"></knotwork-figure>`;

/** Whether it is flat already; a browser frees some things a little later. */
function isFlat(before, after) {
    try {
        assertFlat(before, after);
        return true;
    } catch {
        return false;
    }
}

describe('nothing is left behind by', { timeout: 300_000 }, () => {
    it('a thousand scenes', () => growth(figure('minimal'), changeScenes, 1000));
    it('a hundred panels of values', () => growth(figure('full'), changeScenes, 100));
    it('a thousand figures', () => growth(figure('none'), changeFigures, 1000));
});
