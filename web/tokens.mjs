// Colours and measures that figure and page share, as custom properties of CSS.
//
// Those of the picture itself (src/ui/theme.cpp). Neutral greys with a little blue, one accent; every
// pair of text and ground has a contrast of 4.5 to 1 or more, controls 3 to 1.

const light = `
    color-scheme: light;
    --ground: #fcfcfe;
    --raised: #f0f2f7;
    --line: #dce0e9;
    --edge: #7b8598;
    --ink: #1b2130;
    --quiet: #525c70;
    --accent: #2f5fd0;
    --on-accent: #ffffff;
    --wash: #e7edfb;
    --bad: #b3261e;
    --bad-wash: #fcecea;`;

const dark = `
    color-scheme: dark;
    --ground: #12151b;
    --raised: #1b2029;
    --line: #2b323e;
    --edge: #76829a;
    --ink: #e7eaf0;
    --quiet: #a0abbd;
    --accent: #86aaff;
    --on-accent: #0d1320;
    --wash: #222d45;
    --bad: #ff8f86;
    --bad-wash: #38211f;`;

const contrast = `
    color-scheme: light;
    --ground: #ffffff;
    --raised: #e6e6e6;
    --line: #000000;
    --edge: #000000;
    --ink: #000000;
    --quiet: #1c1c1c;
    --accent: #0b2f9c;
    --on-accent: #ffffff;
    --wash: #dde6ff;
    --bad: #8c0b0b;
    --bad-wash: #ffecec;`;

const contrastDark = `
    color-scheme: dark;
    --ground: #000000;
    --raised: #262626;
    --line: #ffffff;
    --edge: #ffffff;
    --ink: #ffffff;
    --quiet: #e6e6e6;
    --accent: #a9c2ff;
    --on-accent: #000000;
    --wash: #1c2a52;
    --bad: #ffb3ad;
    --bad-wash: #4a1512;`;

export const tokens = { light, dark, contrast, contrastDark };
