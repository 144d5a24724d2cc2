// What ./dev bench runs: ratios against peers through the public interface, building and copying out
// included, and what the page costs in a browser. Exits with 1 where a limit is missed or a result differs.
//   node tests/bench/run.mjs [part of a case's name]
import process from 'node:process';

import { blendingCases } from './cases/blending.mjs';
import { blendingSurfaceCases } from './cases/blending-surfaces.mjs';
import { curveCases } from './cases/curves.mjs';
import { drawingCases } from './cases/drawings.mjs';
import { fittingCases } from './cases/fitting.mjs';
import { meshCases } from './cases/meshes.mjs';
import { nativeCases } from './cases/native.mjs';
import { refinementCases } from './cases/refinement.mjs';
import { sceneCases } from './cases/scenes.mjs';
import { subdivisionCases } from './cases/subdivision.mjs';
import { surfaceCases } from './cases/surfaces.mjs';
import { measurePage } from './page.mjs';
import { compare, largestDifference } from './ratio.mjs';

/** @typedef {import('./cases/case.mjs').Case} Case */
/** @typedef {import('./cases/case.mjs').Peer} Peer */
/** @typedef {import('./cases/case.mjs').Work} Work */
/** @typedef {{ peer: Peer, ours: number, theirs: number, ratio: number }} Row */

const cases = [
    ...curveCases, ...refinementCases, ...fittingCases, ...subdivisionCases, ...blendingCases,
    ...surfaceCases, ...blendingSurfaceCases, ...meshCases, ...sceneCases, ...nativeCases,
];

/** @param {Work} work */
async function resultOf(work) {
    const result = await work.act();
    return work.digest ? work.digest(result) : result;
}

/**
 * The row of one peer, or why there is none.
 * @param {Case} given
 * @param {Work} ours
 * @param {Peer} peer
 * @returns {Promise<Row | string>}
 */
async function measure(given, ours, peer) {
    const theirs = await peer.work(kw);
    if (typeof theirs === 'string') return theirs;
    const same = peer.same ? await peer.same(kw) : ours;
    const difference = largestDifference(await resultOf(same), await resultOf(theirs));
    if (!(difference <= peer.tolerance)) {
        throw new Error(`${given.name}: ${peer.name} and we differ by ${difference}`);
    }
    const times = await compare(ours, theirs, undefined, peer.rounds);
    theirs.dispose();
    const toNanoseconds = 1e6;
    const perUnit = { ours: times.ours * toNanoseconds / given.amount, theirs: times.theirs * toNanoseconds / (peer.amount ?? given.amount) };
    return { peer, ...perUnit, ratio: perUnit.theirs / perUnit.ours };
}

/** @param {Row} row */
function verdict({ peer, ratio }) {
    if (peer.atMost !== undefined) return `at most ${peer.atMost}: ${1 / ratio <= peer.atMost ? 'kept' : 'MISSED'}`;
    if (peer.within !== undefined) {
        return `equal within ${peer.within}: ${Math.abs(1 / ratio - 1) <= peer.within ? 'kept' : 'MISSED'}`;
    }
    if (peer.atLeast === undefined) return '';
    return `at least ${peer.atLeast}: ${ratio >= peer.atLeast ? 'kept' : 'MISSED'}`;
}

/** @param {Row} row */
function report(row) {
    const { peer, theirs, ours, ratio } = row;
    const share = peer.name.startsWith('a frame') ? `   ${(100 / ratio).toFixed(1)} % of it` : '';
    const numbers = [theirs.toFixed(1).padStart(9), ours.toFixed(2).padStart(9), ratio.toFixed(1).padStart(9)];
    console.log(`  ${peer.name.padEnd(28)} ${numbers.join(' ')}   ${verdict(row)}${share}`);
    return !verdict(row).endsWith('MISSED');
}

/** @param {Case} given @returns {Promise<boolean>} whether its limits are kept */
async function run(given) {
    console.log(`\n${given.name} (ns a ${given.unit})`);
    console.log('                                  theirs      ours     times');
    const ours = await given.ours(kw);
    let kept = true;
    for (const peer of given.peers) {
        const row = await measure(given, ours, peer);
        if (typeof row === 'string') console.log(`  ${peer.name.padEnd(28)} not measured: ${row}`);
        else kept = report(row) && kept;
    }
    ours.dispose();
    return kept;
}

/** Another build can be named in the environment. */
const distribution = process.env.KNOTWORK_DIST
    ? new URL(`file://${process.env.KNOTWORK_DIST}/`)
    : new URL('../../dist/', import.meta.url);
const { load } = await import(new URL('knotwork.mjs', distribution).href);

const wanted = process.argv[2] ?? '';
const kw = await load();
let allKept = true;
for (const given of [...cases, ...drawingCases(kw)].filter(({ name }) => name.includes(wanted))) {
    try {
        allKept = await run(given) && allKept;
    } catch (problem) {
        console.log(`  ${/** @type {Error} */ (problem).message}`);
        allKept = false;
    }
}
allKept = await measurePage(wanted, distribution) && allKept;
process.exitCode = allKept ? 0 : 1;
