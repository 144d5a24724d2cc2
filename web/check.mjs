// Checks of arguments: nothing is coerced, and nothing of the caller's is run twice.

import { describe, KnotworkError, reading } from './errors.mjs';

/** More numbers than an array of theirs can usefully hold are refused before work begins. */
const mostSamples = 2 ** 26;

/**
 * A finite number.
 * @param {unknown} value
 * @param {string} name
 * @returns {number}
 */
export function finite(value, name) {
    if (typeof value !== 'number') {
        throw new KnotworkError('WRONG_TYPE', name, `${name} must be a number, not ${describe(value)}.`);
    }
    if (!Number.isFinite(value)) {
        throw new KnotworkError('NOT_FINITE', name, `${name} is ${value}; give a finite number.`);
    }
    return value;
}

/**
 * A whole number from `least` to `most`.
 * @param {unknown} value
 * @param {string} name
 * @param {number} least
 * @param {number} most
 * @param {string} [beyond] the code for more than `most`
 * @returns {number}
 */
export function integer(value, name, least, most, beyond = 'OUT_OF_RANGE') {
    const number = finite(value, name);
    if (!Number.isInteger(number)) {
        throw new KnotworkError('NOT_INTEGER', name, `${name} is ${number}; give a whole number.`);
    }
    if (number < least || number > most) {
        throw new KnotworkError(number > most ? beyond : 'OUT_OF_RANGE', name,
            `${name} is ${number}; it must lie between ${least} and ${most}.`);
    }
    return number;
}

/** @param {unknown} value */
export const sampleCount = (value) => integer(value, 'count', 1, mostSamples, 'TOO_LARGE');

/** @param {unknown} value @param {string} name */
export const derivativeOrder = (value, name) => integer(value, name, 0, 25);

/**
 * @param {unknown} value
 * @param {string} name
 * @returns {string}
 */
export function text(value, name) {
    if (typeof value === 'string') return value;
    throw new KnotworkError('WRONG_TYPE', name, `Give a string here, not ${describe(value)}.`);
}

/**
 * A string that is one of these.
 * @template {string} T
 * @param {unknown} value
 * @param {string} name
 * @param {readonly T[]} allowed
 * @returns {T}
 */
export function choice(value, name, allowed) {
    const given = text(value, name);
    const found = allowed.find((one) => one === given);
    if (found !== undefined) return found;
    throw new KnotworkError('UNKNOWN_NAME', name,
        `${name} is ${describe(value)}; it can be ${allowed.map((one) => `'${one}'`).join(', ')}.`);
}

/**
 * Whether this is an object as a literal or JSON.parse() makes it, of whatever realm.
 * @param {object} value
 */
export function isPlain(value) {
    const prototype = Object.getPrototypeOf(value);
    return prototype === Object.prototype || prototype === null
        || (Object.getPrototypeOf(prototype) === null && Object.hasOwn(prototype, 'isPrototypeOf'));
}

/**
 * The fields of an options object by name, each read once; the last argument of many functions.
 * @param {unknown} given
 * @param {readonly string[]} known
 * @returns {Record<string, unknown>}
 */
export function options(given, known) {
    /** @type {Record<string, unknown>} */
    const fields = Object.create(null);
    if (given === undefined) return fields;
    if (typeof given !== 'object' || given === null) throw notOptions(given, known);
    return reading(() => '', () => {
        if (!isPlain(given)) throw notOptions(given, known);
        for (const key of Object.keys(given)) {
            if (!known.includes(key)) throw unknownField(key, known);
            fields[key] = /** @type {Record<string, unknown>} */ (given)[key];
        }
        return fields;
    });
}

/** @param {unknown} given @param {readonly string[]} known */
function notOptions(given, known) {
    return new KnotworkError('WRONG_TYPE', '',
        `The options are an object with ${known.join(', ')}, not ${describe(given)}.`);
}

/** @param {string} key @param {readonly string[]} known */
function unknownField(key, known) {
    return new KnotworkError('UNKNOWN_FIELD', key,
        `There is no option ${describe(key)}; there are ${known.join(', ')}.`);
}

// The built-in accessors look past whatever a subclass or an own property pretends.
const typedArray = Object.getPrototypeOf(Float64Array.prototype);
/** @type {(this: unknown) => string | undefined} */
const tagOf = /** @type {any} */ (Object.getOwnPropertyDescriptor(typedArray, Symbol.toStringTag)).get;
/** @type {(this: Float64Array | Int32Array | Uint32Array) => number} */
const lengthOf = /** @type {any} */ (Object.getOwnPropertyDescriptor(typedArray, 'length')).get;
/** @type {(this: Float64Array | Int32Array | Uint32Array, numbers: ArrayLike<number>, offset: number) => void} */
const setOf = typedArray.set;

/**
 * @param {unknown} value
 * @returns {value is Float64Array}
 */
export const isFloat64Array = (value) => tagOf.call(value) === 'Float64Array';

/**
 * @param {unknown} value
 * @returns {value is Int32Array}
 */
export const isInt32Array = (value) => tagOf.call(value) === 'Int32Array';

/**
 * @param {unknown} value
 * @returns {value is Uint32Array}
 */
export const isUint32Array = (value) => tagOf.call(value) === 'Uint32Array';

/** @param {Float64Array | Int32Array | Uint32Array} numbers */
export const lengthOfNumbers = (numbers) => lengthOf.call(numbers);

/** @type {(this: Float64Array) => ArrayBuffer} */
const bufferOf = /** @type {any} */ (Object.getOwnPropertyDescriptor(typedArray, 'buffer')).get;
/** @type {(this: Float64Array) => number} */
const offsetOf = /** @type {any} */ (Object.getOwnPropertyDescriptor(typedArray, 'byteOffset')).get;

/** Its bytes, as a view. @param {Float64Array} numbers */
export const bytesOf = (numbers) =>
    new Uint8Array(bufferOf.call(numbers), offsetOf.call(numbers), 8 * lengthOf.call(numbers));

/** Some of the numbers, as a view. @param {Float64Array} numbers @param {number} from @param {number} count */
export const partOf = (numbers, from, count) =>
    new Float64Array(bufferOf.call(numbers), offsetOf.call(numbers) + 8 * from, count);

/** @param {Float64Array | Int32Array | Uint32Array} target @param {ArrayLike<number>} numbers @param {number} offset */
export const copyInto = (target, numbers, offset) => setOf.call(target, numbers, offset);

/**
 * Where `length` numbers go: the caller's array, or a new one.
 * @param {unknown} into
 * @param {number} length
 * @param {string} [name]
 * @returns {Float64Array}
 */
export function target(into, length, name = 'into') {
    if (into === undefined) return freshNumbers(length);
    if (!isFloat64Array(into)) {
        throw new KnotworkError('WRONG_TYPE', name, `${name} must be a Float64Array, not ${describe(into)}.`);
    }
    if (lengthOfNumbers(into) === length) return into;
    throw new KnotworkError('WRONG_LENGTH', name,
        `${name} has ${lengthOfNumbers(into)} numbers; the answer has ${length}.`);
}

/** @param {number} length */
function freshNumbers(length) {
    try {
        return new Float64Array(length);
    } catch {
        throw new KnotworkError('OUT_OF_MEMORY', '', `There is no room for ${length} numbers.`);
    }
}

/**
 * A list of finite numbers: the caller's Float64Array itself, or a copy of an array.
 * @param {unknown} value
 * @param {string} name
 * @returns {Float64Array}
 */
export function numbers(value, name) {
    if (isFloat64Array(value)) return value;
    return reading(() => name, () => {
        if (!Array.isArray(value)) {
            throw new KnotworkError('WRONG_TYPE', name,
                `${name} must be an array of numbers or a Float64Array, not ${describe(value)}.`);
        }
        const length = integer(value.length, name, 0, mostSamples, 'TOO_LARGE');
        const copy = freshNumbers(length);
        for (let i = 0; i < length; ++i) copy[i] = numberAt(value[i], name, i);
        return copy;
    });
}

/**
 * A point as three numbers of our own; two lie in the plane z = 0.
 * @param {unknown} value
 * @param {string} name
 * @returns {Float64Array}
 */
export function point(value, name) {
    const given = numbers(value, name);
    const length = lengthOfNumbers(given);
    if (length !== 2 && length !== 3) {
        throw new KnotworkError('WRONG_LENGTH', name, `${name} has ${length} numbers; a point has 2 or 3.`);
    }
    const own = new Float64Array(3);
    copyInto(own, given, 0);
    for (let i = 0; i < 3; ++i) finite(own[i], `${name}[${i}]`);
    return own;
}

/**
 * Two whole numbers, one for each direction of a surface.
 * @param {unknown} value
 * @param {string} name
 * @returns {[number, number]}
 */
export function indexPair(value, name) {
    const given = numbers(value, name);
    const length = lengthOfNumbers(given);
    if (length !== 2) {
        throw new KnotworkError('WRONG_LENGTH', name,
            `${name} has ${length} numbers; it needs two, one for each direction.`);
    }
    return [integer(given[0], `${name}[0]`, 0, 2 ** 31 - 1), integer(given[1], `${name}[1]`, 0, 2 ** 31 - 1)];
}

/** @param {unknown} value @param {string} name @param {number} i */
function numberAt(value, name, i) {
    return typeof value === 'number' ? value : finite(value, `${name}[${i}]`);
}
