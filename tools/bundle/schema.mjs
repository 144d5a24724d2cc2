import { writeFile } from 'node:fs/promises';

import { distribution } from './paths.mjs';

/**
 * Writes dist/schema.json, the JSON Schema of documents, as the built module itself describes them.
 * @param {URL} facade the delivered knotwork.mjs
 */
export async function writeSchema(facade) {
    const { load } = await import(facade.href);
    const schema = (await load()).documentSchema();
    await writeFile(distribution('schema.json'), `${JSON.stringify(schema, null, 2)}\n`);
}
