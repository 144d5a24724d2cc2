// Part 1 of the interface: whatever is thrown is a KnotworkError, nothing is coerced, and what was
// refused leaves everything as it was.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import vm from 'node:vm';

import { KnotworkError, load, near, randomness, refuses, refusesLater } from './support.mjs';

const kw = await load();
const circle = { type: 'parametric-curve', name: 'circle' };
const line = { type: 'bspline-curve', degree: 1, points: [[0, 0], [1, 1]] };
const nothing = () => {};

/** Everything that takes plain data. */
const takers = { curve: kw.curve, bFunction: kw.bFunction, scene: kw.scene };

test('a KnotworkError is an Error with code, path and message', () => {
    const error = refuses(() => kw.curve({ ...line, degree: 'one' }), 'WRONG_TYPE', 'degree');
    assert.ok(error instanceof Error);
    assert.equal(error.name, 'KnotworkError');
    assert.match(String(error), /^KnotworkError: .*one/);
    assert.deepEqual(Object.keys(error).sort(), ['code', 'path']);
});

test('what is no plain object is refused as a whole', () => {
    for (const [name, take] of Object.entries(takers)) {
        for (const value of [undefined, null, 5, 'text', true, 5n, Symbol('s'), nothing, [], new Date(), new Map(), /x/]) {
            const error = refuses(() => take(value), 'WRONG_TYPE', '');
            assert.ok(error, `${name} of ${String(value)}`);
        }
    }
});

test('data of another realm and without prototype is plain', () => {
    const foreign = vm.runInNewContext('({ type: "parametric-curve", name: "circle", parameters: { radius: 2 } })');
    assert.deepEqual(kw.curve(foreign).point(0), [2, 0, 0]);
    const bare = Object.assign(Object.create(null), circle);
    assert.deepEqual(kw.curve(bare).point(0), [1, 0, 0]);
});

test('values that are no data are refused with their place', () => {
    class Point extends Array {}
    const wrong = [
        [{ ...line, points: [[0, 0], nothing] }, 'points[1]'],
        [{ ...line, points: [[0, 5n], [1, 1]] }, 'points[0][1]'],
        [{ ...line, points: new Set() }, 'points'],
        [{ ...line, points: [[0, 0], new Number(5)] }, 'points[1]'],
        [{ ...line, degree: Symbol('x') }, 'degree'],
        [{ ...line, points: [[0, undefined], [1, 1]] }, 'points[0][1]'],
        [{ ...line, points: { 0: [0, 0], length: 1 } }, 'points'],
        [{ ...line, form: new String('open') }, 'form'],
        [{ ...line, knots: new Int32Array(4) }, 'knots'],
        [{ ...line, knots: new DataView(new ArrayBuffer(32)) }, 'knots'],
    ];
    for (const [spec, path] of wrong) refuses(() => kw.curve(spec), 'WRONG_TYPE', path);
    near(kw.curve({ ...line, points: Point.from([[0, 0], [1, 1]]) }).point(1), [1, 1, 0], 0);
});

test('a field that is undefined counts as left out', () => {
    assert.deepEqual(kw.curve({ ...line, knots: undefined, form: undefined }).spec, kw.curve(line).spec);
});

test('getters that throw are refusals, and every getter runs once', () => {
    const thrown = [new TypeError('mine'), 'text', null, undefined, { toString() { throw new Error('twice'); } }];
    for (const one of thrown) {
        refuses(() => kw.curve({ ...line, get degree() { throw one; } }), 'WRONG_TYPE', 'degree');
        refuses(() => kw.curve(line).sample(3, { get into() { throw one; } }), 'WRONG_TYPE');
    }
    let runs = 0;
    const counted = { type: 'bspline-curve', degree: 1, get points() { runs += 1; return line.points; } };
    assert.deepEqual(kw.curve(counted).point(1), [1, 1, 0]);
    assert.equal(runs, 1);
});

test('proxies that throw or lie cannot break out', () => {
    const traps = ['get', 'ownKeys', 'getOwnPropertyDescriptor', 'getPrototypeOf', 'has'];
    for (const trap of traps) {
        const hostile = new Proxy({ ...line }, { [trap]() { throw new RangeError('trap'); } });
        try {
            kw.curve(hostile);
        } catch (error) {
            assert.ok(error instanceof KnotworkError, `${trap}: ${error}`);
        }
        try {
            kw.curve({ ...line, points: new Proxy([[0, 0], [1, 1]], { [trap]() { throw new RangeError('trap'); } }) });
        } catch (error) {
            assert.ok(error instanceof KnotworkError, `${trap}: ${error}`);
        }
    }
    const { proxy, revoke } = Proxy.revocable({}, {});
    revoke();
    for (const take of Object.values(takers)) refuses(() => take(proxy), 'WRONG_TYPE', '');
    refuses(() => kw.curve(line).sampleAt(proxy), 'WRONG_TYPE', 'ts');
    refuses(() => kw.curve(line).sample(2, proxy), 'WRONG_TYPE', '');
    refuses(() => kw.curve({ ...line, points: proxy }), 'WRONG_TYPE', 'points');
});

test('a getter may use the module while its object is read', () => {
    const nested = { type: 'bspline-curve', degree: 1, get points() { return [[0, 0], kw.curve(circle).point(0)]; } };
    assert.deepEqual(kw.curve(nested).point(1), [1, 0, 0]);
});

test('long lists of numbers cross exactly, wherever they stand', () => {
    const random = randomness(5);
    const points = Float64Array.from({ length: 3 * 2000 }, () => random.between(-1, 1));
    const knots = Float64Array.from({ length: 2004 }, (_, i) => Math.min(Math.max(i - 3, 0), 1997));
    for (const spec of [{ type: 'bspline-curve', degree: 3, points, knots }, { knots, points, degree: 3, type: 'bspline-curve' }]) {
        const curve = kw.curve(spec);
        assert.deepEqual(curve.controlPoints(), points);
        assert.deepEqual(Float64Array.from(curve.knots), knots);
        curve.dispose();
    }
});

test('an array whose memory a getter gives away is refused', () => {
    const points = new Float64Array(3 * 2000);
    const given = {
        type: 'bspline-curve', points,
        get degree() {
            structuredClone(points.buffer, { transfer: [points.buffer] });
            return 3;
        },
    };
    refuses(() => kw.curve(given), 'WRONG_TYPE', '');
    kw.curve(circle).dispose();
});

test('cycles and depths are refused', () => {
    const cycle = { type: 'blending-curve', bFunction: { family: 'linear' } };
    cycle.model = cycle;
    refuses(() => kw.curve(cycle), 'TOO_LARGE');
    const list = [];
    list.push(list);
    refuses(() => kw.curve({ ...line, points: list }), 'TOO_LARGE');
    let deep = { family: 'linear' };
    for (let i = 0; i < 31; ++i) deep = { family: 'dual', of: deep };
    assert.equal(kw.bFunction(deep).value(0.25), 0.25);
    refuses(() => kw.bFunction({ family: 'dual', of: deep }), 'TOO_LARGE');
    for (let i = 0; i < 100_000; ++i) deep = { of: deep };
    refuses(() => kw.bFunction(deep), 'TOO_LARGE');
});

test('objects that repeat themselves without end are refused in good time', () => {
    let bomb = [0];
    for (let i = 0; i < 30; ++i) bomb = Array(10).fill(bomb);
    const before = performance.now();
    refuses(() => kw.curve({ ...line, points: bomb }), 'TOO_LARGE');
    assert.ok(performance.now() - before < 2000);
    const endless = new Proxy([], { get: (_, key) => (key === 'length' ? 2 ** 32 - 1 : [0, 0]) });
    refuses(() => kw.curve({ ...line, points: endless }), 'TOO_LARGE');
    refuses(() => kw.curve({ ...line, points: new Array(4e9) }), 'TOO_LARGE', 'points');
});

test('more points than a curve may have are refused', () => {
    refuses(() => kw.curve({ ...line, points: new Float64Array(3 * 100_001) }), 'TOO_LARGE', 'points');
    assert.equal(kw.curve({ ...line, points: new Float64Array(3 * 100_000) }).greville.length, 100_000);
});

test('names of prototypes are fields like any other', () => {
    for (const name of ['__proto__', 'constructor', 'toString', 'hasOwnProperty', 'prototype']) {
        refuses(() => kw.curve(JSON.parse(`{ "type": "bspline-curve", "degree": 1, "points": [[0,0],[1,1]], "${name}": {} }`)), 'UNKNOWN_FIELD', name);
        refuses(() => kw.curve({ type: name }), 'UNKNOWN_NAME', 'type');
        refuses(() => kw.bFunction({ family: name }), 'UNKNOWN_NAME', 'family');
        refuses(() => kw.curve({ ...circle, parameters: JSON.parse(`{ "${name}": 1 }`) }), 'UNKNOWN_FIELD', `parameters.${name}`);
    }
    assert.equal({}.polluted, undefined);
});

test('texts of every alphabet cross, and broken ones do not', () => {
    const title = 'Bézier, Løkken, Δόξα, 曲線, 🦋\u0000\n"\\';
    assert.equal(kw.scene({ knotwork: 1, title, objects: [] }).document.title, title);
    refuses(() => kw.scene({ knotwork: 1, title: 'half \ud83e', objects: [] }), 'WRONG_TYPE', 'title');
    refuses(() => kw.bFunction({ family: 'línea' }), 'UNKNOWN_NAME', 'family');
});

test('options are checked like everything else', () => {
    const curve = kw.curve(circle);
    refuses(() => curve.sample(3, null), 'WRONG_TYPE', '');
    refuses(() => curve.sample(3, []), 'WRONG_TYPE', '');
    refuses(() => curve.sample(3, new Float64Array(9)), 'WRONG_TYPE', '');
    refuses(() => curve.sample(3, { Into: new Float64Array(9) }), 'UNKNOWN_FIELD', 'Into');
    refuses(() => curve.derivatives(0, 1, { side: 'above' }), 'UNKNOWN_NAME', 'side');
    refuses(() => curve.derivatives(0, 1, { side: 1 }), 'WRONG_TYPE', 'side');
    refuses(() => curve.derivatives(0, 1, { side: null }), 'WRONG_TYPE', 'side');
    refuses(() => curve.derivatives(0, 1, { slide: 'left' }), 'UNKNOWN_FIELD', 'slide');
    assert.deepEqual(curve.derivatives(0, 1, { side: undefined }), curve.derivatives(0, 1));
});

test('numbers are numbers', () => {
    const curve = kw.curve(circle);
    for (const t of ['0.5', null, undefined, true, [0.5], { valueOf: () => 0.5 }, 1n, new Number(1)]) {
        refuses(() => curve.point(t), 'WRONG_TYPE', 't');
        refuses(() => curve.derivatives(t, 1), 'WRONG_TYPE', 't');
        refuses(() => curve.derivatives(0, t), 'WRONG_TYPE', 'n');
    }
    for (const t of [NaN, Infinity, -Infinity]) refuses(() => curve.point(t), 'NOT_FINITE', 't');
    refuses(() => curve.derivatives(0, 2 ** 32 + 1), 'OUT_OF_RANGE', 'n');
});

test('values that were disposed of answer DISPOSED and nothing else', () => {
    const uses = {
        curve: [kw.curve(line), ['knots', 'greville', 'domain', 'closed', 'dimension', 'spec'],
            (c) => [() => c.point(0), () => c.sample(3), () => c.sampleAt([0]), () => c.polyline(), () => c.derivatives(0, 1), () => c.insertKnot(0.5), () => c.basis(0)]],
        blending: [kw.curve({ type: 'blending-curve', bFunction: { family: 'linear' }, model: circle, locals: { count: 3 } }),
            ['knots', 'spec'], (c) => [() => c.blendBasis(0), () => c.withPose(0, {})]],
        bFunction: [kw.bFunction({ family: 'linear' }), ['order', 'symmetric', 'smooth', 'warning', 'spec'],
            (b) => [() => b.value(0), () => b.derivatives(0, 1), () => b.sample(3)]],
        scene: [kw.scene({ knotwork: 1, objects: [] }), ['document', 'schema', 'canUndo', 'canRedo', 'revision', 'handle'],
            (s) => [() => s.drawing(), () => s.execute({}), () => s.undo(), () => s.redo()]],
    };
    for (const [value, fields, calls] of Object.values(uses)) {
        for (const field of fields) assert.notEqual(value[field], undefined, field);
        value.dispose();
        for (const field of fields) refuses(() => value[field], 'DISPOSED');
        for (const call of calls(value)) refuses(call, 'DISPOSED');
        value.dispose();
        value[Symbol.dispose ?? Symbol.for('Symbol.dispose')]();
    }
});

test('methods that lost their value refuse', () => {
    const { point, sample, dispose } = kw.curve(line);
    for (const call of [() => point(0), () => sample(3), () => dispose(), () => point.call({}, 0), () => point.call(null, 0)]) {
        refuses(call, 'WRONG_TYPE', 'this');
    }
    const { constructor } = kw.curve(line);
    refuses(() => new constructor(), 'WRONG_TYPE');
    refuses(() => kw.curve(kw.curve(line)), 'WRONG_TYPE', '');
});

test('what was refused leaves the module as it was', async () => {
    const before = kw.session.held();
    const curve = kw.curve(line);
    const random = randomness(41);
    const samples = curve.sample(20);
    const junk = [NaN, -1, 1e300, 'x', null, undefined, [], {}, true, 2 ** 53, 5n, [[1]], { family: 'linear' }];
    const pick = () => junk[random.integer(0, junk.length - 1)];
    const fields = ['type', 'degree', 'form', 'points', 'knots', 'weights', 'name', 'parameters', 'domain', 'bFunction', 'model', 'locals', 'poses', 'x'];
    let refused = 0;
    for (let i = 0; i < 3000; ++i) {
        const spec = random.unit() < 0.5 ? { ...line } : { type: 'blending-curve', bFunction: { family: 'linear' }, model: circle, locals: { count: 3 } };
        for (let k = random.integer(1, 3); k > 0; --k) spec[fields[random.integer(0, fields.length - 1)]] = pick();
        try {
            kw.curve(spec).dispose();
        } catch (error) {
            assert.ok(error instanceof KnotworkError, `${error?.stack}`);
            refused += 1;
        }
    }
    assert.ok(refused > 2000);
    assert.deepEqual(curve.sample(20), samples);
    curve.dispose();
    assert.equal(kw.session.held(), before);
    await refusesLater(kw.decodeLink(5), 'WRONG_TYPE', '');
});
