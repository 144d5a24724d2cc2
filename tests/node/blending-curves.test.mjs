// Part 3 of the interface: Bézier curves, lines and arcs, and what blending curves are made of them.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { load, near, randomness, refuses, tolerances } from './support.mjs';

const kw = await load();
const { sqrt, PI } = Math;
const trefoil = { type: 'parametric-curve', name: 'trefoil' };
const circle = { type: 'parametric-curve', name: 'circle' };
const erb = { family: 'expo-rational' };
const blending = (fields) => kw.curve({ type: 'blending-curve', bFunction: erb, ...fields });
const kinds = ['sub-curve', 'line', 'arc', 'bezier', 'bspline'];
const posed = [{ local: 1, translate: [1, 0.5, 0.25], rotate: { axis: [1, 1, 0], angle: 0.5 }, scale: 1.5 }];

test('a Bézier curve runs over its domain and beyond', () => {
    const curve = kw.curve({ type: 'bezier-curve', points: [[0, 0], [1, 0], [2, 4]], domain: [1, 3] });
    assert.deepEqual([curve.domain, curve.closed, curve.dimension], [[1, 3], false, 2]);
    for (const t of [1, 1.5, 2.2, 3]) {
        near(curve.derivatives(t, 3), [[t - 1, (t - 1) ** 2, 0], [1, 2 * (t - 1), 0], [0, 2, 0], [0, 0, 0]], tolerances.exact);
    }
    refuses(() => curve.point(3.1), 'OUT_OF_RANGE', 't');
    assert.deepEqual(kw.curve({ type: 'bezier-curve', points: [[0, 0], [1, 1]] }).spec,
        { type: 'bezier-curve', points: [[0, 0], [1, 1]], domain: [0, 1] });
    const quarter = kw.curve({ type: 'bezier-curve', points: [[1, 0], [1, 1], [0, 1]], weights: [1, sqrt(0.5), 1] });
    for (const t of [0, 0.3, 1]) near(Math.hypot(...quarter.point(t)), 1, tolerances.exact);
});

test('a line goes from one point to the other', () => {
    const line = kw.curve({ type: 'line-curve', from: [0, 1, 2], to: [2, 1, 0], domain: [0, 4] });
    near(line.derivatives(1, 2), [[0.5, 1, 1.5], [0.5, 0, -0.5], [0, 0, 0]], tolerances.exact);
    assert.deepEqual([line.point(0), line.point(4)], [[0, 1, 2], [2, 1, 0]]);
    near(line.length(), sqrt(8), tolerances.exact);
});

test('an arc keeps the point, the first derivative and the curvature', () => {
    const arc = kw.curve({ type: 'arc-curve', at: 1, point: [2, 0], first: [0, 2], second: [-2, 5], domain: [0, 3] });
    const [p, first, second] = arc.derivatives(1, 2);
    near([p, first, second], [[2, 0, 0], [0, 2, 0], [-2, 0, 0]], tolerances.exact);  // radius 2 about the origin
    for (const t of [0, 0.4, 2, 3]) near(Math.hypot(...arc.point(t)), 2, tolerances.exact);
    const straight = kw.curve({ type: 'arc-curve', at: 0, point: [0, 0], first: [1, 1], second: [2, 2], domain: [0, 1] });
    near(straight.point(1), [1, 1, 0], tolerances.exact);
    refuses(() => kw.curve({ ...arc.spec, first: [0, 0] }), 'OUT_OF_RANGE', 'first');
    refuses(() => kw.curve({ ...arc.spec, domain: undefined }), 'WRONG_TYPE', 'domain');
});

for (const kind of kinds) {
    test(`local curves of the kind ${kind} are what the curve has at its knots`, () => {
        const curve = blending({ model: trefoil, locals: { count: 7, kind }, poses: posed });
        for (const j of [0, 1, 3, 6]) {
            const local = curve.local(j);
            const t = curve.knots[j];
            near(curve.derivatives(t, 3), local.derivatives(t, 3), 1e-9, `local ${j}`);
            const [start, end] = local.domain;
            assert.ok(start < t && t < end && !local.closed);
        }
    });

    test(`a local curve of the kind ${kind} is made again by its specification`, () => {
        const curve = blending({ model: trefoil, locals: { count: 7, kind }, poses: posed });
        for (const j of [0, 1, 4]) {
            const local = curve.local(j);
            const again = kw.curve(local.spec);
            assert.deepEqual([again.domain, again.spec], [local.domain, local.spec]);
            const [start, end] = local.domain;
            for (const share of [0, 0.2, 0.7, 1]) {
                const t = start + share * (end - start);
                near(again.derivatives(t, 2), local.derivatives(t, 2), 1e-10);
            }
        }
    });
}

test('each kind keeps its own data of the model', () => {
    const model = kw.curve(trefoil);
    const t = 2 * PI / 7 * 3;
    const [p, first, second, third] = model.derivatives(t, 3);
    const at = (kind, degree) => blending({ model: trefoil, locals: { count: 7, kind, ...(degree && { degree }) } }).local(3).derivatives(t, 3);
    near(at('line'), [p, first, [0, 0, 0], [0, 0, 0]], tolerances.rounding);
    near(at('bezier'), [p, first, second, third], 1e-10);
    near(at('bezier', 1), [p, first, [0, 0, 0], [0, 0, 0]], 1e-11);
    const arc = at('arc');
    const along = (a) => a.reduce((sum, x, i) => sum + x * first[i], 0) / Math.hypot(...first) ** 2;
    near(arc[2], second.map((x, i) => x - along(second) * first[i]), 1e-10);
    near(at('sub-curve'), [p, first, second, third], tolerances.rounding);
});

test('a B-spline local has eight control points and lies next to the model', () => {
    const curve = blending({ model: trefoil, locals: { count: 7, kind: 'bspline' } });
    const local = curve.local(2);
    assert.deepEqual([local.spec.type, local.spec.degree, local.spec.points.length], ['bspline-curve', 3, 8]);
    const model = kw.curve(trefoil);
    for (const t of [local.domain[0], curve.knots[2], local.domain[1]]) near(local.point(t), model.point(t), 0.01);
    assert.equal(blending({ model: trefoil, locals: { count: 4, kind: 'bspline', degree: 5 } }).local(0).spec.degree, 5);
});

test('at cusps lines and arcs rest at their point', () => {
    for (const kind of ['line', 'arc']) {
        for (const name of ['astroid', 'nephroid']) {
            const curve = blending({ model: { type: 'parametric-curve', name }, locals: { count: 4, kind } });
            assert.ok(curve.sample(100).every((x) => Math.abs(x) < 10));
        }
    }
});

test('knots at equal lengths', () => {
    const model = { type: 'parametric-curve', name: 'ellipse', parameters: { a: 5, b: 1 } };
    const curve = blending({ model, locals: { count: 8 }, spacing: 'length' });
    const ellipse = kw.curve(model);
    for (let i = 0; i < 8; ++i) near(ellipse.length(curve.knots[i], curve.knots[i + 1]), ellipse.length() / 8, 1e-11);
    assert.equal(curve.spec.spacing, 'length');
    assert.deepEqual(kw.curve(curve.spec).knots, curve.knots);
    refuses(() => blending({ model, locals: { count: 4 }, spacing: 'length', knots: [0, 1, 2, 3, 4] }), 'NOT_SUPPORTED', 'spacing');
    refuses(() => blending({ model, locals: { count: 4 }, spacing: 'chord' }), 'UNKNOWN_NAME', 'spacing');
});

test('knots move with their local curves cut anew or kept', () => {
    const curve = blending({ model: trefoil, form: 'open', locals: { count: 5, kind: 'line' }, knots: [0, 1, 2, 3, 4], poses: posed });
    const model = kw.curve(trefoil);
    const knots = [0, 1, 2.5, 3, 4];
    near(curve.withKnots(knots, { recut: true }).derivatives(2.5, 1)[1], model.derivatives(2.5, 1)[1], tolerances.rounding);
    const kept = curve.withKnots(knots, { recut: false });
    assert.deepEqual(kept.knots, knots);
    near(kept.derivatives(2.5, 1)[1], model.derivatives(2, 1)[1], tolerances.rounding);
    for (const j of [0, 1, 2, 3, 4]) {
        for (const t of [1.2, 2, 2.4]) {
            const [a, b] = [curve.local(j), kept.local(j)];
            if (t < a.domain[0] || t > a.domain[1] || t < b.domain[0] || t > b.domain[1]) continue;
            near(b.point(t), a.point(t), tolerances.rounding, `local ${j}`);
        }
    }
    assert.deepEqual(curve.withKnots([0, 1, 2, 2, 4], {}).knots, [0, 1, 2, 2, 4]);
    refuses(() => curve.withKnots([0, 1, 2], { recut: false }), 'KNOTS_COUNT', 'knots');
    refuses(() => curve.withKnots([0, 1, 1, 1, 4]), 'KNOTS_MULTIPLICITY', 'knots[3]');
    refuses(() => curve.withKnots([0, 1, '2', 3, 4]), 'WRONG_TYPE', 'knots[2]');
    refuses(() => curve.withKnots(5), 'WRONG_TYPE', 'knots');
    refuses(() => curve.withKnots(knots, { recut: 1 }), 'WRONG_TYPE', 'recut');
    refuses(() => curve.withKnots(knots, { cut: true }), 'UNKNOWN_FIELD', 'cut');
    refuses(() => curve.local(5), 'OUT_OF_RANGE', 'j');
    refuses(() => curve.local(0.5), 'NOT_INTEGER', 'j');
    refuses(() => curve.local(), 'WRONG_TYPE', 'j');
});

test('samples of blending curves are their points', () => {
    const random = randomness(41);
    for (const kind of kinds) {
        for (const form of ['open', 'closed']) {
            const curve = blending({ model: trefoil, form, locals: { count: 9, kind }, poses: posed });
            const samples = curve.sample(400);
            for (let i = 0; i < 40; ++i) {
                const at = random.integer(0, 399);
                const t = at === 399 ? curve.domain[1] : curve.domain[0] + (curve.domain[1] - curve.domain[0]) * at / 399;
                near([...samples.subarray(3 * at, 3 * at + 3)], curve.point(t), 1e-12, `${kind} at ${t}`);
            }
            const ts = Array.from({ length: 50 }, () => random.between(...curve.domain));
            const scattered = curve.sampleAt(ts);
            ts.forEach((t, i) => near([...scattered.subarray(3 * i, 3 * i + 3)], curve.point(t), 1e-12));
        }
    }
});

for (const [name, locals, code, path] of [
    ['a degree that is too high', { count: 4, kind: 'bezier', degree: 26 }, 'TOO_LARGE', 'locals.degree'],
    ['no degree at all', { count: 4, kind: 'bezier', degree: 0 }, 'OUT_OF_RANGE', 'locals.degree'],
    ['more degree than eight points allow', { count: 4, kind: 'bspline', degree: 8 }, 'OUT_OF_RANGE', 'locals.degree'],
    ['the degree of a line', { count: 4, kind: 'line', degree: 1 }, 'NOT_SUPPORTED', 'locals.degree'],
    ['an unknown kind', { count: 4, kind: 'parabola' }, 'UNKNOWN_NAME', 'locals.kind'],
]) {
    test(`local curves with ${name} are refused as ${code}`, () => {
        refuses(() => blending({ model: circle, locals }), code, path);
    });
}
