// A blending curve as a careful programmer writes it in JavaScript: typed arrays, the B-function from
// a table of values and slopes (cubic Hermite), local Bézier curves by their Bernstein polynomials,
// the span moved along with the parameter.

const cells = 1024;

/**
 * @param {{ derivatives: (t: number, n: number) => number[] }} bFunction
 */
export function tableOf(bFunction) {
    const table = new Float64Array(2 * (cells + 1));
    for (let i = 0; i <= cells; ++i) {
        const [value, slope] = bFunction.derivatives(i / cells, 1);
        table[2 * i] = value;
        table[2 * i + 1] = slope / cells;
    }
    return table;
}

/** @param {Float64Array} table @param {number} w */
function lookUp(table, w) {
    const x = w * cells;
    const i = Math.min(Math.floor(x), cells - 1);
    const u = x - i;
    const v = 1 - u;
    const at = 2 * i;
    return v * v * ((1 + 2 * u) * table[at] + u * table[at + 1])
        + u * u * ((1 + 2 * v) * table[at + 2] - v * table[at + 3]);
}

/**
 * The point of a cubic in `work`, twelve numbers that are overwritten, at u.
 * @param {Float64Array} work
 * @param {number} u
 */
function deCasteljau(work, u) {
    const v = 1 - u;
    for (let last = 9; last > 0; last -= 3) {
        for (let i = 0; i < last; ++i) work[i] = v * work[i] + u * work[i + 3];
    }
}

/**
 * @param {Float64Array} locals twelve numbers each: four control points
 * @param {Float64Array} domains start and end of each
 * @param {Float64Array} knots
 * @param {Float64Array} table
 * @param {number} count
 * @param {Float64Array} xyz
 */
export function sampleBlend(locals, domains, knots, table, count, xyz) {
    const last = knots.length - 2;
    const start = knots[0];
    const length = knots[last + 1] - start;
    const first = new Float64Array(12);
    const second = new Float64Array(12);
    let span = 0;
    for (let i = 0; i < count; ++i) {
        const t = start + (length * i) / (count - 1);
        while (span < last && t >= knots[span + 1]) ++span;
        const weight = lookUp(table, (t - knots[span]) / (knots[span + 1] - knots[span]));
        for (let k = 0; k < 12; ++k) {
            first[k] = locals[12 * span + k];
            second[k] = locals[12 * span + 12 + k];
        }
        const from = domains[2 * span];
        const to = domains[2 * span + 2];
        deCasteljau(first, (t - from) / (domains[2 * span + 1] - from));
        deCasteljau(second, (t - to) / (domains[2 * span + 3] - to));
        for (let axis = 0; axis < 3; ++axis) {
            xyz[3 * i + axis] = (1 - weight) * first[axis] + weight * second[axis];
        }
    }
}
