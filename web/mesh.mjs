// Meshes as values. Their lists cross as whole blocks of memory, whatever their length.

import { choice, copyInto, integer, options, target, text } from './check.mjs';
import { describe, KnotworkError } from './errors.mjs';
import { Held } from './held.mjs';
import { packedFaces, packedVertices, sendMesh } from './mesh-input.mjs';

/** @typedef {import('./core.mjs').Core} Core */

/** In the order of MeshScheme. */
const schemes = /** @type {const} */ (['catmull-clark', 'doo-sabin', 'loop', 'butterfly', 'sqrt3']);

/** The core says which number of levels makes a mesh too large. */
const mostLevels = 1000;

/** Longer texts are refused before they are copied. */
const longestText = 2 ** 28;

export class Mesh extends Held {
    /** How many vertices, edges and faces there are, and edges with one face. */
    get counts() {
        const { core, handle } = Held.of(this);
        core.ask('meshCounts', handle);
        const [vertices, edges, faces, boundaryEdges] = core.block(0, 4);
        return { vertices, edges, faces, boundaryEdges };
    }

    /** x, y, z triples. */
    get vertices() {
        const { core, points, vertices } = partsOf(this);
        const copy = target(undefined, 3 * vertices);
        copyInto(copy, core.doubles(points, 3 * vertices), 0);
        return copy;
    }

    /** The vertices of each face, counter-clockwise seen from outside. */
    get faces() {
        return facesOf(this);
    }

    /** [v0, v1, f0, f1] each: face f0 goes from v0 to v1, f1 back; −1 where there is none. */
    get edges() {
        const { core, handle } = Held.of(this);
        core.ask('meshCounts', handle);
        const count = core.number(1);
        const flat = core.indices(core.number(4), 4 * count);
        const edges = new Array(count);
        for (let e = 0, at = 0; e < count; ++e, at += 4) {
            edges[e] = [flat[at], flat[at + 1], flat[at + 2], flat[at + 3] | 0];
        }
        return edges;
    }

    /** Its creases, with what is left of their sharpness. */
    get creases() {
        const { core, handle } = Held.of(this);
        return core.json('meshCreases', handle);
    }

    /** Three vertices for each triangle that the faces can be cut into. */
    get indices() {
        const { core, handle } = Held.of(this);
        const count = 3 * core.count('meshTriangles', handle);
        const indices = core.indices(core.call('bulkIndices'), count).slice();
        core.call('dropBulk');
        return indices;
    }

    /** A unit normal for every vertex; zero for those without faces. @param {{ into?: Float64Array }} [given] */
    vertexNormals(given) {
        const { core, vertices } = partsOf(this);
        const normals = target(options(given, ['into']).into, 3 * vertices);
        core.count('meshNormals', Held.of(this).handle);
        copyInto(normals, core.bulkView(3 * vertices), 0);
        core.call('dropBulk');
        return normals;
    }

    /** A finer mesh: `levels` steps of a scheme. @param {string} scheme @param {number} [levels] */
    subdivide(scheme, levels = 1) {
        const { core, handle } = Held.of(this);
        const index = schemeIndex(scheme);
        const count = integer(levels, 'levels', 0, mostLevels, 'TOO_LARGE');
        return new Mesh(core, core.ask('meshSubdivided', handle, index, count));
    }

    /** Where a scheme moves the vertices in the end, and the normals there. @param {string} scheme */
    limit(scheme) {
        const { core, handle } = Held.of(this);
        const count = 3 * core.count('meshLimit', handle, schemeIndex(scheme));
        const numbers = core.bulkView(2 * count);
        const limit = { positions: target(undefined, count), normals: target(undefined, count) };
        copyInto(limit.positions, numbers.subarray(0, count), 0);
        copyInto(limit.normals, numbers.subarray(count), 0);
        core.call('dropBulk');
        return limit;
    }

    /** What a scheme makes of meshes. @param {string} scheme */
    classification(scheme) {
        return Held.of(this).core.json('meshClassification', schemeIndex(scheme));
    }

    /** The same vertices with every face cut into triangles. */
    triangulated() {
        const { core, handle } = Held.of(this);
        return new Mesh(core, core.ask('meshTriangulated', handle));
    }

    /** The text of an OBJ file, which reads back as the same mesh. */
    toObj() {
        const { core, handle } = Held.of(this);
        return core.ask('meshObj', handle);
    }

    /** What makes it again: the solid that it is, or vertices and faces. */
    get spec() {
        const { core, handle } = Held.of(this);
        const spec = core.json('meshSpec', handle);
        if (spec !== null) return spec;
        const creases = core.json('meshCreases', handle);
        const { points, vertices } = partsOf(this);
        const lists = { vertices: rowsOf(core.doubles(points, 3 * vertices), vertices), faces: facesOf(this) };
        return creases.length > 0 ? { ...lists, creases } : lists;
    }
}

/** @param {unknown} scheme */
const schemeIndex = (scheme) => schemes.indexOf(choice(scheme, 'scheme', schemes));

/**
 * How large a mesh is, and where in memory its lists are.
 * @param {Mesh} mesh
 */
function partsOf(mesh) {
    const { core, handle } = Held.of(mesh);
    core.ask('meshParts', handle);
    const [vertices, faces, corners, size, points, indices, starts] = core.block(0, 7);
    return { core, vertices, faces, corners, size, points, indices, starts };
}

/**
 * @param {Mesh} mesh
 * @returns {number[][]}
 */
function facesOf(mesh) {
    const { core, faces, corners, size, indices, starts } = partsOf(mesh);
    const flat = core.indices(indices, corners);
    const firsts = size > 0 ? undefined : core.indices(starts, faces + 1);
    const lists = new Array(faces);
    for (let f = 0, at = 0; f < faces; ++f) {
        const end = firsts ? firsts[f + 1] : at + size;
        const face = new Array(end - at);
        for (let j = 0; at < end; ++at, ++j) face[j] = flat[at];
        lists[f] = face;
    }
    return lists;
}

/** @param {Float64Array} flat @param {number} count */
function rowsOf(flat, count) {
    const rows = new Array(count);
    for (let i = 0; i < count; ++i) rows[i] = [flat[3 * i], flat[3 * i + 1], flat[3 * i + 2]];
    return rows;
}

/** @param {Core} core @param {unknown} given */
export function makeMesh(core, given) {
    if (typeof given !== 'object' || given === null) throw noMesh(given);
    const fields = options(given, ['vertices', 'faces', 'creases', 'solid', 'parameters', 'obj']);
    const { vertices, faces, creases, solid, parameters, obj } = fields;
    if (solid !== undefined) {
        alone(fields, ['solid', 'parameters', 'creases']);
        return new Mesh(core, core.ask('mesh', core.send({ solid, parameters, creases })));
    }
    if (obj !== undefined) {
        alone(fields, ['obj']);
        return new Mesh(core, fromObj(core, text(obj, 'obj')));
    }
    alone(fields, ['vertices', 'faces', 'creases']);
    if (vertices === undefined && faces === undefined) throw noMesh(given);
    // A list of the caller's own numbers is read last, when no code of theirs can change it any more.
    const rows = packedFaces(faces);
    sendMesh(core, packedVertices(vertices), rows);
    const mesh = new Mesh(core, core.ask('meshFromRoom'));
    return creases === undefined ? mesh : creased(mesh, creases);
}

/**
 * The mesh with creases, in its place.
 * @param {Mesh} mesh
 * @param {unknown} creases
 */
function creased(mesh, creases) {
    const { core, handle } = Held.of(mesh);
    try {
        return new Mesh(core, core.ask('meshCreased', handle, core.send({ creases })));
    } finally {
        mesh.dispose();
    }
}

/** @param {Core} core @param {string} obj */
function fromObj(core, obj) {
    if (obj.length > longestText) {
        throw new KnotworkError('TOO_LARGE', 'obj', `The text has ${obj.length} characters; at most ${longestText} are read.`);
    }
    core.sendText(obj);
    return core.ask('meshFromText');
}

/** @param {Record<string, unknown>} fields @param {string[]} known */
function alone(fields, known) {
    for (const name of Object.keys(fields)) {
        if (fields[name] === undefined || known.includes(name)) continue;
        throw new KnotworkError('UNKNOWN_FIELD', name,
            `A mesh is given by one of vertices and faces, solid, or obj; ${name} does not go with ${known[0]}.`);
    }
}

/** @param {unknown} given */
function noMesh(given) {
    return new KnotworkError('WRONG_TYPE', '',
        `A mesh is { vertices, faces } or { solid: 'cube' } or { obj: text }, not ${describe(given)}.`);
}
