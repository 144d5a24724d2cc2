// Part 7 of the interface: algorithms step by step.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { fractions, inSpace, load, near, randomKnots, randomness, refuses, tolerances, truth } from './support.mjs';

const kw = await load();

const quadratic = {
    type: 'bspline-curve', degree: 2, points: fractions(truth.quad_curve.ctrl), knots: truth.quad_curve.knots.map(Number),
};
const square = [[0, 0], [1, 0], [1, 1], [0, 1]];
const blending = {
    type: 'blending-curve', bFunction: { family: 'expo-rational' }, form: 'closed', locals: { count: 5 },
    model: { type: 'parametric-curve', name: 'butterfly' }, poses: [{ local: 2, translate: [1, 0.5, 0.25] }],
};

/** What is wrong with an XML text that has no declarations, comments or CDATA; '' for nothing. */
function malformed(xml) {
    const open = [];
    let roots = 0;
    const rest = xml.replace(/<(\/?)([a-z]+)((?: [a-z]+="[^"<&]*")*)>|([^<&>]+)|&(?:lt|gt|amp);/g, (_, close, name, attributes, text) => {
        if (name === undefined) return open.length > 0 || text === undefined ? '' : `text outside: ${text}`;
        if (close === '') {
            if (open.length === 0) roots += 1;
            open.push(name);
            return '';
        }
        return open.pop() === name && attributes === '' ? '' : `stray </${name}>`;
    });
    if (rest !== '') return rest;
    return roots === 1 && open.length === 0 ? '' : `open: ${open.join(' ')}`;
}

/** How many children each of these elements of MathML has. */
const arity = { mfrac: 2, msub: 2, msup: 2, msubsup: 3 };

/** Elements with another number of children than theirs. */
function wrongChildren(xml) {
    const wrong = [];
    const stack = [{ name: '', children: 0 }];
    for (const [, close, name] of xml.matchAll(/<(\/?)([a-z]+)[^>]*>/g)) {
        if (close === '') {
            stack.at(-1).children += 1;
            stack.push({ name, children: 0 });
        } else {
            const { children } = stack.pop();
            if (name in arity && children !== arity[name]) wrong.push(`${name} has ${children}`);
        }
    }
    return wrong;
}

/** Makes a trace and checks what holds for every frame. */
function trace(given) {
    const made = kw.trace(given);
    assert.equal(made.algorithm, given.algorithm);
    assert.deepEqual(Object.keys(made), ['algorithm', 'frames']);
    assert.ok(made.frames.length > 0);
    for (const frame of made.frames) checkFrame(frame);
    return made.frames;
}

function checkFrame(frame) {
    assert.ok(frame.title.length > 3 && frame.text.length > 20, frame.text);
    assert.match(frame.text, /^[A-Z].*[^.]\.$/);
    assert.doesNotMatch(frame.title + frame.text, /[{}]|NaN|Infinity|undefined|null|-0\b(?!\.)/);
    for (const point of frame.points) {
        assert.equal(point.length, 3);
        assert.ok(point.every(Number.isFinite));
    }
    const valid = (i) => Number.isInteger(i) && i >= 0 && i < frame.points.length;
    for (const edge of frame.edges) assert.ok(edge.length === 2 && edge.every(valid) && edge[0] !== edge[1]);
    assert.ok(frame.marked.every(valid));
    assert.ok((frame.weights ?? []).every(Number.isFinite));
    assert.ok((frame.matrix ?? []).every((row) => row.length === frame.matrix[0].length && row.every(Number.isFinite)));
    if (frame.formula !== undefined) {
        assert.ok(frame.formula.startsWith('<math xmlns="http://www.w3.org/1998/Math/MathML"'));
        assert.equal(malformed(frame.formula), '');
        assert.deepEqual(wrongChildren(frame.formula), []);
    }
    assert.match(frame.key, /^[a-z-]+\.[a-z-]+$/);
    assert.ok(Object.values(frame.values).every((value) => typeof value === 'string' && value !== ''));
}

const lastPoint = (frames) => frames.at(-1).points.at(-1);

/** Random splines of all forms, rational or not, each with parameters at its knots, ends and between. */
function eachSpline(seed, act) {
    const random = randomness(seed);
    for (let i = 0; i < 30; ++i) {
        const degree = random.integer(1, 6);
        const count = random.integer(degree + 1, degree + 8);
        const spec = { type: 'bspline-curve', degree, points: random.points(count, 2 + (i % 2)) };
        if (i % 3 === 0) spec.form = ['open', 'closed', 'clamped'][(i / 3) % 3];
        else spec.knots = randomKnots(random, degree, count);
        if (i % 4 === 0) spec.weights = spec.points.map(() => random.between(0.3, 3));
        if (spec.form === 'closed' && count <= degree) continue;
        const curve = kw.curve(spec);
        const [a, b] = curve.domain;
        const inner = curve.knots.filter((knot) => a <= knot && knot <= b);
        act(curve, [a, b, ...inner, random.between(a, b), random.between(a, b)]);
    }
}

test('the checkers of formulae see what is wrong', () => {
    assert.equal(malformed('<a><b>x &lt; y</b></a>'), '');
    for (const bad of ['<a><b></a></b>', '<a>', '<a></a><a></a>', '<a>&</a>', '<a>&nbsp;</a>', 'x<a></a>', '<a x=1></a>']) {
        assert.notEqual(malformed(bad), '', bad);
    }
    assert.deepEqual(wrongChildren('<mfrac><mi>a</mi></mfrac>'), ['mfrac has 1']);
});

test('de Boor, Cox–de Boor and the factor matrices end with the point of the curve', () => {
    eachSpline(71, (curve, parameters) => {
        for (const t of parameters) {
            for (const [algorithm, frames] of [['de-boor', 1], ['cox-de-boor', 1], ['factor-matrices', 2]]) {
                const found = trace({ algorithm, curve: curve.spec, t });
                assert.equal(found.length, curve.spec.degree + frames);
                near(lastPoint(found), curve.point(t), 4e-14, `${algorithm} at ${t}`);
            }
        }
    });
});

test('Cox–de Boor ends with the values of the basis, the factors multiply to them', () => {
    eachSpline(72, (curve, parameters) => {
        for (const t of parameters) {
            const [values] = curve.basis(t);
            near(trace({ algorithm: 'cox-de-boor', curve: curve.spec, t }).at(-1).weights, values, tolerances.exact);
            const factors = trace({ algorithm: 'factor-matrices', curve: curve.spec, t })
                .flatMap(({ matrix }) => (matrix ? [matrix] : []));
            const times = (row, matrix) => matrix[0].map((_, c) => row.reduce((sum, one, r) => sum + one * matrix[r][c], 0));
            const present = (row) => row.filter((one) => one > 1e-13).sort((a, b) => a - b);
            near(present(factors.reduce(times, [1])), present(values), tolerances.exact);
        }
    });
});

test('Boehm ends with the points of insertKnot and is refused as it is', () => {
    eachSpline(73, (curve, parameters) => {
        for (const knot of parameters) {
            let refined;
            try {
                refined = curve.insertKnot(knot);
            } catch (error) {
                refuses(() => kw.trace({ algorithm: 'boehm', curve: curve.spec, knot }), error.code, 'knot');
                continue;
            }
            const frames = trace({ algorithm: 'boehm', curve: curve.spec, knot });
            near(frames.at(-1).points, refined.spec.points.map(inSpace), tolerances.exact);
        }
    });
});

test('Oslo ends with the matrix and the points of the truth', () => {
    const { to, alpha, ctrl } = truth.oslo_quad;
    const frames = trace({ algorithm: 'oslo', curve: quadratic, knots: fractions([to])[0] });
    assert.equal(frames.length, alpha.length + 2);
    near(frames.at(-1).matrix, fractions(alpha), tolerances.exact);
    near(frames.at(-1).points, fractions(ctrl).map(inSpace), tolerances.exact);
});

test('Lane–Riesenfeld and the four-point scheme end with the rings of the truth', () => {
    const sameRing = (found, ring) => ring.some((_, shift) => found.length === ring.length
        && found.every((point, i) => point.every((x, axis) => Math.abs(x - (ring[(i + shift) % ring.length][axis] ?? 0)) <= 1e-14)));
    for (const degree of [1, 2, 3]) {
        const frames = trace({ algorithm: 'lane-riesenfeld', points: square, closed: true, degree, levels: 1 });
        assert.equal(frames.length, 2 + degree);
        assert.ok(sameRing(frames.at(-1).points, fractions(truth.LR[`d${degree}_k1`]).slice(0, -1)), `degree ${degree}`);
    }
    const frames = trace({ algorithm: 'four-point', points: square, closed: true });
    assert.ok(sameRing(frames.at(-1).points, fractions(truth.fourpoint_sq.k1)));
});

test('levels, degree, tension and form have defaults', () => {
    const points = [[0, 0], [1, 0], [2, 1], [3, 1], [4, 0]];
    assert.deepEqual(trace({ algorithm: 'lane-riesenfeld', points }),
        trace({ algorithm: 'lane-riesenfeld', points, closed: false, degree: 3, levels: 1 }));
    assert.deepEqual(trace({ algorithm: 'four-point', points: Float64Array.from(points.flatMap(inSpace)) }),
        trace({ algorithm: 'four-point', points, closed: false, tension: 1 / 16, levels: 1 }));
});

test('a blend ends with the point of the curve', () => {
    const curve = kw.curve(blending);
    for (const t of [...curve.knots, 1, 7.3, 20, 36]) {
        const frames = trace({ algorithm: 'blend', curve: blending, t });
        near(lastPoint(frames), curve.point(t), tolerances.exact * 8);
        near(frames.at(-1).weights, [1 - frames.at(-1).weights[1], frames.at(-1).weights[1]], 0);
    }
});

test('a blend of patches ends with the point of the surface, and its weights make it', () => {
    const surface = {
        type: 'blending-surface', bFunction: [{ family: 'expo-rational' }, { family: 'linear' }], locals: [4, 3], kind: 'bezier',
        model: { type: 'parametric-surface', name: 'torus' }, poses: [{ local: [0, 1], translate: [0, 0, 1], scale: 2 }],
    };
    const made = kw.surface(surface);
    for (const [u, v] of [[0, 0], [0.3, 2], [6, 6], [2 * Math.PI, 1], [3, 2 * Math.PI]]) {
        const frames = trace({ algorithm: 'blend', surface, u, v });
        assert.equal(frames.length, 5);
        near(lastPoint(frames), made.point(u, v), tolerances.exact * 16);
        const { weights, matrix } = frames[2];
        near(matrix.flat(), weights, 0);
        const four = frames[3].marked.map((i) => frames[3].points[i]);
        near([0, 1, 2].map((axis) => four.reduce((sum, point, k) => sum + weights[k] * point[axis], 0)), lastPoint(frames),
            tolerances.exact * 16);
    }
    refuses(() => kw.trace({ algorithm: 'blend', surface: surface.model, u: 0, v: 0 }), 'NOT_SUPPORTED', 'surface.type');
    refuses(() => kw.trace({ algorithm: 'blend', surface, u: 0 }), 'WRONG_TYPE', 'v');
    refuses(() => kw.trace({ algorithm: 'blend', surface, u: 0, v: 0, t: 0 }), 'UNKNOWN_FIELD', 't');
});

test('Catmull–Clark ends with the finer mesh, and its matrix makes it', () => {
    const mesh = { solid: 'cube' };
    const frames = trace({ algorithm: 'catmull-clark', mesh, levels: 2 });
    assert.equal(frames.length, 9);
    const finer = kw.mesh(mesh).subdivide('catmull-clark', 2);
    assert.deepEqual(frames.at(-1).points.flat(), [...finer.vertices]);
    assert.equal(frames.at(-1).edges.length, finer.counts.edges);
    const { matrix, points } = frames[4];
    near(matrix.map((row) => [0, 1, 2].map((axis) => row.reduce((sum, w, i) => sum + w * frames[0].points[i][axis], 0))),
        points, tolerances.exact);
    assert.deepEqual(trace({ algorithm: 'catmull-clark', mesh }), trace({ algorithm: 'catmull-clark', mesh, levels: 1 }));
});

test('sentences say the numbers of their step', () => {
    const [begin, level, result] = trace({ algorithm: 'de-boor', curve: quadratic, t: 2 });
    assert.match(begin.text, /parameter 2 lies between the knots 1 and 3; .* 3 of the 5 control points .* number 1 to number 3/);
    assert.match(level.text, /0\.6667 and 0\.3333, and leaves 2 points, \(2\.333, 2\.667\) and \(3\.667, 2\)/);
    assert.match(result.text, /with 0\.5 of the second point, gives the point of the curve at 2, \(3, 2\.333\)/);
    assert.equal(level.values.ratios, '0.6667 and 0.3333');
});

test('the same question has the same answer', () => {
    const given = { algorithm: 'cox-de-boor', curve: quadratic, t: 1.3 };
    assert.deepEqual(kw.trace(given), kw.trace(given));
});

test('refusals name what is wrong and where', () => {
    const bad = (given, code, path) => refuses(() => kw.trace(given), code, path);
    const names = bad({ algorithm: 'doo-sabin', mesh: { solid: 'cube' }, levels: 1 }, 'UNKNOWN_NAME', 'algorithm');
    assert.match(names.message, /de-boor, cox-de-boor, factor-matrices, boehm, oslo, lane-riesenfeld, four-point, blend/);
    bad(undefined, 'WRONG_TYPE', '');
    bad('de-boor', 'WRONG_TYPE', '');
    bad({}, 'WRONG_TYPE', 'algorithm');
    bad({ algorithm: 'toString' }, 'UNKNOWN_NAME', 'algorithm');
    bad({ algorithm: 'de-boor', t: 1 }, 'WRONG_TYPE', 'curve');
    bad({ algorithm: 'de-boor', curve: kw.curve(quadratic), t: 1 }, 'WRONG_TYPE', 'curve');
    bad({ algorithm: 'de-boor', curve: quadratic }, 'WRONG_TYPE', 't');
    bad({ algorithm: 'de-boor', curve: quadratic, t: NaN }, 'NOT_FINITE', 't');
    bad({ algorithm: 'de-boor', curve: quadratic, t: 4.1 }, 'OUT_OF_RANGE', 't');
    bad({ algorithm: 'de-boor', curve: quadratic, t: 1, side: 'left' }, 'UNKNOWN_FIELD', 'side');
    bad({ algorithm: 'de-boor', curve: { ...quadratic, points: [[0, 0], [1, 1], [2, NaN]] }, t: 1 }, 'NOT_FINITE', 'curve.points[2][1]');
    bad({ algorithm: 'de-boor', curve: blending, t: 1 }, 'NOT_SUPPORTED', 'curve.type');
    bad({ algorithm: 'blend', curve: quadratic, t: 1 }, 'NOT_SUPPORTED', 'curve.type');
    bad({ algorithm: 'boehm', curve: quadratic, knot: 0 }, 'KNOTS_MULTIPLICITY', 'knot');
    bad({ algorithm: 'oslo', curve: quadratic, knots: [0, 0, 0, 2, 3, 4, 4, 4] }, 'KNOTS_MULTIPLICITY', 'knots[3]');
    bad({ algorithm: 'oslo', curve: quadratic, knots: [0, 0, 0, 1, Infinity] }, 'NOT_FINITE', 'knots[4]');
    bad({ algorithm: 'lane-riesenfeld', points: square, closed: 1 }, 'WRONG_TYPE', 'closed');
    bad({ algorithm: 'lane-riesenfeld', points: square, levels: 23 }, 'TOO_LARGE', 'levels');
    bad({ algorithm: 'lane-riesenfeld', points: square, closed: true, levels: 20 }, 'TOO_LARGE', 'levels');
    bad({ algorithm: 'four-point', points: [[0, 0]] }, 'WRONG_LENGTH', 'points');
});
