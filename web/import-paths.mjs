// Paths of SVG as B-spline curves (W3C, Scalable Vector Graphics 2, chapter 9.3).
//
// Every piece of a path becomes one curve that is the path exactly: of degree 3 with three equal
// knots between segments, or of degree 1 where it has lines only. Arcs are cubic curves of at most
// 45°, which are nowhere farther away than 5e-6 of the radius. The pictures of SVG have y downwards,
// so y changes its sign. Transformations are not looked at.

import { KnotworkError } from './errors.mjs';

const mostPoints = 100_000;
const farthest = 1e12;

/** How many numbers follow each command. @type {Record<string, number>} */
const arity = { m: 2, l: 2, h: 1, v: 1, c: 6, s: 4, q: 4, t: 2, a: 7, z: 0 };

/** @typedef {[number, number]} Pair */
/** @typedef {Pair[]} Segment the points after the one where it begins: one of a line, three of a cubic */

/**
 * @param {string} whole a document, or the data of one path
 * @param {number} mostPieces
 * @returns {object[]} the specifications of curves
 */
export function readPaths(whole, mostPieces) {
    const paths = whole.trimStart().startsWith('<') ? pathsIn(whole) : [{ data: whole, at: 0 }];
    const pieces = [];
    for (const { data, at } of paths) {
        pieces.push(...new PathReader(data, (offset) => placeOf(whole, at + offset)).read());
        if (pieces.length <= mostPieces) continue;
        throw new KnotworkError('TOO_LARGE', 'text', `${placeOf(whole, at)}there are more than ${mostPieces} pieces of paths.`);
    }
    if (pieces.length > 0) return pieces.map(curveOf);
    throw new KnotworkError('WRONG_LENGTH', 'text', 'There is no path here: give <path d="…"> or its data, as M0 0L1 1.');
}

/** The data of all paths of a document, one after the other. @param {string} whole */
function* pathsIn(whole) {
    for (const match of whole.matchAll(/<path\b[^<>]*?\sd\s*=\s*(?:"([^"<]*)"|'([^'<]*)')/gd)) {
        const group = match[1] === undefined ? 2 : 1;
        yield { data: match[group], at: /** @type {any} */ (match).indices[group][0] };
    }
}

/** @param {string} whole @param {number} offset */
function placeOf(whole, offset) {
    const before = whole.slice(0, offset).split(/\r\n|[\r\n]/);
    return `Line ${before.length}, column ${/** @type {string} */ (before.at(-1)).length + 1}: `;
}

class PathReader {
    #data;
    #place;
    #at = 0;
    /** @type {{ start: Pair, segments: Segment[] }[]} */
    #pieces = [];
    /** @type {Pair} */
    #here = [0, 0];
    /** @type {Pair} */
    #start = [0, 0];
    /** The control point that a smooth command reflects, and of which degree. */
    #control = { degree: 0, point: /** @type {Pair} */ ([0, 0]) };
    #points = 0;

    /** @param {string} data @param {(offset: number) => string} place */
    constructor(data, place) {
        this.#data = data;
        this.#place = place;
    }

    read() {
        this.#skip(/[\s]*/y);
        let first = true;
        while (this.#at < this.#data.length) {
            const letter = this.#data[this.#at];
            if (!/[mlhvcsqtaz]/i.test(letter) || (first && !/m/i.test(letter))) {
                throw this.#refusal('SYNTAX', first ? 'a path begins with M' : `${JSON.stringify(letter)} is no command of a path`);
            }
            ++this.#at;
            this.#command(letter);
            first = false;
        }
        return this.#pieces.filter(({ segments }) => segments.length > 0);
    }

    /** A command with all the lists of numbers that follow it. @param {string} letter */
    #command(letter) {
        const name = letter.toLowerCase();
        const relative = letter === name;
        this.#skip(/\s*/y);
        if (name === 'z') return this.#close();
        for (let again = false; !again || this.#startsNumber(); again = true) {
            const numbers = Array.from({ length: arity[name] }, (_, i) => this.#number(name === 'a' && (i === 3 || i === 4)));
            this.#step(again && name === 'm' ? 'l' : name, numbers, relative);
        }
    }

    /** @param {string} name @param {number[]} numbers @param {boolean} relative */
    #step(name, numbers, relative) {
        const [x, y] = relative ? this.#here : [0, 0];
        /** @param {number} i @returns {Pair} */
        const pair = (i) => [numbers[i] + x, numbers[i + 1] + y];
        switch (name) {
            case 'm': return this.#move(pair(0));
            case 'l': return this.#line(pair(0));
            case 'h': return this.#line([numbers[0] + x, this.#here[1]]);
            case 'v': return this.#line([this.#here[0], numbers[0] + y]);
            case 'c': return this.#cubic(pair(0), pair(2), pair(4));
            case 's': return this.#cubic(this.#reflected(3), pair(0), pair(2));
            case 'q': return this.#quadratic(pair(0), pair(2));
            case 't': return this.#quadratic(this.#reflected(2), pair(0));
            default: return this.#arc(numbers, pair(5));
        }
    }

    /** @param {Pair} to */
    #move(to) {
        this.#count();
        this.#here = this.#start = to;
        this.#control.degree = 0;
        this.#pieces.push({ start: to, segments: [] });
    }

    #close() {
        const [x, y] = this.#here;
        if (x !== this.#start[0] || y !== this.#start[1]) this.#line(this.#start);
        this.#here = this.#start;
        this.#count();
        // What follows without a move begins where this piece began.
        this.#pieces.push({ start: this.#start, segments: [] });
        this.#control.degree = 0;
    }

    /** A step more, of as many points as it may need. */
    #count() {
        this.#points += 3;
        if (this.#points >= mostPoints) throw this.#refusal('TOO_LARGE', `the path has more than ${mostPoints} points`);
    }

    /** @param {Segment} segment */
    #add(segment) {
        this.#count();
        if (segment.some((pair) => pair.some((c) => !(Math.abs(c) <= farthest)))) {
            throw this.#refusal('OUT_OF_RANGE', 'a coordinate is beyond ±1e12');
        }
        /** @type {{ segments: Segment[] }} */ (this.#pieces.at(-1)).segments.push(segment);
        this.#here = /** @type {Pair} */ (segment.at(-1));
    }

    /** @param {Pair} to */
    #line(to) {
        this.#add([to]);
        this.#control.degree = 0;
    }

    /** @param {Pair} first @param {Pair} second @param {Pair} to */
    #cubic(first, second, to) {
        this.#add([first, second, to]);
        this.#control = { degree: 3, point: second };
    }

    /** @param {Pair} middle @param {Pair} to */
    #quadratic(middle, to) {
        const from = this.#here;
        this.#add([between(from, middle, 2 / 3), between(to, middle, 2 / 3), to]);
        this.#control = { degree: 2, point: middle };
    }

    /** The last control point mirrored in where the path stands. @param {number} degree @returns {Pair} */
    #reflected(degree) {
        if (this.#control.degree !== degree) return this.#here;
        return between(this.#control.point, this.#here, 2);
    }

    /** @param {number[]} numbers @param {Pair} to */
    #arc([rx, ry, turn, large, sweep], to) {
        for (const segment of arcSegments(this.#here, to, Math.abs(rx), Math.abs(ry), turn * Math.PI / 180, large === 1, sweep === 1)) {
            this.#add(segment);
        }
        this.#control.degree = 0;
    }

    /** A number, or a flag of an arc, which needs nothing after it. @param {boolean} flag */
    #number(flag) {
        const found = this.#match(flag ? /[01]/y : /[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?/y);
        if (found === '') throw this.#refusal('SYNTAX', flag ? 'here stands a flag, 0 or 1' : 'here a number is missing');
        this.#skip(/\s*(?:,\s*)?/y);
        return Number(found);
    }

    #startsNumber() {
        return /[-+.\d]/.test(this.#data[this.#at] ?? '');
    }

    /** @param {RegExp} pattern sticky */
    #match(pattern) {
        pattern.lastIndex = this.#at;
        const found = pattern.exec(this.#data)?.[0] ?? '';
        this.#at += found.length;
        return found;
    }

    /** @param {RegExp} pattern */
    #skip(pattern) {
        this.#match(pattern);
    }

    /** @param {string} code @param {string} why */
    #refusal(code, why) {
        return new KnotworkError(code, 'text', `${this.#place(this.#at)}${why}.`);
    }
}

/** @param {Pair} a @param {Pair} b @param {number} s @returns {Pair} */
const between = (a, b, s) => [a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1])];

/**
 * From the ends of an arc to its middle and angles (SVG 2, appendix B.2.4), and on to cubic curves.
 * @param {Pair} from @param {Pair} to @param {number} rx @param {number} ry @param {number} turn
 * @param {boolean} large @param {boolean} sweep
 * @returns {Segment[]}
 */
function arcSegments(from, to, rx, ry, turn, large, sweep) {
    if (from[0] === to[0] && from[1] === to[1]) return [];
    if (rx === 0 || ry === 0) return [[to]];
    const [cos, sin] = [Math.cos(turn), Math.sin(turn)];
    const [hx, hy] = [(from[0] - to[0]) / 2, (from[1] - to[1]) / 2];
    // On the unit circle: half the chord, turned back and divided by the radii.
    const [x, y] = [(cos * hx + sin * hy) / rx, (cos * hy - sin * hx) / ry];
    const scale = Math.max(1, Math.hypot(x, y)); // radii too small grow until they reach
    const [ux, uy] = [x / scale, y / scale];
    const away = Math.sqrt(Math.max(0, 1 / (ux * ux + uy * uy) - 1)) * (large === sweep ? -1 : 1);
    const middle = [away * uy, -away * ux];
    const begin = Math.atan2(uy - middle[1], ux - middle[0]);
    const span = Math.atan2(-uy - middle[1], -ux - middle[0]) - begin;
    const angle = sweep ? (span < 0 ? span + 2 * Math.PI : span) : (span > 0 ? span - 2 * Math.PI : span);
    /** From the unit circle to the ellipse. @param {number} c @param {number} s @returns {Pair} */
    const outside = (c, s) => {
        const [px, py] = [(middle[0] + c) * rx * scale, (middle[1] + s) * ry * scale];
        return [(from[0] + to[0]) / 2 + cos * px - sin * py, (from[1] + to[1]) / 2 + sin * px + cos * py];
    };
    return circleSegments(begin, angle, outside, to);
}

/**
 * @param {number} begin @param {number} angle
 * @param {(x: number, y: number) => Pair} place where a point near the unit circle stands
 * @param {Pair} to
 * @returns {Segment[]}
 */
function circleSegments(begin, angle, place, to) {
    const count = Math.max(1, Math.ceil(Math.abs(angle) / (Math.PI / 4) - 1e-9));
    const step = angle / count;
    const reach = 4 / 3 * Math.tan(step / 4);
    return Array.from({ length: count }, (_, i) => {
        const [a, b] = [begin + i * step, begin + (i + 1) * step];
        return [
            place(Math.cos(a) - reach * Math.sin(a), Math.sin(a) + reach * Math.cos(a)),
            place(Math.cos(b) + reach * Math.sin(b), Math.sin(b) - reach * Math.cos(b)),
            i + 1 === count ? to : place(Math.cos(b), Math.sin(b)),
        ];
    });
}

/** @param {{ start: Pair, segments: Segment[] }} piece */
function curveOf({ start, segments }) {
    const straight = segments.every(({ length }) => length === 1);
    const degree = straight ? 1 : 3;
    const points = [start];
    for (const segment of segments) {
        points.push(...(straight || segment.length === 3 ? segment : asCubic(/** @type {Pair} */ (points.at(-1)), segment[0])));
    }
    const inner = Array.from({ length: segments.length + 1 }, (_, i) => Array(degree).fill(i)).flat();
    const upright = points.map(([x, y]) => [x, y === 0 ? 0 : -y]);
    return { type: 'bspline-curve', degree, points: upright, knots: [0, ...inner, segments.length] };
}

/** @param {Pair} from @param {Pair} to @returns {Segment} */
const asCubic = (from, to) => [between(from, to, 1 / 3), between(from, to, 2 / 3), to];
