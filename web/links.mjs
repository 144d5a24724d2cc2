// Share links: #v1.<codec>.<payload>. Codec p names a built-in scene and what differs from it, j is
// percent-encoded JSON, d is JSON compressed (deflate-raw) in base64url.

import { text } from './check.mjs';
import { deflate, fromBase64Url, inflate, toBase64Url } from './deflate.mjs';
import { describe, KnotworkError } from './errors.mjs';
import { applyChanges, changesBetween, same } from './changes.mjs';

/** @typedef {import('./core.mjs').Core} Core */

const version = 1;
/** As much as a document may have. */
const mostBytes = 2 ** 20;
/** A link of a document of that size, every byte percent-encoded. */
const mostLetters = 3 * mostBytes + 100;

const shape = /^v(\d{1,9})\.([^.]*)\.(.*)$/s;
const codecs = /** @type {Record<string, (core: Core, payload: string) => unknown>} */ (
    Object.assign(Object.create(null), { p: openPreset, j: openPercent, d: openDeflated }));

/**
 * The shortest link that opens as this document.
 * @param {Core} core
 * @param {unknown} document
 * @returns {Promise<string>}
 */
export async function encodeLink(core, document) {
    const size = core.send(document);
    const canonical = core.canonicalDocument(size);
    const given = JSON.parse(core.ask('inputText', size));

    const preset = presetPayload(core, given, canonical);
    if (preset !== undefined) return `#v${version}.p.${preset}`;
    const json = JSON.stringify(given);
    const percent = `#v${version}.j.${percentEncode(json)}`;
    const compressed = await deflate(new TextEncoder().encode(json));
    if (compressed === undefined) return percent;
    const deflated = `#v${version}.d.${toBase64Url(compressed)}`;
    return deflated.length < percent.length ? deflated : percent;
}

/**
 * The document of a link, or of an address that ends in one; checked, but as it was written.
 * @param {Core} core
 * @param {unknown} link
 * @returns {Promise<any>}
 */
export async function decodeLink(core, link) {
    const { codec, payload } = partsOf(text(link, ''));
    const document = await codecs[codec](core, payload);
    core.release(core.openScene(core.send(document)));
    return document;
}

/** @param {string} link */
function partsOf(link) {
    if (link.length > mostLetters) throw tooLarge();
    const parts = shape.exec(link.slice(link.indexOf('#') + 1));
    if (parts === null) throw malformed('A link looks like #v1.d.…');
    const [, number, codec, payload] = parts;
    if (Number(number) !== version) {
        throw new KnotworkError('VERSION', '',
            `This link has version ${number}; version ${version} is read here. A newer Knotwork opens it.`);
    }
    if (codec in codecs) return { codec, payload };
    throw new KnotworkError('UNKNOWN_NAME', '', `A link cannot be written as ${describe(codec)}; p, j and d are known.`);
}

/** @param {string} why */
const malformed = (why) => new KnotworkError('SYNTAX', '', `This link cannot be read. ${why}`);

const tooLarge = () => new KnotworkError('TOO_LARGE', '', `A document has at most ${mostBytes} bytes.`);

/** @param {string} payload */
function percentDecode(payload) {
    try {
        return decodeURIComponent(payload);
    } catch {
        throw malformed('Its percent signs are not followed by what belongs there.');
    }
}

/** Also what addresses leave alone but text around a link may not. @param {string} plain */
function percentEncode(plain) {
    return encodeURIComponent(plain).replace(/[!'()*]/g, (letter) => `%${letter.charCodeAt(0).toString(16)}`);
}

/** @param {string} json */
function parse(json) {
    try {
        return JSON.parse(json);
    } catch {
        throw malformed('What it carries is not JSON.');
    }
}

/** @param {Core} _core @param {string} payload */
function openPercent(_core, payload) {
    return parse(percentDecode(payload));
}

/** @param {Core} _core @param {string} payload */
async function openDeflated(_core, payload) {
    const compressed = fromBase64Url(payload);
    if (compressed === undefined) throw malformed('Its letters are not base64url.');
    const plain = await inflate(compressed, mostBytes);
    if (plain === 'too large') throw tooLarge();
    if (plain === undefined) throw malformed('It is damaged or cut short.');
    try {
        return parse(new TextDecoder('utf-8', { fatal: true, ignoreBOM: true }).decode(plain));
    } catch (problem) {
        throw problem instanceof KnotworkError ? problem : malformed('What it carries is not text.');
    }
}

// Codec p: <scene id> for a built-in scene as kw.scenes lists it, or <scene id>~<changes>, the
// changes to its canonical document as percent-encoded JSON, { "objects[0].degree": 2, … }.

/** @param {Core} core @param {string} payload */
function openPreset(core, payload) {
    const cut = payload.indexOf('~');
    const id = percentDecode(cut < 0 ? payload : payload.slice(0, cut));
    const listed = core.json('scenes').find((/** @type {{ id: string }} */ scene) => scene.id === id);
    if (listed === undefined) {
        throw new KnotworkError('UNKNOWN_NAME', '', `There is no built-in scene ${describe(id)}.`);
    }
    if (cut < 0) return listed.document;
    const changes = parse(percentDecode(payload.slice(cut + 1)));
    const changed = applyChanges(core.canonicalDocument(core.send(listed.document)), changes);
    if (changed === undefined) throw malformed('Its changes do not fit the scene.');
    return changed;
}

/**
 * How codec p writes a document, or undefined where another codec is shorter or only they can.
 * @param {Core} core
 * @param {any} given
 * @param {any} canonical
 */
function presetPayload(core, given, canonical) {
    for (const { id, document } of core.json('scenes')) {
        if (same(given, document)) return percentEncode(id);
        if (!same(given, canonical) || document.title !== canonical.title) continue;
        const changes = changesBetween(core.canonicalDocument(core.send(document)), given);
        const payload = changes && percentEncode(JSON.stringify(changes));
        if (payload && payload.length < 300) return `${percentEncode(id)}~${payload}`;
    }
    return undefined;
}
