// What the browser tests share: a server of the delivered files, a browser, and pages that keep a
// record of everything that they should not have said.
import assert from 'node:assert/strict';
import { access, readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { after, before } from 'node:test';
import { fileURLToPath } from 'node:url';

import { chromium } from 'playwright-core';

import { serve } from '../../tools/serve.mjs';

/** The folder under test; another build can be named in the environment. */
export const distribution = process.env.KNOTWORK_DIST ?? fileURLToPath(new URL('../../dist/', import.meta.url));
const browsers = ['/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome'];
export const browserFlags = [
    '--headless', '--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader',
    '--disable-background-networking', '--disable-component-update', '--disable-sync', '--no-first-run',
    '--force-color-profile=srgb', '--hide-scrollbars',
];
const policy = "script-src 'self' 'wasm-unsafe-eval'; style-src 'self'";

export async function browserPath() {
    for (const path of [process.env.KNOTWORK_CHROMIUM, ...browsers]) {
        if (path && await access(path).then(() => true, () => false)) return path;
    }
    throw new Error(`No browser: install Debian's package chromium, or name one in KNOTWORK_CHROMIUM.`);
}

/** Starts server and browser for the tests of one file, and stops them after the last. */
export function useBrowser() {
    const running = { unheard: new Set() };
    before(async () => {
        running.server = await serve({ directory: distribution });
        running.browser = await chromium.launch({ executablePath: await browserPath(), args: browserFlags });
    });
    after(async () => {
        const said = [...running.unheard].flat();
        await running.browser?.close();
        await running.server?.close();
        assert.deepEqual(said, [], 'no page says anything on the console');
    });
    return running;
}

/** Runs in every page before its own scripts: counts what a quiet page does not do. */
function observe() {
    const counts = { frames: 0, copies: 0, contexts: [], violations: [], texts: [] };
    globalThis.observed = counts;
    document.addEventListener('securitypolicyviolation', (event) => {
        counts.violations.push(`${event.violatedDirective} ${event.blockedURI} ${event.sample}`);
    });
    const { requestAnimationFrame } = globalThis;
    globalThis.requestAnimationFrame = (callback) => {
        counts.frames += 1;
        return requestAnimationFrame(callback);
    };
    for (const { prototype } of [HTMLCanvasElement, globalThis.OffscreenCanvas].filter(Boolean)) {
        const { getContext } = prototype;
        prototype.getContext = function observed(kind, ...rest) {
            const context = getContext.call(this, kind, ...rest);
            if (kind === 'webgl2' && !counts.contexts.includes(context)) counts.contexts.push(context);
            return context;
        };
    }
    const counted = (prototype, name) => {
        const original = prototype[name];
        prototype[name] = function observed(...args) {
            counts.copies += 1;
            return original.apply(this, args);
        };
    };
    counted(CanvasRenderingContext2D.prototype, 'drawImage');
    counted(ImageBitmapRenderingContext.prototype, 'transferFromImageBitmap');
    const { fillText, strokeText } = CanvasRenderingContext2D.prototype;
    CanvasRenderingContext2D.prototype.fillText = function observed(...args) {
        if (!counts.texts.includes(args[0])) counts.texts.push(args[0]);
        if (!globalThis.withoutLabels) fillText.apply(this, args);
    };
    CanvasRenderingContext2D.prototype.strokeText = function observed(...args) {
        if (!globalThis.withoutLabels) strokeText.apply(this, args);
    };
}

/** What the test's own tool says where it keeps pages from being kept for offline. */
const blockedWorker = 'Service Worker registration blocked by Playwright';

/** Everything that pages of a context should not have said, as they say it. */
function listen(context) {
    const said = [];
    context.on('console', (message) => {
        if (message.text() !== blockedWorker) said.push(`${message.type()}: ${message.text()}`);
    });
    context.on('weberror', (problem) => said.push(`error: ${problem.error().stack ?? problem.error()}`));
    context.on('requestfailed', (request) => said.push(`failed: ${request.url()}`));
    context.on('response', (response) => {
        if (response.status() >= 400) said.push(`${response.status()}: ${response.url()}`);
    });
    return said;
}

/** A context whose test fails when it is closed after one of its pages has said anything. */
async function quietContext({ browser, unheard }, options) {
    const context = await browser.newContext(options);
    const said = listen(context);
    unheard.add(said);
    const close = context.close.bind(context);
    context.close = async () => {
        const heard = [...said];
        unheard.delete(said);
        await close();
        assert.deepEqual(heard, [], 'no page says anything on the console');
    };
    return { context, said };
}

/**
 * A page at rest: reduced motion, one device pixel a CSS pixel, light, English, unless told otherwise.
 * @param {ReturnType<typeof useBrowser>} running
 * @param {string} path
 * @param {object} [options] of the browser's context; `html` makes `path` a page of this markup,
 *     `css` its style sheet; `script` runs before its own; `before` gets it before it goes anywhere
 */
export async function openPage({ server, ...running }, path = '', { html, css = '', script, before, ...options } = {}) {
    const { context, said } = await quietContext(running, {
        viewport: { width: 1280, height: 900 }, reducedMotion: 'reduce', colorScheme: 'light',
        locale: 'en-GB', serviceWorkers: 'block', ...options,
    });
    const page = await context.newPage();
    const fetched = [];
    page.on('request', (request) => fetched.push(request.url()));
    await page.addInitScript(observe);
    if (script) await page.addInitScript(script);
    if (html !== undefined) await servePage(page, path, html, css);
    await before?.(page);
    await page.goto(server.url + path);
    return { page, context, said, fetched };
}

async function servePage(page, path, html, css) {
    const body = `<!doctype html><html lang="en"><head><title>Test</title><link rel="icon" href="favicon.svg">
        <link rel="stylesheet" href="test.css"><script type="module" src="element.mjs"></script></head>
        <body>${html}</body></html>`;
    await page.route(`**/${path}`, (route) => route.fulfill({
        body, contentType: 'text/html; charset=utf-8', headers: { 'Content-Security-Policy': policy },
    }));
    await page.route('**/test.css', (route) => route.fulfill({ body: css, contentType: 'text/css' }));
}

/** The same with the first picture of its figure. */
export async function openFigure(running, path, options) {
    const shown = await openPage(running, path, options);
    await figureReady(shown.page);
    return shown;
}

/** What axe objects to in a page, having found at least so much to look at. */
export async function axeViolations(page, leastPasses = 10) {
    const axe = createRequire(import.meta.url).resolve('axe-core/axe.min.js');
    await page.evaluate(await readFile(axe, 'utf8'));
    const found = await page.evaluate(() => globalThis.axe.run());
    assert.ok(found.passes.length > leastPasses, 'axe has looked');
    return found.violations.flatMap(({ id, nodes }) => nodes.map((node) => `${id}: ${node.target} ${node.html}`));
}

/** Waits until this figure has its first picture. */
export async function figureReady(page, selector = 'knotwork-figure') {
    await page.waitForFunction((name) => document.querySelector(name)?.scene, selector);
    await page.evaluate(async (name) => {
        await document.querySelector(name).ready;
        await new Promise((done) => { requestAnimationFrame(() => requestAnimationFrame(done)); });
    }, selector);
}

/** The canonical document of a figure. */
export const documentOf = (page, selector = 'knotwork-figure') =>
    page.evaluate((name) => document.querySelector(name).value, selector);

/** The figure's picture as bytes of a PNG. */
export async function pictureOf(page, selector = 'knotwork-figure') {
    const url = await page.evaluate((name) =>
        document.querySelector(name).shadowRoot.querySelector('canvas').toDataURL(), selector);
    return Buffer.from(url.slice(url.indexOf(',') + 1), 'base64');
}

/** Fails with everything that the page said on the console or to its policy. */
export async function assertSilent({ page, said }) {
    const violations = await page.evaluate(() => globalThis.observed.violations);
    assert.deepEqual([...said, ...violations], []);
}

/**
 * Places (in CSS pixels of the page) where the pointer would take hold of something, found as a hand
 * finds them: by moving over the picture and looking at the cursor. Neighbouring ones are one place.
 * `from` and `to` say in which part of the picture to look, 0 to 1 from its left and top.
 */
export function handlesOf(page, { from = [0, 0], to = [1, 1] } = {}) {
    return page.evaluate(([name, distance, [left, top], [right, bottom]]) => {
        const view = document.querySelector(name).shadowRoot.querySelector('.view');
        const box = view.getBoundingClientRect();
        const cursorAt = (x, y) => {
            view.dispatchEvent(new PointerEvent('pointermove', {
                clientX: x, clientY: y, pointerType: 'mouse', pointerId: 1, bubbles: true,
            }));
            return view.style.cursor;
        };
        const empty = cursorAt(box.left + 3, box.top + box.height / 2);
        const groups = [];
        for (let y = box.top + top * box.height + 2; y < box.top + bottom * box.height; y += distance) {
            for (let x = box.left + left * box.width + 2; x < box.left + right * box.width; x += distance) {
                const cursor = cursorAt(x, y);
                if (cursor === empty) continue;
                const group = groups.find((g) => g.cursor === cursor &&
                    g.places.some(([px, py]) => Math.hypot(px - x, py - y) < 2.5 * distance));
                if (group) group.places.push([x, y]);
                else groups.push({ cursor, places: [[x, y]] });
            }
        }
        view.dispatchEvent(new PointerEvent('pointerleave', { pointerType: 'mouse', pointerId: 1 }));
        const mean = (list) => list.reduce((sum, value) => sum + value, 0) / list.length;
        return groups.map(({ cursor, places }) => ({
            cursor, x: mean(places.map(([x]) => x)), y: mean(places.map(([, y]) => y)), size: places.length,
        }));
    }, ['knotwork-figure', 5, from, to]);
}

/** Drags with the real mouse, in steps as a hand would. */
export async function drag(page, from, to) {
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    await page.mouse.move((from.x + to.x) / 2, (from.y + to.y) / 2, { steps: 4 });
    await page.mouse.move(to.x, to.y, { steps: 4 });
    await page.mouse.up();
    await page.evaluate(() => new Promise((done) => { requestAnimationFrame(() => requestAnimationFrame(done)); }));
}

/** Waits for the next two frames of the browser. */
export const settle = (page) => page.evaluate(() =>
    new Promise((done) => { requestAnimationFrame(() => requestAnimationFrame(done)); }));

/**
 * Waits until this function of the page answers with something true; it may take its time for that.
 * @param {import('playwright-core').Page} page
 * @param {(given: any) => any} act
 * @param {any} [given]
 */
export async function until(page, act, given, patience = 20_000) {
    const end = Date.now() + patience;
    while (!await page.evaluate(act, given)) {
        assert.ok(Date.now() < end, `waited in vain for ${act}`);
        await page.waitForTimeout(50);
    }
}
