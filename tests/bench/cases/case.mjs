// What a case of the benchmark is: the same work done by us and by each peer.

/**
 * `act` does the work once and answers with its result; where another process does it, `time` has
 * it done and says how many milliseconds that took. `digest` makes of a result what is compared.
 * @typedef {object} Work
 * @property {() => any} act
 * @property {(result: any) => ArrayLike<number>} [digest]
 * @property {() => Promise<number>} [time]
 * @property {() => void} dispose
 */

/**
 * @typedef {object} Peer
 * @property {string} name
 * @property {number} tolerance of the difference between our result and theirs
 * @property {number} [atLeast] how many times faster we promise to be
 * @property {number} [atMost] how many times its time we promise to take at most
 * @property {number} [rounds] how often both are measured, where one call takes many seconds
 * @property {number} [within] by how much the times for one unit may differ, as a part of them
 * @property {number} [amount] how much they do in one act, where it is not what we do
 * @property {(kw: any) => Work} [same] our work of that amount, with which theirs is compared
 * @property {(kw: any) => Work | string | Promise<Work | string>} work or why it is not there
 */

/**
 * @typedef {object} Case
 * @property {string} name
 * @property {string} unit what is counted
 * @property {number} amount of it in one act
 * @property {(kw: any) => Work | Promise<Work>} ours
 * @property {Peer[]} peers
 */

const nothing = () => {};

/** @param {() => Float64Array} act @param {() => void} [dispose] @returns {Work} */
export const work = (act, dispose = nothing) => ({ act, dispose });

/**
 * Short work, often enough for the clock.
 * @param {number} times
 * @param {() => any} act
 */
export function repeated(times, act) {
    return () => {
        let answer = act();
        for (let i = 1; i < times; ++i) answer = act();
        return answer;
    };
}
