// Frames, lengths, nearest points, spheres, fits, subdivision and kinds of local curves on random
// input: what holds for all of them, whatever the curve.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import fc from 'fast-check';

import { coordinate, distance, gentleSpline, holds, number, places, share, spline, withCurve } from './generators.mjs';
import { curves } from './hostile.mjs';
import { load, near, tolerances } from './support.mjs';

const kw = await load();

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const length = (a) => Math.hypot(...a);
const anyCurve = fc.oneof(spline, ...curves.map(fc.constant));
const gentle = fc.oneof(gentleSpline, ...curves.map(fc.constant));
const within = (curve, part) => curve.domain[0] + part * (curve.domain[1] - curve.domain[0]);
const triples = (flat) => Array.from({ length: flat.length / 3 }, (_, i) => [...flat.slice(3 * i, 3 * i + 3)]);

test('frames are orthonormal and right-handed, and curve and twist as the derivatives say', () => {
    holds(fc.property(gentle, share, (spec, between) => withCurve(kw, spec, (curve) => {
        for (const { t, side } of places(curve, between)) {
            const { point, tangent, normal, binormal, curvature, torsion } = curve.frame(t, { side });
            const [p, first, second, third] = curve.derivatives(t, 3, { side });
            assert.deepEqual(point, p);
            near([length(tangent), length(normal), length(binormal)], [1, 1, 1], tolerances.rounding);
            near(cross(tangent, normal), binormal, tolerances.rounding);
            const speed = length(first);
            const wedge = cross(first, second);
            const size = speed * length(second);
            // Where the curve nearly rests, or is nearly straight, these quotients are rounding.
            if (speed < 1e-3 || length(wedge) <= 1e-6 * size) continue;
            near(tangent, first.map((x) => x / speed), tolerances.rounding);
            const bend = (curve.dimension === 2 ? wedge[2] : length(wedge)) / speed ** 3;
            assert.ok(Math.abs(curvature - bend) <= 1e-9 * Math.abs(bend), `${curvature} against ${bend} at ${t}`);
            const twist = dot(wedge, third) / dot(wedge, wedge);
            const scale = length(third) / length(wedge);
            assert.ok(Math.abs(torsion - twist) <= 1e-9 * scale, `${torsion} against ${twist} at ${t}`);
        }
    })));
});

test('lengths add up, are no shorter than chords, and have an inverse', () => {
    holds(fc.property(anyCurve, share, share, (spec, one, two) => withCurve(kw, spec, (curve) => {
        const [a, b] = curve.domain;
        const [u, v] = [within(curve, one), within(curve, two)].sort((x, y) => x - y);
        const whole = curve.length();
        const parts = curve.length(a, u) + curve.length(u, v) + curve.length(v, b);
        assert.ok(Math.abs(parts - whole) <= 1e-9 * (1 + whole), `${parts} against ${whole}`);
        const s = curve.length(a, u);
        const back = curve.parameterAtLength(s);
        assert.ok(Math.abs(curve.length(a, back) - s) <= 1e-9 * (1 + whole));
    })), { numRuns: 100 });
});

test('a piece without breaks is no shorter than its chord', () => {
    const smooth = fc.array(fc.array(coordinate, { minLength: 3, maxLength: 3 }), { minLength: 2, maxLength: 8 })
        .map((points) => ({ type: 'bezier-curve', points }));
    holds(fc.property(smooth, share, share, (spec, one, two) => withCurve(kw, spec, (curve) => {
        const [u, v] = [one, two].sort((x, y) => x - y);
        assert.ok(curve.length(u, v) >= distance(curve.point(u), curve.point(v)) - tolerances.rounding);
    })));
});

test('nothing on a curve is nearer than its nearest point', () => {
    const place = fc.array(number(-3, 3), { minLength: 3, maxLength: 3 });
    holds(fc.property(anyCurve, place, (spec, p) => withCurve(kw, spec, (curve) => {
        const found = curve.closestPoint(p);
        assert.ok(distance(found.point, p) <= found.distance * (1 + 1e-12) + 1e-15);
        // At a break the point is of one of its sides.
        const sides = ['left', 'right'].map((side) => curve.derivatives(found.t, 0, { side })[0]);
        assert.ok(Math.min(...sides.map((q) => distance(q, found.point))) <= tolerances.rounding);
        for (const q of triples(curve.sample(257))) {
            assert.ok(found.distance <= distance(p, q) + 1e-9, `${q} is nearer than ${found.point}`);
        }
    })), { numRuns: 100 });
});

test('a sphere holds all of its curve, and is the smallest that does', () => {
    holds(fc.property(anyCurve, (spec) => withCurve(kw, spec, (curve) => {
        const { center, radius } = curve.enclosingSphere();
        const tolerance = 1e-4;
        const around = triples(curve.polyline({ tolerance }).points);
        for (const p of around) assert.ok(distance(p, center) <= radius * (1 + 1e-9) + 1e-12);
        // What is around some of the points need be no larger than what is around all of them, and
        // the others are no farther from these than the tolerance.
        const some = kw.enclosingSphere(around);
        assert.ok(some.radius <= radius * (1 + 1e-9) + 1e-12);
        assert.ok(radius <= some.radius + tolerance, `${radius} around points within ${some.radius}`);
    })), { numRuns: 100 });
});

test('a fit gives back the spline that its data come from', () => {
    const plain = spline.filter(({ weights, form, degree, points }) => !weights && form === 'clamped' && points.length > degree + 1);
    holds(fc.property(plain, (spec) => {
        const even = { type: 'bspline-curve', degree: spec.degree, points: spec.points };
        withCurve(kw, even, (curve) => {
            const count = 12 * spec.points.length;
            const parameters = Array.from({ length: count }, (_, i) => within(curve, i / (count - 1)));
            const points = triples(curve.sampleAt(parameters));
            const fit = kw.fit({ points, degree: spec.degree, count: spec.points.length, parameters, knots: curve.knots });
            assert.ok(fit.residuals.max <= 1e-12, `${fit.residuals.max}`);
            near(fit.curve.sample(33), curve.sample(33), 1e-12);
            fit.curve.dispose();
        });
    }), { numRuns: 100 });
});

test('interpolation goes through every point', () => {
    const points = fc.array(fc.array(coordinate, { minLength: 2, maxLength: 2 }), { minLength: 5, maxLength: 20 })
        .filter((all) => all.every((p, i) => i === 0 || distance([...p, 0], [...all[i - 1], 0]) > 0.05));
    holds(fc.property(points, fc.integer({ min: 1, max: 4 }), fc.constantFrom('chord', 'centripetal', 'uniform'), (given, degree, parameters) => {
        const { curve, parameters: ts, residuals } = kw.interpolate({ points: given, degree, parameters });
        const size = 1 + Math.max(...triples(curve.controlPoints()).map(length));
        assert.ok(residuals.max <= 1e-12 * size, `${residuals.max}`);
        for (const [k, t] of ts.entries()) near(curve.point(t), [...given[k], 0], 1e-12 * size);
        curve.dispose();
    }));
});

const polygon = fc.array(fc.array(coordinate, { minLength: 3, maxLength: 3 }), { minLength: 6, maxLength: 12 });
const scheme = fc.oneof(
    fc.record({ scheme: fc.constant('lane-riesenfeld'), degree: fc.integer({ min: 1, max: 5 }) }),
    fc.constant({ scheme: 'chaikin' }),
    fc.record({ scheme: fc.constant('four-point'), tension: number(0, 0.15) }),
);

test('levels one after the other are levels at once, and move with their points', () => {
    const affine = ([x, y, z]) => [2 * x - y + 1, x + y - z, 0.5 * z - 3];
    holds(fc.property(polygon, scheme, fc.boolean(), (points, rule, closed) => {
        const levels = (from, count) => kw.subdivide({ ...rule, points: from, closed, levels: count });
        const two = levels(points, 2);
        near(levels(levels(points, 1), 1), two, tolerances.exact);
        near(triples(levels(points.map(affine), 2)), triples(two).map(affine), 10 * tolerances.exact);
        if (closed) assert.equal(two.length, 3 * 4 * points.length);
    }));
});

test('limits stay where they are when the polygon is subdivided', () => {
    holds(fc.property(polygon, fc.constantFrom(2, 3, 4, 5), (points, degree) => {
        const rule = { type: 'subdivision-curve', scheme: 'lane-riesenfeld', degree, closed: true };
        withCurve(kw, { ...rule, points, levels: 0 }, (coarse) => withCurve(kw, { ...rule, points, levels: 3 }, (fine) => {
            const before = triples(coarse.limitPoints());
            const after = triples(fine.limitPoints());
            for (const p of before) {
                const gap = Math.min(...after.map((q) => distance(p, q)));
                assert.ok(gap <= tolerances.refinement, `${p} has moved by ${gap}`);
            }
        }));
    }));
});

const kinds = [
    { kind: 'sub-curve', keeps: 3 }, { kind: 'line', keeps: 1 },
    { kind: 'bezier', degree: 1, keeps: 1 }, { kind: 'bezier', degree: 2, keeps: 2 }, { kind: 'bezier', degree: 3, keeps: 3 },
];

test('at its knot a blend has the point and the derivatives that its local curve has kept', () => {
    const models = curves.filter(({ type }) => type === 'parametric-curve' || type === 'formula-curve');
    const smooth = { family: 'expo-rational' };
    holds(fc.property(fc.constantFrom(...models), fc.constantFrom(...kinds), fc.integer({ min: 2, max: 9 }), (model, { keeps, ...cut }, count) => {
        const spec = { type: 'blending-curve', bFunction: smooth, model, form: 'open', locals: { count, ...cut } };
        withCurve(kw, spec, (curve) => withCurve(kw, model, (whole) => {
            for (const t of curve.knots) {
                const found = curve.derivatives(t, keeps);
                const wanted = whole.derivatives(t, keeps);
                for (let k = 0; k <= keeps; ++k) near(found[k], wanted[k], 1e-9 * (1 + length(wanted[k])), `${cut.kind} ${k} at ${t}`);
            }
        }));
    }));
});
