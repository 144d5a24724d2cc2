// Part 3 of the interface: parametric curves and blending curves.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { load, near, randomness, refuses, tolerances } from './support.mjs';

const kw = await load();
const named = (name, parameters, domain) => kw.curve({
    type: 'parametric-curve', name, ...(parameters && { parameters }), ...(domain && { domain }),
});
const { sin, cos, exp, PI } = Math;

/** The formulas of the interface, written again. */
const formulas = {
    circle: [{ radius: 1.5 }, (t, { radius: r }) => [r * cos(t), r * sin(t)], 2 * PI],
    ellipse: [{ a: 3, b: 0.5 }, (t, { a, b }) => [a * cos(t), b * sin(t)], 2 * PI],
    lissajous: [{ a: 2, b: 1, kx: 3, ky: 2 }, (t, { a, b, kx, ky }) => [a * cos(kx * t), b * sin(ky * t)], 2 * PI],
    rose: [{ a: 2, k: 5 }, (t, { a, k }) => [a * cos(k * t) * cos(t), a * cos(k * t) * sin(t)], PI],
    butterfly: [{ scale: 0.5 }, (t, { scale: s }) => {
        const r = exp(cos(t)) - 2 * cos(4 * t) - sin(t / 12) ** 5;
        return [s * sin(t) * r, s * cos(t) * r];
    }, 12 * PI],
    hypotrochoid: [{ R: 5, r: 3, d: 4 }, (t, { R, r, d }) => [
        (R - r) * cos(t) + d * cos((R - r) * t / r), (R - r) * sin(t) - d * sin((R - r) * t / r)], 6 * PI],
};

for (const [name, [parameters, formula, length]] of Object.entries(formulas)) {
    test(`${name} is its formula on its domain`, () => {
        const curve = named(name, parameters);
        near(curve.domain, [0, length], tolerances.rounding);
        assert.deepEqual([curve.closed, curve.dimension], [true, 2]);
        const random = randomness(31);
        for (let i = 0; i < 100; ++i) {
            const t = random.between(0, length);
            near(curve.point(t), [...formula(t, parameters), 0], tolerances.rounding, `at ${t}`);
        }
    });

    test(`${name} has exact derivatives`, () => {
        const curve = named(name, parameters);
        const random = randomness(32);
        for (let i = 0; i < 20; ++i) {
            const t = random.between(0.01, length - 0.01);
            const h = 1e-4;
            const rows = curve.derivatives(t, 5);
            const [before, after] = [t - h, t + h].map((s) => curve.derivatives(s, 4));
            for (let k = 0; k < 5; ++k) {
                // The error of the difference is h²/6 of the derivative two orders higher.
                const scale = 1 + Math.hypot(...rows[k + 1]) + 10 ** (k + 1);
                near(after[k].map((x, c) => (x - before[k][c]) / (2 * h)), rows[k + 1], 2e-6 * scale, `order ${k + 1}`);
            }
        }
    });

    test(`${name} reads back as what it was made from`, () => {
        const curve = named(name, parameters);
        const { spec } = curve;
        assert.deepEqual([spec.type, spec.name, spec.parameters], ['parametric-curve', name, parameters]);
        assert.deepEqual(kw.curve(spec).sample(50), curve.sample(50));
    });
}

test('defaults of the parameters are those that kw.parametricCurves lists', () => {
    const listed = kw.parametricCurves;
    assert.deepEqual(listed.map(({ name }) => name).sort(), [...new Set(listed.map(({ name }) => name))].sort());
    for (const name of Object.keys(formulas)) assert.ok(listed.some((one) => one.name === name), name);
    for (const { name, label, parameters, dimension } of listed) {
        const curve = named(name);
        assert.equal(curve.dimension, dimension);
        assert.ok(label.length > 0);
        const usual = Object.fromEntries(parameters.map((one) => [one.name, one.default]));
        assert.deepEqual(curve.spec.parameters, usual);
    }
    assert.deepEqual(named('ellipse').spec.parameters, { a: 2, b: 1 });
    assert.deepEqual(named('hypotrochoid').spec.parameters, { R: 5, r: 3, d: 5 });
});

test('a closed curve wraps, and a part of it does not', () => {
    const circle = named('circle');
    near(circle.point(2 * PI + 0.5), circle.point(0.5), tolerances.rounding);
    near(circle.point(-0.5), circle.point(2 * PI - 0.5), tolerances.rounding);
    const part = named('circle', undefined, [0, 1]);
    assert.deepEqual([part.closed, part.domain], [false, [0, 1]]);
    refuses(() => part.point(1.0001), 'OUT_OF_RANGE', 't');
});

test('the period of a rose follows from its k', () => {
    for (const [k, period] of [[4, 2 * PI], [3, PI], [1 / 2, 4 * PI], [4 / 3, 6 * PI], [5 / 3, 3 * PI], [2 / 3, 6 * PI]]) {
        near(named('rose', { k }).domain[1], period, tolerances.rounding, `k = ${k}`);
    }
    refuses(() => named('rose', { k: PI }), 'OUT_OF_RANGE', 'parameters.k');
    near(named('rose', { k: PI }, [0, 3]).domain, [0, 3], 0);
});

test('what is wrong with a parametric curve is said with its place', () => {
    refuses(() => named('cirlce'), 'UNKNOWN_NAME', 'name');
    refuses(() => kw.curve({ type: 'parametric-curve' }), 'WRONG_TYPE', 'name');
    refuses(() => named('circle', { r: 1 }), 'UNKNOWN_FIELD', 'parameters.r');
    refuses(() => named('circle', { radius: '1' }), 'WRONG_TYPE', 'parameters.radius');
    refuses(() => named('circle', { radius: NaN }), 'NOT_FINITE', 'parameters.radius');
    refuses(() => named('lissajous', { kx: NaN }), 'NOT_FINITE', 'parameters.kx');
    refuses(() => named('circle', undefined, [1, 0]), 'OUT_OF_RANGE', 'domain');
    refuses(() => named('circle', undefined, [0]), 'WRONG_LENGTH', 'domain');
    refuses(() => named('circle', undefined, [0, Infinity]), 'NOT_FINITE', 'domain[1]');
});

// Blending curves

const erb = { family: 'expo-rational' };
const blending = (fields) => kw.curve({ type: 'blending-curve', bFunction: erb, ...fields });
const butterfly = { type: 'parametric-curve', name: 'butterfly' };
const circle = { type: 'parametric-curve', name: 'circle' };
const openSpline = { type: 'bspline-curve', degree: 3, points: [[0, 0], [1, 2], [3, 3], [4, 0], [6, 1], [7, 3]] };

test('sub-curves of one curve blend into that curve, whatever the B-function and the knots', () => {
    const random = randomness(33);
    for (const model of [butterfly, circle, openSpline]) {
        for (const bFunction of [erb, { family: 'linear' }, { family: 'polynomial', p: 3, q: 1 }]) {
            const whole = kw.curve(model);
            const curve = blending({ model, bFunction, locals: { count: random.integer(2, 12) } });
            assert.deepEqual([curve.domain, curve.closed, curve.dimension], [whole.domain, whole.closed, whole.dimension]);
            // The last span of a closed curve blends into c(t − T), which for the butterfly is another strand.
            const last = curve.knots.at(-2);
            for (let i = 0; i < 30; ++i) {
                const t = random.between(curve.domain[0], model === butterfly ? last : curve.domain[1]);
                near(curve.point(t), whole.point(t), tolerances.rounding, `at ${t}`);
            }
        }
    }
});

test('knots are uniform over the domain of the model by default, one more where closed', () => {
    near(blending({ model: circle, locals: { count: 4 } }).knots, [0, PI / 2, PI, 3 * PI / 2, 2 * PI], tolerances.rounding);
    near(blending({ model: openSpline, locals: { count: 4 } }).knots, [0, 1, 2, 3], tolerances.exact);
    near(blending({ model: circle, form: 'open', locals: { count: 3 } }).knots, [0, PI, 2 * PI], tolerances.rounding);
});

test('at its knot the curve has the point and the derivatives of its local curve', () => {
    const turn = { local: 1, translate: [0.5, -1], rotate: { axis: [0, 0, 1], angle: 0.7 }, scale: 1.5 };
    for (const [bFunction, orders] of [[erb, 4], [{ family: 'polynomial', p: 2, q: 2 }, 2], [{ family: 'linear' }, 0]]) {
        const curve = blending({ model: openSpline, bFunction, locals: { count: 4 }, poses: [turn] });
        const model = kw.curve(openSpline);
        const [c, s] = [1.5 * cos(0.7), 1.5 * sin(0.7)];
        const rows = model.derivatives(1, orders);
        const expected = rows.map(([x, y], k) => (k === 0
            ? [x + 0.5, y - 1, 0]  // scale and rotation are about the point itself
            : [c * x - s * y, s * x + c * y, 0]));
        near(curve.derivatives(1, orders, { side: 'right' }), expected, 1e-11, JSON.stringify(bFunction));
        near(curve.derivatives(1, orders, { side: 'left' }).slice(0, 3), expected.slice(0, 3), 1e-11);
    }
});

test('a pose changes the curve only where its local curve takes part', () => {
    const plain = blending({ model: openSpline, locals: { count: 4 } });
    const posed = plain.withPose(1, { translate: [0, 5, 2] });
    assert.equal(posed.dimension, 3);
    for (const t of [2, 2.4, 3]) assert.deepEqual(posed.point(t), plain.point(t));
    for (const t of [0.5, 1, 1.5]) assert.ok(posed.point(t)[1] > plain.point(t)[1] + 0.1);
    assert.deepEqual(plain.spec.poses, []);
    const { poses } = posed.spec;
    assert.equal(poses.length, 1);
    assert.deepEqual([poses[0].local, poses[0].translate], [1, [0, 5, 2]]);
});

test('withPose replaces the pose that was there', () => {
    const curve = blending({ model: openSpline, locals: { count: 4 }, poses: [{ local: 1, translate: [1, 1] }, { local: 2, scale: 2 }] });
    const again = curve.withPose(1, { translate: [3, 0] });
    assert.deepEqual(again.spec.poses.map(({ local }) => local).sort(), [1, 2]);
    near(again.point(1), kw.curve(openSpline).point(1).map((x, c) => x + [3, 0, 0][c]), tolerances.exact);
    near(again.withPose(1, {}).point(1), kw.curve(openSpline).point(1), tolerances.exact);
});

test('withPose refuses as a specification does', () => {
    const curve = blending({ model: circle, locals: { count: 4 } });
    refuses(() => curve.withPose(4, {}), 'OUT_OF_RANGE', 'j');
    refuses(() => curve.withPose(-1, {}), 'OUT_OF_RANGE', 'j');
    refuses(() => curve.withPose('1', {}), 'WRONG_TYPE', 'j');
    refuses(() => curve.withPose(1, { turn: 1 }), 'UNKNOWN_FIELD', 'turn');
    refuses(() => curve.withPose(1, { rotate: { axis: [0, 0, 0], angle: 1 } }), 'OUT_OF_RANGE', 'rotate.axis');
    refuses(() => curve.withPose(1, { scale: 0 }), 'OUT_OF_RANGE', 'scale');
    refuses(() => curve.withPose(1, { translate: [0, NaN] }), 'NOT_FINITE', 'translate[1]');
    refuses(() => curve.withPose(1, { local: 1 }), 'UNKNOWN_FIELD', 'local');
    refuses(() => curve.withPose(1, 5), 'WRONG_TYPE', '');
    refuses(() => curve.withPose(1), 'WRONG_TYPE', '');
});

test('the blend basis sums to one and blends the local curves', () => {
    const curve = blending({ model: circle, locals: { count: 5 }, bFunction: { family: 'logistic' } });
    for (const t of [0, 0.3, 1.7, 4, 6.2, 2 * PI]) {
        const weights = curve.blendBasis(t);
        assert.equal(weights.length, 5);
        near(weights.reduce((sum, one) => sum + one, 0), 1, tolerances.exact);
        assert.ok(weights.filter((weight) => weight !== 0).length <= 2);
    }
    assert.deepEqual(curve.blendBasis(curve.knots[2]), [0, 0, 1, 0, 0]);
    const open = blending({ model: openSpline, locals: { count: 3 } });
    refuses(() => open.blendBasis(-1), 'OUT_OF_RANGE', 't');
});

test('a closed blending curve is smooth over its seam where its model returns', () => {
    const curve = blending({ model: circle, locals: { count: 5 }, poses: [{ local: 0, translate: [0.5, 0] }] });
    const [start, end] = curve.domain;
    near(curve.derivatives(end, 3, { side: 'left' }), curve.derivatives(start, 3, { side: 'right' }), 1e-11);
    near(curve.point(end + 0.3), curve.point(start + 0.3), 1e-12);
});

test('a closed blending curve is smooth over its seam also where its model does not return', () => {
    const model = { ...circle, domain: [0, 5] };
    const curve = blending({ model, form: 'closed', locals: { count: 5 } });
    const [start, end] = curve.domain;
    near(curve.derivatives(end, 2, { side: 'left' }), curve.derivatives(start, 2, { side: 'right' }), 1e-11);
});

test('local curves given one by one are blended in the global parameter, or fitted into place', () => {
    const line = (points) => ({ type: 'bspline-curve', degree: 1, points });
    const locals = [line([[0, 0], [1, 0]]), line([[0, 1], [1, 1]]), line([[0, 2], [1, 2]])];
    const fitted = blending({ locals, fit: 'affine', bFunction: { family: 'linear' } });
    assert.deepEqual(fitted.knots, [0, 1, 2]);
    near(fitted.point(0), [0, 0, 0], tolerances.exact);
    near(fitted.point(1), [0.5, 1, 0], tolerances.exact);
    near(fitted.point(2), [1, 2, 0], tolerances.exact);
    const plain = blending({ locals, bFunction: { family: 'linear' } });
    near(plain.point(1), [1, 1, 0], tolerances.exact);
});

test('two equal knots are a break', () => {
    const curve = blending({
        model: circle, form: 'open', locals: { count: 4 }, knots: [0, 1, 1, 2],
        poses: [{ local: 1, translate: [0, 0, 1] }, { local: 2, translate: [0, 0, -1] }],
    });
    near(curve.derivatives(1, 0, { side: 'left' })[0][2], 1, tolerances.exact);
    near(curve.derivatives(1, 0, { side: 'right' })[0][2], -1, tolerances.exact);
});

for (const [name, fields, code, path] of [
    ['no B-function', { bFunction: undefined, model: circle, locals: { count: 4 } }, 'WRONG_TYPE', 'bFunction'],
    ['a parameter of its B-function', { bFunction: { ...erb, alpha: 5 }, model: circle, locals: { count: 4 } }, 'OUT_OF_RANGE', 'bFunction.alpha'],
    ['no local curves', { model: circle }, 'WRONG_TYPE', 'locals'],
    ['one local curve', { model: circle, locals: { count: 1 } }, 'OUT_OF_RANGE', 'locals.count'],
    ['half a local curve', { model: circle, locals: { count: 2.5 } }, 'NOT_INTEGER', 'locals.count'],
    ['far too many', { model: circle, locals: { count: 1e6 } }, 'TOO_LARGE', 'locals.count'],
    ['an unknown kind', { model: circle, locals: { count: 4, kind: 'parabola' } }, 'UNKNOWN_NAME', 'locals.kind'],
    ['no model', { locals: { count: 4 } }, 'WRONG_TYPE', 'model'],
    ['something wrong in the model', { model: { ...circle, parameters: { radius: '1' } }, locals: { count: 4 } }, 'WRONG_TYPE', 'model.parameters.radius'],
    ['something wrong in a local curve', { locals: [circle, { type: 'parametric-curve', name: 'x' }] }, 'UNKNOWN_NAME', 'locals[1].name'],
    ['too few knots', { model: circle, locals: { count: 4 }, knots: [0, 1, 2, 3] }, 'KNOTS_COUNT', 'knots'],
    ['knots that fall', { model: circle, locals: { count: 3 }, form: 'open', knots: [0, 2, 1] }, 'KNOTS_DECREASING', 'knots[2]'],
    ['three equal knots', { model: circle, locals: { count: 5 }, form: 'open', knots: [0, 1, 1, 1, 2] }, 'KNOTS_MULTIPLICITY', 'knots[3]'],
    ['a pose of no local curve', { model: circle, locals: { count: 3 }, poses: [{ local: 3 }] }, 'OUT_OF_RANGE', 'poses[0].local'],
    ['two poses of one', { model: circle, locals: { count: 3 }, poses: [{ local: 1 }, { local: 1 }] }, 'OUT_OF_RANGE', 'poses[1].local'],
    ['an axis of no length', { model: circle, locals: { count: 3 }, poses: [{ local: 1, rotate: { axis: [0, 0, 0], angle: 1 } }] }, 'OUT_OF_RANGE', 'poses[0].rotate.axis'],
    ['a field that is not known', { model: circle, locals: { count: 3 }, blend: erb }, 'UNKNOWN_FIELD', 'blend'],
]) {
    test(`a blending curve with ${name} is refused as ${code}`, () => {
        refuses(() => blending(fields), code, path);
    });
}
