// Bad input by the table and at volume: every method and every place of every specification refuses
// what is not of its kind, and 100 000 refusals leave nothing behind.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import {
    bFunctions, curves, kindOf, meshes, methods, placesOf, refusalOf, scenes, fitRequests, surfaces, traces, withoutArguments,
    withValue, wrong,
    wrongCalls,
} from './hostile.mjs';
import { allocatorSlack, load } from './support.mjs';

const kw = await load();
const takers = [
    ...bFunctions.map((spec) => ({ name: `bFunction ${spec.family}`, take: kw.bFunction, spec })),
    ...curves.map((spec, i) => ({ name: `curve ${i}, ${spec.type}`, take: kw.curve, spec })),
    ...surfaces.map((spec, i) => ({ name: `surface ${i}, ${spec.type}`, take: kw.surface, spec })),
    ...scenes.map((spec) => ({ name: 'scene', take: kw.scene, spec })),
    ...meshes.map((spec) => ({ name: `mesh of ${Object.keys(spec)[0]}`, take: kw.mesh, spec })),
    ...fitRequests.map((spec) => ({ name: 'fit', take: kw.fit, spec })),
    ...traces.map((spec) => ({ name: `trace ${spec.algorithm}`, take: kw.trace, spec })),
];

/** The methods of a value, its prototypes' included. */
function methodsOf(value) {
    const names = new Set();
    for (let at = Object.getPrototypeOf(value); at !== Object.prototype; at = Object.getPrototypeOf(at)) {
        for (const [name, { value: method }] of Object.entries(Object.getOwnPropertyDescriptors(at))) {
            if (typeof method === 'function' && name !== 'constructor') names.add(name);
        }
    }
    return [...names];
}

/** @param {string} type */
const ofType = (type) => kw.curve(curves.find((spec) => spec.type === type));

const samples = {
    BFunction: kw.bFunction(bFunctions[3]),
    BsplineCurve: ofType('bspline-curve'),
    ParametricCurve: ofType('parametric-curve'),
    BezierCurve: ofType('bezier-curve'),
    LineCurve: ofType('line-curve'),
    ArcCurve: ofType('arc-curve'),
    BlendingCurve: ofType('blending-curve'),
    SubdivisionCurve: ofType('subdivision-curve'),
    FormulaCurve: ofType('formula-curve'),
    Mesh: kw.mesh(meshes[1]),
    BsplineSurface: kw.surface(surfaces[0]),
    ParametricSurface: kw.surface(surfaces[2]),
    BlendingSurface: kw.surface(surfaces[4]),
    Scene: kw.scene(scenes[0]),
};

for (const [kind, value] of Object.entries(samples)) {
    test(`every method of ${kind} refuses arguments of other kinds`, () => {
        let calls = 0;
        for (const name of methodsOf(value).filter((one) => !withoutArguments.includes(one))) {
            const kinds = methods[kind]?.[name] ?? methods.Curve[name];
            assert.ok(kinds, `the table in hostile.mjs has no row for ${kind}.${name}`);
            for (const { what, act } of wrongCalls(value, name, kinds)) {
                assert.ok(refusalOf(act), `${kind}.${what} was taken`);
                calls += 1;
            }
        }
        assert.ok(calls > 50);
    });
}

for (const { name, take, spec } of takers) {
    test(`every place of ${name} refuses values of other kinds`, () => {
        const made = take(spec);
        const canonical = made.spec ?? made.document ?? spec;
        assert.deepEqual(take(canonical).spec, made.spec);
        let refused = 0;
        for (const { path, value } of placesOf(canonical)) {
            for (const [k, amiss] of wrong[kindOf(value)].entries()) {
                if (fits(path, amiss)) continue;
                const error = refusalOf(() => take(withValue(canonical, path, amiss)));
                assert.ok(error, `wrong value ${k} for ${kindOf(value)} was taken at ${path.join('.')}`);
                refused += 1;
            }
        }
        assert.ok(refused > 20);
    });
}

/** What is undefined counts as left out, and a scale is three numbers or one. */
function fits(path, amiss) {
    return amiss === undefined || (path.at(-1) === 'scale' && Number.isFinite(amiss) && amiss !== 0);
}

test('lists of numbers that lie about themselves are the numbers that they hold', () => {
    class Liar extends Float64Array {
        static get [Symbol.species]() { throw new RangeError('mine'); }
        subarray() { throw new RangeError('mine'); }
        get length() { return 1e9; }
        set() { throw new RangeError('mine'); }
    }
    const ts = new Liar([0, 0.5, 1]);
    assert.deepEqual(samples.BsplineCurve.sampleAt(ts), samples.BsplineCurve.sampleAt([0, 0.5, 1]));
    assert.deepEqual(samples.BsplineCurve.basisAt(ts), samples.BsplineCurve.basisAt([0, 0.5, 1]));
    assert.deepEqual(Float64Array.from([...Array(9).keys()], (i) => samples.BsplineCurve.sample(3, { into: new Liar(9) })[i]),
        samples.BsplineCurve.sample(3));
});

/** Everything above that is refused, as one list of calls. */
const refused = [
    ...Object.entries(samples).flatMap(([kind, value]) => methodsOf(value)
        .filter((name) => !withoutArguments.includes(name))
        .flatMap((name) => wrongCalls(value, name, methods[kind]?.[name] ?? methods.Curve[name]).map(({ act }) => act))),
    ...takers.flatMap(({ take, spec }) => placesOf(spec).flatMap(({ path, value }) => wrong[kindOf(value)]
        .filter((one) => !fits(path, one))
        .map((amiss) => () => take(withValue(spec, path, amiss))))),
];

/** What was made lives in the module itself, or holds a curve that does, or is plain data. */
function disposeOf(made) {
    if (made.dispose) made.dispose();
    else made.curve?.dispose();
}

/** Runs `act` for i = 0 … times − 1, and expects handles and memory as they were. */
function leavesNothing(times, act) {
    for (let i = 0; i < 2 * refused.length; ++i) act(i);
    const inUse = () => {
        refusalOf(() => kw.bFunction({ family: 'no' })); // the reason of the last refusal is kept
        return [kw.session.held(), kw.session.memoryInUse()];
    };
    const before = inUse();
    for (let i = 0; i < times; ++i) act(i);
    const [held, bytes] = inUse();
    assert.equal(held, before[0]);
    assert.ok(Math.abs(bytes - before[1]) <= allocatorSlack, `${bytes} bytes in use, ${before[1]} before`);
}

test('100 000 refused calls leave handles and memory as they were', () => {
    assert.ok(refused.length > 3000);
    leavesNothing(100_000, (i) => assert.ok(refusalOf(refused[i % refused.length])));
});

test('100 000 curves and B-functions made and disposed of leave handles and memory as they were', () => {
    const cheap = takers.filter(({ name }) => !name.includes('scene') && !name.includes('expo-rational'));
    leavesNothing(100_000, (i) => {
        const { take, spec } = cheap[i % cheap.length];
        disposeOf(take(spec));
    });
});

test('the module works on after all that', () => {
    for (const { take, spec } of takers) {
        const made = take(spec);
        if (made.normal) assert.ok(made.grid(5, 4).normals.every(Number.isFinite));
        if (made.sample) assert.ok(made.sample(9).every(Number.isFinite));
        disposeOf(made);
    }
});
