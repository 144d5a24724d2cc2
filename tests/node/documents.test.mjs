// Documents of every kind: canonical forms, all that is wrong with one, and those that mean harm.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { test } from 'node:test';
import { deflateRawSync } from 'node:zlib';

import fc from 'fast-check';

import { holds, pathsOf, sceneCommand, sceneDocument } from './generators.mjs';
import { placesOf, withValue } from './hostile.mjs';
import { KnotworkError, load, refuses, refusesLater } from './support.mjs';

const kw = await load();
const spline = { id: 'c1', type: 'bspline-curve', degree: 3, points: [[0, 0], [1, 2], [3, 3], [4, 0], [6, 1]] };
const documentOf = (fields) => ({ knotwork: 1, objects: [{ ...spline, ...fields }] });

/** The error of opening a document, or undefined. Anything but a KnotworkError fails. */
function refusalOf(document) {
    try {
        kw.scene(document).dispose();
        return undefined;
    } catch (error) {
        assert.ok(error instanceof KnotworkError, `${error?.stack ?? error} is no KnotworkError`);
        return error;
    }
}

/** What validate() says is what opening says. */
function agree(document) {
    const error = refusalOf(document);
    const problems = kw.validate(document);
    assert.deepEqual(problems, error?.problems ?? []);
    if (!error) return;
    const { code, path, message } = error;
    assert.deepEqual(problems[0], { code, path, message });
    assert.ok(problems.length <= 100);
}

test('a refusal tells all that is wrong, in the order of reading', () => {
    const document = {
        knotwork: 1, title: 3, scenery: 1,
        objects: [
            { ...spline, degree: 2.5, points: [[0, 0], [1, NaN], [2], [3, 3]], style: { width: 99 } },
            { type: 'blending-curve', bFunction: { family: 'mixed', of: [{ family: 'x' }, { family: 'linear' }], weight: 2 }, locals: { count: 3 } },
            { type: 'bspline-curve', degree: 2, points: [[0, 0], [1, 0], [2, 0]], knots: [0, 0, 0, 1, 1, 0] },
        ],
        effects: [{ target: 'nobody', kind: 'rotate' }, { target: 'c1', kind: 'rotate', period: 0 }],
    };
    const error = refuses(() => kw.scene(document), 'UNKNOWN_FIELD', 'scenery');
    assert.deepEqual(error.problems.map(({ path, code }) => `${path} ${code}`), [
        'scenery UNKNOWN_FIELD', 'title WRONG_TYPE',
        'objects[0].degree NOT_INTEGER', 'objects[0].points[1][1] NOT_FINITE', 'objects[0].points[2] WRONG_LENGTH', 'objects[0].style.width OUT_OF_RANGE',
        'objects[1].bFunction.of[0].family UNKNOWN_NAME', 'objects[1].bFunction.weight OUT_OF_RANGE',
        'objects[2].knots[5] KNOTS_DECREASING', 'effects[0].target UNKNOWN_NAME', 'effects[1].period OUT_OF_RANGE',
    ]);
    agree(document);
});

test('every other refusal tells of itself', () => {
    const error = refuses(() => kw.curve({ type: 'bspline-curve' }), 'WRONG_TYPE', 'degree');
    assert.deepEqual(error.problems, [{ code: error.code, path: error.path, message: error.message }]);
});

test('links tell all that is wrong with what they carry', async () => {
    const bad = documentOf({ degree: 99, points: [[0, 'x'], [1]] });
    const error = await refusesLater(kw.encodeLink(bad), 'TOO_LARGE', 'objects[0].degree');
    assert.equal(error.problems.length, 3);
    const carried = await refusesLater(kw.decodeLink(`#v1.j.${encodeURIComponent(JSON.stringify(bad))}`), 'TOO_LARGE', 'objects[0].degree');
    assert.deepEqual(carried.problems, error.problems);
});

test('nothing is wrong with the built-in scenes and their canonical forms', () => {
    for (const { document } of kw.scenes) {
        assert.deepEqual(kw.validate(document), []);
        assert.deepEqual(kw.validate(kw.scene(document).document), []);
    }
});

test('validate() never refuses, whatever it is given', () => {
    const cycle = {};
    cycle.cycle = cycle;
    const throwing = { get knotwork() { throw new RangeError('mine'); } };
    for (const value of [undefined, null, 3, 'x', [], {}, () => 1, Symbol('s'), 1n, cycle, throwing, new Proxy({}, { ownKeys() { throw new Error('mine'); } })]) {
        const problems = kw.validate(value);
        assert.ok(problems.length > 0);
        for (const { code, path, message } of problems) assert.ok([code, path, message].every((text) => typeof text === 'string'));
    }
});

test('canonical documents of every type are their own, to the byte', () => {
    holds(fc.property(sceneDocument, (given) => {
        const error = refusalOf(given);
        if (error) return;
        const scene = kw.scene(given);
        const canonical = JSON.stringify(scene.document);
        const again = kw.scene(JSON.parse(canonical));
        assert.equal(JSON.stringify(again.document), canonical);
        scene.dispose();
        again.dispose();
    }));
});

test('what is undone is as it was, and what is redone as it came to be', () => {
    let done = 0;
    holds(fc.property(sceneDocument, fc.array(sceneCommand, { minLength: 1, maxLength: 8 }), (given, commands) => {
        if (refusalOf(given)) return;
        const scene = kw.scene(given);
        const first = JSON.stringify(scene.document);
        let last = first;
        for (const command of commands) {
            const { revision, canUndo } = scene;
            try {
                scene.execute(command(JSON.parse(last)));
                last = JSON.stringify(scene.document);
                const again = kw.scene(JSON.parse(last));
                assert.equal(JSON.stringify(again.document), last);
                again.dispose();
                done += 1;
            } catch (error) {
                if (!(error instanceof KnotworkError)) throw error;
                assert.deepEqual([scene.revision, scene.canUndo, JSON.stringify(scene.document)], [revision, canUndo, last]);
            }
        }
        while (scene.undo());
        assert.equal(JSON.stringify(scene.document), first);
        while (scene.redo());
        assert.equal(JSON.stringify(scene.document), last);
        scene.dispose();
    }));
    assert.ok(done > 200, `${done} commands were possible`);
});

test('the selection comes back with its step', () => {
    const scene = kw.scene(documentOf({}));
    scene.select(['objects[0].points[1]']);
    scene.execute({ insert: 'objects[0].points[5]', value: [7, 7], selection: ['objects[0].points[5]'] });
    assert.deepEqual(scene.selection, ['objects[0].points[5]']);
    scene.undo();
    assert.deepEqual(scene.selection, ['objects[0].points[1]']);
    scene.redo();
    assert.deepEqual(scene.selection, ['objects[0].points[5]']);
    scene.execute({ remove: 'objects[0].points[5]' });
    assert.deepEqual(scene.selection, []);
    refuses(() => scene.select('objects[0]'), 'WRONG_TYPE', 'selection');
    refuses(() => scene.select(['..']), 'SYNTAX', 'selection[0]');
    refuses(() => scene.execute({ set: 'title', value: '', selection: [3] }), 'WRONG_TYPE', 'selection[0]');
});

// --- documents that mean harm ---------------------------------------------------------------------

const markup = '<img src=x onerror=alert(1)>"\'&amp;\u202e\0';
const nested = (depth) => `${'['.repeat(depth)}${']'.repeat(depth)}`;
const blendsWithin = (depth) => (depth === 0 ? { family: 'linear' } : { family: 'dual', of: blendsWithin(depth - 1) });
const curvesWithin = (depth) => (depth === 0 ? { type: 'parametric-curve', name: 'circle' } : {
    type: 'blending-curve', bFunction: { family: 'linear' }, model: curvesWithin(depth - 1), locals: { count: 3 },
});
const many = (count, one) => Array.from({ length: count }, (_, i) => one(i));

/** Each is refused, or is a scene as good as any. @type {Record<string, () => unknown>} */
const harmful = {
    'a prototype': () => JSON.parse('{"knotwork":1,"__proto__":{"polluted":1},"objects":[]}'),
    'a prototype in an object': () => JSON.parse('{"knotwork":1,"objects":[{"type":"line-curve","from":[0,0],"to":[1,1],"__proto__":{"polluted":1}}]}'),
    'a constructor': () => JSON.parse('{"knotwork":1,"constructor":{"prototype":{"polluted":1}}}'),
    'names of prototypes as types': () => ({ knotwork: 1, objects: [{ type: '__proto__' }, { type: 'constructor' }, { type: 'toString' }] }),
    'prototype parameters': () => JSON.parse('{"knotwork":1,"objects":[{"type":"formula-curve","x":"t","y":"t","domain":[0,1],"parameters":{"__proto__":1,"constructor":2}}]}'),
    'depth in a field': () => documentOf({ points: JSON.parse(nested(31)) }),
    'depth beyond what is read': () => documentOf({ points: JSON.parse(nested(5000)) }),
    'blends within blends': () => documentOf({ type: 'blending-curve', bFunction: blendsWithin(28) }),
    'curves within curves': () => ({ knotwork: 1, objects: [curvesWithin(12)] }),
    'equal ids': () => ({ knotwork: 1, objects: many(1000, () => spline) }),
    'objects without ids': () => ({ knotwork: 1, objects: many(1000, () => ({ type: 'line-curve', from: [0, 0], to: [1, 1] })) }),
    'too many objects': () => ({ knotwork: 1, objects: many(1001, () => 0) }),
    'too many effects': () => ({ knotwork: 1, objects: [spline], effects: many(1001, () => ({ target: 'c1', kind: 'rotate' })) }),
    'effects on nothing': () => ({ knotwork: 1, objects: [spline], effects: many(1000, (i) => ({ target: `c${i + 2}`, kind: 'rotate' })) }),
    'text with markup': () => ({ knotwork: 1, title: markup, description: markup, objects: [{ ...spline, id: markup }] }),
    'markup as keys': () => documentOf({ [markup]: 1 }),
    'huge numbers': () => documentOf({ points: [[1e308, -1e308], [1e308, 1e308], [0, 0], [1, 1]] }),
    'huge degrees': () => documentOf({ degree: 1e308 }),
    'huge levels': () => ({ knotwork: 1, objects: [{ type: 'subdivision-surface', levels: 20, mesh: { solid: 'cube' } }] }),
    'many locals': () => ({ knotwork: 1, objects: [{ type: 'blending-surface', bFunction: { family: 'linear' }, model: { type: 'parametric-surface', name: 'torus' }, locals: [10_000, 10_000] }] }),
    'solids of many faces': () => ({ knotwork: 1, objects: [{ type: 'subdivision-surface', levels: 0, mesh: { solid: 'torus', parameters: { around: 1e9, across: 1e9 } } }] }),
    'infinities': () => documentOf({ knots: [0, 0, 0, 0, Infinity, NaN, 1, 1, 1] }),
    'ten thousand bad points': () => documentOf({ points: many(10_000, () => ['x', null]) }),
    'an endless formula': () => documentOf({ type: 'formula-curve', x: '('.repeat(50_000), y: '-'.repeat(50_000) }),
    'a megabyte of title': () => ({ knotwork: 1, title: 'x'.repeat(2 ** 20), objects: [] }),
    'a lone surrogate': () => ({ knotwork: 1, title: '\ud800', objects: [] }),
    'a fractional version': () => ({ knotwork: 1.5 }),
    'versions of all kinds': () => ({ knotwork: { valueOf: 1 } }),
};

/** Milliseconds of this process's own that have passed: others on the machine do not count. */
const ownTime = () => {
    const { user, system } = process.cpuUsage();
    return (user + system) / 1000;
};

/** Milliseconds of the quickest of three. */
function quickest(act) {
    let least = Infinity;
    for (let i = 0; i < 3; ++i) {
        const start = ownTime();
        act();
        least = Math.min(least, ownTime() - start);
    }
    return least;
}

for (const [name, make] of Object.entries(harmful)) {
    test(`${name}: refused or a scene, in good time`, () => {
        const document = make();
        agree(document);
        const time = quickest(() => refusalOf(document));
        assert.ok(time < 100, `${time} ms`);
        assert.equal({}.polluted, undefined);
        assert.equal(Object.prototype.constructor, Object);
    });
}

test('text is text: markup comes back as it was', () => {
    const { title, objects } = kw.scene(harmful['text with markup']()).document;
    assert.deepEqual([title, objects[0].id], [markup, markup]);
});

test('links that mean harm are refused in good time', async () => {
    const link = (codec, payload) => `#v1.${codec}.${payload}`;
    const bomb = deflateRawSync(Buffer.alloc(64 * 2 ** 20, ' ')).toString('base64url');
    for (const text of [
        link('d', bomb), link('j', nested(100_000)), link('d', deflateRawSync(nested(300_000)).toString('base64url')),
        link('j', encodeURIComponent('{"knotwork":1,"__proto__":{"polluted":1}}')), link('p', 'butterfly~%7B%22__proto__.x%22%3A1%7D'),
    ]) {
        let least = Infinity;
        for (let i = 0; i < 3; ++i) {
            const start = ownTime();
            await assert.rejects(kw.decodeLink(text), KnotworkError);
            least = Math.min(least, ownTime() - start);
        }
        assert.ok(least < 100, `${text.slice(0, 40)}: ${least} ms`);
    }
    assert.equal({}.polluted, undefined);
});

const replacements = fc.constantFrom(
    null, true, -1, 0.5, 1e308, -0, NaN, Infinity, '', 'x', markup, [], {}, [[]], [1, 2], [null], { type: 'line-curve' }, { __proto__: null },
    'constructor', '__proto__', '9'.repeat(400), many(200, (i) => i));

for (const { id, document } of kw.scenes) {
    test(`${id} with anything in any place is refused or a scene`, () => {
        const canonical = kw.scene(document).document;
        const places = placesOf(canonical);
        holds(fc.property(fc.array(fc.tuple(fc.nat(places.length - 1), replacements), { minLength: 1, maxLength: 3 }), (changes) => {
            const damaged = changes.reduce((one, [i, value]) => tryPut(one, places[i].path, value), canonical);
            agree(damaged);
        }), { numRuns: 60 });
    });
}

/** `document` with `value` at the path, if that is still there. */
function tryPut(document, path, value) {
    const steps = path.slice(0, -1);
    let at = document;
    for (const step of steps) {
        if (typeof at !== 'object' || at === null || !Object.hasOwn(at, step)) return document;
        at = at[step];
    }
    return typeof at === 'object' && at !== null ? withValue(document, path, value) : document;
}

// --- links for ever ---------------------------------------------------------------------------------

const corpus = JSON.parse(await readFile(new URL('../links/corpus.json', import.meta.url), 'utf8'));

test('the corpus has links of every codec', () => {
    assert.deepEqual([...new Set(corpus.map(({ link }) => link.split('.')[1]))].sort(), ['d', 'j', 'p']);
});

for (const { link, document } of corpus) {
    test(`${link.slice(0, 50)} opens as the document that it was made of`, async () => {
        const opened = await kw.decodeLink(link);
        // What is written down is a part: fields that came with later versions are not in it.
        for (const path of pathsOf(document)) assert.deepEqual(valueAt(opened, path), valueAt(document, path), path);
        kw.scene(opened).dispose();
    });
}

/** @param {any} document @param {string} path */
function valueAt(document, path) {
    const found = path.split(/[.[\]]+/).filter((step) => step !== '').reduce((at, step) => at?.[step], document);
    return typeof found === 'object' ? undefined : found;
}
