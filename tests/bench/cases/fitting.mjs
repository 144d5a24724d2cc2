/** @type {import('./case.mjs').Case[]} */
export const fittingCases = [];
