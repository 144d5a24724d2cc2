// Hostile texts for the readers of other programs' files: refused by a KnotworkError, and soon.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import fc from 'fast-check';

import { holds } from './generators.mjs';
import { KnotworkError, load } from './support.mjs';

const kw = await load();

/** Milliseconds that the process itself may work on a text. */
const soon = 100;

/** Reads a text as whatever is asked for; answers the refusal, if it is one. */
function read(text, options) {
    try {
        return { document: kw.importDocument(text, options) };
    } catch (refusal) {
        assert.ok(refusal instanceof KnotworkError, `${JSON.stringify(text.slice(0, 200))}: ${refusal.stack}`);
        assert.ok(refusal.message.length > 10 && refusal.message.length < 1000, refusal.message);
        return { refusal };
    }
}

/** Text of pieces that mean something to a reader, cut off anywhere. */
const textOf = (pieces) => fc.tuple(fc.array(fc.oneof({ weight: 6, arbitrary: fc.constantFrom(...pieces) },
    { weight: 1, arbitrary: fc.string({ maxLength: 4 }) }), { maxLength: 60 }), fc.nat(3)).map(([list, cut]) => {
    const text = list.join('');
    return text.slice(0, text.length - cut);
});

const grammars = {
    csv: ['1', '2.5', '-3e2', '1e400', '1,5', ',', ';', '\t', ' ', '\n', '\r\n', '\r', '"', '""', '"a b"', 'x', 'y', 'z,', 't', 'object', '#', '\uFEFF', 'NaN', '\0'],
    svg: ['M0 0', 'm1,1', 'L1 1', 'l-1-1', 'H5', 'v.5', 'C1 1 2 2 3 3', 's1 1 2 0', 'Q1 1 2 0', 't1 1', 'A1 2 30 0 1 3 3', 'a0 0 0 111 1', 'Z', 'z', '1e9', '1e400', '-', '.', ',', ' ',
        '<svg>', '<path d="', '"/>', '<path\nd=\'', '\'', '<!--', '&amp;', 'd=', '</svg>'],
    obj: ['v 0 0 0\n', 'v 1 0 0\n', 'v 0 1 0\n', 'v 0 0 1e400\n', 'v 1\n', 'f 1 2 3\n', 'f 1/1/1 2//2 3\n', 'f -1 -2 -3\n', 'f 1 1 1\n', 'f 9 9 9\n', 'f', ' ', '\\\n', '\n', '# x\n', 'vn 0 0 1\n', 'o a\n', '1', '-'],
    json: ['{', '}', '[', ']', '"knotwork":1', '"objects":', '"type":', '"bspline-curve"', ',', ':', 'null', '1e400', '"\\u0000"', '"__proto__":', '{"x":1}'],
};

for (const [format, pieces] of Object.entries(grammars)) {
    test(`any text of ${format} gives a canonical document or a KnotworkError, whatever it is read as`, () => {
        holds(fc.property(textOf(pieces), fc.constantFrom({ format }, {}, { format, as: 'curve' }), (text, options) => {
            const { document } = read(text, options);
            if (document === undefined) return;
            const scene = kw.scene(document);
            assert.deepEqual(scene.document, document);
            scene.dispose();
        }), { numRuns: 400 });
    });
}

const most = 2 ** 22;
const fill = (piece, length = most - 100) => piece.repeat(Math.floor(length / piece.length));
const triangle = 'v 0 0 0\nv 1 0 0\nv 0 1 0\n';

/** As long as a text may be, and nothing that could be a picture. */
const endless = {
    csv: [fill('1'), fill(','), fill(';'), fill(' '), fill('"'), fill('\n'), fill('#\n'), fill('"a" '), fill('1 ,'), `"${fill('\n')}`, fill('1,2,3,'), `1${fill('e')}`,
        `object,x,y\n${Array.from({ length: 1e5 }, (_, i) => `${i},1,2`).join('\n')}`],
    svg: [fill('<path d="M0 0L1 1"/>'), fill('M0 0L1 1'), fill('M0 0'), `M0 0${fill('z')}`, `<${fill('<path d')}`, `<path d${fill(' ')}`, `<path${fill(' d')}`, `<path d="${fill('1 ')}`, `<path d="M0 0L${fill('1')}`],
    obj: [fill('\n'), fill('g a\n'), `${triangle}${fill('f 1 2 3\n')}`, `${triangle}f ${fill('1 ')}`, `${triangle}f ${fill('1//')}`, `v 0 0 ${fill('\\\n')}`],
    json: [fill('['), fill('{"a":'), fill(' '), fill('1')],
};

for (const [format, texts] of Object.entries(endless)) {
    test(`endless texts of ${format} are refused soon`, () => {
        for (const text of texts) {
            let least = Infinity;
            for (let attempt = 0; attempt < 3 && least > soon; ++attempt) {
                const before = process.cpuUsage();
                assert.ok(read(text, { format }).refusal, `${JSON.stringify(text.slice(0, 40))} was read`);
                const { user, system } = process.cpuUsage(before);
                least = Math.min(least, (user + system) / 1000);
            }
            assert.ok(least <= soon, `${least} ms for ${JSON.stringify(text.slice(0, 40))}`);
        }
    });
}

test('what a table has too much of is said at its place', () => {
    const refused = (text, place) => assert.ok(read(text, { format: 'csv' }).refusal.message.startsWith(place));
    refused(`object,x,y\n${Array.from({ length: 1001 }, (_, i) => `${i},1,2`).join('\n')}`, 'Line 1002, column 1: there are more than 1000 names');
    refused(`x,y\n"${'""'.repeat(1001)}",1`, 'Line 2, column 1: a cell has at most 1000 letters');
    refused('\n'.repeat(200_000), 'Line 200000, column 1: a table has at most 200000 lines');
    refused('x,y\n', 'Line 1, column 1: there is no point under these names');
});
