// Algorithms step by step: picture, sentence and formula in step, by buttons, keys and the interface.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { describe, it } from 'node:test';

import { assertSilent, axeViolations, documentOf, openFigure, openPage, settle, useBrowser } from './support.mjs';

const running = useBrowser();

const opened = (scene, options = {}) => openFigure(running, `#${scene}`, options);

const frameOf = async (page) => (await documentOf(page)).objects[0].trace.frame;
const strip = (page) => page.getByRole('region', { name: 'Step by step' });
const button = (page, name) => strip(page).getByRole('button', { name, exact: true });

/** What the picture and the strip say about the step that is shown, once they are in step. */
async function told(page) {
    const { drawn, ...strip } = await toldNow(page);
    if (drawn.includes(strip.title)) return { drawn, ...strip };
    await page.waitForTimeout(300);  // a new scene has just been read, which may take its time
    return toldNow(page);
}

const toldNow = (page) => page.evaluate(() => {
    const figure = document.querySelector('knotwork-figure');
    const drawn = figure.scene.drawing().shapes.filter(({ role, kind }) => kind === 'label' && (role === 'trace' || role === 'label'));
    const { textContent: title } = figure.shadowRoot.querySelector('.trace h3');
    const { textContent: text } = figure.shadowRoot.querySelector('.trace p');
    return { drawn: drawn.map((shape) => shape.text), title, text, maths: figure.shadowRoot.querySelectorAll('.trace math').length };
});

const run = (page, command) => page.evaluate((given) => document.querySelector('knotwork-figure').scene.execute(given), command);

describe('a trace', { timeout: 300_000 }, () => {
    it('is stepped through by buttons and slider, each a step of history', async () => {
        const shown = await opened('knot-insertion');
        const { page } = shown;
        assert.equal(await frameOf(page), 2);
        await button(page, 'Previous step').click();
        assert.equal(await frameOf(page), 1);
        assert.equal((await told(page)).title, 'New points on the legs');
        await strip(page).getByRole('slider', { name: 'Step' }).press('Home');
        assert.equal(await frameOf(page), 0);
        await button(page, 'Previous step').click({ force: true });  // it says that it is disabled
        assert.equal(await frameOf(page), 0, 'there is none before the first');
        await button(page, 'Next step').click();
        assert.equal(await frameOf(page), 1);
        for (const frame of [0, 1, 2]) {
            await page.getByRole('button', { name: 'Undo' }).click();
            assert.equal(await frameOf(page), frame);
        }
        await assertSilent(shown);
        await shown.context.close();
    });

    it('shows the same step in the picture, with its formula as MathML', async () => {
        const { page, context } = await opened('bspline-forms');
        const panel = page.getByRole('combobox', { name: 'Step through' });
        const algorithms = (await panel.locator('option').evaluateAll((all) => all.map(({ value }) => value))).filter(Boolean);
        assert.deepEqual(algorithms, ['de-boor', 'cox-de-boor', 'factor-matrices', 'boehm', 'oslo']);
        let formulae = 0;
        for (const form of ['clamped', 'open', 'closed']) {
            await run(page, { set: 'objects[0].form', value: form });
            for (const algorithm of algorithms) {
                await panel.selectOption(algorithm);
                await button(page, 'Next step').click();
                await settle(page);
                const { drawn, title, text, maths } = await told(page);
                assert.ok(drawn.includes(title), `${algorithm}, ${form}: ${title} is not among ${drawn}`);
                assert.ok(text.length > 20);
                formulae += maths;
            }
        }
        assert.ok(formulae > 5, `${formulae} formulae`);
        const drawnAsMath = await page.evaluate(() => {
            const math = document.querySelector('knotwork-figure').shadowRoot.querySelector('.trace math');
            return math.namespaceURI.endsWith('MathML') && math.getBoundingClientRect().width > 20;
        });
        assert.ok(drawnAsMath);
        await panel.selectOption('');
        assert.equal(await strip(page).count(), 0);
        assert.equal((await documentOf(page)).objects[0].trace, undefined);
        await context.close();
    });

    it('is there for every other type of object that has one', async () => {
        const { page, context } = await opened('lane-riesenfeld');
        for (const [scene, algorithm] of [['lane-riesenfeld', 'lane-riesenfeld'], ['blending-curve', 'blend'],
            ['blending-surface', 'blend'], ['subdivision-surfaces', 'catmull-clark']]) {
            await page.evaluate((id) => { location.hash = id; }, scene);
            await page.waitForFunction((id) => [...document.querySelectorAll('h1')].length && location.hash === `#${id}`, scene);
            await page.evaluate((id) => document.querySelector('knotwork-figure').show(id), scene);
            await run(page, { set: 'objects[0].trace', value: { algorithm, frame: 1 } });
            await settle(page);
            const { drawn, title } = await told(page);
            assert.ok(drawn.includes(title), `${scene}: ${title} is not among ${drawn}`);
        }
        await context.close();
    });

    it('plays to its end as one step of history, and is told of politely', async () => {
        const { page, context } = await opened('knot-insertion');
        await run(page, { set: 'objects[0].trace.frame', value: 0 });
        await page.clock.install();
        await button(page, 'Play the steps').click();
        assert.equal(await frameOf(page), 1);
        await page.clock.runFor(3000);
        assert.equal(await frameOf(page), 2);
        await page.clock.runFor(3000);
        assert.equal(await button(page, 'Play the steps').count(), 1, 'it has stopped');
        assert.match(await page.evaluate(() =>
            document.querySelector('knotwork-figure').shadowRoot.querySelector('[role=status]').textContent), /^The refined polygon\. /);
        await page.getByRole('button', { name: 'Undo' }).click();
        assert.equal(await frameOf(page), 0);
        await context.close();
    });

    it('is stepped through by the element, which tells of each step', async () => {
        const { page, context } = await opened('knot-insertion');
        const steps = await page.evaluate(async () => {
            const figure = document.querySelector('knotwork-figure');
            const heard = [];
            figure.addEventListener('step', ({ detail }) => heard.push(detail));
            figure.step(-1);
            await new Promise((done) => { setTimeout(done); });
            figure.step(-1);
            await new Promise((done) => { setTimeout(done); });
            figure.step();
            return heard;
        });
        assert.deepEqual(steps, [1, 0, 1].map((frame) => ({ source: 'api', frame, frames: 3 })));
        await context.close();
    });

    it('fits on a phone, and axe has nothing against it', async () => {
        for (const options of [{}, { viewport: { width: 320, height: 640 }, colorScheme: 'dark' }]) {
            const { page, context } = await opened('oslo', options);
            assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
            assert.deepEqual(await axeViolations(page), []);
            await context.close();
        }
    });
});

describe('a formula', { timeout: 60_000 }, () => {
    it('is nothing but mathematics, whatever its text is', async () => {
        const { page, context, said } = await openPage(running, 'mathml.html', { html: '<p>mathematics</p>' });
        await page.route('**/mathml.mjs', async (route) => route.fulfill({
            body: await readFile(new URL('../../web/mathml.mjs', import.meta.url), 'utf8'), contentType: 'text/javascript',
        }));
        const made = await page.evaluate(async () => {
            const { formulaOf } = await import('./mathml.mjs');
            const ns = 'xmlns="http://www.w3.org/1998/Math/MathML"';
            return [
                `<math ${ns} display="block" onclick="alert(1)"><mi>x</mi><script>1</script><maction href="x"><mn>2</mn></maction></math>`,
                `<math ${ns}><mi>x</math>`, '<p>x</p>', '', `<math ${ns}><img xmlns="http://www.w3.org/1999/xhtml" src="x"/><mo>&lt;</mo></math>`,
            ].map((text) => formulaOf(text)?.outerHTML ?? null);
        });
        assert.deepEqual(made, ['<math display="block"><mi>x</mi></math>', null, null, null, '<math><mo>&lt;</mo></math>']);
        said.length = 0;  // the policy speaks of the handler that it has refused
        await context.close();
    });
});
