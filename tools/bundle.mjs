// Leaves the distributable files in dist/:  node tools/bundle.mjs
import { cp, mkdir, readdir, rm } from 'node:fs/promises';
import { pathToFileURL } from 'node:url';

import { writeGallery } from './bundle/gallery.mjs';
import { writeIcons } from './bundle/icons.mjs';
import { bundleModules } from './bundle/modules.mjs';
import { writeOffline } from './bundle/offline.mjs';
import { distribution, project } from './bundle/paths.mjs';
import { writeSchema } from './bundle/schema.mjs';
import { writeStandalone } from './bundle/standalone.mjs';

/** Pages, styles and types are delivered as they are; scripts and words go through the bundler. */
const delivered = /\.(html|css|d\.ts|svg|png|json)$/;

async function copyStaticFiles() {
    const names = (await readdir(project('web'))).filter((name) => delivered.test(name));
    await Promise.all(names.map((name) => cp(project('web', name), distribution(name))));
}

async function copyWasm() {
    await cp(project('build/wasm/knotwork.wasm'), distribution('knotwork.wasm'));
    await cp(project('build/wasm/knotwork_page.wasm'), distribution('knotwork-page.wasm'));
}

await rm(distribution(), { recursive: true, force: true });
await mkdir(distribution(), { recursive: true });
await Promise.all([copyStaticFiles(), copyWasm(), bundleModules(), writeIcons()]);
const facade = pathToFileURL(distribution('knotwork.mjs'));
await writeSchema(facade);
await writeGallery(facade);
await writeStandalone();
await writeOffline();
