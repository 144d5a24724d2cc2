// Drawings of the built-in scenes in a view of 1600 × 1000 pixels, as a share of a frame of 60 Hz.
// What is measured goes through the public interface: shapes as typed arrays, copied out.

/** @typedef {import('./case.mjs').Case} Case */
/** @typedef {import('./case.mjs').Work} Work */

const frame = 1000 / 60;  // milliseconds
/** A drawing may take a quarter of a frame or so: the rest is the renderer's and the page's. */
const most = 4;
const [width, height] = [1600, 1000];
const invisible = 0.15;   // pixels of chord error, as the page has it
const another = Infinity;

/** A frame of the screen, which comes when it comes. */
const screen = {
    name: 'a frame of 60 Hz', tolerance: another, atLeast: frame / most,
    work: () => ({ act: () => [], time: () => Promise.resolve(frame), dispose: () => {} }),
};

/** The tolerance of a view that fits the scene. @param {any} scene */
function toleranceOf(scene) {
    const { bounds } = scene.drawing({ tolerance: 0.1, panes: ['curve'] });
    const [x, y] = [0, 1].map((c) => bounds.max[c] - bounds.min[c]);
    const exact = invisible / Math.min(width / x, height / y);
    return 2 ** Math.floor(Math.log2(exact));
}

/** @param {any} drawing */
const positionsOf = ({ shapes }) => shapes[0].positions;

/**
 * Two scenes by turns, so that nothing of the last drawing can be used again.
 * @param {any} kw @param {object} document @returns {Work}
 */
function anew(kw, document) {
    const scenes = [kw.scene(document), kw.scene(document)];
    const tolerance = toleranceOf(scenes[0]);
    const { panes } = scenes[0].document.view;
    let turn = 0;
    return {
        act: () => scenes[turn ^= 1].drawing({ tolerance, panes, phase: 0.3 }),
        digest: positionsOf,
        dispose: () => scenes.forEach((scene) => scene.dispose()),
    };
}

/** The frames of an animation, one after another. @param {any} kw @param {object} document @returns {Work} */
function playing(kw, document) {
    const scene = kw.scene(document);
    const tolerance = toleranceOf(scene);
    const { panes } = scene.document.view;
    let time = 0;
    return {
        act: () => scene.drawing({ tolerance, panes, time: time += frame / 1000 }),
        digest: positionsOf,
        dispose: () => scene.dispose(),
    };
}

/** @param {string} name @param {(kw: any) => Work} ours @returns {Case} */
const drawn = (name, ours) => ({ name, unit: 'drawing', amount: 1, ours, peers: [screen] });

/** One case a scene, and one more for its animation if it has one. @param {any} kw @returns {Case[]} */
export function drawingCases(kw) {
    return kw.scenes.flatMap((/** @type {any} */ { id, document }) => {
        const still = drawn(`drawing of ${id}, all of it anew`, () => anew(kw, document));
        if (document.effects.length === 0) return [still];
        return [still, drawn(`drawing of ${id}, playing`, () => playing(kw, document))];
    });
}
