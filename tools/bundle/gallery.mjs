import { mkdir, writeFile } from 'node:fs/promises';

import { distribution } from './paths.mjs';

/** The size of a picture in the gallery, in CSS pixels. */
const size = { width: 480, height: 300 };

/**
 * Writes dist/gallery/<scene>.svg and <scene>.dark.svg, a picture of every built-in scene as the
 * built module's own exporter draws it.
 * @param {URL} facade the delivered knotwork.mjs
 */
export async function writeGallery(facade) {
    const { load } = await import(facade.href);
    const kw = await load();
    await mkdir(distribution('gallery'), { recursive: true });
    for (const { id, document } of kw.scenes) {
        const scene = kw.scene(document);
        for (const [theme, name] of [['light', `${id}.svg`], ['dark', `${id}.dark.svg`]]) {
            const picture = scene.svg({ ...size, theme, background: 'none' });
            await writeFile(distribution('gallery', name), picture);
        }
        scene.dispose();
    }
}
