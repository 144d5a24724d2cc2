// Tables of points: CSV, with semicolons, tabs or blanks in place of the commas, and with decimal
// commas where those part nothing else.

import { KnotworkError } from './errors.mjs';

const mostPoints = 100_000;
const mostLines = 200_000;
const mostCells = 1000;
const mostLetters = 1000;
const largest = 1e12;
const decimal = /^[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?$/;
const parameterNames = ['t', 'u', 'v', 'w'];
const groupNames = ['object', 'id', 'name', 'curve'];

/** @typedef {{ text: string, line: number, column: number }} Cell where it begins, counted from 1 */

/**
 * The points of a table, those of one name together, in the order in which they come.
 * @param {string} whole
 * @param {number} mostNames
 * @returns {{ name: string, points: number[][] }[]}
 */
export function readTable(whole, mostNames) {
    const separator = separatorOf(whole);
    const commas = separator !== ',';
    const rows = rowsOf(whole, separator);
    const { value: first } = rows.next();
    if (!first) throw refusal('WRONG_LENGTH', undefined, 'there is no point; give lines as 1.5,2 or 1.5,2,0');
    const header = first.some(({ text }) => text !== '' && !isNumber(text, commas));
    const columns = header ? namedColumns(first) : countedColumns(first);
    const reader = new PointReader(columns, commas, mostNames);
    if (!header) reader.add(first);
    for (const row of rows) reader.add(row);
    if (reader.groups.length === 0) throw refusal('WRONG_LENGTH', first[0], 'there is no point under these names');
    return reader.groups;
}

/** What parts the cells: the first line that is not empty says so. @param {string} whole */
function separatorOf(whole) {
    const line = /^[^\S\r\n]*[^\s#].*$/m.exec(whole)?.[0] ?? '';
    const bare = line.replace(/"[^"]*"/g, '');
    if (bare.includes('\t')) return '\t';
    if (bare.includes(';')) return ';';
    // 1,5 2,5 is two numbers, and so is 1, 5.
    return bare.includes(',') && !/\d,\d+[ ]+[-+.\d]/.test(bare) ? ',' : ' ';
}

/**
 * One after the other, so that what is wrong with a long table is found where it stands.
 * @param {string} whole
 * @param {string} separator
 * @returns {Generator<Cell[], undefined, void>} without empty lines and those that begin with #
 */
function* rowsOf(whole, separator) {
    const scanner = new Scanner(whole, separator);
    for (let count = 0; !scanner.finished;) {
        const row = scanner.row();
        if (row.length === 0) continue;
        if (count > mostPoints) {
            throw refusal('TOO_LARGE', row[0], `there are more than ${mostPoints} points`);
        }
        count += 1;
        yield row;
    }
}

class Scanner {
    #text;
    #separator;
    #at = 0;
    #line = 1;
    #lineStart = 0;

    /** @param {string} text @param {string} separator */
    constructor(text, separator) {
        this.#text = text;
        this.#separator = separator;
    }

    get finished() {
        return this.#at >= this.#text.length;
    }

    /** The cells of a line, and to where the next one begins. */
    row() {
        /** @type {Cell[]} */
        const cells = [];
        this.#skipBlanks();
        if (this.#text[this.#at] === '#') this.#at = this.#endOfLine();
        while (!this.#atEnd()) {
            if (cells.length === mostCells) throw refusal('TOO_LARGE', this.#here(''), `a line has at most ${mostCells} cells`);
            cells.push(this.#cell());
            this.#skipBlanks();
            if (this.#separator === ' ' || this.#atEnd()) continue;
            ++this.#at;
            this.#skipBlanks();
            // After the last separator of a line stands one more cell, an empty one.
            if (this.#atEnd()) cells.push(this.#here(''));
        }
        this.#nextLine();
        return cells;
    }

    #atEnd() {
        const letter = this.#text[this.#at];
        return letter === undefined || letter === '\n' || letter === '\r';
    }

    #endOfLine() {
        const end = /[\r\n]/g;
        end.lastIndex = this.#at;
        return end.exec(this.#text)?.index ?? this.#text.length;
    }

    #nextLine() {
        if (this.finished) return;
        if (this.#line === mostLines) throw refusal('TOO_LARGE', this.#here(''), `a table has at most ${mostLines} lines`);
        this.#at += this.#text.startsWith('\r\n', this.#at) ? 2 : 1;
        ++this.#line;
        this.#lineStart = this.#at;
    }

    /** Ends of lines in a cell. @param {number} from @param {number} end */
    #countLines(from, end) {
        for (const { 0: letters, index } of this.#text.slice(from, end).matchAll(/\r\n|[\r\n]/g)) {
            ++this.#line;
            this.#lineStart = from + index + letters.length;
        }
    }

    #skipBlanks() {
        while (this.#text[this.#at] === ' ' || (this.#text[this.#at] === '\t' && this.#separator !== '\t')) ++this.#at;
    }

    /** @param {string} text @returns {Cell} */
    #here(text) {
        return { text, line: this.#line, column: this.#at - this.#lineStart + 1 };
    }

    #cell() {
        const cell = this.#here('');
        if (this.#text[this.#at] === '"') {
            cell.text = this.#quoted(cell);
            return cell;
        }
        const from = this.#at;
        while (!this.#atEnd() && !this.#parts(this.#text[this.#at])) ++this.#at;
        cell.text = this.#text.slice(from, this.#at).trimEnd();
        return cell;
    }

    /** @param {string} letter */
    #parts(letter) {
        return letter === this.#separator || (this.#separator === ' ' && letter === '\t');
    }

    /** What stands between quotes, of which two are one within. @param {Cell} cell */
    #quoted(cell) {
        let inside = '';
        for (let from = this.#at + 1; ;) {
            const end = this.#text.indexOf('"', from);
            if (end < 0) throw refusal('SYNTAX', cell, 'this quote is never closed');
            inside += this.#text.slice(from, end);
            this.#countLines(from, end);
            this.#at = end + 1;
            if (this.#text[this.#at] !== '"') break;
            inside += '"';
            if (inside.length > mostLetters) throw refusal('TOO_LARGE', cell, `a cell has at most ${mostLetters} letters`);
            from = this.#at + 1;
        }
        this.#skipBlanks();
        if (this.#atEnd() || this.#parts(this.#text[this.#at]) || this.#separator === ' ') return inside;
        throw refusal('SYNTAX', this.#here(''), 'after a closing quote comes the end of the cell');
    }
}

/** @param {string} text @param {boolean} commas */
const isNumber = (text, commas) => decimal.test(commas ? text.replace(',', '.') : text);

/**
 * Which columns hold the coordinates and, perhaps, the names of objects.
 * @typedef {{ x: number, y: number, z: number, group: number }} Columns −1 for none
 */

/**
 * @param {Cell[]} header
 * @returns {Columns}
 */
function namedColumns(header) {
    const names = header.map(({ text }) => text.toLowerCase());
    const [x, y, z] = ['x', 'y', 'z'].map((name) => names.indexOf(name));
    const group = names.findIndex((name) => groupNames.includes(name));
    if (x >= 0 && y >= 0) return { x, y, z, group };
    if (x >= 0 || y >= 0) throw refusal('SYNTAX', header[Math.max(x, y)], 'columns with the names x and y come together');
    const others = names.flatMap((name, i) => (parameterNames.includes(name) || i === group ? [] : [i]));
    if (others.length === 2 || others.length === 3) {
        return { x: others[0], y: others[1], z: others[2] ?? -1, group };
    }
    throw refusal('SYNTAX', header[0], `the columns need the names x, y and, perhaps, z; here are ${names.length} others`);
}

/**
 * @param {Cell[]} row
 * @returns {Columns}
 */
function countedColumns(row) {
    const count = row.at(-1)?.text === '' ? row.length - 1 : row.length;
    if (count === 2 || count === 3) return { x: 0, y: 1, z: count === 3 ? 2 : -1, group: -1 };
    throw refusal('WRONG_LENGTH', row[0],
        `the line has ${count} cells, a point 2 or 3 numbers; a first line with names, as t,x,y,z, says which they are`);
}

/** Puts together the points of one name. */
class PointReader {
    /** @type {Map<string, number[][]>} */
    #found = new Map();

    /**
     * @param {Columns} columns
     * @param {boolean} commas
     * @param {number} mostNames
     */
    constructor(columns, commas, mostNames) {
        this.columns = columns;
        this.commas = commas;
        this.mostNames = mostNames;
        this.used = [columns.x, columns.y, ...(columns.z < 0 ? [] : [columns.z])];
    }

    /** @param {Cell[]} row */
    add(row) {
        const { group } = this.columns;
        const name = group < 0 ? '' : row[group]?.text ?? '';
        const points = this.#found.get(name) ?? [];
        if (points.length === 0 && this.#found.size === this.mostNames) {
            throw refusal('TOO_LARGE', row[group], `there are more than ${this.mostNames} names of objects`);
        }
        points.push(this.used.map((column) => coordinate(row, column, this.commas)));
        this.#found.set(name, points);
    }

    get groups() {
        return Array.from(this.#found, ([name, points]) => ({ name, points }));
    }
}

/** @param {Cell[]} row @param {number} column @param {boolean} commas */
function coordinate(row, column, commas) {
    const cell = row[column];
    if (cell === undefined || cell.text === '') {
        throw refusal('WRONG_LENGTH', cell ?? row.at(-1), `a coordinate is missing; the line has ${row.length} cells`);
    }
    if (!isNumber(cell.text, commas)) throw refusal('SYNTAX', cell, `${quote(cell.text)} is no number`);
    const number = Number(commas ? cell.text.replace(',', '.') : cell.text);
    if (Math.abs(number) <= largest) return number;
    throw refusal('OUT_OF_RANGE', cell, `${quote(cell.text)} is beyond ±1e12`);
}

/** @param {string} text */
const quote = (text) => `"${text.length > 40 ? `${text.slice(0, 40)}…` : text}"`;

/**
 * @param {string} code
 * @param {{ line: number, column: number } | undefined} at
 * @param {string} why
 */
function refusal(code, at, why) {
    const place = at ? `Line ${at.line}, column ${at.column}: ` : 'In this table ';
    return new KnotworkError(code, 'text', `${place}${why}.`);
}
