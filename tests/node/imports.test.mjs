// Documents from tables, OBJ, SVG and JSON.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import fc from 'fast-check';

import { KnotworkError, load, near, randomness, refuses } from './support.mjs';

const kw = await load();
const { points: randomPoints } = randomness(11);

/** @param {string} text */
const curveOf = (text, options = {}) => kw.importDocument(text, { format: 'csv', as: 'curve', ...options });
const pointsOf = (text) => curveOf(text).objects[0].points;

const square = [[0, 0], [1, 0], [1, 1.5], [-2e-3, 1]];

test('a table is read with commas, semicolons, tabs or blanks', () => {
    for (const separator of [',', ', ', ';', '\t', ' ', '   ', ' ; ']) {
        for (const end of ['\n', '\r\n', '\r']) {
            const text = square.map((point) => point.join(separator)).join(end);
            assert.deepEqual(pointsOf(text), square, JSON.stringify(text));
            assert.deepEqual(pointsOf(`${text}${end}${end}`), square);
            assert.deepEqual(pointsOf(`\uFEFF# made by hand, 2026${end}${end}  ${text}`), square);
            assert.deepEqual(pointsOf(`x${separator}y${end}${text}`), square);
        }
    }
});

test('a refused document tells all that is wrong with it', () => {
    const document = { knotwork: 1, objects: [{ type: 'line-curve', from: [0, 0], to: [1, 'x'] }, { type: 'arc' }] };
    assert.throws(() => kw.importDocument(JSON.stringify(document)), (error) => {
        assert.ok(error instanceof KnotworkError);
        assert.deepEqual(error.problems, kw.validate(document));
        return error.problems.length === 2;
    });
});

test('a decimal comma is understood where a comma parts nothing', () => {
    for (const separator of [';', '\t', ' ']) {
        const text = square.map((point) => point.map((c) => String(c).replace('.', ',')).join(separator)).join('\n');
        assert.deepEqual(pointsOf(text), square, JSON.stringify(text));
    }
    assert.deepEqual(pointsOf('1,5 2,5\n3 4\n'), [[1.5, 2.5], [3, 4]]);
    assert.deepEqual(pointsOf('1,5,2.5\n3,4,1\n'), [[1, 5, 2.5], [3, 4, 1]]);
});

test('a first line names the columns, in any order', () => {
    assert.deepEqual(pointsOf('t,y,x\n0,1,2\n1,3,4\n'), [[2, 1], [4, 3]]);
    assert.deepEqual(pointsOf('"X";"Y";"Z"\n"1";2;3\n4;5;6'), [[1, 2, 3], [4, 5, 6]]);
    assert.deepEqual(pointsOf('longitude,latitude\n5,60\n6,61'), [[5, 60], [6, 61]]);
    assert.deepEqual(pointsOf('t,u,easting,northing\n0,0,5,60\n0,1,6,61'), [[5, 60], [6, 61]]);
});

test('a column of names makes several objects', () => {
    const { objects } = curveOf('object,x,y\na,0,0\n"b ""1"", c",5,5\na,1,1\n"b ""1"", c",6,6\n');
    assert.deepEqual(objects.map(({ id, points }) => [id, points]), [['a', [[0, 0], [1, 1]]], ['b "1", c', [[5, 5], [6, 6]]]]);
});

test('what is exported as CSV is imported again', () => {
    const curves = ['clamped', 'open', 'closed'].map((form, i) => ({ id: `curve ${i}, "${form}"`, type: 'bspline-curve', degree: 2, form, points: randomPoints(6, 3) }));
    const scene = kw.scene({ knotwork: 1, objects: curves });
    const { objects } = curveOf(scene.exportAs('csv', { tolerance: 1e-2 }));
    assert.deepEqual(objects.map(({ id }) => id), curves.map(({ id }) => id));
    for (const [i, { points }] of objects.entries()) {
        const exact = kw.curve({ ...curves[i], id: undefined }).polyline({ tolerance: 1e-2 }).points;
        assert.deepEqual(points.flat(), Array.from(exact));
    }
});

test('a refused table says the line and the column', () => {
    const refusal = (text, code, place) => {
        const { message } = refuses(() => curveOf(text), code, 'text');
        assert.ok(message.startsWith(place), `${message} does not begin with ${place}`);
    };
    refusal('0,0\n1,x\n', 'SYNTAX', 'Line 2, column 3: "x" is no number');
    refusal('0,0\r\n\r\n# one\r\n1 , 2f\r\n', 'SYNTAX', 'Line 4, column 5: "2f"');
    refusal('x;y\n1;2\n1,5;3.5.5\n', 'SYNTAX', 'Line 3, column 5: "3.5.5"');
    refusal('0,0\n1\n', 'WRONG_LENGTH', 'Line 2, column 1: a coordinate is missing');
    refusal('0,0\n1,\n', 'WRONG_LENGTH', 'Line 2, column 3: a coordinate is missing');
    refusal('0,0\n1e13,0\n', 'OUT_OF_RANGE', 'Line 2, column 1: "1e13"');
    refusal('1,2,3,4\n', 'WRONG_LENGTH', 'Line 1, column 1: the line has 4 cells');
    refusal('1\n2\n', 'WRONG_LENGTH', 'Line 1, column 1: the line has 1 cells');
    refusal('x,b\n1,2\n', 'SYNTAX', 'Line 1, column 1: columns with the names x and y');
    refusal('a,b,c,d\n1,2,3,4\n', 'SYNTAX', 'Line 1, column 1: the columns need the names');
    refusal('x,y\n"1,2\n3,4\n', 'SYNTAX', 'Line 2, column 1: this quote is never closed');
    refusal('x,y\n"1"2,2\n', 'SYNTAX', 'Line 2, column 4: after a closing quote');
    refusal('0,0\nNaN,1\n', 'SYNTAX', 'Line 2, column 1: "NaN"');
    refusal('0,0\n0x10,1\n', 'SYNTAX', 'Line 2, column 1: "0x10"');
    refusal('object,x,y\na,1,2\n"b\r\nc" ,3,z\n', 'SYNTAX', 'Line 4, column 7: "z"');
    refusal(`${'1,'.repeat(1001)}\n`, 'TOO_LARGE', 'Line 1, column 2001: a line has at most 1000');
    refusal('', 'WRONG_LENGTH', 'In this table there is no point');
    refusal('# nothing\n', 'WRONG_LENGTH', 'In this table');
});

test('the paths of a picture are its curves again', () => {
    const curves = [
        { id: 'c1', type: 'bspline-curve', degree: 3, points: randomPoints(7, 2) },
        { id: 'c2', type: 'bspline-curve', degree: 3, form: 'closed', points: randomPoints(6, 2) },
        { id: 'c3', type: 'bspline-curve', degree: 1, points: randomPoints(5, 2) },
    ].map((curve) => ({ ...curve, show: { polygon: false, points: false, knots: false } }));
    const svg = kw.scene({ knotwork: 1, objects: curves }).svg({ width: 1000, height: 1000 });
    const [a, , , d, e, f] = /data-matrix="([^"]*)"/.exec(svg)[1].split(' ').map(Number);
    const { objects } = kw.importDocument(svg);
    assert.equal(objects.length, 3);
    for (const [i, object] of objects.entries()) {
        const { show, id, ...spec } = curves[i];
        const original = kw.curve(spec);
        const { id: _, style, show: shown, ...read } = object;
        const imported = kw.curve(read);
        const [start, end] = original.domain;
        for (const s of [0, 0.13, 0.5, 0.77, 1]) {
            const [x, y] = original.point(start + s * (end - start));
            const [px, py] = imported.point(s * imported.domain[1]);
            near([px, -py], [a * x + e, d * y + f], 1e-3);
        }
        void [show, id, _, style, shown];
    }
});

test('all the commands of a path are read', () => {
    const read = (data) => kw.importDocument(data, { format: 'svg' }).objects;
    const same = (one, other) => assert.deepEqual(read(one).map(({ points, knots }) => [points, knots]), read(other).map(({ points, knots }) => [points, knots]));
    assert.deepEqual(read('M0 0L1 2H5V7')[0].points, [[0, 0], [1, -2], [5, -2], [5, -7]]);
    same('M1,1l1 2h4v5', 'M1 1L2 3H6V8');
    same('m1 1 1 2 3-4', 'M1 1L2 3L5-1');
    same('M0 0c1 1 2 1 3 0s2-1 3 0', 'M0 0C1 1 2 1 3 0S5-1 6 0');
    same('M0 0C1 1 2 1 3 0S5-1 6 0', 'M0 0C1 1 2 1 3 0C4-1 5-1 6 0');
    same('M0 0q1 1 2 0t2 0', 'M0 0Q1 1 2 0Q3-1 4 0');
    same('M0 0L1 0S1 1 2 2', 'M0 0L1 0C1 0 1 1 2 2');
    same('M0 0 1 0 1 1z', 'M0 0L1 0L1 1L0 0');
    same('M0 0 1 0 1 1zL5 5', 'M0 0L1 0L1 1L0 0M0 0L5 5');
    same('M.5.5.25.75-1e-1+2', 'M0.5 0.5L0.25 0.75L-0.1 2');
    same('M0 0a1 1 0 01.5.5', 'M 0 0 A 1 1 0 0 1 0.5 0.5');
    const [{ points, knots, degree }] = read('M0 0Q3 3 6 0L7 0');
    assert.equal(degree, 3);
    near(points, [[0, 0], [2, -2], [4, -2], [6, 0], [6 + 1 / 3, 0], [6 + 2 / 3, 0], [7, 0]], 1e-14);
    assert.deepEqual(knots, [0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2]);
    assert.equal(read('M0 0M1 1L2 2M5 5').length, 1);
    const two = kw.importDocument('<?xml version="1.0"?>\n<svg><path fill="red" d="M0 0L1 1"/><g><path\nd=\'M5 5 6 6\'/></g></svg>');
    assert.equal(two.objects.length, 2);
});

test('arcs lie on their ellipses', () => {
    for (const [data, centre, rx, ry, turn] of [
        ['M1 0A1 1 0 0 1 0 1', [0, 0], 1, 1, 0],
        ['M1 0A1 1 0 0 0 0 1', [1, 1], 1, 1, 0],
        ['M1 0A1 1 0 1 0 0 1', [0, 0], 1, 1, 0],
        ['M1 0A1 1 0 1 1 0 1', [1, 1], 1, 1, 0],
        ['M-3 0A3 2 0 0 1 3 0', [0, 0], 3, 2, 0],
        ['M-3 0A.3-.2 0 0 0 3 0', [0, 0], 3, 2, 0],
        ['M0-3A3 2 90 0 1 0 3', [0, 0], 3, 2, Math.PI / 2],
    ]) {
        const { id: _, style, show, ...spec } = kw.importDocument(data).objects[0];
        void [_, style, show];
        const curve = kw.curve(spec);
        for (let i = 0; i <= 40; ++i) {
            const [px, py] = curve.point(curve.domain[1] * i / 40);
            const [x, y] = [px - centre[0], -py - centre[1]];
            const [u, v] = [(Math.cos(turn) * x + Math.sin(turn) * y) / rx, (Math.cos(turn) * y - Math.sin(turn) * x) / ry];
            near(Math.hypot(u, v), 1, 6e-6, `${data} at ${i}`);
        }
    }
    // Which way round: through the lower half of the page, which is y > 0 there.
    const half = (flag) => kw.curve({ ...kw.importDocument(`M0 0A1 1 0 0 ${flag} 2 0`).objects[0], id: undefined, style: undefined, show: undefined });
    assert.ok(half(0).point(half(0).domain[1] / 2)[1] < -0.99);
    assert.ok(half(1).point(half(1).domain[1] / 2)[1] > 0.99);
});

test('a refused path says the line and the column', () => {
    const refusal = (text, code, place) => {
        const { message } = refuses(() => kw.importDocument(text, { format: 'svg' }), code, 'text');
        assert.ok(message.startsWith(place), `${message} does not begin with ${place}`);
    };
    refusal('L1 1', 'SYNTAX', 'Line 1, column 1: a path begins with M');
    refusal('M0 0L1 1 B', 'SYNTAX', 'Line 1, column 10: "B" is no command');
    refusal('M0 0\nL1', 'SYNTAX', 'Line 2, column 3: here a number is missing');
    refusal('M0 0A1 1 0 2 0 1 1', 'SYNTAX', 'Line 1, column 12: here stands a flag');
    refusal('<svg>\n <path d="M0 0X"/></svg>', 'SYNTAX', 'Line 2, column 15: "X"');
    refusal('M0 0L1e13 0', 'OUT_OF_RANGE', 'Line 1');
    refusal('<svg></svg>', 'WRONG_LENGTH', 'There is no path');
    refusal('M0 0', 'WRONG_LENGTH', 'There is no path');
});

test('a document is read as it is', () => {
    for (const { document } of kw.scenes) {
        const scene = kw.scene(document);
        assert.deepEqual(kw.importDocument(scene.exportAs('json')), scene.document);
        assert.equal(kw.importDocument(JSON.stringify(document), { title: 'Mine' }).title, 'Mine');
    }
    refuses(() => kw.importDocument('{"knotwork": 1,}'), 'SYNTAX', 'text');
    refuses(() => kw.importDocument('{"knotwork": 2}'), 'VERSION');
    refuses(() => kw.importDocument('{"knotwork": 1, "objects": [{"type": "bspline-curve"}]}'), 'WRONG_TYPE');
});

test('OBJ becomes a subdivision surface, a table a cloud of points', () => {
    const cube = kw.mesh({ solid: 'cube' });
    const [quads] = kw.importDocument(cube.toObj()).objects;
    assert.equal(quads.type, 'subdivision-surface');
    assert.deepEqual([quads.scheme, quads.levels], ['catmull-clark', 0]);
    assert.deepEqual(kw.mesh(quads.mesh).faces, cube.faces);
    const [triangles] = kw.importDocument(kw.mesh({ solid: 'icosahedron' }).toObj(), { format: 'obj' }).objects;
    assert.equal(triangles.scheme, 'loop');
    const scene = kw.scene({ knotwork: 1, objects: [{ id: 'ball', type: 'subdivision-surface', levels: 1, mesh: { solid: 'cube' } }] });
    assert.equal(kw.mesh(kw.importDocument(scene.exportAs('obj')).objects[0].mesh).counts.faces, 24);
    const [cloud] = kw.importDocument('x,y,z\n1,2,3\n4,5,6').objects;
    assert.equal(cloud.type, 'point-cloud');
    assert.deepEqual(cloud.points, [[1, 2, 3], [4, 5, 6]]);
    refuses(() => kw.importDocument('v 0 0 0\nf 1 2 3\n'), 'OUT_OF_RANGE', 'obj');
    refuses(() => kw.importDocument('v 0 0 x\n', { format: 'obj' }), 'SYNTAX', 'obj');
});

test('what a text is, is guessed', () => {
    assert.equal(kw.importDocument(' \n{"knotwork": 1, "title": "a"}').title, 'a');
    assert.equal(kw.importDocument('M0 0L1 1').objects[0].type, 'bspline-curve');
    assert.equal(kw.importDocument('<svg><path d="M0 0L1 1"/></svg>').objects[0].degree, 1);
    assert.equal(kw.importDocument('0,0\n1,1\n', { as: 'curve' }).objects[0].degree, 1);
});

test('refusals of the options', () => {
    refuses(() => kw.importDocument(5), 'WRONG_TYPE', 'text');
    refuses(() => kw.importDocument('0,0', { format: 'pdf' }), 'UNKNOWN_NAME', 'format');
    refuses(() => kw.importDocument('0,0', { as: 'mesh' }), 'UNKNOWN_NAME', 'as');
    refuses(() => kw.importDocument('0,0', { title: 5 }), 'WRONG_TYPE', 'title');
    refuses(() => kw.importDocument('0,0', { kind: 'csv' }), 'UNKNOWN_FIELD', 'kind');
});

/**
 * Whatever is imported, there is a document or a KnotworkError, and soon: in milliseconds of our own.
 * Those hold what the engine compiles and collects meanwhile, so the best of some counts.
 */
function survives(text, options, limit) {
    let took = Infinity;
    for (let time = 0; time < 4 && took >= limit; time += 1) took = Math.min(took, importing(text, options));
    assert.ok(took < limit, `${took} ms for ${String(text).slice(0, 60)}`);
}

function importing(text, options) {
    const before = process.cpuUsage();
    try {
        kw.importDocument(text, options);
    } catch (error) {
        assert.ok(error instanceof KnotworkError, `${error?.stack ?? error}`);
    }
    return process.cpuUsage(before).user / 1000;
}

test('hostile texts are refused at once', () => {
    const many = (text, count) => text.repeat(count);
    const formats = ['json', 'csv', 'obj', 'svg', undefined];
    const texts = [
        many('[', 1e6), many('{"a":', 1e5), '{"__proto__": {"polluted": 1}, "knotwork": 1}', many('"', 1e6), many(' ', 1e6), many('\n', 1e6),
        many('#\n', 5e5), many('"a\n', 1e5), many('1,', 5e5), many(',', 1e6), many('1 ', 5e5), many('1e', 5e5), many('<path ', 2e5),
        many('<path d', 2e5), many('<path d="', 1e5), `<path ${many(' d', 3e5)}`, `M${many('0', 1e6)}`, `M0 0${many('L', 1e6)}`, many('M0 0', 2e5),
        `M0 0A${many('1', 1e6)}`, many('z', 1e6), many('f 1 2 3\n', 1e5), many('v 0 0 0\n', 1e5), 'x'.repeat(1e6), many('\0', 1e5), many('\ud800', 1e5),
        `"${many('""', 3e5)}`, many('x;', 4e5), many('1\t', 4e5), 'x,y\n' + many('1,2\n', 2e5), 'M0 0' + many('L1 1', 2e5), many('0,0\n', 1e6),
    ];
    for (const text of texts) {
        for (const format of formats) survives(text, { format }, 250);
    }
    assert.equal({}.polluted, undefined);
    refuses(() => kw.importDocument(many('0,0\n', 2 ** 20 + 1)), 'TOO_LARGE', 'text');
    refuses(() => kw.importDocument(`x,y\n${many('1,2\n', 1e5 + 2)}`), 'TOO_LARGE', 'text');
    refuses(() => kw.importDocument(`M0 0${many('C1 1 2 2 3 3', 4e4)}`), 'TOO_LARGE', 'text');
});

test('random texts give a document or a refusal', () => {
    const pieces = ['0', '1.5', '-2', '1e9', ',', ';', '\t', ' ', '\n', '"', '#', 'x', 'y', 'M', 'L', 'C', 'a', 'z', 'v ', 'f ', '<path d="', '{', '[', '"knotwork":1', '}', ']'];
    fc.assert(fc.property(fc.array(fc.oneof(fc.constantFrom(...pieces), fc.string({ maxLength: 3 })), { maxLength: 40 }),
        fc.constantFrom('json', 'csv', 'obj', 'svg', undefined), fc.constantFrom('points', 'curve'), (parts, format, as) => {
            survives(parts.join(''), { format, as }, 1000);
        }), { numRuns: 1500 });
});
