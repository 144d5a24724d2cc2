// Long work on the page's one thread: a slice between two pictures, so that nothing else waits for it.
// A worker would be refused by a strict policy where it is a blob, and could not be had from another
// origin or from file:// where it is a file.

/**
 * How work that takes a while is followed and ended.
 * @typedef {object} Watch
 * @property {AbortSignal} [signal] ends it; nothing of it is left then
 * @property {(fraction: number) => void} [progress] hears after each slice how much is done, 0 to 1
 */

/** Milliseconds of a slice: with what the browser does besides, far below what one feels as a stop. */
const slice = 24;
/** So often, in milliseconds, the browser is left to paint, if anything is painted at all. */
const paintEvery = 80;
/** Milliseconds after which no picture is waited for any more. */
const longestFrame = 100;

/**
 * Calls a function again and again until it says that nothing is left, never for longer than a slice
 * or one call. Rejects with the reason of the signal where that ends it.
 * @param {() => { more: boolean, fraction: number }} advance does a small part
 * @param {Watch} [watch]
 */
export async function inSlices(advance, { signal, progress } = {}) {
    let painted = performance.now();
    for (;;) {
        signal?.throwIfAborted();
        const end = performance.now() + slice;
        let state = advance();
        while (state.more && performance.now() < end) state = advance();
        if (!state.more) return;
        progress?.(state.fraction);
        const due = performance.now() - painted > paintEvery;
        await (due ? nextPicture() : nextTask());
        if (due) painted = performance.now();
    }
}

/** After whatever waits already. Timers would be held back, in pages that nobody sees by seconds. */
function nextTask() {
    return new Promise((resolve) => {
        const { port1, port2 } = new MessageChannel();
        port1.onmessage = () => {
            port1.close();
            resolve(undefined);
        };
        port2.postMessage(0);
    });
}

/** After the next picture of the browser: frames of other origins that nobody sees get none at all. */
async function nextPicture() {
    if (document.visibilityState !== 'hidden') {
        await new Promise((resolve) => {
            requestAnimationFrame(resolve);
            setTimeout(resolve, longestFrame);
        });
    }
    return nextTask();
}
