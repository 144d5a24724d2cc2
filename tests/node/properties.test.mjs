// The identities of DESIGN part 5 and the axioms of B-functions through the public interface, on random
// curves; and random data of every kind into everything that takes any. fast-check makes what fails
// small and prints it; KNOTWORK_SEED and KNOTWORK_CASES repeat it or look further.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import fc from 'fast-check';

import { added, blend, distance, holds, number, places, share, spline, withCurve } from './generators.mjs';
import { bFunctions, curves, methods, placesOf, refusalOf, scenes, withValue } from './hostile.mjs';
import { load, tolerances } from './support.mjs';

const kw = await load();

test('basis functions are a partition of unity, their derivatives sum to nothing, and they make the curve', () => {
    holds(fc.property(spline, share, (spec, between) => withCurve(kw, spec, (curve) => {
        for (const { t } of places(curve, between)) {
            const [row, slopes] = curve.basis(t, { derivatives: 1 });
            const sum = row.reduce((a, b) => a + b, 0);
            assert.ok(Math.abs(sum - 1) <= tolerances.partition, `sum ${sum} at ${t}`);
            assert.ok(row.every((value) => value >= 0));
            const size = slopes.reduce((a, b) => a + Math.abs(b), 0);
            assert.ok(Math.abs(slopes.reduce((a, b) => a + b, 0)) <= tolerances.rounding * (1 + size));
            const weighted = row.map((value, i) => value * (spec.weights?.[i] ?? 1));
            const weight = weighted.reduce((a, b) => a + b, 0);
            const made = [0, 1, 2].map((axis) => weighted.reduce((a, w, i) => a + w * spec.points[i][axis], 0) / weight);
            assert.ok(distance(made, curve.point(t)) <= 2e-14, `${made} at ${t}`);
        }
    })));
});

test('points, rows, samples and lists of samples are one curve', () => {
    holds(fc.property(spline, share, (spec, between) => withCurve(kw, spec, (curve) => {
        const ts = places(curve, between).map(({ t }) => t);
        const listed = curve.sampleAt(ts, { derivatives: 1 });
        for (const [i, t] of ts.entries()) {
            const point = curve.point(t);
            assert.ok(distance(point, curve.derivatives(t, 0)[0]) <= 2e-14);
            assert.ok(distance(point, listed.subarray(3 * i)) <= tolerances.sampled);
        }
        const uniform = curve.sample(7);
        const [a, b] = curve.domain;
        for (let i = 0; i < 7; ++i) {
            const t = i === 6 ? b : a + (b - a) * i / 6;
            assert.ok(distance(curve.point(t), uniform.subarray(3 * i)) <= tolerances.sampled);
        }
    })));
});

test('inserting a knot keeps the curve from both sides of every knot and at both ends', () => {
    holds(fc.property(spline, share, share, fc.integer({ min: 1, max: 3 }), (spec, at, between, times) => withCurve(kw, spec, (curve) => {
        const [a, b] = curve.domain;
        let refined;
        const error = refusalOf(() => { refined = curve.insertKnot(a + at * (b - a), times); });
        if (error) return void assert.ok(['KNOTS_MULTIPLICITY', 'OUT_OF_RANGE'].includes(error.code), error.message);
        for (const { t, side } of places(refined, between)) {
            const [before] = curve.derivatives(t, 0, { side });
            const [after] = refined.derivatives(t, 0, { side });
            assert.ok(distance(before, after) <= tolerances.refinement, `${distance(before, after)} at ${t} ${side}`);
        }
        refined.dispose();
    })));
});

test('a specification read back makes the same curve to the bit', () => {
    const anyCurve = fc.oneof(spline, ...curves.map(fc.constant));
    holds(fc.property(anyCurve, share, (spec, between) => withCurve(kw, spec, (curve) => {
        withCurve(kw, curve.spec, (again) => {
            assert.deepEqual(again.spec, curve.spec);
            for (const { t, side } of places(curve, between)) {
                assert.deepEqual(again.derivatives(t, 2, { side }), curve.derivatives(t, 2, { side }));
            }
        });
    })));
});

test('a polyline stays within its tolerance and has its vertices on the curve', () => {
    const tolerance = fc.integer({ min: -6, max: 0 }).map((k) => 10 ** k);
    holds(fc.property(fc.oneof(spline, ...curves.map(fc.constant)), tolerance, (spec, within) => withCurve(kw, spec, (curve) => {
        const { points, parameters } = curve.polyline({ tolerance: within });
        for (let i = 0; i + 1 < parameters.length; ++i) {
            if (parameters[i] === parameters[i + 1]) continue; // a jump
            const middle = curve.point((parameters[i] + parameters[i + 1]) / 2);
            assert.ok(fromChord(middle, points.subarray(3 * i), points.subarray(3 * i + 3)) <= within * (1 + 1e-9) + 1e-13);
        }
    })), { numRuns: 100 });
});

/** The distance of p from the chord a b. */
function fromChord(p, a, b) {
    const chord = [0, 1, 2].map((k) => b[k] - a[k]);
    const square = chord.reduce((sum, x) => sum + x * x, 0);
    const along = square === 0 ? 0 : chord.reduce((sum, x, k) => sum + x * (p[k] - a[k]), 0) / square;
    const at = Math.min(1, Math.max(0, along));
    return distance(p, [0, 1, 2].map((k) => a[k] + at * chord[k]));
}

test('every B-function rises from 0 to 1, is symmetric where it says so and flat where its orders say so', () => {
    holds(fc.property(blend, share, (spec, between) => {
        const b = kw.bFunction(spec);
        const values = b.sample(33);
        assert.deepEqual([values[0], values[32], b.value(0), b.value(1)], [0, 1, 0, 1]);
        for (let i = 1; i < 33; ++i) assert.ok(values[i] >= values[i - 1] - tolerances.expoRational);
        assert.ok(b.derivatives(between, 1)[1] >= -tolerances.rounding);
        if (b.symmetric) {
            const slope = b.derivatives(between, 1)[1];
            assert.ok(Math.abs(b.value(between) + b.value(1 - between) - 1) <= tolerances.expoRational + 2e-16 * slope);
        }
        for (const end of [0, 1]) {
            const rows = b.derivatives(end, 3);
            for (let k = 1; k <= Math.min(3, b.order[end]); ++k) assert.ok(Math.abs(rows[k]) <= tolerances.rounding);
        }
        b.dispose();
    }));
});

test('a blend of one model is the model, whatever the B-function and the knots', () => {
    const model = { type: 'parametric-curve', name: 'circle' };
    const gaps = fc.array(number(0.2, 1), { minLength: 2, maxLength: 6 });
    holds(fc.property(blend, gaps, share, (bFunction, given, between) => {
        const knots = added(given);
        const scale = 2 * Math.PI / knots.at(-1);
        const spec = { type: 'blending-curve', bFunction, model, form: 'closed', locals: { count: given.length }, knots: knots.map((t) => t * scale) };
        withCurve(kw, spec, (curve) => withCurve(kw, model, (circle) => {
            for (const { t } of places(curve, between)) assert.ok(distance(curve.point(t), circle.point(t)) <= tolerances.rounding);
            const weights = curve.blendBasis(between * 6);
            assert.ok(Math.abs(weights.reduce((a, b) => a + b, 0) - 1) <= tolerances.exact);
        }));
    }));
});

const anything = fc.anything({
    withBigInt: true, withBoxedValues: true, withDate: true, withMap: true, withNullPrototype: true, withObjectString: true,
    withSet: true, withSparseArray: true, withTypedArray: true, maxDepth: 4,
});
/** Numbers that are seldom thought of, and anything. */
const odd = fc.oneof(
    fc.double(), fc.constantFrom(0, -0, 1e-300, 1e300, 2 ** 31, 2 ** 32 + 5, 2 ** 53, -1, 0.5, NaN), fc.integer(),
    fc.array(fc.double(), { maxLength: 5 }), fc.string(), anything,
);

/** Takes or refuses; what was taken is of use and can be disposed of. */
function takesOrRefuses(take, data) {
    let made;
    refusalOf(() => { made = take(data); });
    if (made === undefined) return;
    if (made.point) refusalOf(() => made.derivatives(made.domain[0], 2));
    if (made.sample) made.sample(5);
    if (made.drawing) made.drawing({ tolerance: 0.1 });
    made.dispose();
}

test('anything at all is taken or refused', () => {
    for (const take of [kw.curve, kw.bFunction, kw.scene]) {
        holds(fc.property(anything, (data) => takesOrRefuses(take, data)));
    }
});

const mutations = (specs) => fc.constantFrom(...specs).chain((spec) => {
    const paths = placesOf(spec).map(({ path }) => path).filter((path) => path.length > 0);
    const change = fc.tuple(fc.constantFrom(...paths), odd);
    return fc.array(change, { minLength: 1, maxLength: 3 }).map((changes) => changes.reduce((data, [path, value]) => {
        try {
            return withValue(data, path, value);
        } catch {
            return data; // an earlier change took the place away
        }
    }, spec));
});

for (const [name, take, specs] of [['curve', kw.curve, curves], ['bFunction', kw.bFunction, bFunctions], ['scene', kw.scene, scenes]]) {
    test(`a ${name} with something odd in it is taken or refused, and the module works on`, () => {
        const before = kw.session.held();
        holds(fc.property(mutations(specs), (data) => takesOrRefuses(take, data)), { numRuns: 1000 });
        for (const spec of specs) take(spec).dispose();
        assert.equal(kw.session.held(), before);
    });
}

test('methods take or refuse any arguments', () => {
    const values = [...curves.map(kw.curve), ...bFunctions.map(kw.bFunction), ...scenes.map(kw.scene)];
    const calls = values.flatMap((value) => Object.values(methods).flatMap((row) => Object.keys(row))
        .filter((name) => typeof value[name] === 'function')
        .map((name) => ({ name, value, [fc.toStringMethod]: () => `${name} of ${JSON.stringify(value.spec ?? value.document)}` })));
    holds(fc.property(fc.constantFrom(...calls), fc.array(odd, { maxLength: 3 }), ({ value, name }, given) => {
        if (name === 'sample' && typeof given[0] === 'number' && given[0] > 1e5) return; // allowed, and long
        refusalOf(() => value[name](...given)?.dispose?.());
    }));
    for (const value of values) value.dispose();
});
