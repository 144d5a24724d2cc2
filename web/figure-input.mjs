// Hands and keys on the picture. A figure is a guest: wheel and finger scroll the page unless a
// handle is hit, Tab always leaves, and nothing is heard outside the figure's own elements.

/** @typedef {import('./page-module.mjs').App} App */

const shiftBit = 1;
const commandBit = 2;
const altBit = 4;

/** @param {{ shiftKey: boolean, ctrlKey: boolean, metaKey: boolean, altKey: boolean }} event */
function modifiersOf(event) {
    return (event.shiftKey ? shiftBit : 0) | (event.ctrlKey || event.metaKey ? commandBit : 0) |
        (event.altKey ? altBit : 0);
}

const lineHeight = 16;  // CSS pixels that a wheel's "line" stands for

export class FigureInput {
    /** @type {Set<string>} */
    #keysDown = new Set();
    #abort = new AbortController();

    /**
     * @param {HTMLElement} wrapper
     * @param {{ app: App, id: number, acted: () => void, readOnly: () => boolean,
     *     wheelZoom: () => string, shortcut: (event: KeyboardEvent) => boolean }} target `acted` is
     *     told after all that the application was told; `shortcut` gets the keys it had no use for
     */
    constructor(wrapper, target) {
        this.wrapper = wrapper;
        this.target = target;
        const options = { signal: this.#abort.signal };
        for (const [type, kind] of pointerKinds) {
            wrapper.addEventListener(type, (event) => this.#pointer(kind, /** @type {PointerEvent} */ (event)), options);
        }
        const active = { ...options, passive: false };
        wrapper.addEventListener('touchstart', (event) => this.#touch(event), active);
        wrapper.addEventListener('wheel', (event) => this.#wheel(event), active);
        wrapper.addEventListener('keydown', (event) => this.#key(event, true), options);
        wrapper.addEventListener('keyup', (event) => this.#key(event, false), options);
        wrapper.addEventListener('focus', () => this.#focused(), options);
        wrapper.addEventListener('blur', () => this.#releaseKeys(), options);
    }

    dispose() {
        this.#abort.abort();
    }

    /** @param {{ clientX: number, clientY: number }} event */
    #place(event) {
        const box = this.wrapper.getBoundingClientRect();
        return { x: event.clientX - box.left, y: event.clientY - box.top };
    }

    /**
     * @param {string} kind
     * @param {PointerEvent} event
     */
    #pointer(kind, event) {
        if (kind === 'down' && event.pointerType === 'mouse' && event.button > 1) return;
        const { app, id } = this.target;
        const { x, y } = this.#place(event);
        if (kind === 'down') app.focus(id);  // before the press, which a change of focus would end
        const taken = app.pointer(id, kind, x, y, event.buttons, modifiersOf(event), event.pointerType);
        if (kind === 'down' && taken) this.wrapper.setPointerCapture(event.pointerId);
        this.wrapper.style.cursor = app.cursor(id) || 'default';
        this.target.acted();
    }

    /**
     * Decides whether this finger drags or scrolls; the browser asks only once, here.
     * @param {TouchEvent} event
     */
    #touch(event) {
        const finger = event.touches[0];
        const { x, y } = this.#place(finger);
        const holds = event.touches.length === 1 && !this.target.readOnly() &&
            this.target.app.hits(this.target.id, x, y, 'touch');
        if (!holds) return;
        event.preventDefault();
        this.wrapper.focus({ preventScroll: true });
    }

    /** @param {WheelEvent} event */
    #wheel(event) {
        const mode = this.target.wheelZoom();
        let modifiers = modifiersOf(event);
        if (mode === 'never' && (modifiers & commandBit)) return;
        if (mode === 'focus' && this.wrapper.matches(':focus')) modifiers |= commandBit;
        const unit = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? lineHeight : 1;
        const { x, y } = this.#place(event);
        const { app, id } = this.target;
        if (app.wheel(id, x, y, event.deltaX * unit, event.deltaY * unit, modifiers)) {
            event.preventDefault();
        }
        this.target.acted();
    }

    /**
     * @param {KeyboardEvent} event
     * @param {boolean} down
     */
    #key(event, down) {
        if (event.key === 'Tab' || event.isComposing) return;
        const { app, id } = this.target;
        const taken = app.key(id, event.key, down, modifiersOf(event));
        if (taken || (down && this.target.shortcut(event))) event.preventDefault();
        if (down) this.#keysDown.add(event.key);
        else this.#keysDown.delete(event.key);
        const typed = down && event.key.length === 1 && !event.ctrlKey && !event.metaKey;
        if (typed) app.text(id, event.key);
        this.target.acted();
    }

    #focused() {
        this.target.app.focus(this.target.id);
        this.target.acted();
    }

    /** A key that is let go elsewhere would stay down here for ever. */
    #releaseKeys() {
        for (const key of this.#keysDown) this.target.app.key(this.target.id, key, false, 0);
        this.#keysDown.clear();
        this.target.acted();
    }
}

/** @type {[string, string][]} */
const pointerKinds = [
    ['pointerdown', 'down'],
    ['pointermove', 'move'],
    ['pointerup', 'up'],
    ['pointercancel', 'cancel'],
    ['pointerleave', 'leave'],
];
