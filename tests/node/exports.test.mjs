// Scenes as files for other programs, each read back by a reader of that format.
import assert from 'node:assert/strict';
import { mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';

import { validateBytes } from 'gltf-validator';

import { distribution, load, near, randomness, refuses } from './support.mjs';
import { around, elementsOf, mapped, pointOn, stepsOf, unmapped } from './svg-reader.mjs';

const kw = await load();
const sceneOf = (...objects) => kw.scene({ knotwork: 1, title: 'Exported', objects });
const { points: randomPoints } = randomness(20260);

const show = { polygon: false, points: false, knots: false };
/** @param {object} curve */
const alone = (curve) => sceneOf({ id: 'c1', ...curve, show });
const numbersIn = (text) => text.split(' ').map(Number);

/** The path of the curve in a picture, and how the world lies in it. */
function curveIn(svg) {
    const elements = elementsOf(svg);
    const found = elements.filter(({ name, parent }) => name === 'path' && parent.attributes['data-role'] === 'curve');
    assert.equal(found.length, 1);
    return { steps: stepsOf(found[0].attributes.d), matrix: numbersIn(around(found[0], 'data-matrix')) };
}

const forms = ['clamped', 'open', 'closed'];
const polynomial = [
    ...forms.flatMap((form) => [1, 2, 3].map((degree) => (
        { type: 'bspline-curve', degree, form, points: randomPoints(7, 2) }))),
    { type: 'bspline-curve', degree: 3, points: randomPoints(6, 2), knots: [0, 0, 0, 0, 1, 1.001, 7, 7, 7, 7] },
    { type: 'bspline-curve', degree: 2, points: randomPoints(6, 2).map(([x, y]) => [1e5 * x, 1e5 * y]), form: 'closed' },
    { type: 'bspline-curve', degree: 3, points: randomPoints(5, 2).map(([x, y]) => [1e-4 * x + 3, 1e-4 * y]) },
    { type: 'bezier-curve', points: randomPoints(4, 2), domain: [-2, 5] },
    { type: 'bezier-curve', points: randomPoints(3, 2) },
    { type: 'line-curve', from: [1, 2], to: [3, -4] },
];

test('a curve of degree 3 or less is read back from its picture, to 1e-6 of it', () => {
    for (const spec of polynomial) {
        for (const [width, height] of [[800, 600], [120, 90], [1000, 1600], [4000, 300]]) {
            const { steps, matrix } = curveIn(alone(spec).svg({ width, height }));
            const curve = kw.curve(spec);
            const [start, end] = curve.domain;
            const stops = [...new Set([start, ...(curve.knots ?? []).filter((t) => start < t && t < end), end])];
            const spans = steps.filter(({ command }) => command === 'C' || command === 'L');
            assert.equal(spans.length, stops.length - 1, JSON.stringify(spec));
            let from = steps[0].points[0];
            for (const [k, step] of spans.entries()) {
                for (const s of [0, 0.25, 0.5, 0.8, 1]) {
                    const exact = mapped(matrix, curve.point(stops[k] + s * (stops[k + 1] - stops[k])));
                    near(pointOn(from, step, s), exact, 1e-6 * Math.min(width, height), `${width}×${height} ${JSON.stringify(spec)}`);
                }
                from = step.points.at(-1);
            }
        }
    }
});

test('any other curve is within a tenth of a pixel', () => {
    for (const spec of [
        { type: 'parametric-curve', name: 'butterfly' },
        { type: 'parametric-curve', name: 'rose' },
        { type: 'bspline-curve', degree: 2, points: [[1, 0], [1, 1], [0, 1]], weights: [1, Math.SQRT1_2, 1] },
        { type: 'bspline-curve', degree: 5, points: randomPoints(9, 2) },
        { type: 'blending-curve', bFunction: { family: 'expo-rational' }, model: { type: 'parametric-curve', name: 'circle' }, locals: { count: 5, kind: 'line' } },
    ]) {
        const { steps, matrix } = curveIn(alone(spec).svg());
        const curve = kw.curve(spec);
        let from = steps[0].points[0];
        for (const step of steps.slice(1)) {
            for (const s of [0.2, 0.5, 0.9, 1]) {
                const at = unmapped(matrix, pointOn(from, step, s));
                const { distance } = curve.closestPoint(at);
                assert.ok(distance * matrix[0] <= 0.1, `${spec.type} ${distance * matrix[0]} pixels`);
            }
            from = step.points.at(-1);
        }
        assert.ok(steps.length < 600, `${steps.length} steps`);
    }
});

test('an effect that is affine leaves curves exact', () => {
    const spec = { type: 'bspline-curve', degree: 3, points: randomPoints(6, 2) };
    const scene = kw.scene({ knotwork: 1, objects: [{ id: 'c1', ...spec, show }],
        effects: [{ target: 'c1', kind: 'rotate', axis: [0, 0, 1], angle: 1 }, { target: 'c1', kind: 'translate', by: [2, 1, 0] }] });
    const { steps, matrix } = curveIn(scene.svg({ phase: 0.5 }));
    assert.deepEqual(new Set(steps.map(({ command }) => command)), new Set(['M', 'C']));
    const shape = scene.drawing({ phase: 0.5 }).shapes.find(({ role }) => role === 'curve');
    near(unmapped(matrix, steps.at(-1).points[2]), Array.from(shape.positions.slice(-3, -1)), 1e-5);
    assert.notEqual(scene.svg({ phase: 0.5 }), scene.svg());
    assert.equal(scene.svg({ phase: 1 }), scene.svg());
});

test('everything drawn lies in the picture, which keeps the aspect', () => {
    for (const { document } of kw.scenes) {
        const svg = kw.scene(document).svg({ width: 640, height: 400 });
        const elements = elementsOf(svg);
        const { attributes } = elements[0];
        assert.equal(attributes.viewBox, '0 0 640 400');
        for (const element of elements) {
            if (element.name !== 'path') continue;
            let from = [0, 0];
            for (const step of stepsOf(element.attributes.d)) {
                // Control points of a piece may lie outside, the piece itself may not.
                for (const s of step.command === 'M' ? [1] : [0.25, 0.5, 0.75, 1]) {
                    const [x, y] = pointOn(from, step, s);
                    assert.ok(x >= 0 && x <= 640 && y >= 0 && y <= 400, `${x} ${y}`);
                }
                from = step.points.at(-1);
            }
        }
        const [a, , , d] = numbersIn(elements.find(({ attributes: own }) => 'data-matrix' in own).attributes['data-matrix']);
        assert.ok(document.view?.mode === '3d' || a === -d);
    }
});

test('a picture is named and described, and only has what every policy allows', () => {
    const elements = elementsOf(kw.scene(kw.scenes[0].document).svg());
    assert.equal(elements[0].name, 'svg');
    assert.equal(elements[0].attributes.role, 'img');
    assert.deepEqual(elements.slice(1, 3).map(({ name }) => name), ['title', 'desc']);
    assert.equal(elements[1].text, kw.scenes[0].document.title);
    const allowed = ['svg', 'title', 'desc', 'g', 'path', 'circle', 'rect', 'text'];
    for (const { name, uri, attributes } of elements) {
        assert.ok(allowed.includes(name), name);
        assert.equal(uri, 'http://www.w3.org/2000/svg');
        for (const key of Object.keys(attributes)) assert.doesNotMatch(key, /^(style|on|href|xlink)/);
    }
});

test('markup in a title, a description or a name stays text', () => {
    for (const text of ['</title><script>alert(1)</script>', '"><svg onload="x">', ']]>&lt;&#0;', 'a\0b\x1f\u{1F600}\uFFFE', '\ud800']) {
        const scene = kw.scene({ knotwork: 1, title: text.replace('\ud800', '?'), objects: [{ id: text.replace('\ud800', '?'), type: 'parametric-curve', name: 'circle' }] });
        for (const svg of [scene.svg(), scene.svg({ title: 'x', description: text.replace('\ud800', '?') })]) {
            const elements = elementsOf(svg);
            assert.ok(elements.every(({ name }) => name !== 'script'));
            assert.equal(elements.filter(({ name }) => name === 'svg').length, 1);
        }
    }
    const title = '<a> & "b" \'c\'';
    assert.equal(elementsOf(kw.scene({ knotwork: 1, title }).svg())[1].text, title);
});

test('a picture of a size, of a theme, of a ground of its own', () => {
    const scene = alone(polynomial[0]);
    const ground = (options) => elementsOf(scene.svg(options)).find(({ name }) => name === 'rect')?.attributes.fill;
    assert.equal(ground(), '#ffffff');
    assert.equal(ground({ theme: 'dark' }), '#12151b');
    assert.equal(ground({ theme: 'contrast' }), '#ffffff');
    assert.equal(ground({ background: '#abcdef' }), '#abcdef');
    assert.equal(ground({ background: 'none' }), undefined);
    assert.equal(elementsOf(scene.svg({ title: 'Mine' }))[1].text, 'Mine');
    assert.equal(elementsOf(scene.svg({ width: 10.5, height: 20 }))[0].attributes.viewBox, '0 0 10.5 20');
    assert.equal(scene.svg(), scene.exportAs('svg'));
});

test('the plots stand below the curve, each with its ticks', () => {
    const { document } = kw.scenes.find(({ id }) => id === 'b-functions');
    const scene = kw.scene(document);
    const panes = ['curve', 'basis', 'knots', 'bFunction'];
    const elements = elementsOf(scene.svg({ panes, width: 900, height: 700 }));
    const shown = elements.filter(({ attributes }) => attributes['data-pane']).map(({ attributes }) => attributes['data-pane']);
    assert.deepEqual(shown, ['curve', 'basis', 'knots', 'bFunction', 'bFunction', 'bFunction']);
    const areas = elements.filter(({ attributes }) => attributes.class === 'knotwork-plot').map(({ attributes }) => attributes);
    for (const { x, y, width, height } of areas) {
        assert.ok(Number(x) >= 0 && Number(x) + Number(width) <= 900 && Number(y) > 350 && Number(y) + Number(height) <= 700);
    }
    // Every function lies in the area of its plot, and the basis functions sum to 1 at the top of it.
    for (const element of elements.filter(({ name, parent }) => name === 'path' && parent.attributes['data-role'] === 'basis')) {
        const { x, y, width, height } = areas[0];
        for (const { points: [[px, py]] } of stepsOf(element.attributes.d)) {
            assert.ok(px >= Number(x) - 1e-3 && px <= Number(x) + Number(width) + 1e-3);
            assert.ok(py >= Number(y) - 1e-3 && py <= Number(y) + Number(height) + 1e-3);
        }
    }
    const ticks = elements.filter(({ name }) => name === 'text').map(({ text }) => text);
    assert.ok(['B', 'B\u2032', 'B\u2033'].every((name) => ticks.includes(name)));
    for (const { attributes } of elements.filter(({ name }) => name === 'text')) {
        assert.ok(Number(attributes.y) < 699 && Number(attributes.x) > 5, attributes.y);
    }
    assert.ok(ticks.includes('0') && ticks.includes('1') && ticks.length > 8);
    assert.deepEqual(elementsOf(scene.svg({ panes: ['knots'] })).flatMap(({ attributes }) => attributes['data-pane'] ?? []), ['knots']);
    assert.equal(scene.svg({ panes: ['curve'] }), scene.svg());
    const alonePanes = elementsOf(alone({ type: 'parametric-curve', name: 'circle' }).svg({ panes }));
    assert.deepEqual(alonePanes.flatMap(({ attributes }) => attributes['data-pane'] ?? []), ['curve']);
});

test('the hodograph stands beside the curve, x and y to one scale', () => {
    const spec = { type: 'bspline-curve', degree: 2, points: [[0, 0], [1, 3], [4, 1], [5, 5]] };
    const scene = sceneOf({ id: 'c1', ...spec, show: { hodograph: true } });
    const elements = elementsOf(scene.svg({ panes: ['hodograph', 'curve'], width: 900, height: 500 }));
    const panes = elements.filter(({ attributes }) => attributes['data-pane']);
    assert.deepEqual(panes.map(({ attributes }) => attributes['data-pane']), ['curve', 'hodograph']);
    const [line, arrow] = elements.filter(({ name, parent }) => name === 'path' && parent.attributes['data-role'] === 'hodograph');
    const corners = (d) => stepsOf(d).flatMap(({ points }) => points);
    const extent = (list, i) => Math.max(...list.map((p) => p[i])) - Math.min(...list.map((p) => p[i]));
    const curve = kw.curve(spec);
    const derivatives = [0, 1, 2].map((t) => curve.derivatives(t, 1)[1]);
    const drawn = corners(line.attributes.d);
    const scale = extent(drawn, 0) / extent(derivatives, 0);
    near(extent(drawn, 1) / extent(derivatives, 1), scale, 1e-2);
    near(corners(arrow.attributes.d).map(([x, y], _, [from]) => [(x - from[0]) / scale, (from[1] - y) / scale]).at(-1), curve.derivatives(1, 1)[1].slice(0, 2), 1e-2);
    const { x, width } = elements.find(({ attributes }) => attributes.class === 'knotwork-plot').attributes;
    assert.ok(Number(x) > 500 && Number(x) + Number(width) <= 900);
    assert.deepEqual(elementsOf(alone(spec).svg({ panes: ['curve', 'hodograph'] })).flatMap(({ attributes }) => attributes['data-pane'] ?? []), ['curve']);
    assert.deepEqual(kw.scene({ knotwork: 1, view: { panes: ['curve', 'hodograph'] } }).document.view.panes, ['curve', 'hodograph']);
});

const textsOf = (svg) => elementsOf(svg).filter(({ name }) => name === 'text').map(({ text }) => text);

test('the curvature stands over the knots, with one axis and where it has no bound a mark', () => {
    const spec = { type: 'bspline-curve', degree: 3, points: [[0, 0], [1, 3], [4, 1], [5, 5], [7, 2]] };
    const panesOf = (scene, panes) => elementsOf(scene.svg({ panes })).flatMap(({ attributes }) => attributes['data-pane'] ?? []);
    const scene = sceneOf({ id: 'c1', ...spec, show: { curvature: true } });
    assert.deepEqual(panesOf(scene, ['knots', 'curvature', 'basis', 'curve']), ['curve', 'curvature', 'basis', 'knots']);
    const plots = elementsOf(scene.svg({ panes: ['curve', 'curvature', 'knots'] })).filter(({ attributes }) => attributes.class === 'knotwork-plot');
    assert.equal(plots[0].attributes.x, plots[1].attributes.x);
    assert.equal(plots[0].attributes.width, plots[1].attributes.width);
    assert.ok(Number(plots[0].attributes.y) + Number(plots[0].attributes.height) <= Number(plots[1].attributes.y));
    assert.deepEqual(panesOf(alone(spec), ['curve', 'curvature']), ['curve']);
    const cusps = sceneOf({ id: 'c1', type: 'parametric-curve', name: 'astroid', show: { curvature: true } });
    assert.equal(textsOf(cusps.svg({ panes: ['curvature'] })).filter((text) => text === '\u2212\u221e').length, 5);
});

test('two B-functions stand in one plot with a legend', () => {
    const curve = (id, family, dashed) => ({
        id, type: 'blending-curve', bFunction: { family }, form: 'closed', locals: { count: 4 },
        model: { type: 'parametric-curve', name: 'circle' }, style: { colour: dashed ? '#d55e00' : '#0072b2', dashed },
    });
    const svg = sceneOf(curve('one', 'polynomial', false), curve('two', 'linear', true)).svg({ panes: ['curve', 'bFunction'] });
    const lines = elementsOf(svg).filter(({ name, parent }) => name === 'path' && parent.attributes['data-role'] === 'bFunction');
    assert.equal(lines.length, 6);
    assert.equal(lines.filter(({ attributes }) => attributes['stroke-dasharray']).length, 3);
    assert.ok(textsOf(svg).includes('one') && textsOf(svg).includes('two'));
});

test('a picture has no more digits than can be seen', () => {
    const svg = kw.scene(kw.scenes.find(({ id }) => id === 'butterfly').document).svg();
    const paths = svg.replaceAll(/data-matrix="[^"]*"/g, '');
    assert.doesNotMatch(paths, /\d\.\d{5}|\d[eE][-+]?\d|-0[ ,"]|\d\.\d*0[ ,"LCZM]/);
    assert.ok(svg.length < 60_000, `${svg.length} letters`);
});

test('a document exported as JSON is the document', () => {
    for (const { document } of kw.scenes) {
        const scene = kw.scene(document);
        const text = scene.exportAs('json');
        assert.equal(JSON.stringify(JSON.parse(text)), JSON.stringify(scene.document));
        assert.ok(text.split('\n').every((line) => line.length <= 400));
        assert.equal(text.at(-1), '\n');
    }
});

test('the calls in JavaScript make the same objects', async () => {
    const objects = [
        { id: 'c1', ...polynomial[0] }, { id: 'let', ...polynomial[2] }, { id: 'object2', ...polynomial[3] },
        { id: "it's; \"quoted\" */ \\", type: 'formula-curve', x: 'a*t', y: 'sin(t)', parameters: { a: 2 }, domain: [0, 1] },
        { id: 'blend', type: 'blending-curve', bFunction: { family: 'linear' }, model: { type: 'parametric-curve', name: 'circle' }, locals: { count: 3 } },
    ];
    const code = sceneOf(...objects).exportAs('js');
    assert.match(code, /^import \{ load \} from 'knotwork';\n\nconst kw = await load\(\);\n\nconst c1 = kw\.curve\(\{ ?\n?/);
    const folder = await mkdtemp(path.join(tmpdir(), 'knotwork-export-'));
    try {
        const file = path.join(folder, 'made.mjs');
        const names = Array.from(code.matchAll(/^const (\S+) = kw\.curve/gm), ([, name]) => name);
        assert.deepEqual(names, ['c1', 'object2', 'object2_', 'object4', 'blend']);
        const module = new URL('knotwork.mjs', distribution).href;
        await writeFile(file, `${code.replace("'knotwork'", JSON.stringify(module))}\nexport const made = [${names}];\n`);
        const { made } = await import(pathToFileURL(file).href);
        for (const [i, curve] of made.entries()) {
            const { id: _, ...spec } = objects[i];
            assert.deepEqual(curve.spec, kw.curve(spec).spec);
        }
    } finally {
        await rm(folder, { recursive: true });
    }
});

/** @param {string} text */
const rowsOf = (text) => text.trimEnd().split('\n').map((line) => line.split(','));

test('CSV has a row for every point, exactly', () => {
    const curve = kw.curve(polynomial[2]);
    const [header, ...rows] = rowsOf(alone(polynomial[2]).exportAs('csv', { tolerance: 1e-3 }));
    assert.deepEqual(header, ['object', 't', 'x', 'y', 'z']);
    const { points, parameters } = curve.polyline({ tolerance: 1e-3 });
    assert.deepEqual(rows.map(([, t]) => Number(t)), Array.from(parameters));
    assert.deepEqual(rows.flatMap((row) => row.slice(2).map(Number)), Array.from(points));
    assert.ok(rows.every(([object]) => object === 'c1'));
    const named = sceneOf({ id: 'a,"b"', ...polynomial[0] }).exportAs('csv');
    assert.match(named, /\n"a,""b""",/);
});

test('OBJ has an object each, with its lines', () => {
    const text = sceneOf({ id: 'first one', ...polynomial[0] }, { id: 'ring', ...polynomial[8] }).exportAs('obj', { tolerance: 0.1 });
    const lines = text.split('\n');
    assert.deepEqual(lines.filter((line) => line.startsWith('o ')), ['o first_one', 'o ring']);
    const vertices = lines.filter((line) => line.startsWith('v ')).map((line) => line.slice(2).split(' ').map(Number));
    const strips = lines.filter((line) => line.startsWith('l ')).map((line) => line.slice(2).split(' ').map(Number));
    const { points } = kw.curve(polynomial[8]).polyline({ tolerance: 0.1 });
    assert.deepEqual(strips[1].flatMap((i) => vertices[i - 1]), Array.from(points));
    assert.equal(strips.flat().length, vertices.length);
});

/** @param {Uint8Array} bytes */
async function gltfProblems(bytes) {
    const { issues, info } = await validateBytes(bytes, { maxIssues: 20 });
    assert.deepEqual(issues.messages.filter(({ severity }) => severity < 3).map(({ code, pointer }) => `${code} ${pointer}`), []);
    return info;
}

test('glTF is valid, as one text and as one file', async () => {
    for (const { id, document } of kw.scenes) {
        const scene = kw.scene(document);
        const text = scene.exportAs('gltf');
        const info = await gltfProblems(new TextEncoder().encode(text));
        assert.equal(info.version, '2.0', id);
        const binary = await gltfProblems(scene.exportAs('glb'));
        assert.equal(binary.totalVertexCount, info.totalVertexCount);
        assert.ok(info.totalVertexCount > 2);
    }
    await gltfProblems(new TextEncoder().encode(kw.scene({ knotwork: 1 }).exportAs('gltf')));
    await gltfProblems(kw.scene({ knotwork: 1 }).exportAs('glb'));
});

test('glTF holds the points of a curve, its colour in linear light and its name', () => {
    const gltf = JSON.parse(sceneOf({ id: 'c1', ...polynomial[0], style: { colour: '#ff8000' } }).exportAs('gltf', { tolerance: 0.1 }));
    const [uri, data] = gltf.buffers[0].uri.split(',');
    assert.equal(uri, 'data:application/octet-stream;base64');
    const bytes = Buffer.from(data, 'base64');
    const { points } = kw.curve(polynomial[0]).polyline({ tolerance: 0.1 });
    const floats = new Float32Array(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length));
    assert.deepEqual(Array.from(floats), Array.from(new Float32Array(points)));
    assert.equal(gltf.meshes[0].primitives[0].mode, 3);
    assert.equal(gltf.nodes[0].name, 'c1');
    near(gltf.materials[0].pbrMetallicRoughness.baseColorFactor, [1, 0.2158605, 0, 1], 1e-6);
});

test('what is not finite is left out', async () => {
    const pole = { id: 'c1', type: 'formula-curve', x: 't', y: '1/(t - 1)', domain: [0, 2] };
    let scene;
    try {
        scene = sceneOf(pole);
    } catch {
        return; // refused on entry, which is as good
    }
    for (const format of ['csv', 'obj', 'gltf']) {
        assert.doesNotMatch(scene.exportAs(format, { tolerance: 0.5 }), /nan|inf|null/i);
    }
    elementsOf(scene.svg());
});

const solids = [
    { id: 'torus', type: 'parametric-surface', name: 'torus', style: { colour: '#3366cc' } },
    { id: 'cube', type: 'subdivision-surface', scheme: 'catmull-clark', levels: 2, mesh: { solid: 'cube' } },
    { id: 'data', type: 'point-cloud', points: [[0, 0], [1, 2], [3, 1], [4, 4], [6, 0]] },
    { id: 'fitted', type: 'point-cloud', points: randomPoints(20, 3), fit: { degree: 3, count: 6 } },
    { id: 'c1', ...polynomial[0] },
];

/** The triangles of a binary STL. @param {Uint8Array} bytes */
function facetsOf(bytes) {
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
    const count = view.getUint32(80, true);
    assert.equal(bytes.length, 84 + 50 * count);
    assert.notEqual(new TextDecoder().decode(bytes.subarray(0, 5)), 'solid');
    return Array.from({ length: count }, (_, i) => [0, 1, 2, 3].map((k) =>
        [0, 1, 2].map((c) => view.getFloat32(84 + 50 * i + 12 * k + 4 * c, true))));
}

const minus = (a, b) => a.map((x, c) => x - b[c]);
const cross = ([a, b, c], [x, y, z]) => [b * z - c * y, c * x - a * z, a * y - b * x];
const dot = (a, b) => a.reduce((sum, x, c) => sum + x * b[c], 0);

/** The volume that closed facets enclose, positive where they look outwards. */
const volumeOf = (facets) => facets.reduce((sum, [, a, b, c]) => sum + dot(a, cross(b, c)) / 6, 0);

test('STL is closed, looks outwards and has the volume of the solid', () => {
    const torus = facetsOf(sceneOf(solids[0]).exportAs('stl', { tolerance: 1e-3 }));
    near(volumeOf(torus), 2 * Math.PI ** 2 * 2, 0.02);
    for (const [normal, a, b, c] of torus) {
        const across = cross(minus(b, a), minus(c, a));
        near(dot(normal, across) / Math.hypot(...across), 1, 1e-4);
    }
    const cube = facetsOf(sceneOf({ ...solids[1], scheme: 'catmull-clark', levels: 0 }).exportAs('stl'));
    assert.equal(cube.length, 12);
    near(volumeOf(cube), 8, 1e-6);
});

test('surfaces, meshes and clouds go into every format', async () => {
    const scene = sceneOf(...solids);
    const text = scene.exportAs('gltf');
    await gltfProblems(new TextEncoder().encode(text));
    const info = await gltfProblems(scene.exportAs('glb'));
    assert.equal(info.drawCallCount, 6);
    assert.deepEqual(JSON.parse(text).meshes.map(({ primitives: [{ mode }] }) => mode), [4, 4, 0, 0, 3, 3]);

    const obj = scene.exportAs('obj');
    const mesh = kw.mesh({ obj: sceneOf(solids[1]).exportAs('obj') });
    const exact = kw.mesh({ solid: 'cube' }).subdivide('catmull-clark', 2);
    assert.deepEqual(mesh.vertices, exact.vertices);
    assert.deepEqual(mesh.faces, exact.faces);
    assert.match(obj, /\no data\nv 0 0 0\nv 1 2 0\n[^]*\np \d+ \d+ \d+ \d+ \d+\n/);
    const torus = kw.mesh({ obj: sceneOf(solids[0]).exportAs('obj') });
    assert.equal(torus.counts.boundaryEdges, 0);
    assert.equal(torus.counts.vertices - torus.counts.edges + torus.counts.faces, 0);

    const [header, ...rows] = rowsOf(scene.exportAs('csv', { tolerance: 0.05 }));
    assert.deepEqual(header, ['object', 't', 'u', 'v', 'x', 'y', 'z']);
    assert.ok(rows.every((row) => row.length === 7));
    const surface = kw.surface({ type: 'parametric-surface', name: 'torus' });
    for (const [name, t, u, v, x, y, z] of rows) {
        if (name === 'torus') near(surface.point(Number(u), Number(v)), [x, y, z].map(Number), 1e-12);
        else assert.equal(u + v, '');
        assert.equal(t === '', name === 'torus' || name === 'cube' || name === 'data' || (name === 'fitted' && t === ''));
    }
    assert.deepEqual(rows.find(([name]) => name === 'data').slice(4), ['0', '0', '0']);
});

test('a turned solid still looks outwards', () => {
    const scene = kw.scene({ knotwork: 1, objects: [solids[1]],
        effects: [{ target: 'cube', kind: 'rotate', axis: [1, 0, 0], angle: 1 }] });
    near(volumeOf(facetsOf(scene.exportAs('stl', { phase: 0.5 }))), volumeOf(facetsOf(scene.exportAs('stl'))), 1e-5);
});

test('the calls in JavaScript make surfaces, meshes and fits', () => {
    const code = sceneOf(...solids).exportAs('js');
    const made = new Function('kw', `${code.slice(code.indexOf('const torus'))}\nreturn { torus, cube, data, fitted };`)(kw);
    assert.deepEqual(made.torus.spec, kw.surface({ type: 'parametric-surface', name: 'torus' }).spec);
    assert.deepEqual(made.cube.vertices, kw.mesh({ solid: 'cube' }).subdivide('catmull-clark', 2).vertices);
    assert.deepEqual(made.data, solids[2].points);
    assert.deepEqual(made.fitted.spec, kw.fit({ points: solids[3].points, degree: 3, count: 6 }).curve.spec);
});

test('STL needs faces', () => {
    refuses(() => alone(polynomial[0]).exportAs('stl'), 'NOT_SUPPORTED', 'format');
});

test('refusals name the option', () => {
    const scene = alone(polynomial[0]);
    refuses(() => scene.svg({ width: 0 }), 'OUT_OF_RANGE', 'width');
    refuses(() => scene.svg({ height: 1e9 }), 'TOO_LARGE', 'height');
    refuses(() => scene.svg({ width: '800' }), 'WRONG_TYPE', 'width');
    refuses(() => scene.svg({ height: NaN }), 'NOT_FINITE', 'height');
    refuses(() => scene.svg({ theme: 'sepia' }), 'UNKNOWN_NAME', 'theme');
    refuses(() => scene.svg({ phase: 1.5 }), 'OUT_OF_RANGE', 'phase');
    refuses(() => scene.svg({ phase: 0.5, time: 1 }), 'UNKNOWN_FIELD', 'time');
    refuses(() => scene.svg({ background: 'url(x)' }), 'SYNTAX', 'background');
    refuses(() => scene.svg({ title: 5 }), 'WRONG_TYPE', 'title');
    refuses(() => scene.svg({ tolerance: 1 }), 'UNKNOWN_FIELD', 'tolerance');
    refuses(() => scene.svg({ panes: ['curves'] }), 'UNKNOWN_NAME', 'panes[0]');
    refuses(() => scene.svg(null), 'WRONG_TYPE', '');
    refuses(() => scene.exportAs('pdf'), 'UNKNOWN_NAME', 'format');
    refuses(() => scene.exportAs('csv', { tolerance: 0 }), 'OUT_OF_RANGE', 'tolerance');
    const ring = alone({ type: 'parametric-curve', name: 'circle' });
    refuses(() => ring.exportAs('csv', { tolerance: 1e-18 }), 'TOO_LARGE', 'tolerance');
    refuses(() => scene.exportAs('obj', { width: 5 }), 'UNKNOWN_FIELD', 'width');
    const gone = alone(polynomial[0]);
    gone.dispose();
    refuses(() => gone.svg(), 'DISPOSED');
});

test('an export leaves nothing behind', () => {
    const scene = kw.scene(kw.scenes[0].document);
    const all = () => ['svg', 'json', 'js', 'csv', 'obj', 'gltf', 'glb'].forEach((format) => scene.exportAs(format));
    all();
    const before = kw.session.memoryInUse();
    for (let i = 0; i < 5; ++i) all();
    assert.ok(Math.abs(kw.session.memoryInUse() - before) <= 64);
});


test('an export in slices is the same to the byte, whatever becomes of the scene meanwhile', () => {
    const mesh = { id: 'm', type: 'subdivision-surface', scheme: 'catmull-clark', levels: 4, mesh: { solid: 'cube' } };
    for (const format of /** @type {const} */ (['svg', 'json', 'js', 'csv', 'obj', 'stl', 'gltf', 'glb'])) {
        const scene = sceneOf(mesh, { type: 'bspline-curve', degree: 3, points: randomPoints(7, 2) });
        const whole = scene.exportAs(format);
        const work = scene.exporting(format);
        const chunks = [];
        let slices = 0;
        for (let [more, former] = [true, 0]; more; slices += 1) {
            const slice = work.advance(1000);
            assert.ok(slice.fraction >= former && slice.fraction <= 1);
            chunks.push(slice.bytes);
            if (slices === 0) scene.execute({ set: 'objects[0].levels', value: 1 });
            if (slices === 1) scene.dispose();
            [more, former] = [slice.more, slice.fraction];
        }
        work.dispose();
        const written = Buffer.concat(chunks);
        assert.deepEqual(written, Buffer.from(whole), format);
        if (!['json', 'js'].includes(format)) assert.ok(slices > 4, `${format}: ${slices} slices`);
        refuses(() => work.advance(), 'DISPOSED', '');
    }
    refuses(() => sceneOf(mesh).exporting('doc'), 'UNKNOWN_NAME', 'format');
    refuses(() => sceneOf(mesh).exporting('obj', { width: 3 }), 'UNKNOWN_FIELD', 'width');
    const curves = sceneOf({ type: 'line-curve', from: [0, 0], to: [1, 1] }).exporting('stl');
    refuses(() => { while (curves.advance().more); }, 'NOT_SUPPORTED', 'format');
});
