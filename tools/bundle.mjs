// Leaves the distributable files in dist/:  node tools/bundle.mjs
import { cp, mkdir, readdir, rm } from 'node:fs/promises';
import { pathToFileURL } from 'node:url';

import { bundleModules } from './bundle/modules.mjs';
import { distribution, project } from './bundle/paths.mjs';
import { writeSchema } from './bundle/schema.mjs';
import { writeStandalone } from './bundle/standalone.mjs';

/** Files of web/ that are delivered as they are. */
const asTheyAre = /\.(html|css|d\.ts|svg|png|json)$/;

async function copyStaticFiles() {
    for (const entry of await readdir(project('web'), { withFileTypes: true })) {
        if (!entry.isDirectory() && !asTheyAre.test(entry.name)) continue;
        await cp(project('web', entry.name), distribution(entry.name), {
            recursive: true,
            filter: (source) => !source.endsWith('.mjs'),
        });
    }
}

async function copyWasm() {
    await cp(project('build/wasm/knotwork.wasm'), distribution('knotwork.wasm'));
    await cp(project('build/wasm/knotwork_page.wasm'), distribution('knotwork-page.wasm'));
}

await rm(distribution(), { recursive: true, force: true });
await mkdir(distribution(), { recursive: true });
await Promise.all([copyStaticFiles(), copyWasm(), bundleModules()]);
await writeSchema(pathToFileURL(distribution('knotwork.mjs')));
await writeStandalone();
