import { readFile, writeFile } from 'node:fs/promises';

import { PNG } from 'pngjs';

import { distribution, project } from './paths.mjs';

/** @typedef {{ side: number, radius: number, ground: number[], points: number[][], half: number }} Icon */

const steps = 12;  // pieces that stand for one Bézier curve
const sizes = [['icon-180.png', 180, false], ['icon-192.png', 192, true], ['icon-512.png', 512, true]];

/** @param {string} colour `#rgb` or `#rrggbb` */
function channels(colour) {
    const digits = colour.length === 4 ? [...colour.slice(1)].map((digit) => digit + digit) : colour.slice(1).match(/../g);
    return (digits ?? []).map((pair) => parseInt(pair, 16));
}

/** @param {number[][]} bezier four points @param {number} t */
function pointOf(bezier, t) {
    const weights = [(1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t ** 3];
    return [0, 1].map((axis) => bezier.reduce((sum, point, k) => sum + weights[k] * point[axis], 0));
}

/**
 * The icon of web/favicon.svg: a square with round corners, and one closed path of cubic Béziers.
 * @param {string} svg
 * @returns {Icon}
 */
function iconOf(svg) {
    const found = (/** @type {RegExp} */ pattern) => {
        const match = pattern.exec(svg);
        if (!match) throw new Error(`favicon.svg has nothing like ${pattern}`);
        return match.slice(1);
    };
    const [side, radius, colour] = found(/<rect width="(\d+)".* rx="(\d+)" fill="(#\w+)"/);
    const [shift, scale] = found(/translate\(([\d.]+) [\d.]+\) scale\(([\d.]+)\)/).map(Number);
    const [width] = found(/stroke-width="([\d.]+)"/).map(Number);
    const numbers = found(/ d="M([^"]+)z"/)[0].split(/[ C]/).map(Number);
    const corners = Array.from({ length: numbers.length / 2 }, (_, k) => [0, 1].map((axis) => shift + scale * numbers[2 * k + axis]));
    const points = [corners[0]];
    for (let k = 0; k + 3 < corners.length; k += 3) {
        for (let step = 1; step <= steps; step += 1) points.push(pointOf(corners.slice(k, k + 4), step / steps));
    }
    return { side: Number(side), radius: Number(radius), ground: channels(colour), points, half: scale * width / 2 };
}

/** @param {number} x @param {number} y @param {number[]} a @param {number[]} b */
function distanceToPiece(x, y, [ax, ay], [bx, by]) {
    const [dx, dy] = [bx - ax, by - ay];
    const t = Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy)));
    return Math.hypot(x - ax - t * dx, y - ay - t * dy);
}

/** How far a place is outside of a centred square with round corners. */
function outsideSquare(/** @type {number} */ x, /** @type {number} */ y, /** @type {number} */ side, /** @type {number} */ radius) {
    const over = [x, y].map((value) => Math.abs(value - side / 2) - side / 2 + radius);
    return Math.hypot(...over.map((value) => Math.max(0, value))) + Math.min(0, Math.max(...over)) - radius;
}

/**
 * The icon in so many pixels; what is masked, or set on a ground, has no corners of its own.
 * @param {Icon} icon
 * @param {number} pixels
 * @param {boolean} round
 */
function drawn({ side, radius, ground, points, half }, pixels, round) {
    const scale = side / pixels;
    const covered = (/** @type {number} */ distance) => Math.min(1, Math.max(0, 0.5 - distance / scale));
    const png = new PNG({ width: pixels, height: pixels });
    for (let k = 0; k < pixels * pixels; k += 1) {
        const [x, y] = [(k % pixels + 0.5) * scale, (Math.floor(k / pixels) + 0.5) * scale];
        let distance = Infinity;
        for (let i = 1; i < points.length; i += 1) {
            distance = Math.min(distance, distanceToPiece(x, y, points[i - 1], points[i]));
        }
        const line = covered(distance - half);
        const opacity = round ? covered(outsideSquare(x, y, side, radius)) : 1;
        png.data.set([...ground.map((channel) => channel + (255 - channel) * line), 255 * opacity], 4 * k);
    }
    return PNG.sync.write(png);
}

/** Writes the icon of the page in the sizes that systems ask for, drawn from web/favicon.svg. */
export async function writeIcons() {
    const icon = iconOf(await readFile(project('web/favicon.svg'), 'utf8'));
    for (const [name, pixels, round] of sizes) {
        await writeFile(distribution(String(name)), drawn(icon, Number(pixels), Boolean(round)));
    }
    await writeFile(distribution('icon-maskable-512.png'), drawn(icon, 512, false));
}
