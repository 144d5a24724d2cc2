// The values panel: axioms, comparisons, and a control for every field of every kind of object.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';

import { assertSilent, axeViolations, documentOf, handlesOf, openFigure, settle, useBrowser } from './support.mjs';

const running = useBrowser();

const opened = (scene, options = {}) => openFigure(running, `#${scene}`, options);

/** Shows a document that is made of these objects. */
async function openedWith(...objects) {
    const shown = await opened('bspline-forms');
    await shown.page.evaluate((all) => document.querySelector('knotwork-figure').show({ knotwork: 1, objects: all }), objects);
    await settle(shown.page);
    return shown;
}

const field = (page, name) => page.getByRole('spinbutton', { name, exact: true });

async function type(page, name, text) {
    await field(page, name).fill(text);
    await field(page, name).press('Enter');
}

const checklist = (page) => page.getByRole('list', { name: 'Axioms of a B-function', exact: true });

describe('the axioms', { timeout: 300_000 }, () => {
    it('are checked while a formula is typed, with place and number of what fails', async () => {
        const shown = await opened('b-function-axioms');
        const { page } = shown;
        const first = checklist(page).first();
        assert.deepEqual((await first.getByRole('listitem').allInnerTexts()).map((text) => /holds|fails/.exec(text)[0]),
            ['fails', 'holds', 'fails', 'fails', 'fails']);
        assert.match(await first.innerText(), /B\(1\) = 0/);
        assert.match(await first.innerText(), /B′\(0\.5004\) = −0\.00783/);
        await page.getByRole('textbox', { name: 'B(t)', exact: true }).first().fill('t');
        await page.getByRole('textbox', { name: 'B(t)', exact: true }).first().press('Enter');
        await page.getByText('5 of 5 hold').first().waitFor();
        assert.ok(!/fails/.test(await first.innerText()));
        await assertSilent(shown);
        await shown.context.close();
    });

    it('are tried on a formula that is not in the scene', async () => {
        const { page, context } = await opened('b-functions');
        const before = await documentOf(page);
        await page.getByText('Axioms of a B-function').click();
        await page.getByRole('textbox', { name: 'Try B(t) =' }).fill('t^3');
        const tried = page.getByRole('status').getByRole('list', { name: 'Axioms of a B-function, t^3' });
        assert.equal((await tried.innerText()).match(/fails/g).length, 1, 'it is not symmetric');
        assert.deepEqual(await documentOf(page), before);
        await context.close();
    });

    it('mark the place of a mistake in a formula', async () => {
        const { page, context } = await opened('b-functions');
        const before = await documentOf(page);
        await page.getByText('Axioms of a B-function').click();
        const input = page.getByRole('textbox', { name: 'Try B(t) =' });
        await input.fill('t^2*(3-2*x)');
        assert.equal(await input.getAttribute('aria-invalid'), 'true');
        assert.equal(await page.locator('knotwork-figure .pointed mark').innerText(), 'x)');
        await input.fill('sin(pi*t)^2');
        assert.equal(await input.getAttribute('aria-invalid'), null);
        await page.getByRole('button', { name: 'Use it' }).click();
        assert.equal(await input.getAttribute('aria-invalid'), 'true', 'a curve cannot be blended by what is no B-function');
        assert.deepEqual(await documentOf(page), before);
        await input.fill('t^2*(3-2*t)');
        await page.getByRole('button', { name: 'Use it' }).click();
        assert.deepEqual((await documentOf(page)).objects[0].bFunction, { family: 'formula', expression: 't^2*(3-2*t)' });
        await context.close();
    });
});

describe('a comparison', { timeout: 300_000 }, () => {
    it('puts the same curve under another B-function beside it, as one step of history', async () => {
        const { page, context } = await opened('b-functions');
        const before = await documentOf(page);
        await page.getByRole('combobox', { name: 'Compare with' }).selectOption('logistic');
        await page.getByRole('button', { name: 'Compare' }).click();
        const { objects: [one, other] } = await documentOf(page);
        assert.equal(other.bFunction.family, 'logistic');
        assert.notEqual(other.style.colour, one.style.colour);
        assert.deepEqual([other.model, other.knots, other.poses], [one.model, one.knots, one.poses]);
        await settle(page);
        const graph = page.getByRole('img', { name: /blend: Expo-rational \(ERB\).*Logistic/ }).first();
        assert.equal(await graph.locator('path:not(.grid)').count(), 2);
        await page.getByRole('button', { name: 'Undo' }).click();
        assert.deepEqual(await documentOf(page), before);
        await settle(page);
        assert.equal(await page.locator('knotwork-figure .graph').count(), 0);
        await context.close();
    });
});

describe('the values panel', { timeout: 300_000 }, () => {
    it('has a control for every field of every built-in scene, and each scene can be changed by it', async () => {
        const shown = await opened('bspline-forms');
        const found = await shown.page.evaluate(async () => {
            const figure = document.querySelector('knotwork-figure');
            const root = figure.shadowRoot;
            const wrong = [];
            const kw = await customElements.get('knotwork-figure').api();
            for (const { id } of kw.scenes) {
                await figure.show(id);
                figure.pause();
                const sections = [...root.querySelectorAll('.values-inner > *')];
                const { schema } = figure.scene;
                schema.forEach(({ object, fields }, k) => {
                    const shownPaths = new Set([...sections[k].querySelectorAll('[data-path]')].map((e) => e.dataset.path));
                    for (const option of sections[k].querySelectorAll('option')) shownPaths.add(option.value);
                    const missing = fields.filter(({ path }) => !shownPaths.has(path) && !['trace.algorithm', 'trace.frame'].includes(path));
                    wrong.push(...missing.map(({ path, kind }) => `${id}/${object}: ${path} (${kind})`));
                });
                const before = JSON.stringify(figure.value);
                const number = sections[0].querySelector('[data-path="style.width"] input[type=text]');
                number.value = '7';
                number.dispatchEvent(new Event('change'));
                if (JSON.stringify(figure.value) === before) wrong.push(`${id}: nothing has changed`);
            }
            return wrong;
        });
        assert.deepEqual(found, []);
        await assertSilent(shown);
        await shown.context.close();
    });

    it('opens the fields of the object that is selected, and leaves the others folded', async () => {
        const { page, context } = await opened('blending-compare');
        const open = () => page.evaluate(() => [...document.querySelector('knotwork-figure').shadowRoot
            .querySelectorAll('.object')].map((section) => section.open));
        assert.deepEqual(await open(), [true, false]);
        assert.equal(await page.getByRole('combobox', { name: 'Family' }).count(), 1);
        await page.getByRole('heading', { name: 'expo', exact: true }).click();
        await page.getByRole('spinbutton', { name: 'β, steepness' }).waitFor();
        assert.deepEqual(await open(), [true, true]);
        assert.equal(await page.getByRole('spinbutton', { name: 'β, steepness' }).inputValue(), '12');
        await page.getByRole('heading', { name: 'expo', exact: true }).click();
        const [handle] = (await handlesOf(page, { to: [0.6, 1] })).filter(({ cursor }) => cursor === 'grab');
        await page.mouse.click(handle.x, handle.y);
        await page.waitForFunction(() => document.querySelector('knotwork-figure').selection?.object === 1);
        assert.deepEqual(await open(), [true, true]);
        await context.close();
    });

    it('shows long lists page by page', async () => {
        const points = Array.from({ length: 1234 }, (_, k) => [k / 100, Math.sin(k / 50)]);
        const { page, context } = await openedWith({ id: 'many', type: 'point-cloud', points });
        await page.getByText('Control points').or(page.getByText('Points', { exact: true })).first().click();
        const rows = page.locator('knotwork-figure details[data-path=points] tbody tr');
        assert.equal(await rows.count(), 50);
        await page.getByRole('button', { name: 'Next page' }).click();
        await type(page, 'Point 51, y', '3.5');
        assert.equal((await documentOf(page)).objects[0].points[50][1], 3.5);
        await page.getByRole('button', { name: 'Remove point 52' }).click();
        assert.equal((await documentOf(page)).objects[0].points.length, 1233);
        await page.getByRole('button', { name: 'Add a point' }).click();
        await field(page, 'Point 1234, x').waitFor();
        assert.ok(await rows.count() <= 50);
        assert.ok(await page.evaluate(() => document.querySelector('knotwork-figure').shadowRoot.querySelectorAll('*').length) < 2500);
        await context.close();
    });

    it('shows the net of a surface row by row', async () => {
        const net = [0, 1, 2, 3].map((i) => [0, 1, 2].map((j) => [i, j, 0]));
        const { page, context } = await openedWith({ id: 'net', type: 'bspline-surface', degree: [2, 2], form: ['clamped', 'clamped'], points: net });
        await page.getByRole('combobox', { name: 'Row' }).selectOption('points[2]');
        await type(page, 'Point 3, z', '1,5');
        assert.deepEqual((await documentOf(page)).objects[0].points[2][2], [2, 2, 1.5]);
        assert.equal(await page.getByRole('button', { name: /Remove point/ }).count(), 0, 'no point of a net goes alone');
        await context.close();
    });

    it('gives a solid its vertices, to be moved', async () => {
        const { page, context } = await openedWith({ id: 'body', type: 'subdivision-surface', scheme: 'catmull-clark', levels: 1, mesh: { solid: 'cube' } });
        const mesh = page.getByRole('combobox', { name: 'Mesh' });
        assert.equal(await mesh.inputValue(), 'cube');
        await page.evaluate(() => document.querySelector('knotwork-figure').scene.execute({ set: 'objects[0].style.width', value: 2.1 - 0.9 }));
        await field(page, 'Width').waitFor();
        assert.equal(await field(page, 'Width').inputValue(), '1.2', 'and no 1.2000000000000002');
        await mesh.selectOption({ label: 'Its own vertices' });
        await type(page, 'Point 1, x', '-2');
        assert.equal((await documentOf(page)).objects[0].mesh.vertices[0][0], -2);
        assert.equal(await page.getByText('6 faces').count(), 1);
        await mesh.selectOption('dodecahedron');
        assert.deepEqual((await documentOf(page)).objects[0].mesh, { solid: 'dodecahedron' });
        await context.close();
    });

    it('moves, turns and scales the patches of a surface, and says beside the field why not', async () => {
        const { page, context } = await opened('blending-surface');
        await type(page, 'Pose 1, Move z', '0.75');
        await type(page, 'Pose 1, Turn by', '0.5');
        await type(page, 'Pose 1, about x', '1');
        await type(page, 'Pose 1, Scale y', '2');
        const [pose] = (await documentOf(page)).objects[0].poses;
        assert.deepEqual(pose, { local: [0, 1], translate: [1, 0, 0.75], rotate: { axis: [1, 0, 1], angle: 0.5 }, scale: [1, 2, 1] });
        await type(page, 'Pose 1, Patch u', '99');
        assert.equal(await field(page, 'Pose 1, Patch u').getAttribute('aria-invalid'), 'true');
        await page.getByRole('button', { name: 'Pose another patch' }).click();
        assert.equal((await documentOf(page)).objects[0].poses.length, 3);
        await context.close();
    });

    it('has nothing that axe objects to, and scrolls sideways on no phone', async () => {
        for (const scene of ['b-function-axioms', 'blending-surface', 'blending-compare']) {
            const { page, context } = await opened(scene, { viewport: { width: 320, height: 640 } });
            assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), scene);
            assert.deepEqual(await axeViolations(page), [], scene);
            await context.close();
        }
    });
});
