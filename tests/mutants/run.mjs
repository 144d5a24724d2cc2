// ./dev mutants [WORD]: plants each mistake of mutants.mjs in a copy of the sources and expects the
// test that it names to fail. The copy and what is built of it stay in build/mutants, so that the next
// run compiles only what changed; the sources themselves are never touched.
import { spawnSync } from 'node:child_process';
import { mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

import { mutants } from './mutants.mjs';

const root = fileURLToPath(new URL('../../', import.meta.url));
const copy = path.join(root, 'build/mutants/source');
const build = path.join(root, 'build/mutants/build');
const log = path.join(root, 'build/logs/mutants.log');

/** @param {string} file */
function written(file) {
    try {
        return readFileSync(file, 'utf8');
    } catch {
        return undefined;
    }
}

/** Writes a file only where its text changes: what did not change is not compiled again. */
function write(file, text) {
    if (written(file) === text) return;
    mkdirSync(path.dirname(file), { recursive: true });
    writeFileSync(file, text);
}

/** All files below a folder of the project, as paths from its root. */
function filesBelow(folder) {
    return readdirSync(path.join(root, folder), { withFileTypes: true }).flatMap((entry) => {
        const name = `${folder}/${entry.name}`;
        return entry.isDirectory() ? filesBelow(name) : [name];
    });
}

/** The copy as the sources are, without what they no longer have. */
function restore() {
    const files = ['src/geometry', 'tests/cpp', 'tests/truth', 'cmake'].flatMap(filesBelow);
    for (const file of files) write(path.join(copy, file), readFileSync(path.join(root, file), 'utf8'));
    write(path.join(copy, 'CMakeLists.txt'), readFileSync(path.join(root, 'tests/mutants/CMakeLists.txt'), 'utf8'));
    const known = new Set(files);
    const old = readdirSync(path.join(copy, 'src/geometry')).filter((name) => !known.has(`src/geometry/${name}`));
    for (const name of old) rmSync(path.join(copy, 'src/geometry', name));
}

/** The files of the named tests, and what the properties share. */
function testFiles() {
    const sources = filesBelow('tests/cpp').filter((file) => file.endsWith('.cpp'));
    const found = mutants.map(({ test }) => {
        const [suite, name] = test.split('.');
        const head = new RegExp(`TEST(_[PF])?\\(\\s*${suite}\\s*,\\s*${name}\\s*\\)`);
        const file = sources.find((source) => head.test(readFileSync(path.join(root, source), 'utf8')));
        if (!file) fail(`There is no test ${test}.`);
        return file;
    });
    const shared = sources.filter((file) => /\/properties\/(?!test_)/.test(file));
    return [...new Set([...found, ...shared])];
}

/** @param {string} message @returns {never} */
function fail(message) {
    console.error(message);
    process.exit(1);
}

/** A mutant may make a test run for ever. */
const longestTest = 600_000;  // milliseconds

/** Runs a command, as long as it likes, and keeps what it says; answers its exit status. */
const run = (command, ...args) => runFor(undefined, command, args);

function runFor(timeout, command, args) {
    const { status, signal, stdout, stderr, error } = spawnSync(command, args, { encoding: 'utf8', cwd: root, timeout });
    writeFileSync(log, `$ ${command} ${args.join(' ')}\n${stdout ?? ''}${stderr ?? error}\n`, { flag: 'a' });
    return { status: status ?? -1, signal, said: `${stdout}` };
}

const compiles = () => run('cmake', '--build', build).status === 0;
const test = (filter) => runFor(longestTest, path.join(build, 'knotwork_tests'), [`--gtest_filter=${filter}`, '--gtest_color=no']);

/** What comes of one mutant, in a word; `caught` is the good one. @param {import('./mutants.mjs').Mutant} mutant */
function verdict({ file, find, replace, test: name }) {
    const source = readFileSync(path.join(root, 'src/geometry', file), 'utf8');
    const places = source.split(find).length - 1;
    if (places !== 1) return `DOES NOT APPLY ANY MORE: what it looks for stands ${places} times in ${file}`;
    const target = path.join(copy, 'src/geometry', file);
    write(target, source.replace(find, () => replace));
    const built = compiles();
    const result = built ? test(name) : undefined;
    write(target, source);
    if (!result) return `DOES NOT COMPILE: see ${path.relative(root, log)}`;
    if (result.signal) return `caught (${result.signal})`;
    return result.status === 0 ? 'SURVIVED' : 'caught';
}

const [word] = process.argv.slice(2);
const chosen = mutants.filter(({ name }) => !word || name.includes(word));
if (chosen.length === 0) fail(`No mutant has '${word}' in its name; there are:\n${mutants.map(({ name }) => `  ${name}`).join('\n')}`);

mkdirSync(copy, { recursive: true });
mkdirSync(path.dirname(log), { recursive: true });
writeFileSync(log, '');
restore();
console.log('Compiling the geometry and the tests that the mutants name ...');
const configured = run('cmake', '-S', copy, '-B', build, '-G', 'Ninja', '-DCMAKE_CXX_FLAGS_RELEASE=-O1',
    `-DKNOTWORK_MUTANT_TESTS=${testFiles().join(';')}`);
if (configured.status !== 0 || !compiles()) fail(`The sources as they are do not compile; see ${path.relative(root, log)}`);
for (const name of new Set(chosen.map(({ test: one }) => one))) {
    const { status, said } = test(name);
    if (status !== 0 || !said.includes('[  PASSED  ] 1 test')) fail(`${name} does not pass without a mutant.`);
}

const verdicts = chosen.map((mutant) => {
    const found = verdict(mutant);
    console.log(`${found.padEnd(18)} ${mutant.name}\n${''.padEnd(19)}by ${mutant.test}`);
    return found;
});
const caught = verdicts.filter((one) => one.startsWith('caught')).length;
console.log(`\n${caught} of ${chosen.length} mutants caught`);
process.exit(caught === chosen.length ? 0 : 1);
