// Text over the picture, drawn by the browser: every script, crisp at any pixel ratio.

const family = 'system-ui, "Segoe UI", Roboto, "Noto Sans", "DejaVu Sans", sans-serif';

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
 * @param {CanvasRenderingContext2D} context with one unit a CSS pixel
 * @param {Label[]} labels
 */
export function drawLabels(context, labels) {
    for (const label of labels) {
        context.font = `${label.weight ?? 400} ${label.size ?? 12}px ${family}`;
        context.textAlign = label.align ?? 'left';
        context.textBaseline = label.baseline ?? 'alphabetic';
        if (label.halo) {
            context.strokeStyle = label.halo;
            context.lineWidth = 3.5;
            context.lineJoin = 'round';
            context.strokeText(label.text, label.x, label.y);
        }
        context.fillStyle = label.colour ?? '#888888';
        context.fillText(label.text, label.x, label.y);
    }
}
