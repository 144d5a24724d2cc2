// Colours and measures that figure and page share, as custom properties of CSS.
//
// Neutral greys with a little blue, one accent; every pair of text and ground has a contrast of
// 4.5 to 1 or more, controls 3 to 1.

const light = `
    color-scheme: light;
    --ground: #ffffff;
    --raised: #f5f6f8;
    --line: #dde0e6;
    --edge: #858c99;
    --ink: #1b1f27;
    --quiet: #565d6b;
    --accent: #2458c5;
    --on-accent: #ffffff;
    --wash: #e9effb;
    --bad: #b3261e;
    --bad-wash: #fcecea;`;

const dark = `
    color-scheme: dark;
    --ground: #14161b;
    --raised: #1c1f26;
    --line: #30343d;
    --edge: #7a8190;
    --ink: #e8eaef;
    --quiet: #a3a9b6;
    --accent: #8fb1ff;
    --on-accent: #10131a;
    --wash: #243049;
    --bad: #ff9d94;
    --bad-wash: #3a2220;`;

export const tokens = { light, dark };
