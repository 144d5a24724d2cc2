// Scenes: opened, and changed under someone's hand, as shares of what a person does not notice.
import { work } from './case.mjs';

/** @typedef {import('./case.mjs').Case} Case */

const points = 10_000;

/** A document of so many points, half of them in one curve. */
function largeDocument() {
    const polygon = Array.from({ length: points / 2 }, (_, i) => [Math.cos(i / 50) * (1 + i / points), Math.sin(i / 50), i / points]);
    const short = polygon.slice(0, 50);
    return {
        knotwork: 1,
        objects: [
            { id: 'long', type: 'bspline-curve', degree: 3, points: polygon },
            ...Array.from({ length: points / 2 / short.length }, (_, i) => ({ id: `c${i}`, type: 'bspline-curve', degree: 3, points: short })),
        ],
    };
}

/**
 * A clock that takes exactly so many milliseconds: what we take is a share of it.
 * @param {number} milliseconds
 * @param {number} atMost the share of it that we promise to take at most
 * @returns {import('./case.mjs').Peer}
 */
const limit = (milliseconds, atMost) => ({
    name: `${milliseconds} ms`, tolerance: 0, atMost,
    work: () => ({ act: () => [1], time: async () => milliseconds, dispose() {} }),
});

/** @type {Case[]} */
export const sceneCases = [
    {
        name: 'a document of 10 000 points opened', unit: 'document', amount: 1,
        ours(kw) {
            const document = largeDocument();
            return work(() => {
                kw.scene(document).dispose();
                return Float64Array.of(1);
            });
        },
        peers: [limit(200, 1)],
    },
    {
        name: 'one point of a document of 10 000 moved', unit: 'move', amount: 1,
        ours(kw) {
            const scene = kw.scene(largeDocument());
            let turn = 0;
            return work(() => {
                turn += 1;
                scene.execute({ move: 'objects[0].points[2500]', to: [turn % 7, 1, 0], gesture: 'drag' });
                return Float64Array.of(1);
            }, () => scene.dispose());
        },
        peers: [limit(4, 1)],
    },
];
