// The built-in scenes by what they are about: first what makes one curious, then in the order of a
// course.

/** @type {[topic: string, scenes: string[]][]} */
const topics = [
    ['effects', ['butterfly', 'rose', 'petals', 'surrounding-sphere']],
    ['splines', ['bspline-forms', 'three-forms', 'local-control', 'basis-functions', 'knot-insertion', 'oslo',
        'factor-matrices', 'through-points', 'fit']],
    ['b-functions', ['b-functions', 'b-function-axioms']],
    ['blending', ['blending-curve', 'blending-compare', 'bspline-model', 'blending-subdivision']],
    ['subdivision', ['lane-riesenfeld', 'subdivision-stencils', 'subdivision-surfaces']],
    ['surfaces', ['blending-cylinder', 'blending-surface']],
];

/**
 * All scenes in groups; those that no topic names stand in one of their own at the end.
 * @template {{ id: string }} Scene
 * @param {Scene[]} scenes
 * @returns {{ topic: string, scenes: Scene[] }[]}
 */
export function byTopic(scenes) {
    const named = new Set(topics.flatMap(([, ids]) => ids));
    const groups = topics.map(([topic, ids]) => ({
        topic, scenes: ids.flatMap((id) => scenes.filter((scene) => scene.id === id)),
    }));
    const others = scenes.filter(({ id }) => !named.has(id));
    return [...groups, { topic: 'others', scenes: others }].filter((group) => group.scenes.length > 0);
}
