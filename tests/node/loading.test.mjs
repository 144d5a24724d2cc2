// load(): what it takes, and that nothing happens before it.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFile } from 'node:fs/promises';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

import { distribution, load, refusesLater } from './support.mjs';

const file = new URL('knotwork.wasm', distribution);
const linear = { family: 'linear' };

/** Runs a script in a process of its own and gives what it prints. */
const run = (script) => execFileSync(process.execPath, ['--input-type=module', '-e', script], { encoding: 'utf8' });

for (const [name, wasm] of [
    ['nothing at all', undefined],
    ['the bytes as a Buffer', await readFile(file)],
    ['the bytes as an ArrayBuffer', new Uint8Array(await readFile(file)).buffer],
    ['a URL', file],
    ['a URL as text', file.href],
    ['a path', fileURLToPath(file)],
]) {
    test(`load() works when it is given ${name}`, async () => {
        const kw = wasm === undefined ? await load() : await load({ wasm });
        assert.equal(kw.bFunction(linear).value(0.25), 0.25);
    });
}

test('importing the module prints nothing and touches no global', () => {
    const script = `
        const before = Object.getOwnPropertyNames(globalThis).length;
        await import(${JSON.stringify(new URL('knotwork.mjs', distribution).href)});
        console.log(Object.getOwnPropertyNames(globalThis).length - before);`;
    assert.equal(run(script), '0\n');
});

test('a process that loaded the module ends by itself', () => {
    const script = `
        const { load } = await import(${JSON.stringify(new URL('knotwork.mjs', distribution).href)});
        console.log((await load()).bFunction({ family: 'linear' }).value(0.5));`;
    assert.equal(run(script), '0.5\n');
});

test('two modules share nothing', async () => {
    const [first, second] = await Promise.all([load(), load()]);
    first.bFunction(linear);
    assert.equal(first.session.held(), 1);
    assert.equal(second.session.held(), 0);
});

test('what is no module is refused with a KnotworkError', async () => {
    await refusesLater(load({ wasm: new Uint8Array(100) }), 'SYNTAX', 'wasm');
    await refusesLater(load({ wasm: Uint8Array.of(0, 97, 115, 109, 1, 0, 0, 0) }), 'SYNTAX', 'wasm');
    await refusesLater(load({ wasm: '/there/is/no/such/file.wasm' }), 'UNKNOWN_NAME', 'wasm');
    await refusesLater(load({ wasm: 5 }), 'WRONG_TYPE', 'wasm');
    await refusesLater(load({ wasm: null }), 'WRONG_TYPE', 'wasm');
    await refusesLater(load({ wasm: '' }), 'WRONG_TYPE', 'wasm');
    await refusesLater(load({ wsam: file }), 'UNKNOWN_FIELD', 'wsam');
    await refusesLater(load('knotwork.wasm'), 'WRONG_TYPE', '');
});

test('the functions of load() need no this', async () => {
    const { curve, bFunction, scene } = await load();
    assert.equal(bFunction(linear).value(1), 1);
    assert.equal(curve({ type: 'parametric-curve', name: 'circle' }).dimension, 2);
    assert.equal(scene({ knotwork: 1, objects: [] }).canUndo, false);
});

test('the headless module stays below 590 KB when compressed', async () => {
    const { gzipSync } = await import('node:zlib');
    const files = await Promise.all(['knotwork.wasm', 'knotwork.mjs'].map((name) => readFile(new URL(name, distribution))));
    const sizes = files.map((bytes) => gzipSync(bytes, { level: 9 }).length);
    assert.ok(sizes[0] < 590_000, `knotwork.wasm has ${sizes[0]} bytes compressed`);
    assert.ok(sizes[1] < 30_000, `knotwork.mjs has ${sizes[1]} bytes compressed`);
});
