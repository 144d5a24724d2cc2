// Who evaluates grids of B-spline surfaces, each in the fastest way that it documents.
import { nurbs } from './packages.mjs';

/**
 * A clamped surface without weights.
 * @typedef {{ degrees: [number, number], knots: [number[], number[]], points: number[][][] }} SplineSurface
 * @typedef {{ positions: Float64Array, normals: Float64Array }} Arrays
 * One way: `make` builds a surface; what it returns fills a grid of nu × nv.
 * @typedef {(nu: number, nv: number, into: Arrays) => void} Gridder
 * @typedef {{ name: string, make: (surface: SplineSurface) => Gridder }} Peer
 */

/** @param {number} degree @param {number[]} knots @returns {[number, number]} */
const domainOf = (degree, knots) => [knots[degree], knots[knots.length - 1 - degree]];

/** @type {Peer} */
export const nurbsSurface = {
    name: 'nurbs',
    make({ degrees, knots, points }) {
        const surface = nurbs({ points, degree: degrees, knots });
        const along = surface.evaluator([1, 0]);
        const across = surface.evaluator([0, 1]);
        const [u0, u1] = domainOf(degrees[0], knots[0]);
        const [v0, v1] = domainOf(degrees[1], knots[1]);
        const s = [0, 0, 0];
        const a = [0, 0, 0];
        const b = [0, 0, 0];
        return (nu, nv, { positions, normals }) => {
            for (let i = 0, at = 0; i < nu; ++i) {
                const u = u0 + (u1 - u0) * i / (nu - 1);
                for (let j = 0; j < nv; ++j, at += 3) {
                    const v = v0 + (v1 - v0) * j / (nv - 1);
                    surface.evaluate(s, u, v);
                    along(a, u, v);
                    across(b, u, v);
                    const x = a[1] * b[2] - a[2] * b[1];
                    const y = a[2] * b[0] - a[0] * b[2];
                    const z = a[0] * b[1] - a[1] * b[0];
                    const inverse = 1 / Math.sqrt(x * x + y * y + z * z);
                    positions[at] = s[0];
                    positions[at + 1] = s[1];
                    positions[at + 2] = s[2];
                    normals[at] = x * inverse;
                    normals[at + 1] = y * inverse;
                    normals[at + 2] = z * inverse;
                }
            }
        };
    },
};

/**
 * The functions that live at each of `count` parameters: values and derivatives, d + 1 each, and the
 * first point that they belong to.
 * @param {number} degree
 * @param {number[]} knots
 * @param {number} count
 */
function basisTable(degree, knots, count) {
    const [start, end] = domainOf(degree, knots);
    const terms = degree + 1;
    const table = { values: new Float64Array(2 * terms * count), first: new Int32Array(count) };
    const lower = new Float64Array(terms);
    const higher = new Float64Array(terms);
    let span = degree;
    for (let i = 0; i < count; ++i) {
        const t = start + (end - start) * i / (count - 1);
        while (span + 2 < knots.length - degree && t >= knots[span + 1]) ++span;
        higher.fill(0);
        higher[0] = 1;
        for (let k = 1; k <= degree; ++k) {
            lower.set(higher);
            let carried = 0;
            for (let j = 0; j < k; ++j) {
                const left = knots[span + 1 + j - k];
                const share = lower[j] / (knots[span + 1 + j] - left);
                higher[j] = carried + (knots[span + 1 + j] - t) * share;
                carried = (t - left) * share;
            }
            higher[k] = carried;
        }
        const at = 2 * terms * i;
        table.first[i] = span - degree;
        table.values.set(higher, at);
        for (let j = 0; j < degree; ++j) {
            const slope = degree * lower[j] / (knots[span + 1 + j] - knots[span + 1 + j - degree]);
            table.values[at + terms + j] -= slope;
            table.values[at + terms + j + 1] += slope;
        }
    }
    return table;
}

/** @type {Peer} */
export const typedArraySurface = {
    name: 'typed-array loop',
    make({ degrees: [du, dv], knots, points }) {
        const columns = points[0].length;
        const net = Float64Array.from(points.flat(2));
        return (nu, nv, { positions, normals }) => {
            const rows = basisTable(du, knots[0], nu);
            const cached = basisTable(dv, knots[1], nv);
            for (let i = 0, at = 0; i < nu; ++i) {
                const along = 2 * (du + 1) * i;
                for (let j = 0; j < nv; ++j, at += 3) {
                    const across = 2 * (dv + 1) * j;
                    let sx = 0, sy = 0, sz = 0, ax = 0, ay = 0, az = 0, bx = 0, by = 0, bz = 0;
                    for (let k = 0; k <= du; ++k) {
                        let from = 3 * (columns * (rows.first[i] + k) + cached.first[j]);
                        const value = rows.values[along + k];
                        const slope = rows.values[along + du + 1 + k];
                        for (let l = 0; l <= dv; ++l, from += 3) {
                            const s = value * cached.values[across + l];
                            const a = slope * cached.values[across + l];
                            const b = value * cached.values[across + dv + 1 + l];
                            const x = net[from];
                            const y = net[from + 1];
                            const z = net[from + 2];
                            sx += s * x; sy += s * y; sz += s * z;
                            ax += a * x; ay += a * y; az += a * z;
                            bx += b * x; by += b * y; bz += b * z;
                        }
                    }
                    store(positions, normals, at, sx, sy, sz, ax, ay, az, bx, by, bz);
                }
            }
        };
    },
};

/**
 * The same with the net's columns summed up once a row: what takes a reader of books a moment longer.
 * @type {Peer}
 */
export const collapsingSurface = {
    name: 'typed-array loop, rows first',
    make({ degrees: [du, dv], knots, points }) {
        const columns = points[0].length;
        const net = Float64Array.from(points.flat(2));
        return (nu, nv, { positions, normals }) => {
            const rows = basisTable(du, knots[0], nu);
            const cached = basisTable(dv, knots[1], nv);
            const collapsed = new Float64Array(6 * columns);
            for (let i = 0, at = 0; i < nu; ++i) {
                collapse(net, columns, rows, du, i, collapsed);
                for (let j = 0; j < nv; ++j, at += 3) {
                    const across = 2 * (dv + 1) * j;
                    let sx = 0, sy = 0, sz = 0, ax = 0, ay = 0, az = 0, bx = 0, by = 0, bz = 0;
                    for (let l = 0; l <= dv; ++l) {
                        const from = 6 * (cached.first[j] + l);
                        const value = cached.values[across + l];
                        const slope = cached.values[across + dv + 1 + l];
                        const x = collapsed[from];
                        const y = collapsed[from + 1];
                        const z = collapsed[from + 2];
                        sx += value * x; sy += value * y; sz += value * z;
                        ax += value * collapsed[from + 3];
                        ay += value * collapsed[from + 4];
                        az += value * collapsed[from + 5];
                        bx += slope * x; by += slope * y; bz += slope * z;
                    }
                    store(positions, normals, at, sx, sy, sz, ax, ay, az, bx, by, bz);
                }
            }
        };
    },
};

/**
 * A point and the unit vector of a × b.
 * @param {Float64Array} positions
 * @param {Float64Array} normals
 * @param {number} at
 * @param {number} sx @param {number} sy @param {number} sz
 * @param {number} ax @param {number} ay @param {number} az
 * @param {number} bx @param {number} by @param {number} bz
 */
function store(positions, normals, at, sx, sy, sz, ax, ay, az, bx, by, bz) {
    const x = ay * bz - az * by;
    const y = az * bx - ax * bz;
    const z = ax * by - ay * bx;
    const inverse = 1 / Math.sqrt(x * x + y * y + z * z);
    positions[at] = sx;
    positions[at + 1] = sy;
    positions[at + 2] = sz;
    normals[at] = x * inverse;
    normals[at + 1] = y * inverse;
    normals[at + 2] = z * inverse;
}

/**
 * The net's columns at row i of the grid: points, and their derivatives along u.
 * @param {Float64Array} net
 * @param {number} columns
 * @param {{ values: Float64Array, first: Int32Array }} rows
 * @param {number} degree
 * @param {number} i
 * @param {Float64Array} collapsed
 */
function collapse(net, columns, rows, degree, i, collapsed) {
    collapsed.fill(0);
    for (let k = 0; k <= degree; ++k) {
        const value = rows.values[2 * (degree + 1) * i + k];
        const slope = rows.values[2 * (degree + 1) * i + degree + 1 + k];
        const from = 3 * columns * (rows.first[i] + k);
        for (let j = 0; j < columns; ++j) {
            for (let axis = 0; axis < 3; ++axis) {
                collapsed[6 * j + axis] += value * net[from + 3 * j + axis];
                collapsed[6 * j + 3 + axis] += slope * net[from + 3 * j + axis];
            }
        }
    }
}
