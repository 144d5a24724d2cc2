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

test('frames have the curvature and torsion of closed forms', () => {
    const pitch = 3;
    const c = pitch / (2 * PI);
    const helix = named('helix', { radius: 2, pitch, turns: 2 });
    for (const t of [0, 1, 5]) {
        const frame = helix.frame(t);
        near(frame.curvature, 2 / (4 + c * c), 1e-14);
        near(frame.torsion, c / (4 + c * c), 1e-14);
        near(frame.point, helix.point(t), 1e-14);
        near(frame.normal, [-Math.cos(t), -Math.sin(t), 0], 1e-14);
    }
    near(named('circle', { radius: 4 }).frame(7).curvature, 0.25, 1e-14);
});

test('curvature in the plane is signed and its normal is the left one', () => {
    const right = kw.curve({ type: 'bspline-curve', degree: 2, points: [[0, 0], [1, 1], [2, 0]] });
    const { curvature, normal, binormal, torsion } = right.frame(0.5);
    near(curvature, -1, 1e-14);  // y = x − x²/2 at its top
    near(normal, [0, 1, 0], 1e-14);
    assert.deepEqual([binormal, torsion], [[0, 0, 1], 0]);
});

test('frames are finite and orthonormal at every knot, end and cusp', () => {
    const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
    const still = kw.curve({ type: 'bspline-curve', degree: 3, points: Array(4).fill([1, 2, 3]) });
    for (const curve of [...kinds(), named('astroid'), named('lemniscate'), still]) {
        const [start, end] = curve.domain;
        for (let i = 0; i <= 24; ++i) {
            for (const side of ['left', 'right']) {
                const { tangent, normal, binormal, curvature, torsion } =
                    curve.frame(start + (end - start) * i / 24, { side });
                near([dot(tangent, tangent), dot(normal, normal), dot(tangent, normal)], [1, 1, 0], 1e-14);
                near([dot(binormal, tangent), dot(binormal, normal)], [0, 0], 1e-14);
                assert.ok(Number.isFinite(curvature) && Number.isFinite(torsion));
            }
        }
    }
    near(named('astroid').frame(0).tangent, [-1, 0, 0], 1e-14);
});

test('frames refuse what lies outside', () => {
    refuses(() => line().frame(1.5), 'OUT_OF_RANGE', 't');
    refuses(() => line().frame(NaN), 'NOT_FINITE', 't');
    refuses(() => line().frame('0'), 'WRONG_TYPE', 't');
    refuses(() => line().frame(0, { side: 'up' }), 'UNKNOWN_NAME', 'side');
    refuses(() => line().frame(0, { from: 'left' }), 'UNKNOWN_FIELD', 'from');
});

test('closestPoint finds the nearest point of all of the curve', () => {
    near(line().closestPoint([3, 0]).point, [1.08, 1.44, 0], 1e-14);
    const ellipse = named('ellipse', { a: 3, b: 1 });
    const found = ellipse.closestPoint([2, 0]);
    near([found.t, found.distance], [Math.acos(0.75), hypot(0.25, Math.sin(Math.acos(0.75)))], 1e-14);
    const centre = named('circle').closestPoint([0, 0, 0]);
    near([centre.t, centre.distance], [0, 1], 1e-15);
    for (const curve of kinds()) {
        const samples = curve.sample(5000);
        for (const p of [[1, 0.3, 0.2], [-4, 2, 0], [0.1, 0, -30]]) {
            let least = Infinity;
            for (let i = 0; i < samples.length; i += 3) {
                least = Math.min(least, hypot(samples[i] - p[0], samples[i + 1] - p[1], samples[i + 2] - p[2]));
            }
            const { t, point, distance } = curve.closestPoint(p);
            assert.ok(distance <= least + 1e-14 && distance >= least - 1e-3, `${distance} of ${least}`);
            near(point, curve.point(t), 1e-13);
        }
    }
});

test('closestPoint refuses what is no point', () => {
    refuses(() => line().closestPoint(), 'WRONG_TYPE', 'p');
    refuses(() => line().closestPoint([1]), 'WRONG_LENGTH', 'p');
    refuses(() => line().closestPoint([1, '2']), 'WRONG_TYPE', 'p[1]');
    refuses(() => line().closestPoint([NaN, 2]), 'NOT_FINITE', 'p[0]');
    refuses(() => line().closestPoint(new Float64Array([1, 2, Infinity])), 'NOT_FINITE', 'p[2]');
    refuses(() => line().closestPoint([1, 2, 1e13]), 'OUT_OF_RANGE', 'p[2]');
});

test('polyline honours its tolerance or says that it cannot', () => {
    const radius = 3;
    const circle = named('circle', { radius });
    for (let tolerance = 1; tolerance > 0.9e-10; tolerance /= 10) {
        const { points, parameters } = circle.polyline({ tolerance });
        let worst = 0;
        for (let i = 3; i < points.length; i += 3) {
            const middle = hypot(points[i] + points[i - 3], points[i + 1] + points[i - 2]) / 2;
            worst = Math.max(worst, radius - middle);
        }
        assert.ok(worst <= tolerance, `${worst} of ${tolerance}`);
        const least = PI / Math.sqrt(2 * tolerance / radius);
        assert.ok(parameters.length <= 1.1 * least + 34, `${parameters.length} points of ${least}`);
    }
    refuses(() => named('circle', { radius: 1e4 }).polyline({ tolerance: 1e-10 }), 'TOO_LARGE', 'tolerance');
});

test('crossings are those of the curve and of its control polygon', () => {
    const wave = kw.curve({ type: 'bspline-curve', degree: 3, points: [[0, 0], [1, 3], [4, -2], [5, 3], [7, -1], [8, 4]] });
    const { curve, polygon } = wave.crossings([0, 1], [1, 0]);
    assert.ok(curve.length <= polygon.length && polygon.length === 5, `${curve.length} of ${polygon.length}`);
    for (const { t, point } of curve) {
        near(point[1], 1, 1e-12);
        near(point, wave.point(t), 1e-14);
    }
    assert.deepEqual(named('circle').crossings === undefined, false);
    refuses(() => named('circle').crossings([0, 0], [1, 0]), 'NOT_SUPPORTED', 'point');
    refuses(() => wave.crossings([0, 0], [0, 0]), 'OUT_OF_RANGE', 'direction');
    refuses(() => wave.crossings([0, 0], '1'), 'WRONG_TYPE', 'direction');
});

test('enclosingSphere is the smallest around the curve itself', () => {
    const expectSphere = (curve, center, radius) => {
        const sphere = curve.enclosingSphere();
        near(sphere.center, center, 1e-6 * radius);
        near(sphere.radius, radius, 1e-12 * radius);
    };
    expectSphere(named('ellipse', { a: 3, b: 1 }), [0, 0, 0], 3);
    expectSphere(named('viviani'), [0, 0, 0], 2);
    expectSphere(line(), [1.5, 2, 0], 2.5);
    for (const curve of kinds()) {
        const { center, radius } = curve.enclosingSphere();
        const samples = curve.sample(3000);
        for (let i = 0; i < samples.length; i += 3) {
            const away = hypot(samples[i] - center[0], samples[i + 1] - center[1], samples[i + 2] - center[2]);
            assert.ok(away <= radius * (1 + 1e-12));
        }
    }
});
