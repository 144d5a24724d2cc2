// Walks with the tab key: each stop has a name and shows that it has the focus, and none is a trap.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';

import pixelmatch from 'pixelmatch';
import { PNG } from 'pngjs';

import { openFigure, settle, useBrowser } from './support.mjs';

const running = useBrowser();
const mostStops = 200;
const ringPixels = 40;  // at least, of a ring two pixels wide around the smallest target
const around = 8;       // CSS pixels about a stop in which its ring is

/** Where the focus is: what kind of element has it, and its box; null where it has left the page. */
const stopOf = (page) => page.evaluate(() => {
    let element = document.activeElement;
    while (element?.shadowRoot?.activeElement) element = element.shadowRoot.activeElement;
    if (!element || element === document.body) return null;
    const seen = element.closest('.aside')?.closest('label') ?? element;  // some are hidden in their labels
    const { x, y, width, height } = seen.getBoundingClientRect();
    const of = element.closest('.tool, .values, .bar, .trace')?.className ?? '';
    return { kind: `${element.localName} ${element.type ?? ''} ${element.className} in ${of}`, box: { x, y, width, height } };
});

async function nameOfFocused(devtools) {
    const { nodes } = await devtools.send('Accessibility.getFullAXTree');
    const isFocused = ({ properties = [] }) => properties.some(({ name, value }) => name === 'focused' && value.value);
    return nodes.filter(isFocused).at(-1)?.name?.value ?? '';
}

/** How many pixels show that the focus is there; it is taken away, and the walk goes on from there. */
async function ringOf(page, { box }) {
    const { width, height } = page.viewportSize();
    const [left, top] = [Math.max(0, box.x - around), Math.max(0, box.y - around)];
    const clip = {
        x: left, y: top,
        width: Math.min(width, box.x + box.width + around) - left, height: Math.min(height, box.y + box.height + around) - top,
    };
    const focused = PNG.sync.read(await page.screenshot({ clip }));
    await page.evaluate(() => {
        let element = document.activeElement;
        while (element?.shadowRoot?.activeElement) element = element.shadowRoot.activeElement;
        element?.blur();
    });
    const without = PNG.sync.read(await page.screenshot({ clip }));
    return pixelmatch(focused.data, without.data, undefined, without.width, without.height, { threshold: 0.1 });
}

/** All stops in their order, each kind of them looked at once. */
async function walk(page) {
    const devtools = await page.context().newCDPSession(page);
    const [stops, rings] = [[], new Map()];
    for (let k = 0; k < mostStops; k += 1) {
        await page.keyboard.press('Tab');
        const stop = await stopOf(page);
        if (!stop) break;
        stops.push({ ...stop, name: await nameOfFocused(devtools) });
        if (!rings.has(stop.kind)) rings.set(stop.kind, await ringOf(page, stop));
    }
    await devtools.detach();
    return { stops, rings: [...rings] };
}

/** How many stops it is back to the first one. */
async function countBackwards(page, first) {
    for (let k = 1; k < mostStops; k += 1) {
        await page.keyboard.press('Shift+Tab');
        if ((await stopOf(page))?.kind === first.kind) return k;
    }
    return mostStops;
}

const ways = {
    'in a window': { viewport: { width: 1280, height: 900 } },
    'in the dark': { viewport: { width: 1280, height: 900 }, colorScheme: 'dark' },
    'on a phone': { viewport: { width: 360, height: 740 } },
    'in forced colours': { viewport: { width: 1280, height: 900 }, forcedColors: 'active' },
};

describe('each stop of the tab key', { timeout: 180_000 }, () => {
    for (const [way, options] of Object.entries(ways)) {
        it(`has a name and a ring, and none keeps it, ${way}`, async () => {
            const { page, context } = await openFigure(running, '#butterfly', options);
            await settle(page);
            const { stops, rings } = await walk(page);
            assert.ok(stops.length > 20 && stops.length < mostStops, `${stops.length} stops`);
            assert.deepEqual(stops.filter(({ name }) => name === ''), []);
            assert.deepEqual(rings.filter(([, pixels]) => pixels < ringPixels), []);
            if (way === 'in a window') assert.equal(await countBackwards(page, stops[0]), stops.length, 'the same way back');
            await context.close();
        });
    }
});
