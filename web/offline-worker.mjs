// The worker that keeps the files of the page. One worker keeps the files of one version, each checked
// by its hash, so that a page is either wholly of that version or wholly from the network:
//
// - the page itself comes from the network; only without one, or when it takes too long, is it the one
//   that is kept;
// - what a page of another version asks for comes from the network, and never from here;
// - a newer worker takes over when a page that has all of its parts says so, never while one loads.

/** @type {{ version: string, files: [name: string, hash: string][] }} written by the build */
const { version, files } = __KEPT__;

const prefix = 'knotwork ';
const patience = 4000;  // milliseconds that a network may take to bring the page
const worker = /** @type {any} */ (globalThis);
const scope = new URL(worker.registration.scope);
const names = new Set(files.map(([name]) => name));

/** Pages by what they are made of; those that an earlier life of this worker knew are in neither. */
const ofThisVersion = new Set();
const ofAnother = new Set();

/** @param {ArrayBuffer} content */
async function hashOf(content) {
    const bytes = new Uint8Array(await crypto.subtle.digest('SHA-256', content));
    return Array.from(bytes, (byte) => byte.toString(16).padStart(2, '0')).join('');
}

/**
 * @param {Cache} cache
 * @param {string} name
 * @param {string} hash
 */
async function keep(cache, name, hash) {
    const response = await fetch(new URL(name, scope), { cache: 'no-cache' });
    if (!response.ok) throw new Error(`${name}: ${response.status}`);
    if (await hashOf(await response.clone().arrayBuffer()) !== hash) throw new Error(`${name} is of another version`);
    await cache.put(new URL(name, scope), response);
}

async function keepAll() {
    const cache = await caches.open(prefix + version);
    await Promise.all(files.map(([name, hash]) => keep(cache, name, hash)));
}

async function forgetOthers() {
    const others = (await caches.keys()).filter((name) => name.startsWith(prefix) && name !== prefix + version);
    await Promise.all(others.map((name) => caches.delete(name)));
}

/** @param {string} name */
async function kept(name) {
    const cache = await caches.open(prefix + version);
    return await cache.match(new URL(name, scope)) ?? Response.error();
}

const impatience = () => new Promise((_, reject) => {
    setTimeout(() => reject(new Error('The network takes too long.')), patience);
});

/**
 * The page: from the network, if there is one.
 * @param {any} event
 */
async function page(event) {
    try {
        const response = await Promise.race([fetch(event.request), impatience()]);
        const same = (await response.clone().text()).includes(version);
        (same ? ofThisVersion : ofAnother).add(event.resultingClientId);
        return response;
    } catch {
        ofThisVersion.add(event.resultingClientId);
        return kept('index.html');
    }
}

/**
 * What a page asks for.
 * @param {any} event
 * @param {string} name
 */
async function part({ request, clientId }, name) {
    if (ofThisVersion.has(clientId)) return kept(name);
    return fetch(request).catch(() => kept(name));
}

worker.addEventListener('install', (/** @type {any} */ event) => event.waitUntil(keepAll()));
worker.addEventListener('activate', (/** @type {any} */ event) => event.waitUntil(forgetOthers()));
worker.addEventListener('message', (/** @type {any} */ { data }) => data === 'take over' && worker.skipWaiting());
worker.addEventListener('fetch', (/** @type {any} */ event) => {
    const { request, clientId } = event;
    const url = new URL(request.url);
    if (request.method !== 'GET' || url.origin !== scope.origin || !url.pathname.startsWith(scope.pathname)) return;
    const name = url.pathname.slice(scope.pathname.length) || 'index.html';
    if (!names.has(name)) return;
    if (request.mode !== 'navigate') {
        if (!ofAnother.has(clientId)) event.respondWith(part(event, name));
    } else if (name === 'index.html') {
        event.respondWith(page(event));  // whatever the page was that one comes from
    }
});
