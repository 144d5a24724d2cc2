// Nothing is left behind: handles and memory after many values, many refusals and collected garbage.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { test } from 'node:test';

import { allocatorSlack, distribution, load, refuses } from './support.mjs';

const kw = await load();
const cubic = { type: 'bspline-curve', degree: 3, points: Array.from({ length: 20 }, (_, i) => [i, (i * 7) % 5]) };
const blend = {
    type: 'blending-curve', bFunction: { family: 'expo-rational', beta: 2 },
    model: { type: 'parametric-curve', name: 'butterfly' }, locals: { count: 12 },
};
const patch = { type: 'bspline-surface', degree: [2, 1], points: [0, 1, 2].map((i) => [0, 1, 2].map((j) => [i, j, i * j])) };
const curveless = { scheme: 'chaikin', points: cubic.points, levels: 7 };
const solids = {
    knotwork: 1,
    objects: [
        { type: 'subdivision-surface', scheme: 'catmull-clark', levels: 3, mesh: { solid: 'cube' } },
        { type: 'parametric-surface', name: 'torus' }, cubic,
    ],
};
const scene = { knotwork: 1, objects: [cubic, blend], effects: [{ target: 'c1', kind: 'rotate' }] };

const lives = {
    'curves that are sampled': [10_000, () => {
        const curve = kw.curve(cubic);
        curve.sample(50);
        curve.dispose();
    }],
    'refined curves': [2000, () => {
        const curve = kw.curve(cubic);
        const refined = curve.insertKnot(0.5, 2);
        refined.basis(0.3, { derivatives: 2 });
        refined.polyline({ tolerance: 0.01 });
        refined.dispose();
        curve.dispose();
    }],
    'blending curves': [500, () => {
        const curve = kw.curve(blend);
        const posed = curve.withPose(3, { translate: [1, 0] });
        posed.sample(20);
        posed.dispose();
        curve.dispose();
    }],
    'subdivided polygons': [2000, () => {
        const curve = kw.curve({ type: 'subdivision-curve', scheme: 'four-point', points: cubic.points, levels: 3 });
        curve.limitTangents();
        kw.subdivide(curve.spec);
        curve.dispose();
        refuses(() => kw.subdivide({ ...curveless, into: new Float64Array(1) }), 'WRONG_LENGTH', 'into');
    }],
    'meshes': [10_000, () => {
        const mesh = kw.mesh({ solid: 'torus', parameters: { around: 5, across: 4 } });
        const again = kw.mesh({ vertices: mesh.vertices, faces: mesh.faces });
        again.vertexNormals();
        again.edges.at(-1);
        again.dispose();
        mesh.dispose();
    }],
    'exports that are dropped half way': [200, () => {
        const shown = kw.scene(solids);
        for (const format of /** @type {const} */ (['svg', 'obj', 'glb', 'gltf'])) {
            const work = shown.exporting(format);
            while (work.advance(500).fraction < 0.5);
            work.dispose();
        }
        shown.dispose();
    }],
    'meshes by their text': [2000, () => {
        const mesh = kw.mesh({ solid: 'cube' });
        const triangles = mesh.triangulated();
        triangles.indices.at(-1);
        kw.mesh({ obj: triangles.toObj() }).dispose();
        triangles.dispose();
        mesh.dispose();
    }],
    'subdivided meshes': [1000, () => {
        const mesh = kw.mesh({ solid: 'octahedron' });
        for (const scheme of ['catmull-clark', 'doo-sabin', 'loop', 'butterfly', 'sqrt3']) {
            const finer = mesh.subdivide(scheme, 2);
            finer.counts;
            finer.dispose();
        }
        mesh.limit('loop');
        refuses(() => mesh.subdivide('loop', 20), 'TOO_LARGE', 'levels');
        mesh.dispose();
    }],
    'refused meshes': [2000, () => {
        refuses(() => kw.mesh({ vertices: new Float64Array(12), faces: [[0, 1, 2], [0, 1, 3]] }), 'NOT_MANIFOLD', 'edges[0,1]');
        refuses(() => kw.mesh({ obj: 'v 0 0 0\nw' }), 'SYNTAX', 'obj');
    }],
    'surfaces with grids': [1000, () => {
        const surface = kw.surface(patch);
        const refined = surface.refine([[0, 0, 0, 0.5, 1, 1, 1], surface.spec.knots[1]]);
        refined.grid(9, 12);
        refined.curvatures(0.3, 0.3);
        refuses(() => kw.surface({ ...patch, weights: [[1]] }), 'WRONG_LENGTH', 'weights');
        refined.dispose();
        surface.dispose();
    }],
    'triangles of surfaces': [1000, () => {
        const triangle = kw.surface({ type: 'blending-triangle', locals: [patch, patch, patch] });
        triangle.grid(9, 12);
        triangle.local(1).dispose();
        refuses(() => kw.surface({ ...triangle.spec, locals: [patch, patch] }), 'WRONG_LENGTH', 'locals');
        triangle.dispose();
    }],
    'B-functions': [10_000, () => {
        const b = kw.bFunction({ family: 'logistic', c: 2 });
        b.sample(10);
        b.dispose();
    }],
    'scenes with a history': [300, () => {
        const one = kw.scene(scene);
        for (let i = 0; i < 5; ++i) one.execute({ move: 'objects[0].points[3]', by: [0.1, 0] });
        one.undo();
        one.drawing({ phase: 0.4, tolerance: 0.1 });
        one.dispose();
    }],
    'refused curves': [10_000, () => refuses(() => kw.curve({ ...cubic, degree: 0 }), 'OUT_OF_RANGE', 'degree')],
    'refused calls': [10_000, () => refuses(() => kw.bFunction({ family: 'no' }), 'UNKNOWN_NAME', 'family')],
};

for (const [name, [times, live]] of Object.entries(lives)) {
    test(`${times} lives of ${name} leave handles and memory as they were`, () => {
        for (let i = 0; i < 20; ++i) live();
        const [held, bytes] = [kw.session.held(), kw.session.memoryInUse()];
        for (let i = 0; i < times; ++i) live();
        assert.equal(kw.session.held(), held);
        assert.ok(Math.abs(kw.session.memoryInUse() - bytes) <= allocatorSlack, `${kw.session.memoryInUse()} bytes, ${bytes} before`);
    });
}

test('handles that were released do not name what comes after them', () => {
    const first = kw.scene({ knotwork: 1, objects: [] });
    const old = first.handle;
    first.dispose();
    const second = kw.scene({ knotwork: 1, objects: [] });
    assert.notEqual(second.handle, old);
    assert.equal(kw.session.sceneDocument(old), '');
    assert.equal(JSON.parse(kw.session.error()).code, 'DISPOSED');
    second.dispose();
});

test('what nobody refers to any more is released with the garbage', () => {
    const script = `
        const { load } = await import(${JSON.stringify(new URL('knotwork.mjs', distribution).href)});
        const kw = await load();
        for (let i = 0; i < 2000; ++i) kw.bFunction({ family: 'linear' });
        for (let i = 0; i < 20 && kw.session.held() > 100; ++i) {
            gc();
            await new Promise((resolve) => setTimeout(resolve, 10));
        }
        console.log(kw.session.held() <= 100 ? 'released' : kw.session.held());`;
    const printed = execFileSync(process.execPath, ['--expose-gc', '--input-type=module', '-e', script], { encoding: 'utf8' });
    assert.equal(printed.trim(), 'released');
});

test('a value that was disposed of is not released twice by the garbage', () => {
    const script = `
        const { load } = await import(${JSON.stringify(new URL('knotwork.mjs', distribution).href)});
        const kw = await load();
        for (let i = 0; i < 500; ++i) kw.bFunction({ family: 'linear' }).dispose();
        const kept = Array.from({ length: 300 }, () => kw.bFunction({ family: 'linear' }));
        for (let i = 0; i < 5; ++i) {
            gc();
            await new Promise((resolve) => setTimeout(resolve, 10));
        }
        console.log(kw.session.held(), kept.every((b) => b.value(0.5) === 0.5));`;
    const printed = execFileSync(process.execPath, ['--expose-gc', '--input-type=module', '-e', script], { encoding: 'utf8' });
    assert.equal(printed.trim(), '300 true');
});

test('the second identical call takes no more memory than the first', () => {
    const curve = kw.curve(cubic);
    const into = new Float64Array(3 * 200_000);
    const work = () => {
        curve.sample(200_000, { into });
        curve.polyline({ tolerance: 1e-5 });
    };
    work();
    const bytes = kw.session.memoryInUse();
    work();
    // The allocator gives a block a few bytes more where no other would fit into the rest.
    assert.ok(Math.abs(kw.session.memoryInUse() - bytes) <= 64);
    curve.dispose();
    assert.ok(kw.session.memoryInUse() < bytes);
});

test('subdividing a mesh takes at most three times the memory of the finished one', async () => {
    const { instantiate } = WebAssembly;
    /** @type {WebAssembly.Memory[]} */
    const memories = [];
    WebAssembly.instantiate = async (...given) => {
        const made = await instantiate(...given);
        memories.push(...Object.values((made.instance ?? made).exports).filter((one) => one instanceof WebAssembly.Memory));
        return made;
    };
    try {
        for (const [scheme, spec, levels] of [
            ['catmull-clark', { solid: 'cube' }, 9], ['loop', { solid: 'icosahedron' }, 8], ['doo-sabin', { solid: 'cube' }, 9],
            ['butterfly', { solid: 'icosahedron' }, 8], ['sqrt3', { solid: 'icosahedron' }, 10],
        ]) {
            const one = await load();
            const memory = memories.pop();
            const before = memory.buffer.byteLength;
            const mesh = one.mesh(spec).subdivide(scheme, levels);
            const taken = memory.buffer.byteLength - before;
            const corners = mesh.indices.length / 3 + 2 * mesh.counts.faces;
            const finished = 8 * mesh.vertices.length + 4 * corners;
            assert.ok(finished > 2 ** 24, `${scheme}: ${finished} bytes are too few to be judged`);
            assert.ok(taken <= 3 * finished, `${scheme} took ${taken / finished} times the mesh`);
        }
    } finally {
        WebAssembly.instantiate = instantiate;
    }
});

test('a module that ran out of memory says so ever after, and the next is fresh', async () => {
    const one = await load();
    const value = one.bFunction({ family: 'linear' });
    one.session.bFunction = () => { throw new WebAssembly.RuntimeError('unreachable'); };
    refuses(() => one.bFunction({ family: 'linear' }), 'OUT_OF_MEMORY', '');
    refuses(() => value.value(0.5), 'OUT_OF_MEMORY', '');
    value.dispose();
    assert.equal((await load()).bFunction({ family: 'linear' }).value(0.5), 0.5);
});
