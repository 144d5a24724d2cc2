// What the tests of the delivered modules share.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';

/** The folder under test; another build can be named in the environment. */
export const distribution = process.env.KNOTWORK_DIST
    ? new URL(`file://${process.env.KNOTWORK_DIST}/`)
    : new URL('../../dist/', import.meta.url);

export const { load, KnotworkError } = await import(new URL('knotwork.mjs', distribution).href);

/** Measured bounds (DESIGN, "Numbers that hold"). */
export const tolerances = {
    exact: 1e-14,          // polynomial algorithms on small numbers
    partition: 1e-14,      // sum of the basis
    expoRational: 2e-13,   // ERB and what is blended by it
    refinement: 5e-14,     // a refined curve against the one before
    sampled: 1e-13,        // the sampler's pieces against the curve, coordinates up to 20
    rounding: 1e-12,       // sin and exp of arguments up to 40
};

/**
 * Bytes by which the module's memory in use may differ with nothing left behind: what is left over
 * between two blocks is given to one of them where it is too small for another.
 */
export const allocatorSlack = 64;

/**
 * Asserts that `act` is refused with this code and path.
 * @param {() => unknown} act
 * @param {string} code
 * @param {string} [path]
 */
export function refuses(act, code, path) {
    try {
        act();
    } catch (error) {
        refusal(error, code, path);
        return error;
    }
    assert.fail(`expected ${code} at ${path}, but nothing was refused`);
}

/** The same for a promise. */
export async function refusesLater(promise, code, path) {
    try {
        await promise;
    } catch (error) {
        refusal(error, code, path);
        return error;
    }
    assert.fail(`expected ${code} at ${path}, but nothing was refused`);
}

function refusal(error, code, path) {
    assert.ok(error instanceof KnotworkError, `${error?.stack ?? error} is no KnotworkError`);
    assert.equal(`${error.code} at '${error.path}'`, `${code} at '${path ?? error.path}'`, error.message);
    assert.ok(error.message.length > 10, 'the message says something');
}

/** Numbers of a list or of lists within lists agree within `tolerance`. */
export function near(actual, expected, tolerance, message = '') {
    if (typeof expected === 'number') {
        const distance = Math.abs(actual - expected);
        assert.ok(distance <= tolerance, `${message} ${actual} is not ${expected} within ${tolerance}`);
        return;
    }
    assert.equal(actual.length, expected.length, `${message} length`);
    for (let i = 0; i < expected.length; ++i) near(actual[i], expected[i], tolerance, `${message}[${i}]`);
}

/** `7/3`, `-1/2` or a decimal. */
export function fraction(text) {
    const [above, below = '1'] = text.split('/');
    return Number(above) / Number(below);
}

export const fractions = (rows) => rows.map((row) => (Array.isArray(row) ? fractions(row) : fraction(row)));

/** [x, y] as the interface gives points. */
export const inSpace = ([x, y, z = 0]) => [x, y, z];

export const truth = JSON.parse(await readFile(new URL('../truth/cases.json', import.meta.url), 'utf8'));

/** Random numbers from a fixed seed (mulberry32), so that a failure can be repeated. */
export function randomness(seed) {
    let state = seed >>> 0;
    const unit = () => {
        state = (state + 0x6d2b79f5) >>> 0;
        let mixed = Math.imul(state ^ (state >>> 15), state | 1);
        mixed ^= mixed + Math.imul(mixed ^ (mixed >>> 7), mixed | 61);
        return ((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32;
    };
    return {
        unit,
        between: (low, high) => low + (high - low) * unit(),
        integer: (low, high) => low + Math.floor((high - low + 1) * unit()),
        points: (count, dimension) =>
            Array.from({ length: count }, () => Array.from({ length: dimension }, () => 2 * unit() - 1)),
    };
}

/** A clamped knot vector with random spans and random multiplicities inside. */
export function randomKnots(random, degree, count) {
    const inner = [];
    while (inner.length < count - degree - 1) {
        const times = Math.min(random.integer(1, degree), count - degree - 1 - inner.length);
        const knot = (inner.at(-1) ?? 0) + random.between(0.1, 2);
        for (let i = 0; i < times; ++i) inner.push(knot);
    }
    const end = (inner.at(-1) ?? 0) + random.between(0.1, 2);
    return [...Array(degree + 1).fill(0), ...inner, ...Array(degree + 1).fill(end)];
}
