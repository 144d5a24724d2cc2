// Closed Lane–Riesenfeld of degree 3 as a careful programmer writes it in JavaScript: two typed
// arrays in turn, each level by the two masks (4, 4)/8 and (1, 6, 1)/8.

/**
 * @param {Float64Array} points triples
 * @param {number} levels
 */
export function laneRiesenfeld(points, levels) {
    let from = points;
    for (let level = 0; level < levels; ++level) {
        const n = from.length / 3;
        const to = new Float64Array(6 * n);
        for (let i = 0; i < n; ++i) {
            const before = 3 * (i === 0 ? n - 1 : i - 1);
            const here = 3 * i;
            const after = 3 * (i === n - 1 ? 0 : i + 1);
            for (let axis = 0; axis < 3; ++axis) {
                const middle = from[here + axis];
                to[6 * i + axis] = (from[before + axis] + 6 * middle + from[after + axis]) / 8;
                to[6 * i + 3 + axis] = (middle + from[after + axis]) / 2;
            }
        }
        from = to;
    }
    return from;
}
