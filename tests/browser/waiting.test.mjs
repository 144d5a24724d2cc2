// What takes a while is done in slices: the page goes on meanwhile, a bar says how far it is, and
// whoever does not want to wait ends it without trace.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';

import { assertSilent, axeViolations, figureReady, openFigure, useBrowser } from './support.mjs';

const running = useBrowser();

/** An octahedron of 524 288 triangles, its file in OBJ of 70 MB. */
const large = {
    knotwork: 1, title: 'Large',
    objects: [{ id: 'm', type: 'subdivision-surface', scheme: 'loop', levels: 8, mesh: { solid: 'octahedron' }, show: { points: false } }],
};

/** Lets a page stand still between two slices, so that what it shows meanwhile can be looked at. */
function makeHoldable() {
    const { postMessage } = MessagePort.prototype;
    const waiting = [];
    let held = false;
    MessagePort.prototype.postMessage = function heldBack(...args) {
        if (held) waiting.push(() => postMessage.apply(this, args));
        else postMessage.apply(this, args);
    };
    globalThis.hold = (hold) => {
        held = hold;
        if (!held) for (const post of waiting.splice(0)) post();
    };
}

const hold = (page, held) => page.evaluate((on) => globalThis.hold(on), held);

/** A page that shows it, quiet again. */
async function openLarge(options) {
    const opened = await openFigure(running, '#rose', { ...options, script: makeHoldable });
    await opened.page.evaluate(async (document) => {
        const figure = globalThis.figure = globalThis.document.querySelector('knotwork-figure');
        await figure.show(document);
        figure.scene.execute({ set: 'title', value: 'Larger' });
        globalThis.state = async () => JSON.stringify([figure.value, figure.scene.canUndo, figure.scene.canRedo,
            figure.scene.revision, (await figure.constructor.stats()).held]);
        globalThis.former = await globalThis.state();
    }, large);
    await figureReady(opened.page);
    return opened;
}

/** Begins to write the file; how that ended is told as text. */
const begin = (page) => page.evaluate(() => {
    const { figure } = globalThis;
    globalThis.ended = figure.exportAs('svg').then(({ size }) => String(size), ({ name }) => name);
});
const ended = (page) => page.evaluate(() => globalThis.ended);
const bar = (page) => page.getByRole('progressbar', { name: 'Writing the file' });

/** That nothing has changed and nothing is left, and that the next export is the whole of it. */
async function assertUntouched(page) {
    const { former, state, whole, written } = await page.evaluate(async () => ({
        former: globalThis.former,
        state: await globalThis.state(),
        whole: globalThis.figure.scene.exportAs('csv').length,
        written: (await globalThis.figure.exportAs('csv')).size,
    }));
    assert.equal(state, former);
    assert.equal(written, whole);
    await bar(page).waitFor({ state: 'hidden' });
}

describe('an export of a large mesh', { timeout: 300_000 }, () => {
    it('is written between other tasks, and is what it is at once', async () => {
        const shown = await openLarge();
        const { page, context } = shown;
        const seen = await page.evaluate(async () => {
            const { figure } = globalThis;
            const fractions = [];
            let tasks = 0;
            let over = false;
            const channel = new MessageChannel();
            channel.port1.onmessage = () => {
                tasks += 1;
                if (!over) setTimeout(() => channel.port2.postMessage(0));
            };
            channel.port2.postMessage(0);
            const blob = await figure.exportAs('obj', {}, { progress: (fraction) => fractions.push(fraction) });
            over = true;
            const same = await blob.text() === figure.scene.exportAs('obj');
            return { fractions, tasks, same, type: blob.type };
        });
        assert.ok(seen.same, 'to the byte');
        assert.equal(seen.type, 'model/obj');
        assert.ok(seen.fractions.length >= 5, `${seen.fractions.length} slices`);
        assert.ok(seen.fractions.every((fraction, i) => fraction >= (seen.fractions[i - 1] ?? 0) && fraction <= 1));
        assert.ok(seen.tasks >= 3, `${seen.tasks} other tasks`);
        assert.equal(await bar(page).count(), 0, 'whoever follows it has a bar of their own');
        await assertSilent(shown);
        await context.close();
    });

    it('shows that a large picture is being made, which can be ended too', async () => {
        const { page, context } = await openFigure(running, '#blending-surface');
        await page.evaluate(() => {
            globalThis.figure = document.querySelector('knotwork-figure');
            const { toBlob } = HTMLCanvasElement.prototype;
            // As long as it is looked at, the browser is not ready.
            HTMLCanvasElement.prototype.toBlob = function held(...args) { globalThis.pack = () => toBlob.apply(this, args); };
            globalThis.begin = () => {
                globalThis.ended = globalThis.figure.exportAs('png', { width: 900 }).then(({ type }) => type, ({ name }) => name);
            };
            globalThis.begin();
        });
        await bar(page).waitFor();
        assert.equal(await bar(page).getAttribute('value'), null, 'how far it is, nobody knows');
        await page.locator('knotwork-figure').getByRole('button', { name: 'Cancel' }).click();
        assert.equal(await ended(page), 'AbortError');
        await bar(page).waitFor({ state: 'hidden' });
        await page.evaluate(() => globalThis.begin());
        await bar(page).waitFor();
        await page.evaluate(() => globalThis.pack());
        assert.equal(await ended(page), 'image/png');
        await bar(page).waitFor({ state: 'hidden' });
        await context.close();
    });

    it('shows how far it is, and is ended by its button and by Escape', async () => {
        const { page, context } = await openLarge();
        const figure = page.locator('knotwork-figure');
        await begin(page);
        await bar(page).waitFor();
        await hold(page, true);
        assert.deepEqual(await axeViolations(page), []);
        await hold(page, false);
        await figure.getByRole('button', { name: 'Cancel' }).click();
        assert.equal(await ended(page), 'AbortError');
        await assertUntouched(page);
        await begin(page);
        await bar(page).waitFor();
        const before = await page.evaluate(() => globalThis.figure.selection);
        await page.evaluate(() => globalThis.figure.focus());
        await page.keyboard.press('Escape');
        assert.equal(await ended(page), 'AbortError');
        assert.deepEqual(await page.evaluate(() => globalThis.figure.selection), before, 'that was all that Escape did');
        await assertUntouched(page);
        await context.close();
    });

    it('is ended by whoever asked for it', async () => {
        const { page, context } = await openLarge();
        const reason = await page.evaluate(() => {
            const control = new AbortController();
            const progress = (fraction) => fraction >= 0.5 && control.abort('enough');
            return globalThis.figure.exportAs('svg', {}, { signal: control.signal, progress }).then(() => 'written', (why) => why);
        });
        assert.equal(reason, 'enough');
        await assertUntouched(page);
        await context.close();
    });

    it('has the scene as it was when it began, whatever is done to it meanwhile', async () => {
        const { page, context } = await openLarge();
        const { whole, written, levels } = await page.evaluate(async () => {
            const { figure } = globalThis;
            const whole = figure.scene.exportAs('obj').length;
            let edited = false;
            const progress = () => {
                if (!edited) figure.scene.execute({ set: 'objects[0].levels', value: 2 });
                edited = true;
            };
            const { size } = await figure.exportAs('obj', {}, { progress });
            return { whole, written: size, levels: figure.value.objects[0].levels };
        });
        assert.equal(written, whole);
        assert.equal(levels, 2);
        await context.close();
    });

    it('goes on while the context of the pictures is lost', async () => {
        const { page, context } = await openLarge();
        await begin(page);
        await page.evaluate(() => {
            const [lost] = globalThis.observed.contexts;
            lost.getExtension('WEBGL_lose_context').loseContext();
        });
        assert.ok(Number(await ended(page)) > 1e7, 'all of it');
        await context.close();
    });

    it('ends with its figure, and leaves nothing behind', async () => {
        const { page, context } = await openLarge();
        await begin(page);
        await bar(page).waitFor();
        await page.evaluate(() => globalThis.figure.remove());
        assert.equal(await ended(page), 'AbortError');
        const held = await page.evaluate(async () => (await customElements.get('knotwork-figure').stats()).held);
        assert.equal(held, 0);
        await context.close();
    });
});

describe('the dialog that writes files', { timeout: 300_000 }, () => {
    it('shows how far it is, and Escape ends the file before the dialog', async () => {
        const { page, context } = await openLarge();
        await page.getByRole('button', { name: 'Export' }).click();
        const dialog = page.getByRole('dialog', { name: 'Export' });
        const writing = dialog.getByRole('progressbar', { name: 'Writing larger.svg' });
        await dialog.getByRole('button', { name: 'Save as SVG' }).click();
        await writing.waitFor();
        await hold(page, true);
        assert.equal(await dialog.getByRole('status').innerText(), 'Writing larger.svg. Escape cancels.');
        assert.equal(await dialog.getByRole('button', { name: 'Save as CSV' }).getAttribute('aria-disabled'), 'true');
        assert.deepEqual(await axeViolations(page), []);
        await hold(page, false);
        await page.keyboard.press('Escape');
        await writing.waitFor({ state: 'hidden' });
        assert.equal(await dialog.getByRole('status').innerText(), 'Cancelled.');
        const download = page.waitForEvent('download');
        await dialog.getByRole('button', { name: 'Save as OBJ' }).click();
        assert.equal((await download).suggestedFilename(), 'larger.obj');
        await dialog.getByText('larger.obj has been saved.').waitFor();
        await page.keyboard.press('Escape');
        assert.equal(await dialog.count(), 0);
        await assertUntouched(page);
        await context.close();
    });
});
