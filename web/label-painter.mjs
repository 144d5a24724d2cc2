// Text in the picture: set by the browser (every script, its hinting), kept as pieces of one texture,
// and drawn by the context that draws the rest. A canvas of its own above the picture would halve the
// pictures a second where the browser has no graphics processor.

import { el } from './dom.mjs';

const family = 'system-ui, "Segoe UI", Roboto, "Noto Sans", "DejaVu Sans", sans-serif';
const haloWidth = 3.5;  // CSS pixels
const leastSide = 512;
const mostSide = 4096;

const vertexShader = `#version 300 es
uniform vec2 view;
layout(location = 0) in vec2 at;
layout(location = 1) in vec2 place;
out vec2 texel;
void main() {
    texel = place;
    gl_Position = vec4(2.0 * at.x / view.x - 1.0, 1.0 - 2.0 * at.y / view.y, 0.0, 1.0);
}`;

const fragmentShader = `#version 300 es
precision highp float;
uniform sampler2D pieces;
in vec2 texel;
out vec4 colour;
void main() {
    colour = texelFetch(pieces, ivec2(texel), 0);
}`;

/**
 * Positions and sizes in CSS pixels.
 * @typedef {object} Label
 * @property {string} text
 * @property {number} x
 * @property {number} y
 * @property {CanvasTextAlign} [align]
 * @property {CanvasTextBaseline} [baseline]
 * @property {number} [size]
 * @property {number | string} [weight]
 * @property {string} [colour]
 * @property {string} [halo] the colour of a rim round the letters
 */

/**
 * Where a text lies in the texture, and where its anchor lies in it; in device pixels.
 * @typedef {{ x: number, y: number, width: number, height: number, anchor: [number, number] }} Piece
 */

export class LabelPainter {
    #gl;
    /** @type {Map<string, Piece>} */
    #pieces = new Map();
    #side = leastSide;
    // Rows of pieces, as type is set in a case.
    #row = { x: 0, y: 0, height: 0 };
    /** @type {CanvasRenderingContext2D | null} */
    #context = null;
    /** @type {ReturnType<typeof makeObjects> | undefined} */
    #objects;

    /** @param {WebGL2RenderingContext} gl */
    constructor(gl) {
        this.#gl = gl;
    }

    /**
     * Draws into the lower left corner of what is bound, over what is there.
     * @param {Label[]} labels
     * @param {{ width: number, height: number }} pixels of the picture
     * @param {number} ratio device pixels a CSS pixel
     */
    paint(labels, { width, height }, ratio) {
        if (labels.length === 0) return;
        this.#objects ??= makeObjects(this.#gl, this.#side);
        const corners = this.#place(labels, ratio);
        if (corners) draw(this.#gl, this.#objects, corners, width, height);
    }

    /** The objects of a lost context are gone with it. */
    forget() {
        this.#objects = undefined;
        this.#empty();
    }

    /** Gives all memory back until there is something to paint again. */
    rest() {
        const objects = this.#objects;
        if (objects) {
            this.#gl.deleteTexture(objects.texture);
            this.#gl.deleteBuffer(objects.buffer);
            this.#gl.deleteVertexArray(objects.vertexArray);
            this.#gl.deleteProgram(objects.program);
        }
        this.#side = leastSide;
        this.#context = null;
        this.forget();
    }

    #empty() {
        this.#pieces.clear();
        this.#row = { x: 0, y: 0, height: 0 };
    }

    /**
     * @param {Label[]} labels
     * @param {number} ratio
     * @returns {Float32Array | undefined} nothing when they do not fit into the largest texture
     */
    #place(labels, ratio) {
        for (;;) {
            const corners = this.#corners(labels, ratio);
            if (corners) return corners;
            // When they are alone in the texture and still do not fit, it is too small.
            this.#empty();
            const alone = this.#corners(labels, ratio);
            if (alone) return alone;
            if (this.#side >= mostSide) return undefined;
            this.#grow();
        }
    }

    #grow() {
        this.#empty();
        this.#side *= 2;
        this.#context = null;
        const { texture } = /** @type {ReturnType<typeof makeObjects>} */ (this.#objects);
        allot(this.#gl, texture, this.#side);
    }

    /**
     * @param {Label[]} labels
     * @param {number} ratio
     * @returns {Float32Array | undefined} x, y and place in the texture of two triangles each
     */
    #corners(labels, ratio) {
        const corners = new Float32Array(24 * labels.length);
        for (const [i, label] of labels.entries()) {
            const piece = this.#pieceOf(label, ratio);
            if (!piece) return undefined;
            // Whole pixels keep letters as crisp as the browser has set them.
            const x = Math.round(label.x * ratio) - piece.anchor[0];
            const y = Math.round(label.y * ratio) - piece.anchor[1];
            for (const [k, [right, down]] of [[0, 0], [1, 0], [0, 1], [0, 1], [1, 0], [1, 1]].entries()) {
                const [dx, dy] = [right * piece.width, down * piece.height];
                corners.set([x + dx, y + dy, piece.x + dx, piece.y + dy], 24 * i + 4 * k);
            }
        }
        return corners;
    }

    /**
     * @param {Label} label
     * @param {number} ratio
     */
    #pieceOf({ x, y, ...looks }, ratio) {
        const key = JSON.stringify([ratio, ...Object.entries(looks).sort().flat()]);
        const known = this.#pieces.get(key);
        if (known) return known;
        const piece = this.#set(looks, ratio);
        if (piece) this.#pieces.set(key, piece);
        return piece;
    }

    /**
     * Sets a text in the next free place and sends it to the texture.
     * @param {Omit<Label, 'x' | 'y'>} looks
     * @param {number} ratio
     * @returns {Piece | undefined}
     */
    #set(looks, ratio) {
        this.#context ??= makePad(this.#side);
        const context = this.#context;
        if (!context) return undefined;
        context.setTransform(ratio, 0, 0, ratio, 0, 0);
        prepare(context, looks);
        const measured = context.measureText(looks.text);
        const rim = looks.halo ? haloWidth / 2 : 0;
        /** @param {number} extent */
        const pixels = (extent) => Math.ceil((extent + rim) * ratio) + 1;
        const left = pixels(measured.actualBoundingBoxLeft);
        const ascent = pixels(measured.actualBoundingBoxAscent);
        const width = Math.min(left + pixels(measured.actualBoundingBoxRight), mostSide);
        const height = ascent + pixels(measured.actualBoundingBoxDescent);
        const place = this.#take(width, height);
        if (!place) return undefined;
        context.setTransform(1, 0, 0, 1, 0, 0);
        context.clearRect(place.x, place.y, width, height);
        context.setTransform(ratio, 0, 0, ratio, place.x + left, place.y + ascent);
        write(context, looks);
        this.#send({ ...place, width, height });
        return { ...place, width, height, anchor: [left, ascent] };
    }

    /**
     * @param {number} width
     * @param {number} height
     */
    #take(width, height) {
        const row = this.#row;
        if (row.x + width > this.#side) this.#row = { x: 0, y: row.y + row.height, height: 0 };
        const { x, y } = this.#row;
        if (width > this.#side || y + height > this.#side) return undefined;
        this.#row = { x: x + width, y, height: Math.max(this.#row.height, height) };
        return { x, y };
    }

    /** @param {{ x: number, y: number, width: number, height: number }} area */
    #send({ x, y, width, height }) {
        const gl = this.#gl;
        const context = /** @type {CanvasRenderingContext2D} */ (this.#context);
        const { texture } = /** @type {ReturnType<typeof makeObjects>} */ (this.#objects);
        gl.bindTexture(gl.TEXTURE_2D, texture);
        gl.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, true);
        gl.texSubImage2D(gl.TEXTURE_2D, 0, x, y, gl.RGBA, gl.UNSIGNED_BYTE,
            context.getImageData(x, y, width, height));
        gl.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false);
        gl.bindTexture(gl.TEXTURE_2D, null);
    }
}

/** @param {number} side */
function makePad(side) {
    const canvas = el('canvas');
    canvas.width = side;
    canvas.height = side;
    return canvas.getContext('2d', { willReadFrequently: true });
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {Omit<Label, 'x' | 'y'>} looks
 */
function prepare(context, { size, weight, align, baseline }) {
    context.font = `${weight ?? 400} ${size ?? 12}px ${family}`;
    context.textAlign = align ?? 'left';
    context.textBaseline = baseline ?? 'alphabetic';
}

/**
 * @param {CanvasRenderingContext2D} context with its origin at the anchor, one unit a CSS pixel
 * @param {Omit<Label, 'x' | 'y'>} looks
 */
function write(context, { text, colour, halo }) {
    if (halo) {
        context.strokeStyle = halo;
        context.lineWidth = haloWidth;
        context.lineJoin = 'round';
        context.strokeText(text, 0, 0);
    }
    context.fillStyle = colour ?? '#888888';
    context.fillText(text, 0, 0);
}

/**
 * @param {WebGL2RenderingContext} gl
 * @param {number} side of the texture
 */
function makeObjects(gl, side) {
    const program = gl.createProgram();
    for (const [kind, source] of /** @type {[number, string][]} */ ([
        [gl.VERTEX_SHADER, vertexShader], [gl.FRAGMENT_SHADER, fragmentShader]])) {
        const shader = /** @type {WebGLShader} */ (gl.createShader(kind));
        gl.shaderSource(shader, source);
        gl.compileShader(shader);
        gl.attachShader(/** @type {WebGLProgram} */ (program), shader);
        gl.deleteShader(shader);  // lives as long as the program
    }
    gl.linkProgram(/** @type {WebGLProgram} */ (program));
    const texture = gl.createTexture();
    allot(gl, texture, side);
    const [buffer, vertexArray] = [gl.createBuffer(), gl.createVertexArray()];
    gl.bindVertexArray(vertexArray);
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    for (const location of [0, 1]) {
        gl.enableVertexAttribArray(location);
        gl.vertexAttribPointer(location, 2, gl.FLOAT, false, 16, 8 * location);
    }
    gl.bindVertexArray(null);
    gl.bindBuffer(gl.ARRAY_BUFFER, null);
    const view = gl.getUniformLocation(/** @type {WebGLProgram} */ (program), 'view');
    return { program, texture, buffer, vertexArray, view };
}

/**
 * @param {WebGL2RenderingContext} gl
 * @param {WebGLTexture | null} texture
 * @param {number} side
 */
function allot(gl, texture, side) {
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, side, side, 0, gl.RGBA, gl.UNSIGNED_BYTE, null);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    gl.bindTexture(gl.TEXTURE_2D, null);
}

/**
 * @param {WebGL2RenderingContext} gl
 * @param {ReturnType<typeof makeObjects>} objects
 * @param {Float32Array} corners
 * @param {number} width
 * @param {number} height
 */
function draw(gl, { program, texture, buffer, vertexArray, view }, corners, width, height) {
    gl.viewport(0, 0, width, height);
    gl.disable(gl.SCISSOR_TEST);
    gl.disable(gl.DEPTH_TEST);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    gl.useProgram(program);
    gl.uniform2f(view, width, height);
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ARRAY_BUFFER, corners, gl.STREAM_DRAW);
    gl.bindVertexArray(vertexArray);
    gl.drawArrays(gl.TRIANGLES, 0, corners.length / 4);
    gl.bindVertexArray(null);
    gl.bindBuffer(gl.ARRAY_BUFFER, null);
    gl.bindTexture(gl.TEXTURE_2D, null);
    gl.useProgram(null);
}
