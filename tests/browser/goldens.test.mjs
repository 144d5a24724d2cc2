// Pictures of the scenes against those that were looked at and found good. Labels are left out, since
// the fonts of machines differ. UPDATE_GOLDENS=1 writes the pictures anew; look at them afterwards.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { readFile, writeFile } from 'node:fs/promises';
import { describe, it } from 'node:test';

import pixelmatch from 'pixelmatch';
import { PNG } from 'pngjs';

import { figureReady, openPage, pictureOf, useBrowser } from './support.mjs';

const running = useBrowser();
const differingShare = 0.001;  // of the pixels; browsers of other versions blend a little differently
const golden = (name) => new URL(`goldens/${name}.png`, import.meta.url);

/** Every scene in light; some of them also in the dark and as a phone has them. */
const sizes = { light: [802, 500], dark: [802, 500], phone: [360, 480] };
const scenes = readFileSync(new URL('../../src/scene/builtin/order.txt', import.meta.url), 'utf8').trim().split('\n');
const inEveryLight = ['butterfly', 'b-functions', 'blending-surface'];

/**
 * @param {string} scene
 * @param {keyof typeof sizes} look
 */
async function pictureOfScene(scene, look) {
    const [width, height] = sizes[look];
    const { page, context } = await openPage(running, 'golden.html', {
        html: `<knotwork-figure scene="${scene}" controls="none"></knotwork-figure>`,
        css: `body { margin: 0 } knotwork-figure { width: ${width}px; --knotwork-height: ${height}px }`,
        colorScheme: look === 'dark' ? 'dark' : 'light',
        viewport: { width: width + 18, height: height + 20 },
        script: 'globalThis.withoutLabels = true;',
    });
    await figureReady(page);
    const picture = await pictureOf(page);
    await context.close();
    return picture;
}

function differing(actual, expected) {
    assert.deepEqual([actual.width, actual.height], [expected.width, expected.height]);
    const { width, height } = expected;
    return pixelmatch(actual.data, expected.data, undefined, width, height, { threshold: 0.1 }) / (width * height);
}

function compared(scene, look) {
    it(`of ${scene} (${look}) is the one that was found good`, async () => {
        const file = golden(look === 'light' ? scene : `${scene}-${look}`);
        const picture = await pictureOfScene(scene, look);
        if (process.env.UPDATE_GOLDENS === '1') await writeFile(file, picture);
        const expected = PNG.sync.read(await readFile(file));
        const share = differing(PNG.sync.read(picture), expected);
        assert.ok(share <= differingShare, `${(100 * share).toFixed(3)} % of the pixels differ`);
    });
}

describe('the picture', { timeout: 300_000 }, () => {
    for (const scene of scenes) compared(scene, 'light');
    for (const scene of inEveryLight) {
        compared(scene, 'dark');
        compared(scene, 'phone');
    }
});
