// Blending surfaces through the public interface.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { load, near, refuses, tolerances } from './support.mjs';

const kw = await load();

const cylinder = { type: 'parametric-surface', name: 'cylinder', parameters: { height: 3 } };
const torus = { type: 'parametric-surface', name: 'torus' };
const erb = { family: 'expo-rational' };
const blend = (fields) => kw.surface({ type: 'blending-surface', bFunction: erb, model: cylinder, locals: [4, 3], ...fields });

test('a cylinder that nobody moved is the cylinder, closed as it is, with uniform knots', () => {
    const surface = blend();
    const model = kw.surface(cylinder);
    assert.deepEqual(surface.domain, model.domain);
    assert.deepEqual(surface.closed, [true, false]);
    assert.deepEqual(surface.knots, [[0, 0.5, 1, 1.5, 2].map((x) => x * Math.PI), [0, 1.5, 3]]);
    for (const [u, v] of [[0, 0], [1, 2], [Math.PI, 1.5], [6, 3], [-1, 0.2]]) {
        assert.deepEqual(surface.derivatives(u, v), model.derivatives(u, v));
        assert.deepEqual(surface.normal(u, v), model.normal(u, v));
    }
});

for (const kind of ['sub-surface', 'plane', 'bezier']) {
    test(`at its knots a surface of the kind ${kind} has the points of the model, and its first derivatives`, () => {
        const surface = blend({ model: torus, locals: [5, 3], kind });
        const model = kw.surface(torus);
        for (const u of surface.knots[0]) {
            for (const v of surface.knots[1]) {
                const [got, expected] = [surface.derivatives(u, v), model.derivatives(u, v)];
                for (const row of ['S', 'Su', 'Sv']) near(got[row], expected[row], tolerances.exact);
                near(surface.normal(u, v), model.normal(u, v), tolerances.exact);
            }
        }
    });
}

test('a pose moves its patch and nothing beyond the neighbouring knots', () => {
    const rest = blend();
    const posed = rest.withPose([1, 1], { translate: [0, 0, 2], rotate: { angle: 0.3 } });
    const [u, v] = [rest.knots[0][1], rest.knots[1][1]];
    const moved = posed.point(u, v).map((x, i) => x - rest.point(u, v)[i]);
    near(moved, [0, 0, 2], tolerances.exact);
    assert.deepEqual(posed.point(rest.knots[0][2], v), rest.point(rest.knots[0][2], v));
    assert.deepEqual(posed.point(4, 1), rest.point(4, 1));
    assert.notDeepEqual(posed.point(1, 1), rest.point(1, 1));
    assert.equal(posed.spec.poses.length, 1);
    assert.deepEqual(posed.spec.poses[0].local, [1, 1]);
    assert.deepEqual(rest.spec.poses, []);
    const back = posed.withPose([1, 1], {});
    assert.deepEqual(back.spec.poses, []);
    assert.deepEqual(kw.surface(posed.spec).derivatives(1, 1), posed.derivatives(1, 1));
});

test('the first patches of a closed surface are seen on both sides of its seams', () => {
    const rest = blend({ model: torus, locals: [5, 3] });
    const posed = rest.withPose([0, 0], { translate: [0, 0, 1] });
    for (const u of [0.5, 2 * Math.PI - 0.5]) {
        for (const v of [0.7, 2 * Math.PI - 0.7]) {
            assert.ok(posed.point(u, v)[2] > rest.point(u, v)[2]);
        }
    }
    assert.deepEqual(posed.point(2, 0.7), rest.point(2, 0.7));
    assert.deepEqual(posed.point(0.5, 3), rest.point(0.5, 3));
});

test('origins are where the handles are', () => {
    const surface = blend({ poses: [{ local: [2, 1], translate: [1, 2, 3], scale: 2 }] });
    const origins = surface.localOrigins;
    assert.equal(origins.length, 3 * 4 * 3);
    surface.knots[0].slice(0, 4).forEach((u, i) => surface.knots[1].forEach((v, j) => {
        const own = kw.surface(cylinder).point(u, v).map((x, axis) => x + (i === 2 && j === 1 ? axis + 1 : 0));
        near(Array.from(origins.subarray(3 * (3 * i + j), 3 * (3 * i + j) + 3)), own, tolerances.exact);
    }));
});

for (const kind of ['sub-surface', 'plane', 'bezier']) {
    test(`a local patch of the kind ${kind} is a surface over the rectangle where it takes part`, () => {
        const surface = blend({ kind, poses: [{ local: [1, 1], rotate: { axis: [1, 0, 0], angle: 0.5 }, scale: [1, 2, 1] }] });
        const local = surface.local(1, 1);
        const [ku, kv] = surface.knots;
        assert.deepEqual(local.domain, [[ku[0], ku[2]], [kv[0], kv[2]]]);
        near(local.point(ku[1], kv[1]), surface.point(ku[1], kv[1]), tolerances.exact);
        near(local.derivatives(ku[1], kv[1]).Su, surface.derivatives(ku[1], kv[1]).Su, tolerances.exact);
        const again = kw.surface(local.spec);
        near(again.point(ku[1] + 0.3, 1), local.point(ku[1] + 0.3, 1), tolerances.exact);
        assert.equal(local.spec.type, kind === 'sub-surface' ? 'blending-surface' : 'bspline-surface');
    });
}

for (const kind of ['sub-surface', 'plane', 'bezier']) {
    test(`a grid of the kind ${kind} has the points and normals of the surface, and its seam meets itself`, () => {
        const surface = blend({ kind, poses: [{ local: [0, 1], translate: [1, 0, 0], scale: 2 }] });
        const [nu, nv] = [9, 7];
        const { positions, normals } = surface.grid(nu, nv);
        for (let i = 0; i < nu; ++i) {
            for (let j = 0; j < nv; ++j) {
                const [u, v] = [2 * Math.PI * (i / (nu - 1)), 3 * (j / (nv - 1))];
                const at = 3 * (i * nv + j);
                near(Array.from(positions.subarray(at, at + 3)), surface.point(u, v), 10 * tolerances.exact);
                near(Array.from(normals.subarray(at, at + 3)), surface.normal(u, v), 100 * tolerances.exact);
            }
        }
        assert.deepEqual(positions.subarray(0, 3 * nv), positions.subarray(3 * (nu - 1) * nv));
    });
}

test('a specification comes back complete', () => {
    const { spec } = blend({ kind: 'bezier', bFunction: [erb, { family: 'linear' }] });
    assert.deepEqual(Object.keys(spec), ['type', 'bFunction', 'model', 'locals', 'kind', 'degree', 'form', 'knots', 'poses']);
    assert.deepEqual(spec.degree, [3, 3]);
    assert.deepEqual(spec.form, ['closed', 'open']);
    assert.equal(spec.bFunction[0].lambda, 0.5);
    assert.deepEqual(kw.surface(spec).spec, spec);
});

test('what cannot be blended is refused where it stands', () => {
    refuses(() => blend({ locals: [4, 1] }), 'OUT_OF_RANGE', 'locals[1]');
    refuses(() => blend({ locals: [1000, 1000] }), 'TOO_LARGE', 'locals');
    refuses(() => blend({ knots: [[0, 1, 2, 1, 4], [0, 1, 2]] }), 'KNOTS_DECREASING', 'knots[0][3]');
    refuses(() => blend({ poses: [{ local: [0, 0] }, { local: [4, 0] }] }), 'OUT_OF_RANGE', 'poses[1].local[0]');
    refuses(() => blend({ bFunction: [erb, { ...erb, alpha: 0 }] }), 'OUT_OF_RANGE', 'bFunction[1].alpha');
    refuses(() => blend({ form: ['closed', 'clamped'] }), 'UNKNOWN_NAME', 'form[1]');
    refuses(() => blend({ degree: [3, 3] }), 'NOT_SUPPORTED', 'degree');
    refuses(() => blend().point(0, 4), 'OUT_OF_RANGE', 'v');
    refuses(() => blend().local(4, 0), 'OUT_OF_RANGE', 'i');
    refuses(() => blend().local(0, 3), 'OUT_OF_RANGE', 'j');
    refuses(() => blend().local('0', 3), 'WRONG_TYPE', 'i');
    refuses(() => blend().withPose([0, 3], {}), 'OUT_OF_RANGE', 'local[1]');
    refuses(() => blend().withPose([0], {}), 'WRONG_LENGTH', 'local');
    refuses(() => blend().withPose(0, {}), 'WRONG_TYPE', 'local');
    refuses(() => blend().withPose([0, 0.5], {}), 'NOT_INTEGER', 'local[1]');
    refuses(() => blend().withPose([0, 0], { scale: 0 }), 'OUT_OF_RANGE', 'scale');
    refuses(() => blend().withPose([0, 0], { local: [0, 0] }), 'UNKNOWN_FIELD', 'local');
    refuses(() => blend().withPose([0, 0]), 'WRONG_TYPE', '');
});
