// Least squares by scipy, where a Python has it.
import { spawnSync } from 'node:child_process';

import { converse } from './conversation.mjs';

const program = `
import json, sys, time
import numpy as np
from scipy.interpolate import make_lsq_spline
given = json.loads(sys.stdin.readline())
points = np.array(given['points']).reshape(-1, 3)
parameters, knots, degree = np.array(given['parameters']), np.array(given['knots']), given['degree']
for line in sys.stdin:
    start = time.perf_counter()
    spline = make_lsq_spline(parameters, points, knots, degree)
    elapsed = time.perf_counter() - start
    answer = spline.c.ravel().tolist() if line.strip() == 'result' else []
    print(json.dumps({'milliseconds': 1000 * elapsed, 'result': answer}), flush=True)
`;

/** A Python that has scipy, where there is one. */
function findPython() {
    const found = ['python3', '/usr/bin/python3'].find((python) => (
        spawnSync(python, ['-c', 'import scipy.interpolate'], { stdio: 'ignore' }).status === 0));
    return found;
}

/**
 * @param {{ points: Float64Array, parameters: Float64Array, knots: Float64Array, degree: number }} given
 * @returns {import('../cases/case.mjs').Work | string}
 */
export function scipy(given) {
    const python = findPython();
    if (python === undefined) return 'no Python with scipy here (package python3-scipy)';
    const plain = Object.fromEntries(Object.entries(given).map(([key, value]) => (
        [key, typeof value === 'number' ? value : Array.from(value)])));
    return converse(python, ['-c', program], plain);
}
