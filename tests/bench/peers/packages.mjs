// The npm packages that are CommonJS.
import { createRequire } from 'node:module';

const require = createRequire(import.meta.url);

/** verb greets on standard output when it is loaded. @param {string} name */
function quietly(name) {
    const { log } = console;
    console.log = () => {};
    try {
        return require(name);
    } finally {
        console.log = log;
    }
}

export const glCatmullClark = require('gl-catmull-clark');
export const nurbs = require('nurbs');
export const verb = quietly('verb-nurbs-web');
