// dist/schema.json, the JSON Schema of documents, against what the module accepts.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { test } from 'node:test';

import { distribution, load } from './support.mjs';

const kw = await load();
const schema = kw.documentSchema();

/**
 * What of JSON Schema the document's schema uses.
 * @returns {string | undefined} where the value does not fit
 */
function misfit(value, rule, path = '') {
    if (rule.$ref) return misfit(value, schema.$defs[rule.$ref.replace('#/$defs/', '')], path);
    if (rule.const !== undefined && value !== rule.const) return `${path} const`;
    if (rule.enum && !rule.enum.includes(value)) return `${path} enum`;
    if (rule.oneOf && rule.oneOf.filter((one) => !misfit(value, one, path)).length !== 1) return `${path} oneOf`;
    if (rule.anyOf && rule.anyOf.every((one) => misfit(value, one, path))) return `${path} anyOf`;
    for (const part of rule.allOf ?? []) {
        if (part.if && misfit(value, part.if, path)) continue;
        const found = misfit(value, part.then ?? part, path);
        if (found) return found;
    }
    if (rule.type === 'object' && (typeof value !== 'object' || value === null || Array.isArray(value))) return `${path} object`;
    if (rule.type === 'array' && !Array.isArray(value)) return `${path} array`;
    if (rule.type === 'string' && typeof value !== 'string') return `${path} string`;
    if (rule.type === 'boolean' && typeof value !== 'boolean') return `${path} boolean`;
    if (rule.type === 'number' && typeof value !== 'number') return `${path} number`;
    if (rule.type === 'integer' && !Number.isInteger(value)) return `${path} integer`;
    if (rule.pattern && !new RegExp(rule.pattern).test(value)) return `${path} pattern`;
    if (value < rule.minimum || value <= rule.exclusiveMinimum) return `${path} minimum`;
    if (value > rule.maximum || value >= rule.exclusiveMaximum) return `${path} maximum`;
    return misfitWithin(value, rule, path);
}

function misfitWithin(value, rule, path) {
    if (Array.isArray(value)) {
        if (value.length < rule.minItems || value.length > rule.maxItems) return `${path} length`;
        return rule.items && value.map((one, i) => misfit(one, rule.items, `${path}[${i}]`)).find(Boolean);
    }
    if (typeof value !== 'object' || value === null) return undefined;
    const missing = rule.required?.find((name) => !Object.hasOwn(value, name));
    if (missing) return `${path}.${missing} required`;
    const known = rule.properties ?? {};
    for (const [key, one] of Object.entries(value)) {
        if (!Object.hasOwn(known, key)) {
            if (rule.additionalProperties === false) return `${path}.${key} unknown`;
            continue;
        }
        const found = misfit(one, known[key], `${path}.${key}`);
        if (found) return found;
    }
    return undefined;
}

const curve = { type: 'bspline-curve', degree: 2, points: [[0, 0], [1, 1], [2, 0]] };
const with1 = (object) => ({ knotwork: 1, objects: [object] });

test('dist/schema.json is what the module says', async () => {
    const delivered = JSON.parse(await readFile(new URL('schema.json', distribution), 'utf8'));
    assert.deepEqual(delivered, schema);
});

test('the built-in scenes fit, as they are written and in their canonical form', () => {
    for (const { id, document } of kw.scenes) {
        assert.equal(misfit(document, schema), undefined, id);
        assert.equal(misfit(kw.scene(document).document, schema), undefined, id);
    }
});

test('documents that are accepted fit, those that are not do not', () => {
    const blend = { type: 'blending-curve', bFunction: { family: 'linear' }, model: { type: 'parametric-curve', name: 'circle' }, locals: { count: 3 } };
    const documents = [
        [with1(curve), true],
        [with1({ ...curve, weights: [1, 2, 1], id: 'a' }), true],
        [with1(blend), true],
        [with1({ ...blend, locals: [curve, curve], model: undefined }), true],
        [with1({ ...blend, poses: [{ local: 1, scale: [1, 2], rotate: { angle: 1 } }] }), true],
        [with1({ ...blend, bFunction: { family: 'mixed', of: [{ family: 'linear' }, { family: 'logistic', c: 3 }], weight: 1 } }), true],
        [{ knotwork: 1, objects: [curve], effects: [{ target: 'c1', kind: 'colour', to: '#00ff00' }] }, true],
        [{ objects: [curve] }, false],
        [with1({ ...curve, degree: 0 }), false],
        [with1({ ...curve, degree: 2.5 }), false],
        [with1({ ...curve, degree: '2' }), false],
        [with1({ ...curve, points: [[0], [1, 1], [2, 0]] }), false],
        [with1({ ...curve, colour: '#00ff00' }), false],
        [with1({ ...curve, style: { colour: 'green' } }), false],
        [with1({ ...curve, type: 'spline' }), false],
        [with1({ ...blend, bFunction: { family: 'logistic', c: 0 } }), false],
        [with1({ ...blend, bFunction: { family: 'expo-rational', lambda: 1 } }), false],
        [with1({ ...blend, model: { type: 'parametric-curve', name: 'circle', parameters: { a: 1 } } }), false],
        [{ knotwork: 1, objects: [curve], effects: [{ target: 'c1', kind: 'shake' }] }, false],
    ];
    for (const [given, good] of documents) {
        const document = JSON.parse(JSON.stringify(given));
        assert.equal(misfit(document, schema) === undefined, good, `${JSON.stringify(document)}: ${misfit(document, schema)}`);
        assert.equal(accepts(document), good, JSON.stringify(document));
    }
});

function accepts(document) {
    try {
        kw.scene(document).dispose();
        return true;
    } catch {
        return false;
    }
}

test('every field has a title and a description', () => {
    const bare = [];
    const look = (rule, path) => {
        for (const [name, one] of Object.entries(rule.properties ?? {})) {
            const structural = one.const !== undefined || ['objects', 'effects', 'parameters'].includes(name);
            if (!structural && !(one.title && one.description)) bare.push(`${path}.${name}`);
            look(one, `${path}.${name}`);
        }
        for (const one of [...(rule.oneOf ?? []), ...(rule.anyOf ?? [])]) look(one, path);
    };
    look(schema, '');
    for (const [name, one] of Object.entries(schema.$defs)) look(one, name);
    assert.deepEqual(bare, []);
});
