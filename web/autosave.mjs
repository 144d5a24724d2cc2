// What was shown last, kept in the reader's own browser. Where storage is forbidden nothing is kept
// and nothing breaks.

const key = 'knotwork.last';
const pause = 400;  // milliseconds after the last change

/** Milliseconds after which it is kept even if the page is never idle. */
const patience = 3000;

/** @type {ReturnType<typeof setTimeout> | undefined} */
let timer;
/** What is to be kept. @type {(() => { document: any, name: string }) | undefined} */
let waiting;

/**
 * Keeps a document, a moment after the last call.
 * @param {() => { document: any, name: string }} shown `name` of the built-in scene that it was
 */
export function keepSoon(shown) {
    waiting = shown;
    clearTimeout(timer);
    timer = setTimeout(keepWhenIdle, pause);
}

/** A large document takes a while to write: not between two pictures of something that moves. */
function keepWhenIdle() {
    if (typeof requestIdleCallback === 'function') requestIdleCallback(keepNow, { timeout: patience });
    else keepNow();
}

/** Keeps what waits to be kept, as before the page goes away. */
export function keepNow() {
    clearTimeout(timer);
    const shown = waiting;
    waiting = undefined;
    if (!shown) return;
    try {
        localStorage.setItem(key, JSON.stringify(shown()));
    } catch {
        // no room or no permission: it lives as long as the page
    }
}

/** What was kept, or undefined. @returns {{ document: any, name: string } | undefined} */
export function kept() {
    try {
        const { document, name } = JSON.parse(localStorage.getItem(key) ?? '');
        return { document, name: String(name) };
    } catch {
        return undefined;
    }
}

export function forgetKept() {
    clearTimeout(timer);
    waiting = undefined;
    try {
        localStorage.removeItem(key);
    } catch {
        // nothing was kept
    }
}
