// What all figures of a page share: one module, one WebGL 2 context, one application, one loop.
//
// Each dirty and visible view is painted into the lower left corner of one hidden canvas and copied
// from there at once, so a page may hold more figures than a browser grants contexts. The loop runs
// only while a visible view asks for another frame.

import { loadPageModule } from './page-module.mjs';

/**
 * A figure as the stage sees it.
 * @typedef {object} View
 * @property {() => boolean} visible
 * @property {() => { width: number, height: number }} pixels size of its canvas in device pixels
 * @property {(source: HTMLCanvasElement) => void} copy takes the picture from the lower left corner
 * @property {() => void} ticked after each look at the view, painted or not
 * @property {(message: string) => void} failed
 */

const contextAttributes = {
    alpha: true,
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
    #context = null;
    /** Pictures painted so far. */
    painted = 0;

    /**
     * @param {import('./page-module.mjs').PageModule} module
     * @param {any} kw
     */
    constructor(module, kw) {
        this.kw = kw;
        this.module = module;
        this.canvas = document.createElement('canvas');
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
        const { width, height } = view.pixels();
        if (width === 0 || height === 0) return;
        this.#grow(width, height);
        this.app.render(id);
        view.copy(this.canvas);
        this.painted += 1;
    }

    /** @returns {string} '' or why there will be no pictures */
    #startDrawing() {
        const context = /** @type {WebGL2RenderingContext | null} */ (
            this.canvas.getContext('webgl2', contextAttributes));
        if (!context) return 'WebGL 2 is not available';
        this.#context = context;
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
     * The hidden canvas holds the largest view; it grows by halves so that dragging a window's
     * corner does not allocate at every step.
     * @param {number} width
     * @param {number} height
     */
    #grow(width, height) {
        if (this.canvas.width < width) this.canvas.width = Math.ceil(width * 1.25);
        if (this.canvas.height < height) this.canvas.height = Math.ceil(height * 1.25);
    }

    /** Without views the memory of the pictures goes back. */
    #rest() {
        if (this.#frame) cancelAnimationFrame(this.#frame);
        this.#frame = 0;
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
