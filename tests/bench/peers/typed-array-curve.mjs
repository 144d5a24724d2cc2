// What a careful programmer writes in JavaScript: typed arrays, no garbage, the span moved along
// with the parameter, the basis by its triangular table (The NURBS Book, A2.2).

/** @typedef {import('../splines.mjs').Spline} Spline */

/** @param {Spline} spline */
export function prepare({ degree, knots, points }) {
    return {
        degree,
        knots: Float64Array.from(knots),
        points: Float64Array.from(points.flat()),
        left: new Float64Array(degree + 1),
        right: new Float64Array(degree + 1),
        basis: new Float64Array(degree + 1),
    };
}

/**
 * `count` points, uniform over the domain of a clamped spline, as x, y, z triples.
 * @param {ReturnType<typeof prepare>} prepared
 * @param {number} count
 * @param {Float64Array} xyz
 */
export function sample({ degree, knots, points, left, right, basis }, count, xyz) {
    const last = knots.length - degree - 2;
    const start = knots[degree];
    const length = knots[last + 1] - start;
    let span = degree;
    for (let i = 0; i < count; ++i) {
        const t = start + (length * i) / (count - 1);
        while (span < last && t >= knots[span + 1]) ++span;
        basis[0] = 1;
        for (let k = 1; k <= degree; ++k) {
            left[k] = t - knots[span + 1 - k];
            right[k] = knots[span + k] - t;
            let carried = 0;
            for (let j = 0; j < k; ++j) {
                const part = basis[j] / (right[j + 1] + left[k - j]);
                basis[j] = carried + right[j + 1] * part;
                carried = left[k - j] * part;
            }
            basis[k] = carried;
        }
        let x = 0;
        let y = 0;
        let z = 0;
        for (let j = 0, at = 3 * (span - degree); j <= degree; ++j, at += 3) {
            x += basis[j] * points[at];
            y += basis[j] * points[at + 1];
            z += basis[j] * points[at + 2];
        }
        xyz[3 * i] = x;
        xyz[3 * i + 1] = y;
        xyz[3 * i + 2] = z;
    }
}
