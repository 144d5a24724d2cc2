// What the page costs in a real browser with software rendering at 1280 × 720: how soon there is a
// picture, how many frames a second an animation has, and how long the page's one thread works on a
// frame. Work is what handlers of the pointer, callbacks of frames and what they queue take; the
// GPU's part, which here are other threads of the same processor, is not in it. Frames that show
// no other picture are not counted.
import { fileURLToPath } from 'node:url';

import { chromium } from 'playwright-core';

import { serve } from '../../tools/serve.mjs';
import { browserFlags, browserPath, figureReady, handlesOf } from '../browser/support.mjs';
import { median } from './ratio.mjs';

/**
 * @typedef {object} Limit
 * @property {number} [atLeast]
 * @property {number} [atMost]
 *
 * @typedef {{ name: string, unit: string, value: number } & Limit} Measured
 */

const viewport = { width: 1280, height: 720 };
const watchFor = 3000;  // milliseconds of animation
const moves = 60;       // of a pointer that drags
const warmth = 8;       // moves before them: the first few are no drag yet
const loads = 5;

/** Runs in the page before its own scripts. */
function observeFrames() {
    const seen = { work: [], times: [], late: [], firstPicture: 0 };
    globalThis.seen = seen;
    let frame = 0;
    let worked = 0;
    let painted = false;
    let began = 0;
    let movedIn;
    const request = globalThis.requestAnimationFrame.bind(globalThis);
    const count = (now) => {
        if (painted) {
            seen.work.push(worked);
            seen.times.push(now);
            worked = 0;
        }
        painted = false;
        frame += 1;
        request(count);
    };
    request(count);
    globalThis.requestAnimationFrame = (callback) => request((now) => {
        const start = performance.now();
        callback(now);
        queueMicrotask(() => { worked += performance.now() - start; });
    });
    globalThis.addEventListener('pointermove', () => {
        began = performance.now();
        movedIn ??= frame;
    }, true);
    globalThis.addEventListener('pointermove', () => { worked += performance.now() - began; });
    const { transferFromImageBitmap } = ImageBitmapRenderingContext.prototype;
    ImageBitmapRenderingContext.prototype.transferFromImageBitmap = function observed(...args) {
        transferFromImageBitmap.apply(this, args);
        seen.firstPicture ||= performance.now();
        painted = true;
        if (movedIn !== undefined) seen.late.push(frame - movedIn);
        movedIn = undefined;
    };
    globalThis.seeAnew = () => {
        for (const list of [seen.work, seen.times, seen.late]) list.length = 0;
        worked = 0;
        movedIn = undefined;
    };
}

/** A torus of 16 × 25 quads, which after four levels has 102 400. */
function fineTorus() {
    const [around, across] = [25, 16];
    const corner = (i, j) => {
        const [u, v] = [2 * Math.PI * i / around, 2 * Math.PI * j / across];
        const out = 2 + Math.cos(v);
        return [out * Math.cos(u), out * Math.sin(u), Math.sin(v)];
    };
    const places = Array.from({ length: around * across }, (_, k) => [Math.floor(k / across), k % across]);
    const at = (i, j) => across * (i % around) + j % across;
    const mesh = {
        vertices: places.map(([i, j]) => corner(i, j)),
        faces: places.map(([i, j]) => [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]),
    };
    return {
        knotwork: 1, title: 'A torus of 102 400 faces', view: { mode: '3d', panes: ['curve'], camera: { elevation: 0.7 } },
        objects: [{ id: 'torus', type: 'subdivision-surface', scheme: 'catmull-clark', levels: 4, mesh }],
    };
}

/** @param {{ browser: any, url: string }} running @param {string} address @param {object} [document] */
async function opened({ browser, url }, address, document) {
    const context = await browser.newContext({ viewport, locale: 'en-GB', colorScheme: 'light', serviceWorkers: 'block' });
    const page = await context.newPage();
    await page.addInitScript(observeFrames);
    await page.goto(url + address);
    await figureReady(page);
    if (document) await page.evaluate((shown) => globalThis.document.querySelector('knotwork-figure').show(shown), document);
    return page;
}

const seenBy = (page) => page.evaluate(() => globalThis.seen);

/** From now on. */
const seeAnew = (page) => page.evaluate(() => globalThis.seeAnew());

/** @returns {Promise<Measured[]>} */
async function firstPicture(running) {
    const times = [];
    for (let k = 0; k < loads; k += 1) {
        const page = await opened(running, '');
        times.push((await seenBy(page)).firstPicture);
        await page.context().close();
    }
    return [{ name: 'first picture', unit: 'ms', value: median(times), atMost: 1000 }];
}

/** @returns {Promise<Measured[]>} */
async function animation(running) {
    const page = await opened(running, '#butterfly');
    await page.waitForTimeout(1000);
    await seeAnew(page);
    await page.waitForTimeout(watchFor);
    const { work, times } = await seenBy(page);
    await page.context().close();
    const rate = times.length < 2 ? 0 : 1000 * (times.length - 1) / (times.at(-1) - times[0]);
    return [
        { name: 'butterfly, frames a second', unit: '', value: rate, atLeast: 50 },
        { name: 'butterfly, work a frame', unit: 'ms', value: median(work), atMost: 6 },
    ];
}

/**
 * A drag of the handle that is next to the middle of the picture.
 * @param {string} what
 * @param {number} atMost milliseconds of work a frame
 * @param {string} address
 * @param {object} [document]
 * @returns {(running: any) => Promise<Measured[]>}
 */
const drag = (what, atMost, address, document) => async (running) => {
    const page = await opened(running, address, document);
    const middle = { x: viewport.width / 2, y: viewport.height / 2 };
    const distance = ({ x, y }) => Math.hypot(x - middle.x, y - middle.y);
    const handles = (await handlesOf(page, { from: [0.3, 0.3], to: [0.7, 0.7] })).filter(({ cursor }) => cursor === 'grab');
    const [handle] = handles.sort((a, b) => distance(a) - distance(b));
    if (!handle) throw new Error(`${what}: no handle was found`);
    await page.mouse.move(handle.x, handle.y);
    await page.mouse.down();
    const objects = () => page.evaluate(() => JSON.stringify(document.querySelector('knotwork-figure').value.objects));
    const before = await objects();
    const moveTo = async (k) => {
        await page.mouse.move(handle.x + k, handle.y + k % 7);
        await page.evaluate(() => new Promise((done) => { requestAnimationFrame(done); }));
    };
    for (let k = 1; k <= warmth; k += 1) await moveTo(k);
    await seeAnew(page);
    for (let k = 1; k <= moves; k += 1) await moveTo(warmth + k);
    const { work, late } = await seenBy(page);
    if (before === await objects()) throw new Error(`${what}: nothing was dragged`);
    await page.context().close();
    return [
        { name: `${what}, work a frame of a drag`, unit: 'ms', value: median(work), atMost },
        { name: `${what}, from input to picture at most`, unit: 'frames', value: Math.max(...late), atMost: 2 },
    ];
};

/** What shows no long task has none of more than this, in milliseconds: browsers tell no shorter ones. */
const shortest = 50;

/**
 * The longest task of the page's one thread while it does something with the torus.
 * @param {string} what
 * @param {number} atMost milliseconds
 * @param {(figure: any) => Promise<unknown>} act
 * @returns {(running: any) => Promise<Measured[]>}
 */
const longestTask = (what, atMost, act) => async (running) => {
    const page = await opened(running, '#rose', fineTorus());
    const doing = await page.evaluateHandle(`(${act})`);
    const value = await page.evaluate(async ([act, least]) => {
        const tasks = [least];
        const observer = new PerformanceObserver((list) => tasks.push(...list.getEntries().map(({ duration }) => duration)));
        const settled = () => new Promise((done) => { setTimeout(done, 1000); });
        await settled();
        observer.observe({ type: 'longtask' });
        const figure = document.querySelector('knotwork-figure');
        // In a task of the page: one of the debugger's is not told of.
        await new Promise((done, failed) => { setTimeout(() => act(figure).then(done, failed)); });
        await settled();
        return Math.max(...tasks);
    }, [doing, shortest]);
    await page.context().close();
    return [{ name: `${what} of 102 400 faces, longest task`, unit: 'ms', value, atMost }];
};

const measurements = [
    { name: 'page: first picture', measure: firstPicture },
    { name: 'page: butterfly', measure: animation },
    { name: 'page: blending-surface', measure: drag('blending-surface', 8, '#blending-surface') },
    { name: 'page: Catmull–Clark', measure: drag('Catmull–Clark of 102 400 faces', 25, '#subdivision-surfaces', fineTorus()) },
    { name: 'page: export SVG', measure: longestTask('SVG', 100, (figure) => figure.exportAs('svg', {})) },
    { name: 'page: export OBJ', measure: longestTask('OBJ', 100, (figure) => figure.exportAs('obj', {})) },
    { name: 'page: export glTF', measure: longestTask('glTF', 100, (figure) => figure.exportAs('gltf', {})) },
    {
        name: 'page: level',
        measure: longestTask('a level more, which makes a mesh', 100, async (figure) => {
            figure.scene.execute({ set: 'objects[0].levels', value: 1 });
            await new Promise((done) => { setTimeout(done, 500); });
            figure.scene.execute({ set: 'objects[0].levels', value: 4 });
        }),
    },
];

/** @param {Measured} row @returns {boolean} whether its limit is kept */
function report({ name, unit, value, atLeast, atMost }) {
    const kept = atLeast === undefined ? value <= Number(atMost) : value >= atLeast;
    const limit = atLeast === undefined ? `at most ${atMost}` : `at least ${atLeast}`;
    console.log(`  ${name.padEnd(64)} ${`${value.toFixed(1)} ${unit}`.padEnd(12)} ${limit}: ${kept ? 'kept' : 'MISSED'}`);
    return kept;
}

/**
 * Measures what has the wanted words in its name; without a browser it says why it does not.
 * @param {string} wanted
 * @param {URL} distribution
 * @returns {Promise<boolean>} whether all limits are kept
 */
export async function measurePage(wanted, distribution) {
    const chosen = measurements.filter(({ name }) => name.includes(wanted));
    if (chosen.length === 0) return true;
    console.log('\nthe page in a browser, software rendering, 1280 × 720');
    const executablePath = await browserPath().catch((error) => {
        console.log(`  not measured: ${error.message}`);
    });
    if (!executablePath) return true;
    const server = await serve({ directory: fileURLToPath(distribution) });
    const browser = await chromium.launch({ executablePath, args: browserFlags });
    let kept = true;
    for (const { measure } of chosen) {
        for (const row of await measure({ browser, url: server.url })) kept = report(row) && kept;
    }
    await browser.close();
    await server.close();
    return kept;
}
