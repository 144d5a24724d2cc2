import path from 'node:path';
import { fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('../../', import.meta.url));

/** @param {string[]} parts @returns {string} a file of the project */
export const project = (...parts) => path.join(root, ...parts);

/** @param {string[]} parts @returns {string} a file of what is delivered */
export const distribution = (...parts) => path.join(root, 'dist', ...parts);
