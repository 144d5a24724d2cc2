// Pictures of the scenes against those that were looked at and found good. Labels are left out, since
// the fonts of machines differ. UPDATE_GOLDENS=1 writes the pictures anew; look at them afterwards.
import assert from 'node:assert/strict';
import { readFile, writeFile } from 'node:fs/promises';
import { describe, it } from 'node:test';

import pixelmatch from 'pixelmatch';
import { PNG } from 'pngjs';

import { figureReady, openPage, pictureOf, useBrowser } from './support.mjs';

const running = useBrowser();
const differingShare = 0.001;  // of the pixels; browsers of other versions blend a little differently
const golden = (name) => new URL(`goldens/${name}.png`, import.meta.url);

async function pictureOfScene(scene, colorScheme) {
    const { page, context } = await openPage(running, 'golden.html', {
        html: `<knotwork-figure scene="${scene}" controls="none"></knotwork-figure>`,
        css: 'body { margin: 0 } knotwork-figure { width: 802px; --knotwork-height: 500px }',
        colorScheme,
        viewport: { width: 820, height: 520 },
    });
    await figureReady(page);
    await page.evaluate(() => {
        globalThis.withoutLabels = true;
        document.querySelector('knotwork-figure').setAttribute('theme', 'auto');  // and so draws again
    });
    await page.waitForTimeout(100);
    const picture = await pictureOf(page);
    await context.close();
    return picture;
}

function differing(actual, expected) {
    assert.deepEqual([actual.width, actual.height], [expected.width, expected.height]);
    const { width, height } = expected;
    return pixelmatch(actual.data, expected.data, undefined, width, height, { threshold: 0.1 }) / (width * height);
}

describe('the picture', { timeout: 300_000 }, () => {
    for (const [scene, scheme] of [['butterfly', 'light'], ['bspline-forms', 'light'], ['b-functions', 'dark']]) {
        it(`of ${scene} (${scheme}) is the one that was found good`, async () => {
            const picture = await pictureOfScene(scene, scheme);
            if (process.env.UPDATE_GOLDENS === '1') await writeFile(golden(scene), picture);
            const expected = PNG.sync.read(await readFile(golden(scene)));
            const share = differing(PNG.sync.read(picture), expected);
            assert.ok(share <= differingShare, `${(100 * share).toFixed(3)} % of the pixels differ`);
        });
    }
});
