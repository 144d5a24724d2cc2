import { readFile, writeFile } from 'node:fs/promises';
import { gzipSync } from 'node:zlib';

import { bundleToText } from './modules.mjs';
import { distribution } from './paths.mjs';

/** @param {string} script */
const inline = (script) => `<script type="module">\n${script.replaceAll('</script', '<\\/script')}</script>`;

/**
 * Writes dist/standalone.html: the page with its styles, its script and its wasm in one file, for
 * places where a page may load nothing else (a file from a stick, a sandboxed frame).
 */
export async function writeStandalone() {
    const page = await readFile(distribution('index.html'), 'utf8');
    const script = await bundleToText('page.mjs');
    const wasm = gzipSync(await readFile(distribution('knotwork-page.wasm')), { level: 9 });
    await writeFile(distribution('standalone.html'), page + inline(script) + wasm.toString('base64'));
}
