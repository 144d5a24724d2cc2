// The element's modules where there is no DOM.
import assert from 'node:assert/strict';
import { it } from 'node:test';

const directory = process.env.KNOTWORK_DIST
    ? new URL(`file://${process.env.KNOTWORK_DIST}/`)
    : new URL('../../dist/', import.meta.url);

it('importing the element in Node defines a class and touches nothing', async () => {
    const before = Object.getOwnPropertyNames(globalThis).sort();
    const { KnotworkFigure, defineFigure } = await import(new URL('element-class.mjs', directory).href);
    assert.equal(typeof KnotworkFigure, 'function');
    defineFigure();
    defineFigure();
    await import(new URL('element.mjs', directory).href);
    assert.deepEqual(Object.getOwnPropertyNames(globalThis).sort(), before);
});
