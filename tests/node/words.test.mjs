// The words of the panels in the other language.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { test } from 'node:test';

import { load } from './support.mjs';

const kw = await load();

/** Every title, description and label that a panel can show. */
function shownWords() {
    const words = new Set();
    const walk = (value) => {
        if (value === null || typeof value !== 'object') return;
        for (const key of ['title', 'description', 'label']) {
            if (typeof value[key] === 'string') words.add(value[key]);
        }
        Object.values(value).forEach(walk);
    };
    walk(kw.documentSchema().$defs);
    for (const { document } of kw.scenes) {
        const scene = kw.scene(document);
        // The words of numbers that a formula names are its author's own.
        scene.schema.forEach(({ label, fields }) => [label, ...fields.flatMap((f) => (f.choices ?? []).map((c) => c.label))]
            .forEach((word) => words.add(word)));
        scene.dispose();
    }
    for (const { label } of [...kw.bFunctions, ...kw.parametricCurves, ...kw.parametricSurfaces]) words.add(label);
    return words;
}

test('every label and help of the panels is there in bokmål', async () => {
    const { labels } = JSON.parse(await readFile(new URL('../../web/locales/nb.json', import.meta.url), 'utf8'));
    assert.deepEqual([...shownWords()].filter((word) => !labels[word]), []);
    assert.ok(Object.keys(labels).length > 250);
});
