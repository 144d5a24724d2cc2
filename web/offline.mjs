// The page can be installed, and opens without a network: a worker of the browser keeps its files.
// Only the page does that, on its own address: neither figures in the pages of others, nor the page
// in a frame or as one file.

const usualWait = 2000;  // milliseconds, where browsers do not say when they are idle

function mayBeKept() {
    const single = document.querySelector('link[rel="manifest"]') === null;
    return window.top === window && /^https?:$/.test(location.protocol) && !single && 'serviceWorker' in navigator;
}

/** @param {ServiceWorker | null} worker that has kept everything, or will have */
function letTakeOver(worker) {
    const say = () => { if (worker?.state === 'installed') worker.postMessage('take over'); };
    worker?.addEventListener('statechange', say);
    say();
}

async function register() {
    const registration = await navigator.serviceWorker.register('offline-worker.js');
    registration.addEventListener('updatefound', () => letTakeOver(registration.installing));
    letTakeOver(registration.waiting ?? registration.installing);
}

/** Has the files kept as soon as nothing more urgent is to be done; the page has all of its parts. */
export function keepForOffline() {
    if (!mayBeKept()) return;
    // Where it is forbidden or there is no room, the page works as well, with a network.
    const quietly = () => { register().catch(() => {}); };
    if ('requestIdleCallback' in window) requestIdleCallback(quietly);
    else setTimeout(quietly, usualWait);
}
