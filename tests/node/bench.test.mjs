// The benchmark's own arithmetic, and that everyone in it computes the same curve.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { peers } from '../bench/peers/curves.mjs';
import { compare, largestDifference, median } from '../bench/ratio.mjs';
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
