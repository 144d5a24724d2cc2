// What the repository as a whole promises: it builds anywhere, from what it names itself.
import assert from 'node:assert/strict';
import { readdirSync, readFileSync, statSync } from 'node:fs';
import path from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

import { mutants } from '../mutants/mutants.mjs';

const root = fileURLToPath(new URL('../../', import.meta.url));
/** @param {string} file */
const read = (file) => readFileSync(path.join(root, file), 'utf8');

/** Folders that a clone does not have. */
const made = ['.git', 'build', 'dist', 'node_modules'];

/** The text files of the project; pictures and fonts are left out. */
function textFiles(folder = '') {
    return readdirSync(path.join(root, folder), { withFileTypes: true }).flatMap((entry) => {
        const name = folder ? `${folder}/${entry.name}` : entry.name;
        if (made.includes(name)) return [];
        if (entry.isDirectory()) return textFiles(name);
        return /\.(png|ttf|wasm|gz|log)$/.test(name) ? [] : [name];
    });
}

/** Home folders and temporary folders of somebody's machine, and its package servers. */
const machineTraces = [
    new RegExp('(^|[\\s"\'`=(:])/(home|Users|root|work|tmp)/\\w'),
    new RegExp('\\b(deb|snapshot|security)\\.' + 'debian\\.org'),
    new RegExp('registry\\.' + 'npm' + 'js'),
];

/**
 * @param {string} text
 * @returns {string[]} the lines that name a machine
 */
function traces(text) {
    return text.split('\n').filter((line) => machineTraces.some((pattern) => pattern.test(line)));
}

test('no file names a folder or a package server of somebody’s machine', () => {
    const files = textFiles();
    assert.ok(files.includes('package.json'), 'the list of files is not complete');
    const found = files.flatMap((file) => traces(read(file)).map((line) => `${file}: ${line.trim()}`));
    assert.deepEqual(found, []);
});

test('the check for traces of a machine sees one', () => {
    assert.equal(traces('cmake -S /' + 'home/ada/knotwork').length, 1);
    assert.equal(traces('fetched from deb.' + 'debian.org').length, 1);
    assert.deepEqual(traces('see src/geometry and build/tmp/x'), []);
});

test('package-lock.json has no download addresses and agrees with package.json', () => {
    const lock = JSON.parse(read('package-lock.json'));
    const manifest = JSON.parse(read('package.json'));
    const packages = Object.entries(lock.packages);
    assert.ok(packages.length > 5);
    assert.deepEqual(packages.filter(([, entry]) => 'resolved' in entry), []);
    assert.deepEqual(lock.packages[''].devDependencies, manifest.devDependencies);
    assert.equal(lock.version, manifest.version);
});

test('every locked package is checked by its hash and runs on the oldest Node.js that we support', () => {
    const { packages } = JSON.parse(read('package-lock.json'));
    for (const [name, entry] of Object.entries(packages)) {
        if (name === '') continue;
        assert.match(entry.integrity ?? '', /^sha512-/, name);
        const floors = Array.from((entry.engines?.node ?? '').matchAll(/(\d+)/g), (match) => Number(match[1]));
        assert.ok(floors.length === 0 || floors[0] <= 18, `${name} needs Node.js ${entry.engines?.node}`);
    }
});

test('versions agree between CMake and npm', () => {
    const version = /project\(knotwork VERSION (\S+)/.exec(read('CMakeLists.txt'))?.[1];
    assert.equal(version, JSON.parse(read('package.json')).version);
});

test('the scripts that people call can be executed', () => {
    for (const file of ['dev', '.ci/run', 'tools/fetch-imgui.sh']) {
        assert.ok(statSync(path.join(root, file)).mode & 0o100, file);
    }
});

test('no test is skipped or left for later', () => {
    const marks = /\b(test|it|describe)\.(skip|todo|only)\b|\bGTEST_SKIP\b|TEST\w*\(\s*\w+\s*,\s*DISABLED_|\b(TODO|FIXME)\b/;
    const own = 'tests/node/repository.test.mjs';
    const found = textFiles().filter((file) => file !== own && file !== 'package-lock.json' && marks.test(read(file)));
    assert.deepEqual(found, []);
});

test('every fuzz target has its seeds, and every folder of seeds its target', () => {
    const targets = readdirSync(path.join(root, 'tests/fuzz'))
        .filter((name) => name.endsWith('.cpp'))
        .map((name) => name.replace(/\.cpp$/, ''));
    const corpus = path.join(root, 'tests/fuzz/corpus');
    assert.deepEqual(readdirSync(corpus).sort(), targets.sort());
    for (const name of targets) assert.ok(readdirSync(path.join(corpus, name)).length > 0, name);
});

test('every mistake that ./dev mutants plants has its one place and its test', () => {
    const tests = textFiles('tests/cpp').map(read).join('\n');
    for (const { name, file, find, replace, test: sentence } of mutants) {
        assert.equal(read(`src/geometry/${file}`).split(find).length, 2, name);
        assert.notEqual(find, replace, name);
        const [suite, title] = sentence.split('.');
        assert.match(tests, new RegExp(`\\b${suite}\\s*,\\s*${title}\\b`), name);
    }
});
