// Part 8 of the interface: scenes, their commands, their history and their drawings.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { test } from 'node:test';

import { load, near, randomness, refuses, tolerances } from './support.mjs';

const kw = await load();
const spline = { id: 'c1', type: 'bspline-curve', degree: 3, points: [[0, 0], [1, 2], [3, 3], [4, 0], [6, 1]] };
const documentWith = (objects, effects = []) => ({ knotwork: 1, title: 'A scene', objects, effects });
const open = () => kw.scene(documentWith([spline]));
const builtin = (id) => kw.scenes.find((scene) => scene.id === id).document;

const circle = { type: 'parametric-curve', name: 'circle' };
const flower = {
    id: 'flower', type: 'blending-curve', bFunction: { family: 'expo-rational' },
    model: { type: 'parametric-curve', name: 'rose' }, locals: { count: 8 },
};
const moving = documentWith([spline, flower, { ...circle, id: 'ring' }], [
    { target: 'c1', kind: 'translate', by: [1, 2, 0], period: 4 },
    { target: 'ring', kind: 'rotate', axis: [0, 1, 0], angle: 1.2 },
    { target: 'flower', kind: 'simulate', translate: [0.4, 0.3, 0], rotate: { axis: [0, 0, 1], angle: 0.5 }, seed: 3 },
    { target: 'flower', kind: 'colour', to: '#ff8800' },
]);

const shapesOf = (scene, role, options) => scene.drawing(options).shapes.filter((shape) => shape.role === role);
/** What can be compared to the bit. */
const frozen = ({ bounds, shapes }) => ({ bounds, shapes: shapes.map((shape) => ({ ...shape, positions: Array.from(shape.positions) })) });

test('a document comes back canonical: defaults filled in, and stable', () => {
    const scene = open();
    const { document } = scene;
    assert.equal(document.knotwork, 1);
    assert.equal(document.title, 'A scene');
    assert.deepEqual(document.objects[0].knots, [0, 0, 0, 0, 1, 2, 2, 2, 2]);
    assert.equal(document.objects[0].form, 'clamped');
    assert.equal(document.objects[0].show.polygon, true);
    assert.match(document.objects[0].style.colour, /^#[0-9a-f]{6}$/);
    const again = kw.scene(document).document;
    assert.equal(JSON.stringify(again), JSON.stringify(document));
});

test('the order of keys in a document does not matter', () => {
    const backwards = (value) => {
        if (Array.isArray(value)) return value.map(backwards);
        if (typeof value !== 'object' || value === null) return value;
        return Object.fromEntries(Object.entries(value).reverse().map(([key, one]) => [key, backwards(one)]));
    };
    assert.equal(JSON.stringify(kw.scene(backwards(moving)).document), JSON.stringify(kw.scene(moving).document));
});

test('an object of a scene is the curve of the same words', () => {
    const { positions, kind } = shapesOf(open(), 'curve', { tolerance: 1e-3 })[0];
    assert.equal(kind, 'polyline');
    const curve = kw.curve(spline);
    near(positions, curve.polyline({ tolerance: 1e-3 }).points, tolerances.sampled);
    assert.deepEqual(kw.curve(open().document.objects[0]).sample(9), curve.sample(9));
});

/** Those that are promised. */
const expectedScenes = [
    'bspline-forms', 'local-control', 'basis-functions', 'factor-matrices', 'knot-insertion', 'oslo', 'fit', 'b-functions',
    'b-function-axioms', 'blending-curve', 'blending-compare', 'bspline-model', 'blending-subdivision', 'lane-riesenfeld',
    'subdivision-surfaces', 'blending-surface', 'butterfly', 'rose', 'petals', 'surrounding-sphere',
];

test('every built-in scene opens, draws and is its own canonical document', () => {
    const ids = kw.scenes.map(({ id }) => id);
    assert.equal(new Set(ids).size, ids.length);
    for (const id of expectedScenes) assert.ok(ids.includes(id), id);
    for (const { id, title, description, document } of kw.scenes) {
        assert.ok(title.length > 0 && description.length > 0, id);
        const scene = kw.scene(document);
        const { bounds, shapes } = scene.drawing();
        assert.ok(shapes.some(({ role }) => ['curve', 'surface', 'wireframe'].includes(role)), id);
        for (const shape of shapes) {
            assert.ok(shape.positions instanceof Float64Array);
            assert.ok(shape.positions.length % 3 === 0 && shape.positions.every(Number.isFinite), `${id} ${shape.role}`);
            assert.match(shape.colour, /^#[0-9a-f]{6}$/);
            assert.ok(scene.document.objects.some((object) => object.id === shape.object));
        }
        assert.ok(bounds.min.every((low, c) => low <= bounds.max[c]), id);
    }
});

test('bounds hold everything that is drawn of the curves', () => {
    const { bounds, shapes } = kw.scene(moving).drawing({ phase: 0.3 });
    for (const { pane, positions } of shapes) {
        if (pane !== 'curve') continue;
        positions.forEach((x, i) => assert.ok(bounds.min[i % 3] <= x && x <= bounds.max[i % 3]));
    }
    assert.equal(kw.scene(documentWith([])).drawing().bounds, null);
});

test('at phase 0 and 1 everything stands where it began, to the bit', () => {
    for (const document of [moving, ...kw.scenes.map((scene) => scene.document)]) {
        const scene = kw.scene(document);
        const start = frozen(scene.drawing({ phase: 0 }));
        assert.deepEqual(frozen(scene.drawing({ phase: 1 })), start);
        assert.deepEqual(frozen(scene.drawing()), start);
        assert.deepEqual(frozen(scene.drawing({ time: 0 })), start);
        if (scene.document.effects.length > 0) assert.notDeepEqual(frozen(scene.drawing({ phase: 0.5 })), start);
    }
});

test('there and back: phase p looks like phase 1 - p', () => {
    const scene = kw.scene(moving);
    for (const phase of [0.125, 0.25, 0.375]) {
        const [there, back] = [phase, 1 - phase].map((p) => shapesOf(scene, 'curve', { phase: p, tolerance: 0.05 }));
        there.forEach((shape, i) => near(shape.positions, back[i].positions, 1e-12));
    }
});

test('an effect is fully there at half its period, each at its own time', () => {
    const scene = kw.scene(documentWith([spline], [moving.effects[0]]));
    const rest = shapesOf(scene, 'curve', {})[0].positions;
    for (const options of [{ phase: 0.5 }, { time: 2 }, { time: 6 }]) {
        const there = shapesOf(scene, 'curve', options)[0].positions;
        near(there, Array.from(rest, (x, i) => x + [1, 2, 0][i % 3]), 1e-12);
    }
    near(shapesOf(scene, 'curve', { time: 4e8 })[0].positions, rest, 1e-6);
});

test('the colour effect ends in its colour', () => {
    const scene = kw.scene(moving);
    const colourAt = (phase) => shapesOf(scene, 'curve', { phase }).find(({ object }) => object === 'flower').colour;
    assert.equal(colourAt(0.5), '#ff8800');
    assert.equal(colourAt(0), colourAt(1));
    assert.notEqual(colourAt(0), colourAt(0.5));
});

test('the same seed makes the same movement, another seed another', () => {
    const at = (seed) => {
        const effects = [{ ...moving.effects[2], seed }];
        return Array.from(shapesOf(kw.scene(documentWith([flower], effects)), 'curve', { phase: 0.5 })[0].positions);
    };
    assert.deepEqual(at(3), at(3));
    assert.notDeepEqual(at(3), at(4));
});

test('set, move, insert, remove, add and pose change what they say', () => {
    const scene = kw.scene(documentWith([spline, flower]));
    const object = (i) => scene.document.objects[i];
    assert.deepEqual(scene.execute({ set: 'objects[0].style.width', value: 4 }), { command: 'set', path: 'objects[0].style.width' });
    assert.equal(object(0).style.width, 4);
    scene.execute({ move: 'objects[0].points[1]', to: [2, 2] });
    assert.deepEqual(object(0).points[1], [2, 2]);
    scene.execute({ move: 'objects[0].points[1]', by: [0.5, -1] });
    near(object(0).points[1], [2.5, 1], tolerances.exact);
    scene.execute({ insert: 'objects[0].points[2]', value: [2, 4] });
    assert.deepEqual([object(0).points.length, object(0).points[2]], [6, [2, 4]]);
    scene.execute({ remove: 'objects[0].points[2]' });
    assert.equal(object(0).points.length, 5);
    scene.execute({ add: { ...circle, id: 'ring' } });
    assert.equal(object(2).id, 'ring');
    scene.execute({ pose: { object: 'flower', local: 2, translate: [1, 0, 0] } });
    assert.equal(object(1).poses.find(({ local }) => local === 2).translate[0], 1);
    scene.execute({ remove: 'objects[2]' });
    assert.equal(scene.document.objects.length, 2);
});

test('knots and points stay consistent whatever is inserted or removed', () => {
    const scene = open();
    const counts = () => {
        const { points, knots, degree } = scene.document.objects[0];
        assert.equal(knots.length, points.length + degree + 1);
        return points.length;
    };
    const picture = shapesOf(scene, 'curve', {})[0].positions;
    scene.execute({ insertKnot: { object: 'c1', at: 0.5 } });
    assert.equal(counts(), 6);
    const ends = (positions) => [...positions.subarray(0, 3), ...positions.subarray(-3)];
    near(ends(shapesOf(scene, 'curve', {})[0].positions), ends(picture), tolerances.exact);
    scene.execute({ remove: 'objects[0].points[1]' });
    assert.equal(counts(), 5);
    for (const [degree, form] of [[2, 'clamped'], [2, 'closed'], [3, 'closed'], [3, 'open'], [1, 'clamped']]) {
        scene.execute({ set: 'objects[0].degree', value: degree });
        scene.execute({ set: 'objects[0].form', value: form });
        assert.equal(kw.curve(scene.document.objects[0]).closed, form === 'closed');
    }
});

test('dragging a knot keeps the order of the knots', () => {
    const scene = open();
    scene.execute({ move: 'objects[0].knots[4]', to: 1.5 });
    assert.equal(scene.document.objects[0].knots[4], 1.5);
    const before = scene.document;
    refuses(() => scene.execute({ set: 'objects[0].knots[4]', value: 'x' }), 'WRONG_TYPE', 'objects[0].knots[4]');
    assert.deepEqual(scene.document, before);
});

test('undo and redo walk through the history to the bit', () => {
    const scene = open();
    const states = [JSON.stringify(scene.document)];
    const commands = [
        { move: 'objects[0].points[0]', by: [0.1, 0.2] }, { set: 'objects[0].degree', value: 2 },
        { add: { ...circle, id: 'ring' } }, { set: 'title', value: 'Another' },
    ];
    for (const command of commands) {
        scene.execute(command);
        states.push(JSON.stringify(scene.document));
    }
    assert.equal(new Set(states).size, states.length);
    for (let i = states.length - 2; i >= 0; --i) {
        assert.deepEqual([scene.canUndo, scene.undo()], [true, true]);
        assert.equal(JSON.stringify(scene.document), states[i]);
    }
    assert.deepEqual([scene.canUndo, scene.undo()], [false, false]);
    for (let i = 1; i < states.length; ++i) {
        assert.deepEqual([scene.canRedo, scene.redo()], [true, true]);
        assert.equal(JSON.stringify(scene.document), states[i]);
    }
    assert.deepEqual([scene.canRedo, scene.redo()], [false, false]);
    scene.undo();
    scene.execute({ set: 'title', value: 'Elsewhere' });
    assert.equal(scene.canRedo, false);
});

test('a gesture is one step of history', () => {
    const scene = open();
    for (let i = 1; i <= 50; ++i) scene.execute({ move: 'objects[0].points[2]', to: [i, i], gesture: 'drag 1' });
    scene.execute({ move: 'objects[0].points[2]', to: [0, 9], gesture: 'drag 2' });
    scene.undo();
    assert.deepEqual(scene.document.objects[0].points[2], [50, 50]);
    scene.undo();
    assert.deepEqual(scene.document.objects[0].points[2], [3, 3]);
    assert.equal(scene.canUndo, false);
});

test('the revision grows with every change and with nothing else', () => {
    const scene = open();
    const start = scene.revision;
    scene.drawing();
    assert.throws(() => scene.execute({ set: 'objects[0].degree', value: 0 }));
    assert.equal(scene.revision, start);
    scene.execute({ set: 'title', value: 'x' });
    scene.undo();
    scene.redo();
    assert.equal(scene.revision, start + 3);
});

test('refused commands leave document and history alone', () => {
    const scene = open();
    const before = JSON.stringify(scene.document);
    for (const [command, code, path] of [
        [{ set: 'objects[0].degree', value: 9 }, undefined, undefined],
        [{ set: 'objects[0].degree', value: '2' }, 'WRONG_TYPE', 'objects[0].degree'],
        [{ set: 'objects[0].colour', value: 1 }, 'UNKNOWN_FIELD', 'objects[0].colour'],
        [{ set: 'objects[3].degree', value: 2 }, undefined, undefined],
        [{ set: 'objects[0].points[1]', value: [0, NaN] }, 'NOT_FINITE', 'objects[0].points[1][1]'],
        [{ set: '__proto__.x', value: 2 }, undefined, undefined],
        [{ set: 5, value: 2 }, 'WRONG_TYPE', undefined],
        [{ remove: 'objects[0].points[17]' }, undefined, undefined],
        [{ add: { type: 'parametric-curve', name: 'circle', id: 'c1' } }, undefined, undefined],
        [{ add: { type: 'nothing' } }, 'UNKNOWN_NAME', undefined],
        [{ jump: 'objects[0]' }, 'UNKNOWN_FIELD', 'jump'],
        [{ pose: { object: 'c1', local: 0 } }, undefined, undefined],
        [{}, undefined, undefined],
        ['undo', 'WRONG_TYPE', ''],
        [null, 'WRONG_TYPE', ''],
    ]) {
        const error = refuses(() => scene.execute(command), ...(code ? [code, path] : [codeOf(scene, command)]));
        assert.ok(error);
        assert.equal(JSON.stringify(scene.document), before);
    }
    assert.equal(scene.canUndo, false);
});

/** For refusals whose code is free to be the most fitting one. */
function codeOf(scene, command) {
    try {
        scene.execute(command);
    } catch (error) {
        return error.code;
    }
    return assert.fail(`${JSON.stringify(command)} was not refused`);
}

test('what is wrong with a document is said with its place', () => {
    const bad = (fields, code, path) => refuses(() => kw.scene({ ...documentWith([spline]), ...fields }), code, path);
    bad({ knotwork: 2 }, 'VERSION', 'knotwork');
    bad({ knotwork: '1' }, 'WRONG_TYPE', 'knotwork');
    bad({ knotwork: undefined }, 'WRONG_TYPE', 'knotwork');
    bad({ objects: {} }, 'WRONG_TYPE', 'objects');
    bad({ objects: [{ ...spline, degree: 3.5 }] }, 'NOT_INTEGER', 'objects[0].degree');
    bad({ objects: [spline, { ...flower, bFunction: { family: 'expo-rational', alpha: 9 } }] }, 'OUT_OF_RANGE', 'objects[1].bFunction.alpha');
    bad({ objects: [{ ...spline, knots: [0, 0, 0, 0, 3, 2, 2, 2, 2] }] }, 'KNOTS_DECREASING', 'objects[0].knots[5]');
    bad({ objects: [{ ...spline, show: { polygons: true } }] }, 'UNKNOWN_FIELD', 'objects[0].show.polygons');
    bad({ objects: [{ ...spline, show: { polygon: 1 } }] }, 'WRONG_TYPE', 'objects[0].show.polygon');
    bad({ objects: [{ ...spline, style: { colour: 'red' } }] }, 'SYNTAX', 'objects[0].style.colour');
    bad({ objects: [spline, spline] }, 'OUT_OF_RANGE', 'objects[1].id');
    bad({ effects: [{ target: 'c2', kind: 'translate' }] }, 'UNKNOWN_NAME', 'effects[0].target');
    bad({ effects: [{ target: 'c1', kind: 'shake' }] }, 'UNKNOWN_NAME', 'effects[0].kind');
    bad({ effects: [{ target: 'c1', kind: 'translate', period: 0 }] }, 'OUT_OF_RANGE', 'effects[0].period');
    bad({ effects: [{ target: 'c1', kind: 'translate', easing: { family: 'sine' } }] }, 'UNKNOWN_NAME', 'effects[0].easing.family');
    bad({ scenery: 1 }, 'UNKNOWN_FIELD', 'scenery');
});

test('a document of more than a mebibyte is refused', () => {
    const title = (length) => ({ knotwork: 1, title: 'x'.repeat(length), objects: [] });
    assert.equal(kw.scene(title(2 ** 20 - 200)).document.title.length, 2 ** 20 - 200);
    refuses(() => kw.scene(title(2 ** 20)), 'TOO_LARGE', '');
});

test('moments are checked', () => {
    const scene = open();
    refuses(() => scene.drawing({ phase: 1.5 }), 'OUT_OF_RANGE', 'phase');
    refuses(() => scene.drawing({ phase: -0.1 }), 'OUT_OF_RANGE', 'phase');
    refuses(() => scene.drawing({ phase: NaN }), 'NOT_FINITE', 'phase');
    refuses(() => scene.drawing({ time: '1' }), 'WRONG_TYPE', 'time');
    refuses(() => scene.drawing({ time: Infinity }), 'NOT_FINITE', 'time');
    refuses(() => scene.drawing({ phase: 0, time: 0 }), 'UNKNOWN_FIELD', 'time');
    refuses(() => scene.drawing({ tolerance: 0 }), 'OUT_OF_RANGE', 'tolerance');
    refuses(() => scene.drawing({ Phase: 0 }), 'UNKNOWN_FIELD', 'Phase');
});

test('the schema lists the fields of each object with their values', () => {
    const scene = kw.scene(documentWith([spline, flower]));
    const [first, second] = scene.schema;
    assert.deepEqual([first.object, first.type, second.object], ['c1', 'bspline-curve', 'flower']);
    const degree = first.fields.find(({ path }) => path === 'degree');
    assert.equal(degree.value, 3);
    assert.ok(degree.label.length > 0 && degree.help.length > 0);
    assert.deepEqual(degree.range, [1, degree.max]);
    const alpha = second.fields.find(({ path }) => path === 'bFunction.alpha');
    assert.deepEqual([alpha.name, alpha.kind, alpha.value, alpha.min, alpha.max, alpha.minOpen], ['alpha', 'number', 1, 0, 4, true]);
});

test('every number that the schema offers can be set, and only within its range', () => {
    for (const { document } of kw.scenes) {
        const scene = kw.scene(document);
        scene.schema.forEach(({ fields }, i) => {
            for (const { path, kind, min, max, minOpen, value } of fields) {
                if (kind !== 'number' || typeof value !== 'number') continue;
                const at = `objects[${i}].${path}`;
                scene.execute({ set: at, value });
                if (max !== undefined) refuses(() => scene.execute({ set: at, value: max * 2 + 1 }), 'OUT_OF_RANGE', at);
                if (minOpen) refuses(() => scene.execute({ set: at, value: min }), 'OUT_OF_RANGE', at);
            }
        });
    }
});

test('random commands never leave a document that cannot be opened again', () => {
    const random = randomness(51);
    const scene = kw.scene(documentWith([spline, flower]));
    let done = 0;
    for (let i = 0; i < 400; ++i) {
        const k = random.integer(-1, 9);
        const number = random.between(-3, 9);
        const commands = [
            { move: `objects[0].points[${k}]`, by: [number, number] }, { insert: `objects[0].points[${k}]`, value: [number, 1] },
            { remove: `objects[0].points[${k}]` }, { move: `objects[0].knots[${k}]`, to: number },
            { insert: `objects[0].knots[${k}]`, value: number }, { remove: `objects[0].knots[${k}]` },
            { insertKnot: { object: 'c1', at: number } }, { set: 'objects[0].degree', value: k },
            { set: 'objects[0].form', value: ['clamped', 'open', 'closed'][random.integer(0, 2)] },
            { set: 'objects[1].locals.count', value: k }, { set: 'objects[1].bFunction.family', value: ['linear', 'logistic', 'polynomial'][random.integer(0, 2)] },
            { set: 'objects[1].model.name', value: ['circle', 'butterfly', 'rose'][random.integer(0, 2)] },
            { set: 'objects[1].form', value: ['open', 'closed'][random.integer(0, 1)] },
            { move: `objects[1].knots[${k}]`, by: number / 10 }, { pose: { object: 'flower', local: k, translate: [number, 0, 0] } },
        ];
        const command = commands[random.integer(0, commands.length - 1)];
        try {
            scene.execute(command);
            done += 1;
        } catch (error) {
            assert.equal(error.name, 'KnotworkError', `${JSON.stringify(command)}: ${error.stack}`);
        }
        if (random.unit() < 0.1) scene.undo();
        if (random.unit() < 0.05) scene.redo();
        const { document } = scene;
        assert.equal(JSON.stringify(kw.scene(document).document), JSON.stringify(document), JSON.stringify(command));
    }
    assert.ok(done > 100, `${done} of 400 commands were possible`);
    scene.drawing({ tolerance: 0.1 });
});

test('the scene of B-functions uses the one that is chosen', () => {
    const scene = kw.scene(builtin('b-functions'));
    const graph = () => Array.from(shapesOf(scene, 'bFunction')[0].positions);
    const before = graph();
    scene.execute({ set: 'objects[0].bFunction', value: { family: 'linear' } });
    assert.notDeepEqual(graph(), before);
    const positions = graph();
    for (let i = 0; i < positions.length; i += 3) near(positions[i + 1], positions[i], 1e-9);
});

test('every built-in scene has a title and a description in each language, and a picture in both themes', async () => {
    const { scenes } = JSON.parse(await readFile(new URL('../../web/locales/nb.json', import.meta.url), 'utf8'));
    assert.deepEqual(Object.keys(scenes), kw.scenes.map(({ id }) => id));
    for (const { id, title, description } of kw.scenes) {
        assert.ok(scenes[id].title && scenes[id].description.length > 40 && description.length > 40, id);
        assert.ok(title.length > 3, id);
        for (const name of [`${id}.svg`, `${id}.dark.svg`]) {
            const picture = await readFile(new URL(`../../dist/gallery/${name}`, import.meta.url), 'utf8');
            assert.ok(picture.startsWith('<svg') && picture.length > 1000 && picture.length < 400_000, `${name} ${picture.length}`);
        }
    }
});
