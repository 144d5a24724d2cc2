// B-functions as values.

import { derivativeOrder, finite, options, sampleCount, target } from './check.mjs';
import { fill } from './samples.mjs';
import { Held } from './held.mjs';

export class BFunction extends Held {
    /** B(t), t in [0, 1]. @param {number} t */
    value(t) {
        const { core, handle } = Held.of(this);
        core.ask('bFunctionDerivatives', handle, finite(t, 't'), 0);
        return core.number(0);
    }

    /** [B, B′, …, B⁽ⁿ⁾] at t. @param {number} t @param {number} n */
    derivatives(t, n) {
        const { core, handle } = Held.of(this);
        const order = derivativeOrder(n, 'n');
        core.ask('bFunctionDerivatives', handle, finite(t, 't'), order);
        return Array.from(core.block(0, order + 1));
    }

    /** `count` values at uniform parameters, both ends included. @param {number} count @param {{ into?: Float64Array }} [given] */
    sample(count, given) {
        const { core, handle } = Held.of(this);
        const total = sampleCount(count);
        const answer = target(options(given, ['into']).into, total);
        fill(core, answer, total, 1, (first, part) => {
            core.ask('bFunctionSample', handle, first, part, total);
        });
        return answer;
    }

    /** The Hermite orders at 0 and at 1; Infinity where all derivatives vanish. */
    get order() {
        traits(this);
        const { core } = Held.of(this);
        return [core.number(0), core.number(1)];
    }

    /** Whether B(t) + B(1 − t) = 1. */
    get symmetric() {
        return traits(this).number(2) === 1;
    }

    /** Whether derivatives of every order exist on all of [0, 1]. */
    get smooth() {
        return traits(this).number(3) === 1;
    }

    /** Where its smoothness ends, in words; empty for a smooth one. */
    get warning() {
        const { core, handle } = Held.of(this);
        return core.call('bFunctionWarning', handle);
    }

    /** What it was made from, defaults filled in. */
    get spec() {
        const { core, handle } = Held.of(this);
        return core.json('bFunctionSpec', handle);
    }
}

/** @param {BFunction} value */
function traits(value) {
    const { core, handle } = Held.of(value);
    core.ask('bFunctionTraits', handle);
    return core;
}

/** @param {import('./core.mjs').Core} core @param {unknown} spec */
export function makeBFunction(core, spec) {
    return new BFunction(core, core.ask('bFunction', core.send(spec)));
}
