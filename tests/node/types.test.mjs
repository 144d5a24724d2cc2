// web/knotwork.d.ts against the module: it compiles strictly, it takes what it should and refuses
// what it should, and it declares exactly the names that exist.
import assert from 'node:assert/strict';
import { mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

import ts from 'typescript';

import { distribution, load } from './support.mjs';

const declarations = fileURLToPath(new URL('knotwork.d.ts', distribution));
const compilerOptions = {
    strict: true, noEmit: true, target: ts.ScriptTarget.ES2022, module: ts.ModuleKind.NodeNext,
    moduleResolution: ts.ModuleResolutionKind.NodeNext, lib: ['lib.es2022.d.ts', 'lib.dom.d.ts', 'lib.esnext.disposable.d.ts'], types: [],
};

/** What the compiler says about a file that uses the package. */
async function complaints(text) {
    const folder = await mkdtemp(path.join(tmpdir(), 'knotwork-types-'));
    try {
        const file = path.join(folder, 'usage.mts');
        const module = path.relative(folder, declarations).replaceAll(path.sep, '/').replace(/\.d\.ts$/, '.mjs');
        await writeFile(file, `import { load, KnotworkError } from '${module.replace('.mjs', '.js')}';\n${text}\nvoid load; void KnotworkError;\n`);
        const program = ts.createProgram([file], compilerOptions);
        return ts.getPreEmitDiagnostics(program).map(({ messageText }) => ts.flattenDiagnosticMessageText(messageText, '\n'));
    } finally {
        await rm(folder, { recursive: true });
    }
}

const usage = `
const kw = await load({ wasm: new Uint8Array(8) });
const b = kw.bFunction({ family: 'mixed', of: [{ family: 'linear' }, { family: 'logistic', c: 2 }], weight: 0.5 });
const orders: [number, number] = b.order;
const values: Float64Array = b.sample(100, { into: new Float64Array(100) });
const spline = kw.curve({ type: 'bspline-curve', degree: 3, points: [[0, 0], [1, 1, 2], [2, 0], [3, 1]] });
const refined = spline.insertKnot(0.5, 2).insertKnot(0.25);
const rows: number[][] = refined.basis(0.5, { derivatives: 2 });
const flat = kw.curve({ type: 'bspline-curve', degree: 1, form: 'closed', points: new Float64Array(9), knots: new Float64Array(4) });
const blend = kw.curve({
    type: 'blending-curve', bFunction: b.spec, model: { type: 'parametric-curve', name: 'circle', parameters: { radius: 2 } },
    locals: { count: 5 }, poses: [{ local: 0, translate: [1, 0], rotate: { axis: [0, 0, 1], angle: 1 }, scale: 2 }],
});
const posed = blend.withPose(1, { scale: [1, 2, 3] });
const weights: number[] = posed.blendBasis(0);
const { points, parameters } = posed.polyline({ tolerance: 0.01 });
const derivatives: [number, number, number][] = posed.derivatives(0, 3, { side: 'left' });
const cloud = new Float64Array(30);
const { curve: fitted, parameters: found, residuals: { rms } } = kw.fit({ points: cloud, degree: 3, count: 5, form: 'closed', smoothing: 1 });
const through: Float64Array = kw.interpolate({ points: [[0, 0], [1, 1]], degree: 1, parameters: [0, 2] }).parameters;
const { center, radius } = kw.enclosingSphere(cloud, { method: 'ritter' });
void [fitted.knots, found.length, rms, through, center[2], radius];
const scene = kw.scene({ knotwork: 1, objects: [{ id: 'c1', ...spline.spec, show: { polygon: false } }],
    effects: [{ target: 'c1', kind: 'rotate', angle: 1, easing: { family: 'linear' } }] });
scene.execute({ move: 'objects[0].points[2]', by: [1, 0], gesture: 'drag' });
const shapes: { object: string, positions: Float64Array }[] = scene.drawing({ time: 2 }).shapes;
const files: [string, string, Uint8Array] = [scene.svg({ width: 320, theme: 'contrast', phase: 0.5 }), scene.exportAs('csv', { tolerance: 1, time: 2 }), scene.exportAs('stl')];
const imported: string | undefined = kw.importDocument(files[1], { format: 'csv', as: 'curve' }).title;
void imported;
const trace = kw.trace({ algorithm: 'lane-riesenfeld', points: new Float64Array(9), closed: true, degree: 2 });
const said: [string, string | undefined] = [trace.frames[0].text, trace.frames[0].formula];
const link: string = await kw.encodeLink(scene.document);
kw.scene(await kw.decodeLink(link)).dispose();
const object = kw.scenes[0].document.objects![0];
try { if (object.type === 'blending-curve') kw.curve(object); } catch (error) {
    if (error instanceof KnotworkError && error.code === 'OUT_OF_RANGE') console.log(error.path);
}
const corners = kw.curve({ type: 'subdivision-curve', scheme: 'four-point', points: [[0, 0], [1, 0], [1, 1]], tension: 0.1 });
const limits: Float64Array[] = [corners.limitPoints(), corners.limitTangents(), kw.subdivide(corners.spec)];
const smooth = kw.subdivide({ scheme: 'lane-riesenfeld', degree: 3, points: new Float64Array(9), closed: true, levels: 2 }, { into: new Float64Array(36) });
const patch = kw.surface({ type: 'bspline-surface', degree: [1, 2], form: ['clamped', 'open'], points: [new Float64Array(9), new Float64Array(9)] });
const finer = patch.refine([patch.spec.knots![0], new Float64Array(6)]);
const torus = kw.surface({ type: 'parametric-surface', name: 'torus', parameters: { R: 3 } });
const bent: [number, number, number] = torus.derivatives(0, 1).Suv;
const grid = torus.grid(10, 10);
const corners3: Uint32Array = patch.grid(10, 10, { into: grid }).indices;
const { k1 }: { k1: number } = torus.curvatures(0, 1);
const fine: Float64Array = torus.triangles({ tolerance: 0.1 }).parameters;
void [fine, torus.isoline('u', 0, { count: 9 }), torus.isoline('v', 1)];
void [corners3, k1, torus.normal(1, 2)[0]];
const handles = kw.surface({ type: 'blending-surface', bFunction: [b.spec, { family: 'linear' }], model: torus.spec, locals: [5, 3],
    kind: 'bezier', degree: [3, 2], form: ['closed', 'open'], poses: [{ local: [0, 1], scale: 2 }] });
const piece: [number, number] = handles.withPose([1, 2], { translate: [0, 0, 1] }).local(1, 2).domain[0];
const four: number[] | undefined = kw.trace({ algorithm: 'blend', surface: handles.spec, u: 0, v: 1 }).frames[2].weights;
void [four, piece, handles.knots[1][0], handles.localOrigins.length];
const triangle = kw.surface({ type: 'blending-triangle', locals: [torus.spec, patch.spec, handles.spec], order: 2 });
const byQuotients = kw.surface({ type: 'blending-triangle', locals: triangle.spec.locals, bFunction: { family: 'expo-rational' } });
const shares: [number, number, number] = byQuotients.weights(0.5, 0.25);
void [shares, triangle.local(2).normal(0, 0)[0]];
void [finer.closed[0], bent, kw.parametricSurfaces[0].formula];
const cube = kw.mesh({ solid: 'cube' });
const ring = kw.mesh({ solid: 'torus', parameters: { around: 6, tube: 0.2 } });
const solid = kw.mesh({ vertices: [[0, 0], [1, 0, 2], [0, 1]], faces: [[0, 1, 2]] });
const flatMesh = kw.mesh({ vertices: new Float64Array(9), faces: cube.faces });
const again = kw.mesh(kw.mesh({ obj: cube.toObj() }).triangulated().spec);
const meshLists: [Float64Array, number[][], Uint32Array] = [ring.vertexNormals({ into: again.vertices }), solid.edges, flatMesh.indices];
const rounded: Float64Array = cube.subdivide('catmull-clark', 2).limit('loop').normals;
const continuity: 'C1' | 'C2' = cube.classification('sqrt3').regular;
void [rounded, continuity];
const boundary: number = cube.counts.boundaryEdges;
const parametersOfSolids: string[] = kw.solids.flatMap((one) => one.parameters.map(({ label }) => label));
void [limits, smooth, meshLists, boundary, parametersOfSolids, orders, values, rows, flat, weights, points, parameters, derivatives, shapes, said];
`;

test('a program that uses everything compiles strictly', async () => {
    assert.deepEqual(await complaints(usage), []);
});

for (const [name, text] of [
    ['a family that does not exist', "(await load()).bFunction({ family: 'sine' });"],
    ['a parameter of another family', "(await load()).bFunction({ family: 'linear', c: 1 });"],
    ['a parameter as text', "(await load()).bFunction({ family: 'logistic', c: '1' });"],
    ['a curve without points', "(await load()).curve({ type: 'bspline-curve', degree: 3 });"],
    ['a method of another kind of curve', "(await load()).curve({ type: 'parametric-curve', name: 'circle' }).knots;"],
    ['single precision', "(await load()).curve({ type: 'parametric-curve', name: 'circle' }).sample(3, { into: new Float32Array(9) });"],
    ['a parameter of another surface', "(await load()).surface({ type: 'parametric-surface', name: 'sphere', parameters: { R: 1 } });"],
    ['a triangle of two patches', "(await load()).surface({ type: 'blending-triangle', locals: [{ type: 'parametric-surface', name: 'plane' }, { type: 'parametric-surface', name: 'plane' }] });"],
    ['a solid that does not exist', "(await load()).mesh({ solid: 'teapot' });"],
    ['a parameter of another solid', "(await load()).mesh({ solid: 'cube', parameters: { sides: 4 } });"],
    ['a code that does not exist', "new KnotworkError('OOPS', '', '');"],
    ['a tension of another scheme', "(await load()).subdivide({ scheme: 'chaikin', points: [], tension: 0 });"],
    ['an option of another format', "(await load()).scene({ knotwork: 1 }).exportAs('csv', { width: 1 });"],
    ['a picture as bytes', "const bytes: Uint8Array = (await load()).scene({ knotwork: 1 }).exportAs('svg'); void bytes;"],
    ['changing what is read only', "(await load()).bFunction({ family: 'linear' }).order = [0, 0];"],
]) {
    test(`${name} does not compile`, async () => {
        assert.notDeepEqual(await complaints(text), []);
    });
}

const program = ts.createProgram([declarations], compilerOptions);
const checker = program.getTypeChecker();
const exported = checker.getExportsOfModule(checker.getSymbolAtLocation(program.getSourceFile(declarations)));

/** The names that an exported interface or class declares, inherited ones included. */
function declared(name) {
    const symbol = exported.find((one) => one.name === name);
    const names = checker.getDeclaredTypeOfSymbol(symbol).getProperties().map((one) => one.name);
    return names.filter((one) => !one.startsWith('__@')).sort();
}

/** The names that a value really has, those of Object aside. */
function real(value) {
    const names = new Set(Object.keys(value));
    for (let at = Object.getPrototypeOf(value); at !== Object.prototype; at = Object.getPrototypeOf(at)) {
        for (const name of Object.getOwnPropertyNames(at)) names.add(name);
    }
    names.delete('constructor');
    return [...names].sort();
}

const kw = await load();
const circle = { type: 'parametric-curve', name: 'circle' };
const factors = kw.trace({ algorithm: 'factor-matrices', t: 0.5, curve: { type: 'bspline-curve', degree: 1, points: [[0, 0], [1, 1]] } });
const values = {
    Knotwork: kw,
    BFunction: kw.bFunction({ family: 'linear' }),
    BsplineCurve: kw.curve({ type: 'bspline-curve', degree: 1, points: [[0, 0], [1, 1]] }),
    ParametricCurve: kw.curve(circle),
    BlendingCurve: kw.curve({ type: 'blending-curve', bFunction: { family: 'linear' }, model: circle, locals: { count: 3 } }),
    BezierCurve: kw.curve({ type: 'bezier-curve', points: [[0, 0], [1, 1]] }),
    LineCurve: kw.curve({ type: 'line-curve', from: [0, 0], to: [1, 1] }),
    ArcCurve: kw.curve({ type: 'arc-curve', at: 0, point: [0, 0], first: [1, 0], second: [0, 1], domain: [0, 1] }),
    SubdivisionCurve: kw.curve({ type: 'subdivision-curve', scheme: 'chaikin', points: [[0, 0], [1, 0], [1, 1]] }),
    Mesh: kw.mesh({ solid: 'cube' }),
    Solid: kw.solids[0],
    Fit: kw.interpolate({ points: [[0, 0], [1, 1]], degree: 1 }),
    Sphere: kw.enclosingSphere([[0, 0], [1, 1]]),
    FormulaCurve: kw.curve({ type: 'formula-curve', x: 't', y: 't^2', domain: [0, 1] }),
    BsplineSurface: kw.surface({ type: 'bspline-surface', degree: [1, 1], points: [[[0, 0], [1, 0]], [[0, 1], [1, 1]]] }),
    BlendingSurface: kw.surface({ type: 'blending-surface', bFunction: { family: 'linear' }, locals: [3, 2], model: { type: 'parametric-surface', name: 'torus' } }),
    BlendingTriangle: kw.surface({ type: 'blending-triangle', locals: ['torus', 'plane', 'cone'].map((name) => ({ type: 'parametric-surface', name })) }),
    ParametricSurface: kw.surface({ type: 'parametric-surface', name: 'torus' }),
    Grid: kw.surface({ type: 'parametric-surface', name: 'plane' }).grid(2, 2),
    SurfaceTriangles: kw.surface({ type: 'parametric-surface', name: 'plane' }).triangles(),
    ParametricSurfaceModel: kw.parametricSurfaces[0],
    Scene: kw.scene(kw.scenes[0].document),
    BFunctionFamily: kw.bFunctions[0],
    ParametricCurveModel: kw.parametricCurves[0],
    ParameterDescription: kw.bFunctions.find(({ parameters }) => parameters.length > 0).parameters[0],
    BuiltinScene: kw.scenes[0],
    Trace: factors,
    TraceFrame: factors.frames[1],
    Drawing: kw.scene(kw.scenes[0].document).drawing(),
    // Triangles have normals and indices, labels an offset: all that a shape can have.
    Shape: Object.assign({}, ...kw.scene({
        knotwork: 1,
        objects: [{ type: 'parametric-surface', name: 'torus' },
            { type: 'bezier-curve', points: [[0, 0], [1, 1]], show: { labels: true } }],
    }).drawing({ tolerance: 0.1 }).shapes),
};

for (const [name, value] of Object.entries(values)) {
    test(`${name} has the names that are declared, and no others`, () => {
        assert.deepEqual(real(value), declared(name));
    });
}

test('the module exports what is declared, and nothing else', async () => {
    const runtime = Object.keys(await import(new URL('knotwork.mjs', distribution).href)).sort();
    const isValue = (symbol) => (symbol.flags & ts.SymbolFlags.Value) !== 0;
    assert.deepEqual(runtime, exported.filter(isValue).map(({ name }) => name).sort());
});

test('the fields of the schema have declared names only', () => {
    const known = declared('FieldDescription');
    for (const { document } of kw.scenes) {
        for (const { fields } of kw.scene(document).schema) {
            for (const field of fields) assert.deepEqual(Object.keys(field).filter((name) => !known.includes(name)), []);
        }
    }
});

test('all codes of the interface are declared', () => {
    const codes = checker.getDeclaredTypeOfSymbol(exported.find(({ name }) => name === 'ErrorCode'));
    assert.equal(codes.types.length, 18);
});
