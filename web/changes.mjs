// What differs between two documents of the same shape, by path.

/** Deeper than any document that is accepted. */
const deepest = 40;

/** @param {unknown} value @returns {value is Record<string, unknown>} */
const isObject = (value) => typeof value === 'object' && value !== null && !Array.isArray(value);

/**
 * Whether two JSON values are equal; the order of keys does not matter.
 * @param {unknown} a
 * @param {unknown} b
 * @returns {boolean}
 */
export function same(a, b) {
    if (Array.isArray(a) && Array.isArray(b)) {
        return a.length === b.length && a.every((one, i) => same(one, b[i]));
    }
    if (isObject(a) && isObject(b)) {
        const keys = Object.keys(a);
        return keys.length === Object.keys(b).length
            && keys.every((key) => Object.hasOwn(b, key) && same(a[key], b[key]));
    }
    return Object.is(a, b);
}

/**
 * { path: new value } that leads from `from` to `to`, or undefined where `to` has other fields.
 * @param {unknown} from
 * @param {unknown} to
 * @returns {Record<string, unknown> | undefined}
 */
export function changesBetween(from, to) {
    /** @type {Record<string, unknown>} */
    const changes = {};
    return collect(from, to, '', changes) ? changes : undefined;
}

/**
 * @param {unknown} from
 * @param {unknown} to
 * @param {string} path
 * @param {Record<string, unknown>} changes
 * @returns {boolean} whether the changes say it all
 */
function collect(from, to, path, changes) {
    if (same(from, to)) return true;
    if (isObject(from) && isObject(to) && sameKeys(from, to)) {
        return Object.keys(from).every((key) => collect(from[key], to[key], path ? `${path}.${key}` : key, changes));
    }
    if (Array.isArray(from) && Array.isArray(to) && from.length === to.length) {
        return from.every((one, i) => collect(one, to[i], `${path}[${i}]`, changes));
    }
    if (path === '') return false;
    changes[path] = to;
    return true;
}

/** @param {object} a @param {object} b */
function sameKeys(a, b) {
    const keys = Object.keys(a);
    return keys.length === Object.keys(b).length && keys.every((key) => Object.hasOwn(b, key));
}

/**
 * The document with these changes, or undefined where a path leads to nothing that is there.
 * Only own fields are followed, so no path reaches a prototype.
 * @param {any} document its own; it is changed
 * @param {unknown} changes
 */
export function applyChanges(document, changes) {
    if (!isObject(changes)) return undefined;
    for (const [path, value] of Object.entries(changes)) {
        if (!put(document, stepsOf(path), value)) return undefined;
    }
    return document;
}

/** @param {string} path */
const stepsOf = (path) => path.split(/[.[\]]+/).filter((step) => step !== '');

/** @param {any} document @param {string[]} steps @param {unknown} value */
function put(document, steps, value) {
    if (steps.length === 0 || steps.length > deepest) return false;
    let place = document;
    for (const [i, step] of steps.entries()) {
        if (typeof place !== 'object' || place === null || !Object.hasOwn(place, step)) return false;
        if (i + 1 < steps.length) place = place[step];
        else place[step] = value;
    }
    return true;
}
