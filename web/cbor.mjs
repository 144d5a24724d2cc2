// Plain data on its way into the core, as CBOR (RFC 8949): doubles cross exactly, NaN included, so
// that the core can say where it stands. Everything that is not plain data is refused here.

import { bytesOf, isFloat64Array, isPlain, lengthOfNumbers } from './check.mjs';
import { describe, KnotworkError } from './errors.mjs';

/** How deep a document may be nested, and how many bytes may cross at once. */
const deepest = 32;
const mostBytes = 16 * 2 ** 20;

const majorBytes = 0x40;
const majorText = 0x60;
const majorArray = 0x80;
const openMap = 0xbf;
const closeMap = 0xff;
const simple = { false: 0xf4, true: 0xf5, null: 0xf6 };
const double = 0xfb;
/** The tag that says nothing: as many as it takes for long numbers to stand where numbers do in memory. */
const emptyTag = [0xd9, 0xd9, 0xf7];
/** Before a byte: how many numbers each point has whose numbers follow (a tag of RFC 8746's kind). */
const rowsOf = [0xd8, 40];

/** Whether the bytes of a Float64Array are in the order in which they cross. */
const littleEndian = new Uint8Array(Uint16Array.of(1).buffer)[0] === 1;

/** Numbers of at least so many bytes are copied once, straight to where they go. */
const longBytes = 2 ** 13;

const loneSurrogate = /[\uD800-\uDFFF]/u;
const utf8 = new TextEncoder();

/**
 * Numbers that stand between two of the bytes that have been written.
 * @typedef {{ at: number, numbers: Float64Array, size: number }} Inset
 */

/** Writes one value after the other into a buffer that is used again. */
export class Encoder {
    #bytes = new Uint8Array(4096);
    #view = new DataView(this.#bytes.buffer);
    #length = 0;
    /** @type {Inset[]} */
    #insets = [];
    #insetBytes = 0;
    /** @type {(string | number)[]} keys and indices that lead to where the encoder is */
    #trail = [];
    #busy = false;

    /** Whether a value is being encoded, as it is when a getter in it makes another call. */
    get busy() {
        return this.#busy;
    }

    /**
     * Gets a value ready for write(), and answers how many bytes it has.
     * @param {unknown} value
     */
    encode(value) {
        this.#length = 0;
        this.#insets.length = 0;
        this.#insetBytes = 0;
        if (this.#trail.length > 0) this.#trail.length = 0;
        this.#busy = true;
        try {
            this.#value(value);
        } catch (problem) {
            throw problem instanceof KnotworkError ? problem : this.#refusal('WRONG_TYPE', 'Reading this value failed; give plain data.');
        } finally {
            this.#busy = false;
        }
        return this.#length + this.#insetBytes;
    }

    /**
     * Writes what has been encoded.
     * @param {Uint8Array} target
     * @param {number} start
     */
    write(target, start) {
        let to = start;
        let from = 0;
        const writeUntil = (/** @type {number} */ end) => {
            target.set(this.#bytes.subarray(from, end), to);
            to += end - from;
            from = end;
        };
        for (const { at, numbers, size } of this.#insets) {
            writeUntil(at);
            // A getter that was read later may have given the array's memory away.
            if (8 * lengthOfNumbers(numbers) !== size) {
                throw new KnotworkError('WRONG_TYPE', '', 'A Float64Array has changed its length while it was read.');
            }
            target.set(bytesOf(numbers), to);
            to += size;
        }
        writeUntil(this.#length);
        this.#insets.length = 0; // holds nobody's arrays
    }

    /** @param {unknown} value */
    #value(value) {
        switch (typeof value) {
            case 'number': return this.#number(value);
            case 'string': return this.#text(value);
            case 'boolean': return this.#byte(value ? simple.true : simple.false);
            case 'object': return this.#object(value);
            default: throw this.#refusal('WRONG_TYPE', `Give plain data here, not ${describe(value)}.`);
        }
    }

    /** @param {object | null} value */
    #object(value) {
        if (value === null) return this.#byte(simple.null);
        if (this.#trail.length >= deepest) {
            throw this.#refusal('TOO_LARGE', `This is nested more than ${deepest} levels deep, or contains itself.`);
        }
        if (isFloat64Array(value)) return this.#numbers(value);
        if (Array.isArray(value)) return this.#list(value);
        if (isPlain(value)) return this.#fields(/** @type {Record<string, unknown>} */ (value));
        throw this.#refusal('WRONG_TYPE', 'Only plain objects, arrays and Float64Arrays are data; this is something else.');
    }

    /** @param {Record<string, unknown>} object */
    #fields(object) {
        this.#byte(openMap);
        for (const key of Object.keys(object)) {
            this.#trail.push(key);
            const value = object[key];
            if (value !== undefined) {
                this.#text(key);
                this.#value(value);
            }
            this.#trail.pop();
        }
        this.#byte(closeMap);
    }

    /** @param {unknown[]} list */
    #list(list) {
        const { length } = list;
        const first = length > 0 ? list[0] : undefined;
        if (typeof first === 'number' && this.#packedNumbers(list, length)) return;
        if (Array.isArray(first) && this.#packedPoints(list, length, first.length)) return;
        this.#head(majorArray, length);
        for (let i = 0; i < length; ++i) {
            this.#trail.push(i);
            this.#value(list[i]);
            this.#trail.pop();
        }
    }

    /**
     * A list of numbers as their bytes, which is what lists mostly are; false where it is none.
     * @param {unknown[]} list
     * @param {number} length
     */
    #packedNumbers(list, length) {
        const start = this.#length;
        this.#head(majorBytes, 8 * length);
        this.#reserve(8 * length);
        const view = this.#view;
        let at = this.#length;
        for (let i = 0; i < length; ++i, at += 8) {
            const value = list[i];
            if (typeof value !== 'number') return this.#backTo(start);
            view.setFloat64(at, value, true);
        }
        this.#length = at;
        return true;
    }

    /**
     * A list of points of equal dimension, likewise.
     * @param {unknown[]} list
     * @param {number} length
     * @param {number} width
     */
    #packedPoints(list, length, width) {
        if (width !== 2 && width !== 3) return false;
        const start = this.#length;
        this.#byte(rowsOf[0]);
        this.#byte(rowsOf[1]);
        this.#byte(width);
        this.#head(majorBytes, 8 * width * length);
        this.#reserve(8 * width * length);
        const view = this.#view;
        let at = this.#length;
        for (let i = 0; i < length; ++i) {
            const point = list[i];
            if (!Array.isArray(point) || point.length !== width) return this.#backTo(start);
            for (let axis = 0; axis < width; ++axis, at += 8) {
                const value = point[axis];
                if (typeof value !== 'number') return this.#backTo(start);
                view.setFloat64(at, value, true);
            }
        }
        this.#length = at;
        return true;
    }

    /** @param {number} length */
    #backTo(length) {
        this.#length = length;
        return false;
    }

    /** @param {Float64Array} numbers */
    #numbers(numbers) {
        const length = lengthOfNumbers(numbers);
        const long = littleEndian && 8 * length >= longBytes;
        if (long) this.#pad();
        this.#head(majorBytes, 8 * length);
        if (long) {
            this.#insets.push({ at: this.#length, numbers, size: 8 * length });
            this.#insetBytes += 8 * length;
            return this.#reserve(0);
        }
        this.#reserve(8 * length);
        if (littleEndian && length > 0) {
            this.#bytes.set(bytesOf(numbers), this.#length);
            this.#length += 8 * length;
            return;
        }
        for (let i = 0; i < length; ++i, this.#length += 8) {
            this.#view.setFloat64(this.#length, numbers[i], true);
        }
    }

    /** So that the numbers after the next head begin at a multiple of eight bytes. */
    #pad() {
        while ((this.#length + this.#insetBytes + headSize(longBytes)) % 8 !== 0) {
            for (const byte of emptyTag) this.#byte(byte);
        }
    }

    /** @param {number} value */
    #number(value) {
        this.#reserve(9);
        this.#bytes[this.#length] = double;
        this.#view.setFloat64(this.#length + 1, value);
        this.#length += 9;
    }

    /** @param {string} text */
    #text(text) {
        const { length } = text;
        this.#head(majorText, length);
        this.#reserve(length);
        const start = this.#length;
        for (let i = 0; i < length; ++i) {
            const unit = text.charCodeAt(i);
            if (unit > 0x7f) {
                this.#length = start - headSize(length);
                return this.#unicode(text);
            }
            this.#bytes[start + i] = unit;
        }
        this.#length = start + length;
    }

    /** @param {string} text */
    #unicode(text) {
        if (loneSurrogate.test(text)) {
            throw this.#refusal('WRONG_TYPE', 'This string has half a surrogate pair in it and is no valid text.');
        }
        const encoded = utf8.encode(text);
        this.#head(majorText, encoded.length);
        this.#reserve(encoded.length);
        this.#bytes.set(encoded, this.#length);
        this.#length += encoded.length;
    }

    /** @param {number} major @param {number} length */
    #head(major, length) {
        if (length < 24) return this.#byte(major + length);
        this.#reserve(5);
        if (length > mostBytes) throw this.#tooLarge();
        this.#bytes[this.#length] = major + 26;
        this.#view.setUint32(this.#length + 1, length);
        this.#length += 5;
    }

    /** @param {number} byte */
    #byte(byte) {
        this.#reserve(1);
        this.#bytes[this.#length++] = byte;
    }

    /** @param {number} more */
    #reserve(more) {
        const needed = this.#length + more;
        if (needed + this.#insetBytes > mostBytes) throw this.#tooLarge();
        if (needed <= this.#bytes.length) return;
        const grown = new Uint8Array(2 ** Math.ceil(Math.log2(needed)));
        grown.set(this.#bytes.subarray(0, this.#length));
        this.#bytes = grown;
        this.#view = new DataView(grown.buffer);
    }

    #tooLarge() {
        return this.#refusal('TOO_LARGE', `This is more than ${mostBytes} bytes of data.`);
    }

    /** @param {string} code @param {string} message */
    #refusal(code, message) {
        return new KnotworkError(code, pathOf(this.#trail), message);
    }
}

/** @param {number} length */
const headSize = (length) => (length < 24 ? 1 : 5);

/** @param {(string | number)[]} trail */
function pathOf(trail) {
    const parts = trail.map((step) => (typeof step === 'number' ? `[${step}]` : `.${step}`));
    return parts.join('').replace(/^\./, '');
}
