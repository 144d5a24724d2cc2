// The page as people have it: zoomed, narrow, in the colours that they chose, without motion.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';

import { PNG } from 'pngjs';

import { assertSilent, openFigure, pictureOf, useBrowser } from './support.mjs';

const running = useBrowser();

const opened = (options, scene = 'b-functions') => openFigure(running, `#${scene}`, options);

/** Everything that a hand can press, with its size and where it ends. */
const controlsOf = (page) => page.evaluate(() => {
    const figure = document.querySelector('knotwork-figure').shadowRoot;
    const list = [...document.querySelectorAll('a[href], button, select, input, summary'),
        ...figure.querySelectorAll('button, select, input, summary')];
    return list.map((control) => {
        const target = control.closest('label, .tool, .card') ?? control;
        const box = target.getBoundingClientRect();
        const style = getComputedStyle(control);
        const shown = box.width > 1 && box.height > 1 && style.visibility !== 'hidden' && !control.closest('.aside, .skip');
        const name = control.getAttribute('aria-label') ?? control.title ?? control.textContent;
        return { name: `${control.localName} ${name}`, shown, width: box.width, height: box.height, right: box.right };
    }).filter(({ shown }) => shown);
});

const overflowOf = (page) => page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);

for (const [name, width, height] of [['a phone of 360 pixels', 360, 740], ['400 % zoom', 320, 225], ['200 % zoom', 640, 450]]) {
    describe(name, { timeout: 60_000 }, () => {
        it('scrolls one way only, and shows every control whole', async () => {
            const shown = await opened({ viewport: { width, height } });
            assert.ok(await overflowOf(shown.page) <= 0, 'nothing sticks out to the side');
            const out = (await controlsOf(shown.page)).filter(({ right }) => right > width + 0.5);
            assert.deepEqual(out, []);
            await assertSilent(shown);
            await shown.context.close();
        });
    });
}

describe('targets', { timeout: 60_000 }, () => {
    it('are 24 pixels for a mouse', async () => {
        const { page, context } = await opened({});
        const small = (await controlsOf(page)).filter(({ width, height }) => Math.min(width, height) < 23.9);
        assert.deepEqual(small, []);
        await context.close();
    });

    it('are 44 pixels high for a finger', async () => {
        const { page, context } = await opened({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
        const small = (await controlsOf(page)).filter(({ width, height }) => height < 43.9 || width < 40);
        assert.deepEqual(small, []);
        await context.close();
    });
});

describe('chosen colours', { timeout: 60_000 }, () => {
    it('give the picture more contrast where the reader or the system asks for it', async () => {
        const looks = [
            [{}, 'light', 0xfc], [{ contrast: 'more' }, 'contrast', 0xff], [{ forcedColors: 'active' }, 'contrast', 0xff],
            [{ contrast: 'more', colorScheme: 'dark' }, 'contrast-dark', 0],
        ];
        for (const [options, theme, ground] of looks) {
            const { page, context } = await opened(options);
            const frame = page.locator('knotwork-figure .frame');
            assert.equal(await frame.getAttribute('data-theme'), theme);
            const { data } = PNG.sync.read(await pictureOf(page));
            assert.equal(data[0], ground, theme);
            await context.close();
        }
    });

    it('leave every state of a control visible where colours are forced', async () => {
        const { page, context } = await opened({ forcedColors: 'active' });
        const told = await page.evaluate(() => {
            const figure = document.querySelector('knotwork-figure').shadowRoot;
            const values = figure.querySelector('[aria-expanded="true"]');
            const box = figure.querySelector('input[type="checkbox"]');
            return { forced: matchMedia('(forced-colors: active)').matches,
                outline: getComputedStyle(values).outlineStyle, checkbox: getComputedStyle(box).appearance };
        });
        assert.deepEqual(told, { forced: true, outline: 'solid', checkbox: 'auto' });
        await context.close();
    });

    it('make edges and quiet words as strong as the ink where more contrast is asked for', async () => {
        const { page, context } = await opened({ contrast: 'more' });
        const told = await page.evaluate(() => {
            const figure = document.querySelector('knotwork-figure').shadowRoot;
            const colour = (element) => getComputedStyle(element).color;
            return { figure: colour(figure.querySelector('.values .shape')) === colour(figure.querySelector('.frame')),
                page: colour(document.querySelector('.intro p')) === colour(document.body) };
        });
        assert.deepEqual(told, { figure: true, page: true });
        await context.close();
    });
});

describe('reduced motion', { timeout: 60_000 }, () => {
    it('starts nothing by itself and paints no frame', async () => {
        const { page, context } = await opened({}, 'butterfly');
        assert.equal(await page.evaluate(() => document.querySelector('knotwork-figure').playing), false);
        const before = await page.evaluate(() => globalThis.observed.frames);
        await page.waitForTimeout(400);
        assert.equal(await page.evaluate(() => globalThis.observed.frames), before);
        await context.close();
    });
});
