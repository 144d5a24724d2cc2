// Compression for links: the platform's streams, or Node's zlib where those lack deflate-raw.

const format = /** @type {CompressionFormat} */ ('deflate-raw');

/**
 * @param {Uint8Array} bytes
 * @returns {Promise<Uint8Array | undefined>} undefined where nothing can compress
 */
export async function deflate(bytes) {
    const stream = make(() => new CompressionStream(format));
    if (stream !== undefined) return gather(piped(bytes, stream), Infinity).catch(() => undefined);
    const zlib = await nodeZlib();
    return zlib && new Uint8Array(zlib.deflateRawSync(bytes));
}

/**
 * @param {Uint8Array} bytes
 * @param {number} most how many bytes may come out; inflating stops there
 * @returns {Promise<Uint8Array | 'too large' | undefined>} undefined for bytes that are damaged
 */
export async function inflate(bytes, most) {
    const stream = make(() => new DecompressionStream(format));
    if (stream !== undefined) {
        return gather(piped(bytes, stream), most).catch(() => undefined);
    }
    const zlib = await nodeZlib();
    try {
        return zlib && new Uint8Array(zlib.inflateRawSync(bytes, { maxOutputLength: most }));
    } catch (problem) {
        return /** @type {{ code?: string }} */ (problem).code === 'ERR_BUFFER_TOO_LARGE' ? 'too large' : undefined;
    }
}

/** @template T @param {() => T} construct @returns {T | undefined} */
function make(construct) {
    try {
        return construct();
    } catch {
        return undefined;
    }
}

/** @param {Uint8Array} bytes @param {GenericTransformStream} stream */
function piped(bytes, stream) {
    return new Blob([/** @type {BlobPart} */ (bytes)]).stream().pipeThrough(stream);
}

/** @returns {Promise<typeof import('node:zlib') | undefined>} */
async function nodeZlib() {
    return import(/* webpackIgnore: true */ /* @vite-ignore */ 'node:zlib').catch(() => undefined);
}

/**
 * @param {ReadableStream<Uint8Array>} stream
 * @param {number} most
 * @returns {Promise<any>}
 */
async function gather(stream, most) {
    const parts = [];
    let length = 0;
    const reader = stream.getReader();
    for (;;) {
        const { done, value } = await reader.read();
        if (done) return joined(parts, length);
        length += value.length;
        if (length > most) {
            await reader.cancel().catch(() => {});
            return 'too large';
        }
        parts.push(value);
    }
}

/** @param {Uint8Array[]} parts @param {number} length */
function joined(parts, length) {
    const whole = new Uint8Array(length);
    let at = 0;
    for (const part of parts) {
        whole.set(part, at);
        at += part.length;
    }
    return whole;
}

/** @param {Uint8Array} bytes */
export function toBase64Url(bytes) {
    let letters = '';
    for (let at = 0; at < bytes.length; at += 4096) {
        letters += String.fromCharCode(...bytes.subarray(at, at + 4096));
    }
    return btoa(letters).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
}

/**
 * @param {string} letters
 * @returns {Uint8Array | undefined} undefined for anything but base64url
 */
export function fromBase64Url(letters) {
    if (!/^[A-Za-z0-9_-]*$/.test(letters) || letters.length % 4 === 1) return undefined;
    const plain = atob(letters.replaceAll('-', '+').replaceAll('_', '/'));
    return Uint8Array.from(plain, (letter) => letter.charCodeAt(0));
}
