// The page as a visitor meets it.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { describe, it } from 'node:test';
import { gzipSync } from 'node:zlib';

import { assertSilent, axeViolations, documentOf, figureReady, openFigure, openPage, pictureOf, settle, useBrowser } from './support.mjs';

const running = useBrowser();
const largestFile = 4 * 1024 * 1024;

const small = {
    knotwork: 1, title: 'A document of my own', description: 'Two hills.',
    objects: [{ id: 'hills', type: 'bspline-curve', degree: 2, points: [[0, 0], [1, 2], [2, 0], [3, 2], [4, 0]] }],
};

const opened = (path = '', options = {}) => openFigure(running, path, options);

const scenes = [['bspline-forms', 'B-spline: three forms'], ['b-functions', 'B-functions'], ['butterfly', 'Butterfly']];

/** Goes to a scene by the gallery. */
async function choose(page, id, title) {
    await page.getByRole('button', { name: 'Scenes' }).click();
    await page.locator(`.gallery a[href$="#${id}"]`).click();
    await page.waitForFunction((text) => document.querySelector('h1').textContent === text, title);
    await settle(page);
}

const refusalOf = (page) => page.locator('#refusal').innerText();

describe('the page', { timeout: 300_000 }, () => {
    it('opens on the butterfly without a word on the console or to its policy', async () => {
        const shown = await opened();
        assert.equal(await shown.page.locator('h1').innerText(), 'Butterfly');
        assert.equal(await shown.page.title(), 'Butterfly – Knotwork');
        assert.ok((await pictureOf(shown.page)).length > 5000, 'there is something in the picture');
        await assertSilent(shown);
        await shown.context.close();
    });

    it('plays from the start unless motion is to be reduced', async () => {
        const phase = (page) => page.evaluate(() =>
            document.querySelector('knotwork-figure').shadowRoot.querySelector('.scrubber').value);
        const moving = await opened('', { reducedMotion: 'no-preference' });
        const first = await pictureOf(moving.page);
        await moving.page.waitForFunction((before) =>
            document.querySelector('knotwork-figure').shadowRoot.querySelector('.scrubber').value !== before,
        await phase(moving.page));
        assert.ok(!(await pictureOf(moving.page)).equals(first));
        await moving.context.close();

        const still = await opened('', { reducedMotion: 'reduce' });
        const resting = await pictureOf(still.page);
        await still.page.waitForTimeout(500);
        assert.equal(await phase(still.page), '0');
        assert.ok((await pictureOf(still.page)).equals(resting));
        await still.context.close();
    });

    it('brings its first picture in less than 1 MB of downloads', async () => {
        const bodies = [];
        const { context } = await opened('', {
            before: (page) => page.on('response', (response) => {
                bodies.push(response.body().then((body) => [response.url(), body]));
            }),
        });
        const sizes = (await Promise.all(bodies)).map(([url, body]) => [url, gzipSync(body).length]);
        const total = sizes.reduce((sum, [, size]) => sum + size, 0);
        assert.ok(sizes.some(([url]) => url.endsWith('.wasm')), 'the module is among what was counted');
        assert.ok(total < 1_000_000, `${total} bytes: ${sizes.join(' ')}`);
        await context.close();
    });

    it('draws no frame in two idle seconds, and draws again when something changes', async () => {
        const { page, context } = await opened('#bspline-forms');
        await page.waitForTimeout(1000);  // until hover and announcements are over
        const counts = () => page.evaluate(() => [globalThis.observed.frames, globalThis.observed.copies]);
        const before = await counts();
        await page.waitForTimeout(2000);
        assert.deepEqual(await counts(), before);
        await page.evaluate(() => {
            document.querySelector('knotwork-figure').scene.execute({ set: 'objects[0].degree', value: 2 });
        });
        await settle(page);
        assert.ok((await counts())[1] > before[1], 'a change is drawn');
        await context.close();
    });

    it('opens scenes from the gallery, and says so in the title', async () => {
        const { page, context, ...rest } = await opened();
        for (const [id, title] of scenes) {
            await choose(page, id, title);
            assert.equal(await page.title(), `${title} – Knotwork`);
        }
        await assertSilent({ page, ...rest });
        await context.close();
    });

    it('opens a file', async () => {
        const shown = await opened();
        await shown.page.locator('input[type=file]').setInputFiles({
            name: 'hills.json', mimeType: 'application/json', buffer: Buffer.from(JSON.stringify(small)),
        });
        await shown.page.waitForFunction(() => document.querySelector('h1').textContent === 'A document of my own');
        assert.equal((await documentOf(shown.page)).objects[0].id, 'hills');
        await assertSilent(shown);
        await shown.context.close();
    });

    it('opens a document from an address', async () => {
        const { page, context } = await opened('?src=mine.json', {
            before: (page) => page.route('**/mine.json', (route) => route.fulfill({ json: small })),
        });
        assert.equal(await page.locator('h1').innerText(), 'A document of my own');
        await context.close();
    });

    it('shares what is shown as a link that opens it again', async () => {
        const { page, context } = await opened('#bspline-forms');
        await page.evaluate(() => {
            document.querySelector('knotwork-figure').scene.execute({ move: 'objects[0].points[2]', to: [0.5, 1.25] });
        });
        await page.getByRole('button', { name: 'Copy link' }).click();
        await page.waitForFunction(() => location.hash.startsWith('#v1.'));
        const address = page.url();
        const there = await context.newPage();
        await there.goto(address);
        await figureReady(there);
        assert.deepEqual((await documentOf(there)).objects[0].points[2], [0.5, 1.25]);
        await context.close();
    });

    it('says why a document is refused, and keeps what was there', async () => {
        const shown = await opened();
        const before = await documentOf(shown.page);
        const broken = { ...small, objects: [{ ...small.objects[0], degree: 99 }] };
        for (const [name, text, told] of [
            ['degree.json', JSON.stringify(broken), /objects\[0\]\.degree/],
            ['half.json', '{"knotwork": 1,', /SYNTAX/],
            ['big.json', ' '.repeat(largestFile + 1), /TOO_LARGE/],
        ]) {
            await shown.page.locator('input[type=file]').setInputFiles({
                name, mimeType: 'application/json', buffer: Buffer.from(text),
            });
            await shown.page.waitForFunction((source) =>
                new RegExp(source).test(document.getElementById('refusal').innerText), told.source);
            assert.deepEqual(await documentOf(shown.page), before);
        }
        await shown.page.locator('#refusal button').click();
        assert.equal(await refusalOf(shown.page), '');
        await assertSilent(shown);
        await shown.context.close();
    });

    it('shows the butterfly when the link that it was opened with is of a future version', async () => {
        const shown = await opened('#v9.j.%7B%7D');
        assert.match(await refusalOf(shown.page), /VERSION/);
        assert.equal((await documentOf(shown.page)).title, 'Butterfly');
        await assertSilent(shown);
        await shown.context.close();
    });

    it('speaks Norwegian, with decimal commas', async () => {
        const { page, context } = await opened('#bspline-forms', { locale: 'nb-NO' });
        assert.equal(await page.evaluate(() => document.documentElement.lang), 'nb');
        assert.equal(await page.locator('h1').innerText(), 'B-spline: tre former');
        const labels = await page.evaluate(() => globalThis.observed.texts);
        assert.ok(labels.some((label) => /^\d,\d$/.test(label)), `labels: ${labels}`);
        assert.ok(!labels.some((label) => /\d\.\d/.test(label)), `labels: ${labels}`);
        const cell = page.getByRole('spinbutton', { name: 'Punkt 1, y' });
        assert.equal(await cell.inputValue(), '-1,6');
        await cell.fill('-1,25');
        await cell.press('Enter');
        assert.equal((await documentOf(page)).objects[0].points[0][1], -1.25);
        await page.getByRole('combobox', { name: 'Språk' }).selectOption('en');
        assert.equal(await page.getByRole('spinbutton', { name: 'Point 1, y' }).inputValue(), '-1.25');
        await context.close();
    });

    it('has the colours of its figure in every theme', async () => {
        for (const theme of ['light', 'dark', 'contrast']) {
            const { page, context } = await opened();
            await page.getByRole('combobox', { name: 'Theme' }).selectOption(theme);
            const differing = await page.evaluate(() => {
                const names = ['ground', 'raised', 'line', 'edge', 'ink', 'quiet', 'accent', 'wash', 'bad', 'bad-wash'];
                const frame = document.querySelector('knotwork-figure').shadowRoot.querySelector('.frame');
                const of = (element, name) => getComputedStyle(element).getPropertyValue(`--${name}`).trim();
                return names.filter((name) => of(document.documentElement, name) !== of(frame, name));
            });
            assert.deepEqual(differing, [], theme);
            await context.close();
        }
    });

    it('never scrolls sideways, on a phone or at 400 %', async () => {
        const { page, context } = await opened();
        for (const [id, title] of scenes) {
            await choose(page, id, title);
            for (const width of [320, 360, 640]) {
                await page.setViewportSize({ width, height: 740 });
                await settle(page);
                const wide = await page.evaluate(() => document.documentElement.scrollWidth);
                assert.ok(wide <= width, `${id}: ${wide} in ${width}`);
            }
        }
        await context.close();
    });

    it('has nothing that axe objects to', async () => {
        for (const colorScheme of ['light', 'dark']) {
            const { page, context } = await opened('', { colorScheme });
            for (const [id, title] of scenes) {
                await choose(page, id, title);
                assert.deepEqual(await axeViolations(page, 20), [], `${id}, ${colorScheme}`);
            }
            await context.close();
        }
    });

    it('says so where there is no WebGL, and the numbers still work', async () => {
        const { page, context, said } = await opened('#bspline-forms', {
            script: () => {
                for (const { prototype } of [HTMLCanvasElement, OffscreenCanvas]) {
                    const { getContext } = prototype;
                    prototype.getContext = function refused(kind, ...rest) {
                        return kind === '2d' ? getContext.call(this, kind, ...rest) : null;
                    };
                }
            },
        });
        assert.match(await page.locator('knotwork-figure .fallback').innerText(), /WebGL/);
        const degree = page.getByRole('spinbutton', { name: 'Degree', exact: true });
        await degree.fill('2');
        await degree.press('Enter');
        assert.equal((await documentOf(page)).objects[0].degree, 2);
        assert.deepEqual(said, []);
        await context.close();
    });

    it('has the same words in each of its languages', async () => {
        const words = async (language) => JSON.parse(await readFile(
            new URL(`../../web/locales/${language}.json`, import.meta.url), 'utf8')).words;
        assert.deepEqual(Object.keys(await words('nb')), Object.keys(await words('en')));
    });
});
