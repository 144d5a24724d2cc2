// The picture of a figure: its canvas, its exact size in device pixels, and whether anyone sees it.

import { el } from './dom.mjs';
import { handsOver } from './stage.mjs';

/** @typedef {import('./stage.mjs').Stage} Stage */
/** @typedef {import('./stage.mjs').Source} Source */
/** @typedef {import('./stage.mjs').Size} Size */

export class FigureView {
    #width = 0;
    #height = 0;
    #ratio = 1;
    #onScreen = false;
    #resize = new ResizeObserver((entries) => this.#onResize(entries[entries.length - 1]));
    #crossing = new IntersectionObserver((entries) => this.#onCrossing(entries[entries.length - 1]));
    #gone = new AbortController();
    /** @type {Stage | undefined} */
    #stage;
    id = 0;

    /**
     * @param {HTMLElement} wrapper
     * @param {{ ticked: () => void, failed: (message: string) => void, painted: () => void,
     *     crossed: (onScreen: boolean) => void }} listener
     */
    constructor(wrapper, listener) {
        this.wrapper = wrapper;
        this.listener = listener;
        this.canvas = el('canvas', { attributes: { 'aria-hidden': 'true' } });
        wrapper.append(this.canvas);
        this.#crossing.observe(wrapper);
    }

    /** @param {Stage} stage */
    join(stage) {
        this.#stage = stage;
        this.id = stage.add({
            visible: () => this.#onScreen && this.#width > 0 && this.#height > 0,
            pixels: () => this.#shot?.size ?? { width: this.#width, height: this.#height, ratio: this.#ratio },
            take: (source, size) => this.#take(source, size),
            ticked: () => this.listener.ticked(),
            failed: (message) => this.listener.failed(message),
        });
        this.#observeSize();
        return this.id;
    }

    leave() {
        this.#gone.abort();
        this.#resize.disconnect();
        this.#crossing.disconnect();
        this.#stage?.remove(this.id);
        this.#stage = undefined;
        this.canvas.remove();
    }

    get onScreen() {
        return this.#onScreen;
    }

    /** Device pixels where the browser tells them, CSS pixels times the ratio where it does not. */
    #observeSize() {
        try {
            this.#resize.observe(this.wrapper, { box: 'device-pixel-content-box' });
        } catch {
            this.#observeRatio();
        }
    }

    /** Where the observer knows no device pixels, it does not hear of another ratio either. */
    #observeRatio() {
        this.#resize.unobserve(this.wrapper);
        this.#resize.observe(this.wrapper);
        matchMedia(`(resolution: ${window.devicePixelRatio}dppx)`)
            .addEventListener('change', () => this.#observeRatio(), { once: true, signal: this.#gone.signal });
    }

    /** @param {ResizeObserverEntry} entry */
    #onResize(entry) {
        const ratio = window.devicePixelRatio;
        const { inlineSize, blockSize } = entry.contentBoxSize[0];
        const exact = entry.devicePixelContentBoxSize?.[0];
        this.#width = wholePixels(inlineSize * ratio, exact?.inlineSize);
        this.#height = wholePixels(blockSize * ratio, exact?.blockSize);
        this.#ratio = ratio;
        this.canvas.width = this.#width;
        this.canvas.height = this.#height;
        this.#stage?.app.resize(this.id, this.#width / ratio, this.#height / ratio, ratio);
        if (this.#onScreen) this.#stage?.paint(this.id);  // setting the size has blanked the canvas
        this.#stage?.request();
    }

    /** @param {IntersectionObserverEntry} entry */
    #onCrossing(entry) {
        this.#onScreen = entry.isIntersecting;
        this.listener.crossed(this.#onScreen);
        if (this.#onScreen) this.#stage?.request();
    }

    /**
     * @param {Source} source
     * @param {Size} size
     */
    #take(source, size) {
        take(this.#shot?.canvas ?? this.canvas, source, size);
        if (!this.#shot) this.listener.painted();
    }

    /**
     * The picture as it is shown, in so many pixels; what is left out follows from the other, and
     * without both it is the canvas itself.
     * @param {number} [width]
     * @param {number} [height]
     */
    shot(width, height) {
        const stage = this.#stage;
        if (!stage || this.#width === 0 || (width === undefined && height === undefined)) return this.canvas;
        const [cssWidth, cssHeight] = [this.#width / this.#ratio, this.#height / this.#ratio];
        const ratio = width === undefined ? Number(height) / cssHeight : width / cssWidth;
        const canvas = el('canvas');
        canvas.width = width ?? Math.max(1, Math.round(cssWidth * ratio));
        canvas.height = height ?? Math.max(1, Math.round(cssHeight * ratio));
        this.#shot = { canvas, size: { width: canvas.width, height: canvas.height, ratio } };
        stage.app.resize(this.id, canvas.width / ratio, canvas.height / ratio, ratio);
        stage.paint(this.id);
        this.#shot = undefined;
        stage.app.resize(this.id, cssWidth, cssHeight, this.#ratio);
        stage.paint(this.id);
        return canvas;
    }

    /** What takes the picture in place of the canvas that is shown. @type {{ canvas: HTMLCanvasElement, size: Size } | undefined} */
    #shot;
}

/**
 * @param {HTMLCanvasElement} canvas
 * @param {Source} source
 * @param {Size} size
 */
function take(canvas, source, { width, height }) {
    if (handsOver(source)) {
        canvas.getContext('bitmaprenderer', { alpha: false })?.transferFromImageBitmap(source.transferToImageBitmap());
        return;
    }
    const context = canvas.getContext('2d', { alpha: false });
    if (!context) return;
    context.globalCompositeOperation = 'copy';
    context.drawImage(source, 0, source.height - height, width, height, 0, 0, width, height);
}

/**
 * The browser's own count differs from the rounded one by a pixel where boxes begin off the grid;
 * one that differs by more (emulated devices) does not know the ratio.
 * @param {number} computed
 * @param {number | undefined} told
 */
function wholePixels(computed, told) {
    return told !== undefined && Math.abs(told - computed) <= 1 ? told : Math.round(computed);
}
