// A process that does work when told to: told what first, then once a line, each answered with
// { milliseconds, result }. So both sides alternate, and its start is not measured.
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import process from 'node:process';
import { createInterface } from 'node:readline';

/**
 * @param {string} command
 * @param {string[]} options
 * @param {object} given
 * @returns {import('../cases/case.mjs').Work}
 */
export function converse(command, options, given) {
    const child = spawn(command, options, { stdio: ['pipe', 'pipe', process.stderr] });
    const lines = createInterface({ input: child.stdout });
    child.stdin.write(`${JSON.stringify(given)}\n`);
    /** @param {string} word */
    const ask = async (word) => {
        child.stdin.write(`${word}\n`);
        const [line] = await once(lines, 'line');
        return JSON.parse(line);
    };
    return {
        act: async () => Float64Array.from((await ask('result')).result),
        time: async () => (await ask('time')).milliseconds,
        dispose: () => void child.kill(),
    };
}
