// The benchmark's own arithmetic, and that everyone in it computes the same curve.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { peers } from '../bench/peers/curves.mjs';
import { compare, largestDifference, median } from '../bench/ratio.mjs';
import { catmullClark } from '../bench/peers/typed-array-catmull-clark.mjs';
import { clampedSpline } from '../bench/splines.mjs';

test('the median is the middle one, or the mean of the two', () => {
    assert.equal(median([3, 1, 2]), 2);
    assert.equal(median([4, 1, 3, 2]), 2.5);
});

test('a difference is seen, and so are a NaN and a missing number', () => {
    assert.equal(largestDifference([1, 2, 3], [1, 2.5, 3]), 0.5);
    assert.equal(largestDifference([1, NaN, 3], [1, 2, 4]), Infinity);
    assert.equal(largestDifference([1, 2], [1, 2, 3]), Infinity);
});

test('the ratio is that of the work, whatever the drift of the machine and its hiccups', async () => {
    let now = 0;
    let calls = 0;
    const work = (/** @type {number} */ milliseconds) => () => {
        calls += 1;
        const drift = 1 + 0.4 * Math.sin(calls / 7);
        const hiccup = calls % 5 === 0 ? 50 : 0;
        now += milliseconds * drift + hiccup;
    };
    const { ratio } = await compare({ act: work(10) }, { act: work(100) }, () => now);
    assert.ok(ratio > 8 && ratio < 13, `ratio ${ratio}`);
});

test('every peer computes the same curve', () => {
    const spline = clampedSpline(3, 20, 5);
    const results = peers.map((peer) => {
        const xyz = new Float64Array(3 * 500);
        peer.make(spline)(500, xyz);
        return xyz;
    });
    for (const [i, xyz] of results.entries()) {
        assert.ok(largestDifference(xyz, results[0]) < 1e-12, peers[i].name);
    }
    assert.deepEqual(Array.from(results[0].subarray(0, 3)), spline.points[0]);
});

test('the typed-array Catmull–Clark of a cube has the corners that a hand computes', () => {
    const positions = Float64Array.from([-1, 1].flatMap((z) => [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([x, y]) => [x, y, z])).flat());
    const quads = Uint32Array.of(0, 3, 2, 1, 4, 5, 6, 7, 0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7);
    const once = catmullClark({ positions, quads }, 1);
    assert.equal(once.positions.length, 3 * 26);
    assert.equal(once.quads.length, 4 * 24);
    assert.ok(largestDifference(once.positions.subarray(0, 24), positions.map((x) => x * 5 / 9)) < 1e-15);
    assert.equal(catmullClark({ positions, quads }, 3).positions.length, 3 * 386);
});
