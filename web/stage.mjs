// What all figures of a page share: one module, one WebGL 2 context, one application, one loop.
//
// Each dirty and visible view is painted on one hidden canvas and its picture handed over at once, so
// a page may hold more figures than a browser grants contexts. The loop runs only while a visible
// view asks for another frame.

import { LabelPainter } from './label-painter.mjs';
import { loadPageModule } from './page-module.mjs';

/** @typedef {HTMLCanvasElement | OffscreenCanvas} Source */
/** @typedef {{ width: number, height: number, ratio: number }} Size in device pixels */

/**
 * A figure as the stage sees it.
 * @typedef {object} View
 * @property {() => boolean} visible
 * @property {() => Size} pixels size of its canvas, and how many of them a CSS pixel has
 * @property {(source: Source, size: Size) => void} take the picture of this size, from the source's lower left
 * @property {() => void} ticked after each look at the view, painted or not
 * @property {(message: string) => void} failed
 */

/** @type {WebGLContextAttributes} */
const contextAttributes = {
    alpha: false,      // every picture covers its canvas, and what need not be blended is shown faster
    antialias: false,  // the renderer smooths its lines itself
    depth: true,
    stencil: false,
    premultipliedAlpha: true,
    preserveDrawingBuffer: false,
};

export class Stage {
    /** @type {Map<number, View>} */
    #views = new Map();
    #frame = 0;
    #lost = false;
    /** @type {WebGL2RenderingContext | null} */
    #context;
    /** @type {LabelPainter | undefined} */
    #labels;
    /** Pictures painted so far. */
    painted = 0;

    /**
     * @param {import('./page-module.mjs').PageModule} module
     * @param {any} kw
     */
    constructor(module, kw) {
        this.kw = kw;
        this.module = module;
        const { canvas, context } = makeCanvas();
        this.canvas = canvas;
        this.#context = context;
        this.app = new module.App(kw.session);
        this.unavailable = this.#startDrawing();
    }

    /**
     * @param {View} view
     * @returns {number}
     */
    add(view) {
        const id = this.app.addView();
        this.#views.set(id, view);
        return id;
    }

    /** @param {number} id */
    remove(id) {
        this.#views.delete(id);
        this.app.removeView(id);
        if (this.#views.size === 0) this.#rest();
    }

    /** Looks at all views before the next picture of the browser. */
    request() {
        if (this.#frame === 0 && !this.#lost && !this.unavailable) {
            this.#frame = requestAnimationFrame((now) => this.#tick(now));
        }
    }

    /**
     * Paints one view now, as after a change of size, when its canvas would otherwise be blank.
     * @param {number} id
     */
    paint(id) {
        const view = this.#views.get(id);
        if (!view || this.#lost || this.unavailable) return;
        const size = view.pixels();
        if (size.width === 0 || size.height === 0) return;
        this.#fit(size);
        this.app.render(id);
        // It may be lost a while before the page is told, and then has no picture to hand over.
        if (this.#context?.isContextLost()) return;
        this.#labels?.paint(JSON.parse(this.app.labels(id) || '[]'), size, size.ratio);
        view.take(this.canvas, size);
        this.painted += 1;
    }

    /** @returns {string} '' or why there will be no pictures */
    #startDrawing() {
        const context = this.#context;
        if (!context) return 'WebGL 2 is not available';
        this.#labels = new LabelPainter(context);
        this.canvas.addEventListener('webglcontextlost', (event) => this.#onLost(event));
        this.canvas.addEventListener('webglcontextrestored', () => this.#onRestored());
        this.handle = this.module.GL.registerContext(context, { majorVersion: 2, ...contextAttributes });
        this.module.GL.makeContextCurrent(this.handle);
        return this.app.start();
    }

    /** @param {number} now milliseconds of page time */
    #tick(now) {
        this.#frame = 0;
        let again = false;
        for (const [id, view] of [...this.#views]) {
            if (!this.#views.has(id) || !view.visible()) continue;
            this.app.tick(id, now / 1000);
            if (this.app.needsFrame(id)) this.paint(id);
            view.ticked();
            again ||= this.#views.has(id) && this.app.needsFrame(id);
        }
        if (again) this.request();
    }

    /**
     * A canvas whose picture is handed over has to have just its size; one that it is copied from
     * holds the largest, and grows by quarters so that dragging a window's corner does not allocate
     * at every step.
     * @param {Size} size
     */
    #fit({ width, height }) {
        const { canvas } = this;
        if (!handsOver(canvas)) {
            if (canvas.width < width) canvas.width = Math.ceil(width * 1.25);
            if (canvas.height < height) canvas.height = Math.ceil(height * 1.25);
            return;
        }
        if (canvas.width !== width) canvas.width = width;
        if (canvas.height !== height) canvas.height = height;
    }

    /** Without views the memory of the pictures goes back. */
    #rest() {
        if (this.#frame) cancelAnimationFrame(this.#frame);
        this.#frame = 0;
        this.#labels?.rest();
        this.canvas.width = 1;
        this.canvas.height = 1;
    }

    /** @param {Event} event */
    #onLost(event) {
        event.preventDefault();  // or it would never be restored
        this.#lost = true;
        if (this.#frame) cancelAnimationFrame(this.#frame);
        this.#frame = 0;
        this.app.contextLost();
        this.#labels?.forget();
    }

    #onRestored() {
        const isLost = () => this.#context?.isContextLost() ?? true;
        const problem = isLost() ? '' : this.app.contextRestored();
        if (isLost()) return;  // again, before it was of any use; this will be heard again too
        this.#lost = false;
        this.unavailable = problem;
        if (this.unavailable) {
            for (const view of this.#views.values()) view.failed(this.unavailable);
        }
        this.request();
    }
}

/**
 * Handing pictures over costs nothing where copying them takes as long as drawing them.
 * @param {Source} canvas
 * @returns {canvas is OffscreenCanvas}
 */
export function handsOver(canvas) {
    return 'transferToImageBitmap' in canvas;
}

/**
 * Browsers that know canvases off the page do not all draw in three dimensions on them.
 * @returns {{ canvas: Source, context: WebGL2RenderingContext | null }}
 */
function makeCanvas() {
    if (typeof OffscreenCanvas === 'function' && typeof ImageBitmapRenderingContext === 'function') {
        const canvas = new OffscreenCanvas(1, 1);
        const context = canvas.getContext('webgl2', contextAttributes);
        if (context) return { canvas, context };
    }
    const canvas = document.createElement('canvas');
    return { canvas, context: canvas.getContext('webgl2', contextAttributes) };
}

/** @type {Promise<Stage> | undefined} */
let shared;

/** The stage of this page; the first call fetches the module, and a failed fetch may be tried again. */
export function sharedStage() {
    shared ??= loadPageModule()
        .then(({ module, kw }) => new Stage(module, kw))
        .catch((error) => {
            shared = undefined;
            throw error;
        });
    return shared;
}
