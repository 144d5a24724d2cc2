// The picture of a figure: its canvas, its exact size in device pixels, and whether anyone sees it.

import { el } from './dom.mjs';
import { drawLabels } from './figure-labels.mjs';

/** @typedef {import('./stage.mjs').Stage} Stage */

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
            pixels: () => ({ width: this.#width, height: this.#height }),
            copy: (source) => this.#copy(source),
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

    /** @param {HTMLCanvasElement} source */
    #copy(source) {
        const context = this.canvas.getContext('2d');
        if (!context || !this.#stage) return;
        const [width, height] = [this.#width, this.#height];
        context.setTransform(1, 0, 0, 1, 0, 0);
        context.globalCompositeOperation = 'copy';
        context.drawImage(source, 0, source.height - height, width, height, 0, 0, width, height);
        context.globalCompositeOperation = 'source-over';
        context.setTransform(this.#ratio, 0, 0, this.#ratio, 0, 0);
        drawLabels(context, JSON.parse(this.#stage.app.labels(this.id) || '[]'));
        this.listener.painted();
    }
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
