// What a reader has chosen before. Where storage is forbidden, as in a sandboxed frame, nothing is
// remembered and nothing breaks.

const prefix = 'knotwork.';

/**
 * The value chosen before, if it is still one of those allowed.
 * @param {string} name
 * @param {string[]} allowed
 */
export function remembered(name, allowed) {
    try {
        const value = localStorage.getItem(prefix + name);
        return value !== null && allowed.includes(value) ? value : undefined;
    } catch {
        return undefined;
    }
}

/**
 * @param {string} name
 * @param {string} value
 */
export function remember(name, value) {
    try {
        localStorage.setItem(prefix + name, value);
    } catch {
        // it will have to be chosen again next time
    }
}
