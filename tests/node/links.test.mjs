// Share links: what is encoded comes back, and what is broken is refused.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { deflateRawSync, inflateRawSync } from 'node:zlib';

import { load, randomness, refusesLater } from './support.mjs';

const kw = await load();
const spline = { id: 'c1', type: 'bspline-curve', degree: 3, points: [[0, 0], [1, 2], [3, 3], [4, 0], [6, 1]] };
const small = { knotwork: 1, title: 'Løkke & Bézier – 50 % (x), "y"', objects: [spline] };
const link = (codec, payload) => `#v1.${codec}.${payload}`;
const percent = (document) => encodeURIComponent(JSON.stringify(document));
const deflated = (text) => deflateRawSync(text).toString('base64url');

/** A document with `count` random points: nothing that compresses well. */
function large(count) {
    const random = randomness(61);
    return { knotwork: 1, objects: [{ ...spline, points: random.points(count, 3) }] };
}

test('documents come back as they were', async () => {
    for (const document of [small, large(100), kw.scene(small).document, { knotwork: 1, objects: [] }]) {
        const text = await kw.encodeLink(document);
        assert.match(text, /^#v1\.[pjd]\.[A-Za-z0-9_.~%-]+$/);
        assert.deepEqual(await kw.decodeLink(text), document);
    }
});

test('every built-in scene is a link of its name', async () => {
    for (const { id, document } of kw.scenes) {
        assert.equal(await kw.encodeLink(document), `#v1.p.${id}`);
        assert.deepEqual(await kw.decodeLink(`#v1.p.${id}`), document);
    }
});

test('a built-in scene with a few changes is a short link', async () => {
    for (const { id, document } of kw.scenes) {
        const scene = kw.scene(document);
        scene.execute({ set: 'objects[0].style.width', value: 5.5 });
        scene.execute({ set: 'objects[0].style.colour', value: '#123456' });
        const text = await kw.encodeLink(scene.document);
        assert.match(text, new RegExp(`^#v1\\.p\\.${id}~`));
        assert.ok(text.length < 300);
        assert.deepEqual(await kw.decodeLink(text), scene.document);
    }
});

test('a built-in scene with another shape is a link of its own', async () => {
    const scene = kw.scene(kw.scenes[0].document);
    scene.execute({ add: { ...spline, id: 'more' } });
    const text = await kw.encodeLink(scene.document);
    assert.deepEqual(await kw.decodeLink(text), scene.document);
});

test('a larger document is compressed', async () => {
    const document = { knotwork: 1, objects: Array.from({ length: 40 }, (_, i) => ({ ...spline, id: `c${i}` })) };
    const text = await kw.encodeLink(document);
    assert.match(text, /^#v1\.d\./);
    assert.ok(text.length < percent(document).length / 10);
    const payload = Buffer.from(text.slice(6), 'base64url');
    assert.deepEqual(JSON.parse(inflateRawSync(payload).toString('utf8')), document);
});

test('links of every codec open, with and without what stands before them', async () => {
    for (const payload of [link('j', percent(small)), link('d', deflated(JSON.stringify(small)))]) {
        for (const before of ['', 'https://example.org/page.html?x=1']) {
            assert.deepEqual(await kw.decodeLink(before + payload), small);
        }
        assert.deepEqual(await kw.decodeLink(payload.slice(1)), small);
    }
});

test('what is encoded is checked first', async () => {
    await refusesLater(kw.encodeLink({ knotwork: 1, objects: [{ ...spline, degree: 9 }] }), 'WRONG_LENGTH', 'objects[0].points');
    await refusesLater(kw.encodeLink({ knotwork: 1, objects: [{ ...spline, points: [[0, NaN]] }] }), 'NOT_FINITE', 'objects[0].points[0][1]');
    await refusesLater(kw.encodeLink(null), 'WRONG_TYPE', '');
    await refusesLater(kw.encodeLink(), 'WRONG_TYPE', '');
});

test('a link of a future version is VERSION, and so is a document of one', async () => {
    for (const text of ['#v2.j.x', '#v10.q.', '#v2.something.else', '#v3.p.butterfly']) await refusesLater(kw.decodeLink(text), 'VERSION');
    await refusesLater(kw.decodeLink(link('j', percent({ ...small, knotwork: 2 }))), 'VERSION', 'knotwork');
});

test('what is no link is SYNTAX', async () => {
    for (const text of ['', '#', 'v', '#v1', '#v1.', '#v1.j', '#vx.j.x', 'hello', '#v-1.j.x', '#v1.5.j.x'.replace('5.', '')]) {
        if (text === '#v1.j.x') continue;
        await refusesLater(kw.decodeLink(text), 'SYNTAX');
    }
});

test('payloads that are damaged are SYNTAX', async () => {
    const whole = deflated(JSON.stringify(large(200)));
    for (const text of [
        link('j', ''), link('j', '%'), link('j', '%E0%A4%A'), link('j', '{'), link('j', '%7B%22knotwork%22%3A1'),
        link('d', ''), link('d', '!!!'), link('d', 'A'), link('d', 'AAAA'), link('d', `${whole.slice(0, 400)}`),
        link('d', `${whole.slice(0, 100)}AAAA${whole.slice(104)}`), link('d', deflated('not json')),
        link('d', deflated(Buffer.from([0x22, 0xff, 0xfe, 0x22]))),
        link('p', 'butterfly~'), link('p', 'butterfly~%'), link('p', 'butterfly~%5B%5D'), link('p', 'butterfly~%7B%22nothing.there%22%3A1%7D'),
    ]) {
        await refusesLater(kw.decodeLink(text), 'SYNTAX');
    }
});

test('names that are not known are UNKNOWN_NAME', async () => {
    await refusesLater(kw.decodeLink('#v1.p.moth'), 'UNKNOWN_NAME');
    await refusesLater(kw.decodeLink('#v1.p.__proto__'), 'UNKNOWN_NAME');
    for (const codec of ['q', 'J', '__proto__', 'constructor', 'toString']) {
        await refusesLater(kw.decodeLink(link(codec, 'x')), 'UNKNOWN_NAME');
    }
});

test('a payload that inflates without end is refused in good time and space', async () => {
    const bomb = deflateRawSync(Buffer.alloc(300 * 2 ** 20, ' ')).toString('base64url');
    const before = process.memoryUsage().arrayBuffers;
    await refusesLater(kw.decodeLink(link('d', bomb)), 'TOO_LARGE');
    assert.ok(process.memoryUsage().arrayBuffers - before < 64 * 2 ** 20);
    await refusesLater(kw.decodeLink(link('j', 'x'.repeat(4 * 2 ** 20))), 'TOO_LARGE');
});

test('where the platform has no streams for it, as in Node 18, links are the same', async () => {
    const { CompressionStream, DecompressionStream } = globalThis;
    const document = { knotwork: 1, objects: Array.from({ length: 40 }, (_, i) => ({ ...spline, id: `c${i}` })) };
    const usual = await kw.encodeLink(document);
    const lacking = class { constructor() { throw new TypeError('deflate-raw'); } };
    try {
        Object.assign(globalThis, { CompressionStream: lacking, DecompressionStream: lacking });
        const text = await kw.encodeLink(document);
        assert.match(text, /^#v1\.d\./);
        assert.deepEqual(await kw.decodeLink(usual), document);
        assert.deepEqual(await kw.decodeLink(text), document);
        await refusesLater(kw.decodeLink(link('d', 'AAAA')), 'SYNTAX');
        const bomb = deflateRawSync(Buffer.alloc(2 ** 21, ' ')).toString('base64url');
        await refusesLater(kw.decodeLink(link('d', bomb)), 'TOO_LARGE');
    } finally {
        Object.assign(globalThis, { CompressionStream, DecompressionStream });
    }
});

test('documents of strangers are checked like any other', async () => {
    await refusesLater(kw.decodeLink(link('j', percent([]))), 'WRONG_TYPE', '');
    await refusesLater(kw.decodeLink(link('j', percent({ ...small, objects: [{ ...spline, degree: '3' }] }))), 'WRONG_TYPE', 'objects[0].degree');
    await refusesLater(kw.decodeLink(link('j', '['.repeat(100_000))), 'SYNTAX');
    await refusesLater(kw.decodeLink(link('j', '['.repeat(10_000) + ']'.repeat(10_000))), 'TOO_LARGE');
    for (const value of [5, null, undefined, {}, ['#v1.p.butterfly'], new String('#v1.p.butterfly')]) {
        await refusesLater(kw.decodeLink(value), 'WRONG_TYPE', '');
    }
});

test('no link reaches a prototype', async () => {
    const poison = '{"knotwork":1,"__proto__":{"polluted":1},"objects":[]}';
    await refusesLater(kw.decodeLink(link('j', encodeURIComponent(poison))), 'UNKNOWN_FIELD', '__proto__');
    for (const path of ['__proto__.polluted', 'constructor.prototype.polluted', 'objects.__proto__.polluted', 'objects[0].__proto__.polluted']) {
        await refusesLater(kw.decodeLink(link('p', `butterfly~${encodeURIComponent(JSON.stringify({ [path]: 1 }))}`)), 'SYNTAX');
    }
    assert.equal({}.polluted, undefined);
    assert.equal([].polluted, undefined);
});

test('links leave nothing behind in the module', async () => {
    const before = kw.session.held();
    await kw.decodeLink(await kw.encodeLink(small));
    await kw.decodeLink('#v1.p.butterfly');
    await refusesLater(kw.decodeLink(link('j', percent({ knotwork: 1, objects: 5 }))), 'WRONG_TYPE', 'objects');
    assert.equal(kw.session.held(), before);
});
