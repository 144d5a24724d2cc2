import { createHash } from 'node:crypto';
import { readdir, readFile, writeFile } from 'node:fs/promises';
import path from 'node:path';

import { build } from 'esbuild';

import { distribution, project } from './paths.mjs';

/** What is delivered for programs and for the pages of others; the page does without. */
const notOfThePage = new Set([
    'knotwork.mjs', 'knotwork.wasm', 'knotwork.d.ts', 'element-class.mjs', 'schema.json', 'standalone.html',
    'offline-worker.js',
]);
const mark = /[ \t]*<meta name="version" content="\w*">\n/;

/** @param {Buffer | string} content */
const hash = (content) => createHash('sha256').update(content).digest('hex');

/** @param {string} directory @returns {Promise<string[]>} names with slashes, in a fixed order */
async function filesOfThePage(directory) {
    const entries = await readdir(directory, { withFileTypes: true });
    const names = await Promise.all(entries.map(async (entry) => (entry.isDirectory()
        ? (await readdir(path.join(directory, entry.name))).map((name) => `${entry.name}/${name}`)
        : [entry.name])));
    return names.flat().filter((name) => !notOfThePage.has(name)).sort();
}

/**
 * Writes offline-worker.js with the names and hashes of all files of the page, and into index.html
 * the version that they are together.
 * @param {string} [directory] of what is delivered
 */
export async function writeOffline(directory = distribution()) {
    const page = path.join(directory, 'index.html');
    const unmarked = (await readFile(page, 'utf8')).replace(mark, '');
    const others = (await filesOfThePage(directory)).filter((name) => name !== 'index.html');
    const hashes = await Promise.all(others.map(async (name) => [name, hash(await readFile(path.join(directory, name)))]));
    const version = hash(JSON.stringify([unmarked, hashes])).slice(0, 16);
    const marked = unmarked.replace('</title>\n', `</title>\n    <meta name="version" content="${version}">\n`);
    if (marked === unmarked) throw new Error('index.html has no line that ends with its title');
    await writeFile(page, marked);
    const kept = { version, files: [['index.html', hash(marked)], ...hashes] };
    await build({
        entryPoints: [project('web/offline-worker.mjs')], outfile: path.join(directory, 'offline-worker.js'),
        bundle: true, format: 'iife', minify: true, target: 'es2022', logLevel: 'warning',
        define: { __KEPT__: JSON.stringify(kept) },
    });
}
