// ./dev coverage: which lines of src/geometry no native test reaches, from what gcov counted. Each of
// them has its reason beside it, `// not reached: why`, on the line, in the comment above it or on a
// line of the same run; otherwise, and where a reason has become untrue, this fails.
import { execFileSync } from 'node:child_process';
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('..', import.meta.url));
const folder = 'src/geometry/';
const objects = path.join(root, 'build/native-coverage/CMakeFiles/knotwork_geometry.dir/src/geometry');
const marker = /\/\/ not reached: \S/;

/** @type {Map<string, Map<number, number>>} how often each line that has code was reached, by file */
const counts = new Map();

/** @param {string} data what gcov knows of one object file */
function count(data) {
    const text = execFileSync('gcov', ['--json-format', '--stdout', data], { cwd: root, encoding: 'utf8', maxBuffer: 2 ** 28 });
    /** @type {{ files: { file: string, lines: { line_number: number, count: number }[] }[] }} */
    const { files } = JSON.parse(text);
    for (const { file, lines } of files) {
        const at = file.lastIndexOf(folder);
        if (at < 0) continue;
        const name = file.slice(at);
        const known = counts.get(name) ?? new Map();
        counts.set(name, known);
        for (const { line_number: line, count: times } of lines) known.set(line, (known.get(line) ?? 0) + times);
    }
}

/**
 * Runs of lines with code that no test reaches, without such as stand between them and have none.
 * @param {Map<number, number>} lines
 * @returns {number[][]}
 */
function unreachedRuns(lines) {
    /** @type {number[][]} */
    const runs = [];
    let open = false;
    for (const [line, times] of [...lines].sort(([a], [b]) => a - b)) {
        if (times === 0 && open) runs[runs.length - 1].push(line);
        if (times === 0 && !open) runs.push([line]);
        open = times === 0;
    }
    return runs;
}

/**
 * What is wrong in one file: runs without a reason, and reasons without a run.
 * @param {string} file
 * @param {Map<number, number>} lines
 */
function offences(file, lines) {
    const text = readFileSync(path.join(root, file), 'utf8').split('\n');
    const marked = text.flatMap((line, i) => (marker.test(line) ? [i + 1] : []));
    const runs = unreachedRuns(lines);
    const belongs = (/** @type {number[]} */ run, /** @type {number} */ line) =>
        line >= run[0] - 1 && line <= run[run.length - 1];
    const bare = runs.filter((run) => !marked.some((line) => belongs(run, line)));
    const idle = marked.filter((line) => !runs.some((run) => belongs(run, line)));
    return [
        ...bare.flatMap((run) => run.map((line) => `${file}:${line}: not reached, without a reason: ${text[line - 1].trim()}`)),
        ...idle.map((line) => `${file}:${line}: is reached after all; take the reason away`),
    ];
}

/** Objects of sources that have gone stay where they were built. */
const data = readdirSync(objects).filter((name) => name.endsWith('.gcno') && existsSync(path.join(root, folder, name.replace(/\.gcno$/, ''))));
for (const name of data) count(path.join(objects, name));
const files = [...counts].sort(([a], [b]) => (a < b ? -1 : 1));
const found = files.flatMap(([file, lines]) => offences(file, lines));
const all = files.flatMap(([, lines]) => [...lines.values()]);
const reached = all.filter((times) => times > 0).length;
for (const line of found) console.log(line);
console.log(`${reached} of ${all.length} lines of ${folder} are reached (${(100 * reached / all.length).toFixed(2)} %); \
${found.length === 0 ? 'the others have their reasons beside them' : `${found.length} complaints`}`);
process.exitCode = found.length === 0 && all.length > 0 ? 0 : 1;
