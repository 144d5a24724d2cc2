// Vertices and faces on their way into the core: checked one by one and packed, since there may be
// millions of them.

import {
    copyInto, isFloat64Array, lengthOfNumbers, point,
} from './check.mjs';
import { describe, KnotworkError, reading } from './errors.mjs';

/** What the core allows: vertices, and the corners of all faces together. */
const mostVertices = 4_000_000;
const mostCorners = 2 ** 25;

/**
 * A list that grows by doubling: nobody's word is taken for how many numbers come.
 * @template {Float64Array | Uint32Array} T
 */
class Packed {
    /** @type {T} */
    #numbers;
    #length = 0;

    /** @param {T} first room to begin with */
    constructor(first) {
        this.#numbers = first;
    }

    get length() {
        return this.#length;
    }

    /** @param {number} number */
    add(number) {
        if (this.#length === this.#numbers.length) this.#grow();
        this.#numbers[this.#length++] = number;
    }

    /** What was added, as a view. */
    get all() {
        return /** @type {T} */ (this.#numbers.subarray(0, this.#length));
    }

    #grow() {
        const { constructor } = /** @type {any} */ (this.#numbers);
        try {
            const grown = new constructor(2 * this.#length);
            grown.set(this.#numbers);
            this.#numbers = grown;
        } catch {
            throw new KnotworkError('OUT_OF_MEMORY', '', `There is no room for ${2 * this.#length} numbers.`);
        }
    }
}

/**
 * Points as x, y, z triples: the caller's Float64Array itself, or a copy of a list.
 * @param {unknown} value
 * @returns {Float64Array}
 */
export function packedVertices(value) {
    if (isFloat64Array(value)) return checkedTriples(value, lengthOfNumbers(value));
    return reading(() => 'vertices', () => {
        if (!Array.isArray(value)) throw notAList('vertices', 'points, or a Float64Array of x, y, z triples', value);
        const count = checkedLength(value.length, typeof value[0] === 'number' ? 3 * mostVertices : mostVertices, 'vertices');
        const packed = new Packed(new Float64Array(1024));
        if (typeof value[0] === 'number') {
            for (let i = 0; i < count; ++i) packed.add(numberIn(value[i], i));
            return checkedTriples(packed.all, packed.length);
        }
        for (let i = 0; i < count; ++i) addPoint(packed, value[i], i);
        return packed.all;
    });
}

/** @param {Float64Array} numbers @param {number} length */
function checkedTriples(numbers, length) {
    if (length % 3 !== 0) {
        throw new KnotworkError('WRONG_LENGTH', 'vertices',
            `vertices has ${length} numbers; a flat list holds x, y, z triples.`);
    }
    checkedLength(length / 3, mostVertices, 'vertices');
    return numbers;
}

/**
 * NaN and infinities pass: the core says which vertex has them.
 * @param {Packed<Float64Array>} packed
 * @param {unknown} given
 * @param {number} i
 */
function addPoint(packed, given, i) {
    if (Array.isArray(given)) {
        const { length } = given;
        const [x, y, z] = length === 2 ? [given[0], given[1], 0] : [given[0], given[1], given[2]];
        if ((length === 2 || length === 3) && typeof x === 'number' && typeof y === 'number' && typeof z === 'number') {
            packed.add(x);
            packed.add(y);
            packed.add(z);
            return;
        }
    }
    for (const coordinate of point(given, `vertices[${i}]`)) packed.add(coordinate);
}

/** @param {unknown} value @param {number} i */
function numberIn(value, i) {
    if (typeof value === 'number') return value;
    throw new KnotworkError('WRONG_TYPE', `vertices[${i}]`, `vertices[${i}] must be a number, not ${describe(value)}.`);
}

/**
 * Faces as compressed rows: where each begins in the list of all corners.
 * @param {unknown} value
 * @returns {{ starts: Uint32Array, corners: Uint32Array }}
 */
export function packedFaces(value) {
    return reading(() => 'faces', () => {
        if (!Array.isArray(value)) throw notAList('faces', 'faces, each a list of vertices', value);
        const count = checkedLength(value.length, mostCorners, 'faces');
        const starts = new Packed(new Uint32Array(1024));
        const corners = new Packed(new Uint32Array(4096));
        starts.add(0);
        for (let f = 0; f < count; ++f) {
            addFace(corners, value[f], f);
            starts.add(corners.length);
        }
        return { starts: starts.all, corners: corners.all };
    });
}

/** @param {Packed<Uint32Array>} corners @param {unknown} face @param {number} f */
function addFace(corners, face, f) {
    if (!Array.isArray(face)) throw notAList(`faces[${f}]`, 'the numbers of vertices', face);
    const size = face.length;
    checkedLength(corners.length + size, mostCorners, 'faces');
    for (let j = 0; j < size; ++j) {
        const index = face[j];
        if (typeof index !== 'number' || index >>> 0 !== index) throw noIndex(index, `faces[${f}][${j}]`);
        corners.add(index);
    }
}

/** @param {unknown} length @param {number} most @param {string} name */
function checkedLength(length, most, name) {
    if (typeof length !== 'number' || !Number.isInteger(length) || length < 0) {
        throw new KnotworkError('WRONG_TYPE', name, `The length of ${name} must be a whole number.`);
    }
    if (length <= most) return length;
    throw new KnotworkError('TOO_LARGE', name,
        `${name} has ${length} entries; a mesh has at most ${mostVertices} vertices and ${mostCorners} corners of faces.`);
}

/** @param {string} path @param {string} of @param {unknown} value */
function notAList(path, of, value) {
    return new KnotworkError('WRONG_TYPE', path, `Give an array of ${of} here, not ${describe(value)}.`);
}

/** @param {unknown} index @param {string} path */
function noIndex(index, path) {
    const allowed = 'a face names vertices by their numbers, counted from 0.';
    if (typeof index !== 'number') {
        return new KnotworkError('WRONG_TYPE', path, `This is ${describe(index)}; ${allowed}`);
    }
    const code = !Number.isFinite(index) ? 'NOT_FINITE' : Number.isInteger(index) ? 'OUT_OF_RANGE' : 'NOT_INTEGER';
    return new KnotworkError(code, path, `The index is ${index}; ${allowed}`);
}

/**
 * Leaves a mesh where `meshFromRoom` takes it over.
 * @param {import('./core.mjs').Core} core
 * @param {Float64Array} vertices
 * @param {{ starts: Uint32Array, corners: Uint32Array }} faces
 */
export function sendMesh(core, vertices, { starts, corners }) {
    const length = lengthOfNumbers(vertices);
    core.ask('meshRoom', length / 3, starts.length - 1, corners.length);
    const [points, firsts, indices] = core.block(0, 3);
    copyInto(core.doubles(points, length), vertices, 0);
    core.indices(firsts, starts.length).set(starts);
    core.indices(indices, corners.length).set(corners);
}
