// Hands and keys on the picture. A figure is a guest: wheel and finger scroll the page unless a
// handle is hit, Tab always leaves, and nothing is heard outside the figure's own elements. A scene
// in space is turned by a finger that goes across; two fingers move and scale any picture.

/** @typedef {import('./page-module.mjs').App} App */

const shiftBit = 1;
const commandBit = 2;
const altBit = 4;

/** @param {{ shiftKey: boolean, ctrlKey: boolean, metaKey: boolean, altKey: boolean }} event */
function modifiersOf(event) {
    return (event.shiftKey ? shiftBit : 0) | (event.ctrlKey || event.metaKey ? commandBit : 0) |
        (event.altKey ? altBit : 0);
}

const runPause = 700;  // milliseconds after which presses of arrow keys are no longer one run
const lineHeight = 16;  // CSS pixels that a wheel's "line" stands for

export class FigureInput {
    /** @type {Set<string>} */
    #keysDown = new Set();
    #abort = new AbortController();
    /** @type {Map<number, { x: number, y: number }>} where fingers are, by pointer */
    #fingers = new Map();
    #pinching = false;
    /** @type {ReturnType<typeof setTimeout> | undefined} */
    #running;
    /** Whether the pointer that is down was a click that places. */
    #placing = false;

    /**
     * @param {HTMLElement} wrapper
     * @param {{ app: App, id: number, acted: () => void, readOnly: () => boolean,
     *     wheelZoom: () => string, shortcut: (event: KeyboardEvent) => boolean,
     *     before: (event: KeyboardEvent) => boolean, pressed: (key: string) => void,
     *     places: (x: number, y: number) => boolean }} target `acted` is told after all that the
     *     application was told; `before` has the first and `shortcut` the last chance at a key, and
     *     `pressed` hears of those that the application took; `places` answers whether a press was
     *     one that puts something there
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
        wrapper.addEventListener('contextmenu', (event) => this.#menu(event), active);
        wrapper.addEventListener('wheel', (event) => this.#wheel(event), active);
        wrapper.addEventListener('keydown', (event) => this.#key(event, true), options);
        wrapper.addEventListener('keyup', (event) => this.#key(event, false), options);
        wrapper.addEventListener('focusin', () => this.#focused(), options);
        wrapper.addEventListener('focusout', (event) => {
            if (!wrapper.contains(/** @type {Node | null} */ (event.relatedTarget))) this.#releaseKeys();
        }, options);
    }

    dispose() {
        clearTimeout(this.#running);
        this.#abort.abort();
    }

    /** The presses of arrow keys up to now are a gesture of their own; tells whether there were any. */
    settle() {
        if (this.#running === undefined) return false;
        clearTimeout(this.#running);
        this.#running = undefined;
        this.target.app.key(this.target.id, 'ArrowRight', false, 0);
        this.target.acted();
        return true;
    }

    /** Further presses within a moment belong to the same run. */
    run() {
        clearTimeout(this.#running);
        this.#running = setTimeout(() => this.settle(), runPause);
    }

    /** Whether a pointer has something in its hand. */
    get busy() {
        return this.#down;
    }

    #down = false;

    /** What a finger may do across the picture is the browser's to know before it comes down. */
    follow() {
        this.wrapper.toggleAttribute('data-space', this.#spatial);
    }

    get #spatial() {
        return this.target.app.spatial(this.target.id);
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
        const buttons = this.#spatial ? 3 : 2;
        if (kind === 'down' && event.pointerType === 'mouse' && event.button >= buttons) return;
        if (event.pointerType === 'touch' && this.#pinch(kind, event)) return;
        const { app, id } = this.target;
        const { x, y } = this.#place(event);
        if (this.#places(kind, event, x, y)) return;
        if (kind === 'down') this.settle();
        if (kind !== 'move') this.#down = kind === 'down';
        if (kind === 'down') app.focus(id);  // before the press, which a change of focus would end
        const taken = app.pointer(id, kind, x, y, event.buttons, modifiersOf(event), event.pointerType);
        if (kind === 'down' && taken) this.wrapper.setPointerCapture(event.pointerId);
        this.wrapper.style.cursor = app.cursor(id) || 'default';
        this.target.acted();
    }

    /**
     * A press that places belongs to the click until it is let go.
     * @param {string} kind
     * @param {PointerEvent} event
     * @param {number} x
     * @param {number} y
     */
    #places(kind, event, x, y) {
        if (kind === 'down' && event.button === 0 && this.target.places(x, y)) {
            this.#placing = true;
            this.target.acted();
            return true;
        }
        const was = this.#placing;
        if (kind !== 'move') this.#placing = false;
        return was && kind !== 'leave';
    }

    /**
     * Whether the fingers are two, or were until one of them was lifted: then they are one hand.
     * @param {string} kind
     * @param {PointerEvent} event
     */
    #pinch(kind, event) {
        const fingers = this.#fingers;
        const { app, id } = this.target;
        const before = spanOf(fingers);
        if (kind === 'down' || (kind === 'move' && fingers.has(event.pointerId))) {
            fingers.set(event.pointerId, this.#place(event));
        } else if (kind !== 'move') {
            fingers.delete(event.pointerId);
        }
        const now = spanOf(fingers);
        if (now && !this.#pinching) {
            const { x, y } = now;
            app.pointer(id, 'cancel', x, y, 0, 0, 'touch');
            this.#pinching = true;
        } else if (now && before && before.length > 0) {
            app.pinch(id, now.x, now.y, now.x - before.x, now.y - before.y, now.length / before.length);
        }
        const pinching = this.#pinching;
        if (fingers.size === 0) this.#pinching = false;
        if (pinching) this.target.acted();
        return pinching;
    }

    /** @param {MouseEvent} event the button that opens the menu moves the picture in space */
    #menu(event) {
        if (this.#spatial && event.button === 2) event.preventDefault();
    }

    /**
     * Decides whether this finger drags or scrolls; the browser asks only once, here.
     * @param {TouchEvent} event
     */
    #touch(event) {
        if (event.targetTouches.length === 2) {
            event.preventDefault();
            return;
        }
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
        if (mode === 'focus' && this.wrapper.matches(':focus-within')) modifiers |= commandBit;
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
        const runs = isOfRun(event);
        if (runs && !down) {
            this.#keysDown.delete(event.key);  // the run may go on
            return;
        }
        if (down && this.target.before(event)) {
            event.preventDefault();
            return;
        }
        if (down && !runs && event.key !== 'Shift') this.settle();
        const taken = app.key(id, event.key, down, modifiersOf(event));
        if (taken && runs) this.run();
        if (taken && down) this.target.pressed(event.key);
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
        this.settle();
        for (const key of this.#keysDown) this.target.app.key(this.target.id, key, false, 0);
        this.#keysDown.clear();
        this.target.acted();
    }
}

/** Keys of which several presses are one step of history. @param {KeyboardEvent} event */
function isOfRun({ key, ctrlKey, metaKey }) {
    return key.startsWith('Arrow') || (/^[rs]$/i.test(key) && !ctrlKey && !metaKey);
}

/**
 * Middle and distance of two fingers.
 * @param {Map<number, { x: number, y: number }>} fingers
 */
function spanOf(fingers) {
    if (fingers.size !== 2) return undefined;
    const [a, b] = fingers.values();
    return { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2, length: Math.hypot(a.x - b.x, a.y - b.y) };
}

/** @type {[string, string][]} */
const pointerKinds = [
    ['pointerdown', 'down'],
    ['pointermove', 'move'],
    ['pointerup', 'up'],
    ['pointercancel', 'cancel'],
    ['pointerleave', 'leave'],
];
