// Catmull–Clark as a careful programmer writes it in JavaScript: flat lists, edges found with a hash
// table of pairs of vertices, nothing but typed arrays. Closed meshes of quads.

/**
 * The edge of each corner, by open addressing: pairs of vertices as one number.
 * @param {Uint32Array} quads
 * @param {number} vertexCount
 */
function findEdges(quads, vertexCount) {
    const edgeCount = quads.length / 2;
    const size = 2 ** Math.ceil(Math.log2(2 * edgeCount));
    const keys = new Float64Array(size).fill(-1);
    const slots = new Uint32Array(size);
    const cornerEdges = new Uint32Array(quads.length);
    const ends = new Uint32Array(2 * edgeCount);
    let found = 0;
    for (let corner = 0; corner < quads.length; ++corner) {
        const a = quads[corner];
        const b = quads[(corner & 3) === 3 ? corner - 3 : corner + 1];
        const low = a < b ? a : b;
        const high = a < b ? b : a;
        const key = low * vertexCount + high;
        let slot = (Math.imul(low, 0x9e3779b1) ^ Math.imul(high, 0x85ebca6b)) >>> 0 & (size - 1);
        while (keys[slot] !== key && keys[slot] !== -1) slot = (slot + 1) & (size - 1);
        if (keys[slot] === -1) {
            keys[slot] = key;
            slots[slot] = found;
            ends[2 * found] = a;
            ends[2 * found + 1] = b;
            found += 1;
        }
        cornerEdges[corner] = slots[slot];
    }
    return { cornerEdges, ends, edgeCount };
}

/** @typedef {{ positions: Float64Array, quads: Uint32Array }} Mesh */

/** @param {Mesh} mesh @returns {Mesh} */
function level({ positions, quads }) {
    const vertexCount = positions.length / 3;
    const faceCount = quads.length / 4;
    const { cornerEdges, ends, edgeCount } = findEdges(quads, vertexCount);
    const firstFace = vertexCount;
    const firstEdge = vertexCount + faceCount;
    const finer = new Float64Array(3 * (firstEdge + edgeCount));
    const valences = new Uint8Array(vertexCount);
    for (let axis = 0; axis < 3; ++axis) {
        for (let f = 0; f < faceCount; ++f) {
            const middle = (positions[3 * quads[4 * f] + axis] + positions[3 * quads[4 * f + 1] + axis]
                + positions[3 * quads[4 * f + 2] + axis] + positions[3 * quads[4 * f + 3] + axis]) / 4;
            finer[3 * (firstFace + f) + axis] = middle;
            for (let k = 0; k < 4; ++k) {
                finer[3 * (firstEdge + cornerEdges[4 * f + k]) + axis] += middle / 4;
                finer[3 * quads[4 * f + k] + axis] += middle;
                if (axis === 0) valences[quads[4 * f + k]] += 1;
            }
        }
        for (let e = 0; e < edgeCount; ++e) {
            const a = positions[3 * ends[2 * e] + axis];
            const b = positions[3 * ends[2 * e + 1] + axis];
            finer[3 * (firstEdge + e) + axis] += (a + b) / 4;
            finer[3 * ends[2 * e] + axis] += a + b;
            finer[3 * ends[2 * e + 1] + axis] += a + b;
        }
        for (let v = 0; v < vertexCount; ++v) {
            const n = valences[v];
            // The sum so far: of the middles of faces, and twice the middles of edges.
            finer[3 * v + axis] = (finer[3 * v + axis] / n + (n - 3) * positions[3 * v + axis]) / n;
        }
    }
    return { positions: finer, quads: finerQuads(quads, cornerEdges, firstFace, firstEdge) };
}

/** @param {Uint32Array} quads @param {Uint32Array} cornerEdges @param {number} firstFace @param {number} firstEdge */
function finerQuads(quads, cornerEdges, firstFace, firstEdge) {
    const finer = new Uint32Array(4 * quads.length);
    for (let corner = 0; corner < quads.length; ++corner) {
        const before = (corner & 3) === 0 ? corner + 3 : corner - 1;
        finer[4 * corner] = quads[corner];
        finer[4 * corner + 1] = firstEdge + cornerEdges[corner];
        finer[4 * corner + 2] = firstFace + (corner >> 2);
        finer[4 * corner + 3] = firstEdge + cornerEdges[before];
    }
    return finer;
}

/** @param {Mesh} mesh @param {number} levels */
export function catmullClark(mesh, levels) {
    let finer = mesh;
    for (let i = 0; i < levels; ++i) finer = level(finer);
    return finer;
}
