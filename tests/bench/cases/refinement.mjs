/** @type {import('./case.mjs').Case[]} */
export const refinementCases = [];
