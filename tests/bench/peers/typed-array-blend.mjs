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
    let span = 0;
    for (let i = 0; i < count; ++i) {
        const t = start + (length * i) / (count - 1);
        while (span < last && t >= knots[span + 1]) ++span;
        const weight = lookUp(table, (t - knots[span]) / (knots[span + 1] - knots[span]));
        let x = 0;
        let y = 0;
        let z = 0;
        for (let side = 0; side < 2; ++side) {
            const share = side === 0 ? 1 - weight : weight;
            const local = span + side;
            const from = domains[2 * local];
            const u = (t - from) / (domains[2 * local + 1] - from);
            const v = 1 - u;
            const b0 = share * v * v * v;
            const b1 = share * 3 * u * v * v;
            const b2 = share * 3 * u * u * v;
            const b3 = share * u * u * u;
            const at = 12 * local;
            x += b0 * locals[at] + b1 * locals[at + 3] + b2 * locals[at + 6] + b3 * locals[at + 9];
            y += b0 * locals[at + 1] + b1 * locals[at + 4] + b2 * locals[at + 7] + b3 * locals[at + 10];
            z += b0 * locals[at + 2] + b1 * locals[at + 5] + b2 * locals[at + 8] + b3 * locals[at + 11];
        }
        xyz[3 * i] = x;
        xyz[3 * i + 1] = y;
        xyz[3 * i + 2] = z;
    }
}
