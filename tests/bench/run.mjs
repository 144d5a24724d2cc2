// What ./dev bench runs: ratios against the npm peers through the public interface, building and
// copying out included. Exits with 1 where a limit is missed or a result differs.
//   node tests/bench/run.mjs [part of a case's name]
import process from 'node:process';

import { cases } from './cases.mjs';
import { peers } from './peers.mjs';
import { compare, largestDifference } from './ratio.mjs';

/** @typedef {import('./cases.mjs').Case} Case */
/** @typedef {{ peer: string, npm: boolean, ours: number, theirs: number, ratio: number }} Row */

/** @param {Case} given @param {import('./peers.mjs').Peer} peer @returns {Row} */
function measure(given, peer) {
    const ours = given.ours(kw);
    const theirs = given.theirs(peer);
    const difference = largestDifference(ours.act(), theirs.act());
    if (!(difference <= given.tolerance)) {
        throw new Error(`${given.name}: ${peer.name} and we differ by ${difference}`);
    }
    const times = compare(ours.act, theirs.act);
    ours.dispose();
    const perPoint = 1e6 / given.points;  // milliseconds to nanoseconds a point
    return {
        peer: peer.name,
        npm: peer.npm,
        ours: times.ours * perPoint,
        theirs: times.theirs * perPoint,
        ratio: times.ratio,
    };
}

/** @param {Case} given @param {Row[]} rows */
function report(given, rows) {
    console.log(`\n${given.name} (ns a point)`);
    console.log('                       theirs     ours   times faster');
    for (const { peer, theirs, ours, ratio } of rows) {
        const numbers = [theirs.toFixed(1).padStart(8), ours.toFixed(2).padStart(8)].join(' ');
        console.log(`  ${peer.padEnd(18)} ${numbers}   ${ratio.toFixed(1).padStart(8)}`);
    }
}

/** The limit is against whichever npm peer is the fastest. @param {Case} given @param {Row[]} rows */
function keepsLimit(given, rows) {
    if (given.limit === undefined) return true;
    const least = Math.min(...rows.filter((row) => row.npm).map((row) => row.ratio));
    const kept = least >= given.limit;
    const verdict = kept ? 'kept' : 'MISSED';
    console.log(`  at least ${given.limit} times the best npm peer: ${least.toFixed(1)}, ${verdict}`);
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
for (const given of cases.filter(({ name }) => name.includes(wanted))) {
    const rows = peers.map((peer) => measure(given, peer));
    report(given, rows);
    allKept = keepsLimit(given, rows) && allKept;
}
process.exitCode = allKept ? 0 : 1;
