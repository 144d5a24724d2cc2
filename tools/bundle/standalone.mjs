import { readFile, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { gzipSync } from 'node:zlib';

import { bundleToText } from './modules.mjs';
import { distribution, project } from './paths.mjs';

const moduleScript = /[ \t]*<script\b[^>]*\btype="module"[^>]*\bsrc="([^"]+)"[^>]*><\/script>\n?/g;
const link = /[ \t]*<link\b[^>]*>\n?/g;

/**
 * Writes dist/standalone.html: the page with its styles, its script and its wasm in one file, for
 * places where a page may load nothing else (a file from a stick, a sandboxed frame). Inline module
 * scripts run there; the wasm lies beside them as text that the page unpacks.
 */
export async function writeStandalone() {
    const page = await readFile(distribution('index.html'), 'utf8');
    const scripts = [...page.matchAll(moduleScript)].map((match) => match[1]);
    if (scripts.length === 0) throw new Error('index.html has no module script to put inline');
    const styled = await replaceAsync(page.replace(moduleScript, ''), link, inlineLink);
    const inlined = [
        `<script type="text/plain" id="knotwork-wasm">${await packedWasm()}</script>`,
        `<script type="module">${scriptText(await bundleToText(scripts.map(source)))}</script>`,
    ].join('\n');
    await writeFile(distribution('standalone.html'), beforeEndOfBody(styled, inlined));
}

/** @param {string} address of a script, as the page names it */
const source = (address) => project('web', path.posix.normalize(address));

async function packedWasm() {
    const wasm = await readFile(distribution('knotwork-page.wasm'));
    return gzipSync(wasm, { level: 9 }).toString('base64');
}

/**
 * A script as the content of an element: nothing in it may look like markup.
 * @param {string} script
 */
function scriptText(script) {
    return script.replaceAll('</script', '<\\/script').replaceAll('<!--', '\\x3c!--');
}

/**
 * What takes the place of a link to another file.
 * @param {string} element
 */
async function inlineLink(element) {
    const address = /\bhref="([^"]+)"/.exec(element)?.[1] ?? '';
    const relation = /\brel="([^"]+)"/.exec(element)?.[1];
    if (/^(data:|https?:)/.test(address)) return element;
    if (relation === 'stylesheet') {
        return `<style>\n${await readFile(distribution(address), 'utf8')}</style>\n`;
    }
    if (relation === 'icon' && address.endsWith('.svg')) {
        const picture = await readFile(distribution(address));
        return element.replace(address, () => `data:image/svg+xml;base64,${picture.toString('base64')}`);
    }
    return '';
}

/**
 * @param {string} page
 * @param {string} addition
 */
function beforeEndOfBody(page, addition) {
    const end = page.lastIndexOf('</body>');
    return end < 0 ? `${page}\n${addition}\n` : `${page.slice(0, end)}${addition}\n${page.slice(end)}`;
}

/**
 * @param {string} text
 * @param {RegExp} pattern a global one
 * @param {(found: string) => Promise<string>} replacement
 */
async function replaceAsync(text, pattern, replacement) {
    const replaced = await Promise.all(Array.from(text.matchAll(pattern), (match) => replacement(match[0])));
    return text.replace(pattern, () => /** @type {string} */ (replaced.shift()));
}
