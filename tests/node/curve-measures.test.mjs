// What is measured on curves: lengths, frames, nearest points, polylines, spheres.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { load, near, refuses, truth } from './support.mjs';

const kw = await load();
const named = (name, parameters, domain) => kw.curve({
    type: 'parametric-curve', name, ...(parameters && { parameters }), ...(domain && { domain }),
});
const { PI, hypot } = Math;
const line = () => kw.curve({ type: 'bspline-curve', degree: 1, points: [[0, 0], [3, 4]] });
const blend = () => kw.curve({
    type: 'blending-curve', bFunction: { family: 'expo-rational' }, form: 'closed',
    model: { type: 'parametric-curve', name: 'circle' }, locals: { count: 4 },
});
/** One of each kind. */
const kinds = () => [
    line(), blend(), named('trefoil'),
    kw.curve({ type: 'bspline-curve', degree: 3, form: 'closed', points: [[0, 0], [2, 0, 1], [2, 2], [0, 2], [1, 1]] }),
];

test('lengths are those of closed forms', () => {
    near(named('circle', { radius: 2 }).length(), 4 * PI, 1e-13);
    near(named('astroid').length(), 6, 1e-13);
    near(named('helix', { radius: 1, pitch: 2, turns: 2 }).length(), 2 * hypot(2 * PI, 2), 1e-13);
    near(named('butterfly').length() / Number(truth.butterfly.length_0_12pi), 1, 1e-13);
    near(named('butterfly').length(0, 2 * PI) / Number(truth.butterfly.length_0_2pi), 1, 1e-13);
    near(line().length(), 5, 1e-14);
    near(line().length(0.25), 3.75, 1e-14);
    near(line().length(0.25, 0.5), 1.25, 1e-14);
    near(blend().length(), 2 * PI, 1e-12);
});

test('the length of a closed curve goes through the seam', () => {
    const circle = named('circle');
    near(circle.length(5, 7), 2, 1e-14);
    near(circle.length(5, 1), 2 * PI - 4, 1e-14);
});

test('parameterAtLength is the inverse of length, for every kind', () => {
    for (const curve of kinds()) {
        const whole = curve.length();
        const [start] = curve.domain;
        for (let i = 0; i <= 10; ++i) {
            const t = curve.parameterAtLength(whole * i / 10);
            near(curve.length(start, t), whole * i / 10, 1e-12 * whole);
        }
    }
    near(named('circle').parameterAtLength(2 * PI + 1), 1, 1e-14);
});

test('lengths refuse what lies outside', () => {
    const curve = line();
    refuses(() => curve.length(-1), 'OUT_OF_RANGE', 'a');
    refuses(() => curve.length(0, 2), 'OUT_OF_RANGE', 'b');
    refuses(() => curve.length(0.5, 0.25), 'OUT_OF_RANGE', 'b');
    refuses(() => curve.length('0'), 'WRONG_TYPE', 'a');
    refuses(() => curve.length(0, null), 'WRONG_TYPE', 'b');
    refuses(() => curve.length(NaN), 'NOT_FINITE', 'a');
    refuses(() => curve.parameterAtLength(6), 'OUT_OF_RANGE', 's');
    refuses(() => curve.parameterAtLength(-1), 'OUT_OF_RANGE', 's');
    refuses(() => curve.parameterAtLength(undefined), 'WRONG_TYPE', 's');
    curve.dispose();
    refuses(() => curve.length(), 'DISPOSED');
    assert.throws(() => curve.parameterAtLength(0));
});
