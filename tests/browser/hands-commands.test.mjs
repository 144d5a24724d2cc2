// Every command of a scene by every hand that has it: the same document, history and report.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { describe, it } from 'node:test';

import {
    anew, assertSame, clicked, dragged, executed, field, focus, openHands, outcome, placeOf, pressed, typed,
} from './hands-support.mjs';
import { documentOf, drag, settle, useBrowser } from './support.mjs';

const running = useBrowser();
const opened = (scene, options) => openHands(running, scene, options);
const point = (k) => `objects[0].points[${k}]`;
const knot = (k) => `objects[0].knots[${k}]`;

/** The verbs of all commands that hands have been seen to make. */
const seen = new Set();

/** assertSame for hands; `api` gets the command that they made. */
async function assertHands(page, ways) {
    let command;
    const [first, ...others] = ways;
    await assertSame(page, [
        [first[0], async () => {
            await first[1]();
            const told = await page.evaluate(() => globalThis.told.filter(({ type }) => type === 'change').at(-1)?.command);
            command = { ...told, gesture: undefined };
            Object.keys(command).forEach((verb) => seen.add(verb));
        }],
        ...others,
        ['api', () => executed(page, command)],
    ]);
}

async function twice(page, { x, y }) {
    await page.keyboard.press('Escape');
    await page.mouse.click(x, y);
    await page.waitForTimeout(60);
    await page.mouse.click(x, y);
    await settle(page);
}

/** A document in place of the one that was opened. */
async function shown(page, value) {
    await page.evaluate((given) => {
        const figure = document.querySelector('knotwork-figure');
        figure.value = given;
        globalThis.start = figure.value;
    }, value);
    await settle(page);
}

describe('every command by every hand', { timeout: 240_000 }, () => {
    it('sets a parameter of a B-function', async () => {
        const { page, context } = await opened('b-functions');
        const path = 'objects[0].bFunction.lambda';
        const [at, other] = [await placeOf(page, path), await placeOf(page, 'objects[0].bFunction.beta')];
        const target = { x: at.x - 0.2 * (other.x - at.x) / 0.25, y: at.y };
        const byKeys = async () => {
            await focus(page, path);
            await typed(page, 'Step of the arrow keys', '0.1');
            await page.locator('knotwork-figure .handle input').focus();
            await pressed(page, path, 'ArrowLeft', 'ArrowLeft');
            await typed(page, 'Step of the arrow keys', '0');
        };
        await assertHands(page, [
            ['pointer', () => dragged(page, path, target)],
            ['pointer', () => clicked(page, path, target)],
            ['key', byKeys],
            ['field', () => typed(page, 'λ, centre', '0.3')],
        ]);
        assert.equal((await documentOf(page)).objects[0].bFunction.lambda, 0.5, 'undone');
        await context.close();
    });

    it('sets the way, the centre and the angle of effects', async () => {
        const { page, context } = await opened('b-functions');
        const target = (await documentOf(page)).objects[0].id;
        await shown(page, { ...await documentOf(page), effects: [
            { target, kind: 'translate', by: [0.5, 0.25, 0] }, { target, kind: 'rotate', angle: 1, center: [0.5, 0.5, 0] },
        ] });
        for (const path of ['effects[0].by', 'effects[1].center']) {
            const at = await placeOf(page, path);
            const place = { x: at.x + 37, y: at.y - 21 };
            await assertHands(page, [
                ['pointer', async () => {
                    await focus(page, path);  // an effect has handles while something of its object is selected
                    await drag(page, at, place);
                }],
                ['pointer', () => clicked(page, path, place)],
            ]);
        }
        await assertHands(page, [['key', () => pressed(page, 'effects[1].angle', 'ArrowUp', 'ArrowRight')]]);
        await assertHands(page, [['key', () => pressed(page, 'effects[0].by', 'Shift+ArrowRight')]]);
        await context.close();
    });

    it('turns and scales a local curve', async () => {
        const { page, context } = await opened('b-functions');
        for (const key of ['r', 's']) {
            await assertHands(page, [['key', () => pressed(page, 'objects[0].poses[2]', key)]]);
        }
        await context.close();
    });

    it('moves a point, and many', async () => {
        const { page, context } = await opened();
        await assertHands(page, [['key', () => pressed(page, point(2), 'ArrowUp')]]);
        await assertHands(page, [['key', async () => {
            await focus(page, point(2));
            await page.keyboard.press('Control+a');
            for (const key of ['ArrowUp', 'ArrowUp']) await page.keyboard.press(key);
            await page.waitForTimeout(900);
        }]]);
        await context.close();
    });

    it('removes a knot, a point, and many points', async () => {
        const { page, context } = await opened();
        await assertHands(page, [
            ['key', () => pressed(page, knot(5), 'Delete')],
            ['field', () => page.getByRole('button', { name: 'Remove knot 6', exact: true }).click()],
        ]);
        await assertHands(page, [['key', async () => {
            await focus(page, point(4));
            await page.keyboard.press('Shift+PageDown');
            await page.keyboard.press('Delete');
        }]]);
        await context.close();
    });

    it('inserts a knot and a point by a double click', async () => {
        const { page, context } = await opened();
        const [a, b] = [await placeOf(page, knot(4)), await placeOf(page, knot(5))];
        const { id, knots } = (await documentOf(page)).objects[0];
        const middle = (knots[4] + knots[5]) / 2;
        await assertHands(page, [
            ['pointer', () => twice(page, { x: (a.x + b.x) / 2, y: a.y })],
            ['field', () => typed(page, 'Insert a knot at', String(middle))],
            ['api', () => executed(page, { insertKnot: { object: id, at: middle } })],
        ]);
        const [first, second] = [await placeOf(page, point(2)), await placeOf(page, point(3))];
        await assertHands(page, [['pointer', () => twice(page, { x: (first.x + second.x) / 2, y: (first.y + second.y) / 2 })]]);
        await context.close();
    });

    it('drops a knot on another and pulls it off again', async () => {
        const { page, context } = await opened();
        const next = await placeOf(page, knot(5));
        const at = await placeOf(page, knot(4));
        await dragged(page, knot(4), next);
        const { knots } = (await documentOf(page)).objects[0];
        assert.equal(knots[4], knots[5], 'one more of the same');
        await page.evaluate(() => { globalThis.start = document.querySelector('knotwork-figure').value; });
        await assertHands(page, [['pointer', () => dragged(page, knot(4), { x: (at.x + next.x) / 2, y: at.y })]]);
        await context.close();
    });

    it('adds an object', async () => {
        const { page, context } = await opened('b-functions');
        await assertHands(page, [['field', () => page.getByRole('button', { name: 'Compare', exact: true }).click()]]);
        await context.close();
    });

    it('takes back and does again', async () => {
        const { page, context } = await opened();
        const change = () => executed(page, { set: 'objects[0].degree', value: 2 });
        const after = async (act) => {
            await anew(page);
            await change();
            await act();
            return (await documentOf(page)).objects[0].degree;
        };
        const view = page.locator('knotwork-figure .view');
        const button = (name) => page.getByRole('button', { name, exact: true }).first();
        const undone = [() => view.press('Control+z'), () => button('Undo').click(),
            () => page.evaluate(() => document.querySelector('knotwork-figure').undo())];
        const redone = [() => view.press('Control+y'), () => button('Redo').click(),
            () => page.evaluate(() => document.querySelector('knotwork-figure').redo())];
        for (const [k, undo] of undone.entries()) {
            assert.equal(await after(undo), 3);
            await redone[k]();
            assert.equal((await documentOf(page)).objects[0].degree, 2);
            assert.equal((await outcome(page)).same.steps, 1);
        }
        await context.close();
    });

    it('has left out no verb', async () => {
        const source = await readFile(new URL('../../src/scene/commands.cpp', import.meta.url), 'utf8');
        const [, list] = /verbs\{([^}]*)\}/.exec(source);
        const verbs = [...list.matchAll(/"(\w+)"/g)].map(([, verb]) => verb);
        assert.ok(verbs.length >= 8);
        assert.deepEqual(verbs.filter((verb) => !seen.has(verb)), []);
    });
});
