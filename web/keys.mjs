// Every key and gesture of a figure, once: the help is made from this list, and a test compares it
// with what the code takes.

/**
 * Keys by their names in KeyboardEvent.key; `command` is Ctrl, or ⌘ on a Mac.
 * @typedef {object} KeyEntry
 * @property {string} does key of the words that say what happens
 * @property {string[]} keys any of these
 * @property {string[]} [with] modifiers to hold
 */

/** Keys that the picture takes while it has the focus. @type {KeyEntry[]} */
export const pictureKeys = [
    { does: 'help.next', keys: ['PageDown', 'PageUp'] },
    { does: 'help.next-too', keys: ['PageDown', 'PageUp'], with: ['Shift'] },
    { does: 'help.all', keys: ['a'], with: ['command'] },
    { does: 'help.kind', keys: ['k'] },
    { does: 'help.move', keys: ['ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown'] },
    { does: 'help.move-far', keys: ['ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown'], with: ['Shift'] },
    { does: 'help.turn', keys: ['ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown'] },
    { does: 'help.turn-local', keys: ['r'] },
    { does: 'help.turn-back', keys: ['r'], with: ['Shift'] },
    { does: 'help.larger', keys: ['s'] },
    { does: 'help.smaller', keys: ['s'], with: ['Shift'] },
    { does: 'help.look', keys: ['1', '3', '7', '5'] },
    { does: 'help.remove', keys: ['Delete', 'Backspace'] },
    { does: 'help.values', keys: ['Enter'] },
    { does: 'help.escape', keys: ['Escape'] },
    { does: 'help.zoom', keys: ['+', '=', '-'] },
    { does: 'help.fit', keys: ['0'] },
    { does: 'help.play', keys: [' '] },
];

/** Keys of the page, wherever no field has the focus. @type {KeyEntry[]} */
export const pageKeys = [
    { does: 'help.undo', keys: ['z'], with: ['command'] },
    { does: 'help.redo', keys: ['z'], with: ['command', 'Shift'] },
    { does: 'help.redo', keys: ['y'], with: ['command'] },
    { does: 'help.paste', keys: ['v'], with: ['command'] },
];

/** What hands do, and what happens; both are keys of words. @type {{ how: string, does: string }[]} */
export const mouseGestures = [
    { how: 'help.mouse.drag', does: 'help.mouse.drag.does' },
    { how: 'help.mouse.snap', does: 'help.mouse.snap.does' },
    { how: 'help.mouse.axis', does: 'help.mouse.axis.does' },
    { how: 'help.mouse.knot', does: 'help.mouse.knot.does' },
    { how: 'help.mouse.tool', does: 'help.mouse.tool.does' },
    { how: 'help.mouse.value', does: 'help.mouse.value.does' },
    { how: 'help.mouse.double', does: 'help.mouse.double.does' },
    { how: 'help.mouse.double-knot', does: 'help.mouse.double-knot.does' },
    { how: 'help.mouse.several', does: 'help.mouse.several.does' },
    { how: 'help.mouse.band', does: 'help.mouse.band.does' },
    { how: 'help.mouse.clicks', does: 'help.mouse.clicks.does' },
    { how: 'help.mouse.empty', does: 'help.mouse.empty.does' },
    { how: 'help.mouse.space', does: 'help.mouse.space.does' },
    { how: 'help.mouse.seam', does: 'help.mouse.seam.does' },
    { how: 'help.mouse.right', does: 'help.mouse.right.does' },
    { how: 'help.mouse.wheel', does: 'help.mouse.wheel.does' },
    { how: 'help.mouse.drop', does: 'help.mouse.drop.does' },
];

/** @type {{ how: string, does: string }[]} */
export const touchGestures = [
    { how: 'help.touch.drag', does: 'help.touch.drag.does' },
    { how: 'help.touch.several', does: 'help.touch.several.does' },
    { how: 'help.touch.scroll', does: 'help.touch.scroll.does' },
    { how: 'help.touch.turn', does: 'help.touch.turn.does' },
    { how: 'help.touch.two', does: 'help.touch.two.does' },
];
