// The look of a figure, in its shadow tree. A constructed style sheet passes the strictest policy.

import { panesMenu, seams } from './figure-panes-style.mjs';
import { tokens } from './tokens.mjs';

const layout = `
:host { display: block; container-type: inline-size; }
:host([hidden]) { display: none; }
*, *::before, *::after { box-sizing: border-box; }
[hidden] { display: none !important; }
.frame {
    ${tokens.light}
    display: grid;
    grid-template: "column" auto "values" auto / minmax(0, 1fr);
    background: var(--ground);
    color: var(--ink);
    font: 400 0.9375rem/1.5 system-ui, "Segoe UI", Roboto, "Noto Sans", "DejaVu Sans", sans-serif;
    border: 1px solid var(--line);
    border-radius: 12px;
    overflow: clip;
    position: relative;
}
.frame[data-theme="dark"] { ${tokens.dark} }
.frame[data-theme="contrast"] { ${tokens.contrast} }
.frame[data-theme="contrast-dark"] { ${tokens.contrastDark} }
.column { grid-area: column; display: flex; flex-direction: column; min-width: 0;
    height: var(--knotwork-column-height, auto); }
.stage { position: relative; flex: 1 1 auto; min-height: 12rem; aspect-ratio: 16 / 9;
    width: 100%; height: var(--knotwork-height, auto); }
:host(:fullscreen) .frame { border: 0; border-radius: 0; height: 100vh; overflow: auto; }
:host(:fullscreen) .column { height: 100vh; }
:host(:fullscreen) .stage { height: auto; }
.view {
    position: absolute;
    inset: 0;
    outline: none;
    user-select: none;
    -webkit-user-select: none;
    -webkit-tap-highlight-color: transparent;
    touch-action: pan-x pan-y pinch-zoom;
}
.view[data-space] { touch-action: pan-y; }
.view canvas { position: absolute; inset: 0; width: 100%; height: 100%; }
.view:is(:focus-visible, :has(:focus-visible))::after {
    content: "";
    position: absolute;
    inset: 3px;
    border: 2px solid var(--accent);
    border-radius: 9px;
    pointer-events: none;
}
.stage[data-placing] .view { cursor: crosshair !important; }
.handle { position: absolute; inset: 0 auto auto 0; width: 0; height: 0; pointer-events: none; }
.handle input[type="range"] { position: absolute; inset: -16px auto auto -16px; width: 32px; height: 32px;
    min-width: 0; opacity: 0; }
.handle:has(:focus-visible)::after { content: ""; position: absolute; inset: -13px auto auto -13px; width: 26px;
    height: 26px; border: 2px solid var(--accent); border-radius: 50%; }
.clicks { position: absolute; inset: 0.5rem 0.5rem auto auto; max-width: calc(100% - 1rem); display: flex;
    flex-wrap: wrap; align-items: center; gap: 0.25rem 0.375rem; padding: 0.25rem 0.375rem 0.25rem 0.625rem;
    border: 1px solid var(--line); border-radius: 8px; background: var(--ground); font-size: 0.8125rem; }
.clicks[data-at="left"] { inset-inline: 0.5rem auto; }
.clicks[data-at="below"] { inset-block: auto 0.5rem; }
.clicks[data-busy] { visibility: hidden; }
.clicks-name { font-weight: 600; padding-inline-end: 0.25rem; }
.clicks-hint:empty { display: none; }
.clicks-hint { color: var(--quiet); padding-inline-end: 0.25rem; }
.quiet-button[aria-pressed="true"]:is(*, :hover) { background: var(--accent); border-color: var(--accent);
    color: var(--on-accent); }
${seams}
.fallback { position: absolute; inset: 0; display: grid; place-content: center; padding: 1.5rem;
    text-align: center; color: var(--quiet); overflow: auto; pointer-events: none; }
.fallback p { margin: 0; }
.waiting { animation: appear 0s 0.8s both; }
@keyframes appear { from { visibility: hidden; } to { visibility: visible; } }
.refusal { position: absolute; inset: auto 0.75rem 0.75rem; padding: 0.75rem 1rem; border-radius: 8px;
    background: var(--bad-wash); color: var(--ink); border-inline-start: 4px solid var(--bad);
    font-size: 0.875rem; overflow-wrap: anywhere; }
.refusal p { margin: 0; }
.progress { position: absolute; inset: auto 0.75rem 0.75rem; display: grid; grid-template-columns: minmax(0, 1fr) auto;
    align-items: center; gap: 0.375rem 0.75rem; margin-inline: auto; max-width: 30rem; padding: 0.625rem 0.75rem 0.75rem;
    border: 1px solid var(--line); border-radius: 10px; background: var(--ground); font-size: 0.875rem;
    box-shadow: 0 4px 16px rgb(0 0 0 / 12%); }
.progress-name { overflow-wrap: anywhere; }
.progress progress { grid-area: 2 / 1; appearance: none; -webkit-appearance: none; width: 100%; height: 6px; border: 0;
    border-radius: 3px; background: var(--wash); accent-color: var(--accent); }
.progress progress::-webkit-progress-bar { border-radius: 3px; background: var(--wash); }
.progress progress::-webkit-progress-value { border-radius: 3px; background: var(--accent); }
.progress progress::-moz-progress-bar { border-radius: 3px; background: var(--accent); }
.progress .quiet-button { grid-area: 1 / 2 / span 2; }
.aside { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%);
    white-space: nowrap; }
@container (min-width: 60rem) {
    .frame[data-values] {
        grid-template: "column values" auto / minmax(0, 1fr) minmax(20rem, 23rem);
    }
    .frame[data-values] .values {
        border-block-start: 0;
        border-inline-start: 1px solid var(--line);
        contain: size;
        overflow: auto;
        overscroll-behavior: contain;
    }
}
`;

const toolbar = `
.toolbar {
    flex: none;
    display: flex;
    flex-wrap: wrap;
    align-items: center;
    gap: 0.125rem 0.25rem;
    padding: 0.375rem 0.5rem;
    border-block-start: 1px solid var(--line);
}
.motion { display: flex; align-items: center; gap: 0.25rem; flex: 1 1 12rem; max-width: 30rem; }
/* Moves at every picture: on a layer of its own nothing else is painted again with it. */
.scrubber { will-change: transform; }
.spring { flex: 1 0 0; }
.button {
    display: inline-flex;
    align-items: center;
    justify-content: center;
    gap: 0.375rem;
    min-width: 36px;
    min-height: 36px;
    padding: 0.25rem;
    border: 0;
    border-radius: 8px;
    background: transparent;
    color: var(--ink);
    font: inherit;
    font-size: 0.875rem;
    cursor: pointer;
}
.button:hover { background: var(--raised); }
.button[aria-disabled="true"] { color: var(--edge); cursor: default; background: transparent; }
.frame[data-theme^="contrast"] .button[aria-disabled="true"] { opacity: 0.5; }
.button:is([aria-pressed="true"], [aria-expanded="true"]) { background: var(--wash); color: var(--accent); }
.button .caption { padding-inline-end: 0.375rem; white-space: nowrap; }
.button.captioned { padding-inline: 0.5rem 0.25rem; }
.button.roomy .caption { display: none; }
@container (min-width: 68rem) {
    .button.roomy .caption { display: inline; }
    .button.roomy:has(.caption) { padding-inline: 0.5rem 0.25rem; }
}
.icon { width: 20px; height: 20px; flex: none; fill: none; stroke: currentColor; stroke-width: 1.6;
    stroke-linecap: round; stroke-linejoin: round; }
:is(button, input, select, summary):focus-visible {
    outline: 2px solid var(--accent);
    outline-offset: 1px;
}
input[type="range"] { appearance: none; -webkit-appearance: none; flex: 1; min-width: 4rem; height: 24px;
    margin: 0; background: transparent; cursor: pointer; border-radius: 6px; }
input[type="range"]::-webkit-slider-runnable-track { height: 3px; border-radius: 2px;
    background: color-mix(in srgb, var(--edge) 75%, var(--ground)); }
input[type="range"]::-moz-range-track { height: 3px; border-radius: 2px;
    background: color-mix(in srgb, var(--edge) 75%, var(--ground)); }
input[type="range"]::-webkit-slider-thumb { appearance: none; -webkit-appearance: none;
    width: 15px; height: 15px; margin-top: -6px; border-radius: 50%; border: 2px solid var(--ground);
    background: var(--accent); box-shadow: 0 0 0 1px var(--accent); }
input[type="range"]::-moz-range-thumb { width: 12px; height: 12px; border-radius: 50%;
    border: 2px solid var(--ground); background: var(--accent); box-shadow: 0 0 0 1px var(--accent); }
input[type="range"]:disabled { opacity: 0.5; cursor: default; }
@container (max-width: 26rem) {
    .toolbar { column-gap: 0; padding-inline: 0.25rem; }
}
@container (max-width: 32rem) {
    .motion { flex-basis: 100%; max-width: none; }
    .spring { display: none; }
    .button.captioned { margin-inline-start: auto; }
}
@media (pointer: coarse) {
    .button { min-width: 44px; min-height: 44px; }
    input[type="range"] { height: 44px; }
    .handle input[type="range"] { inset: -22px auto auto -22px; width: 44px; height: 44px; }
    .clicks .quiet-button { min-width: 44px; }
}
`;

const trace = `
.trace { flex: none; border-block-start: 1px solid var(--line); padding: 0.375rem 0.5rem 0.5rem 1.125rem; }
.trace-bar { display: flex; flex-wrap: wrap; align-items: center; gap: 0 0.75rem; }
.trace h2 { margin: 0; font-size: 0.9375rem; font-weight: 650; letter-spacing: -0.005em; }
.trace-steps { display: flex; align-items: center; gap: 0.125rem; flex: 1 1 14rem; max-width: 30rem; }
.trace-steps .count { min-width: 6.5rem; padding-inline-start: 0.5rem; font-size: 0.875rem; }
.trace-bar > .button { margin-inline-start: auto; }
.trace-body { display: grid; grid-template-columns: minmax(0, 1fr) minmax(0, 1fr); gap: 0 1.5rem; height: 7.25rem; padding-inline-end: 0.625rem; overflow: auto; }
.trace-body:focus-visible { outline: 2px solid var(--accent); }
.trace h3 { margin: 0.125rem 0 0.125rem; font-size: 0.9375rem; font-weight: 600; }
.trace p { margin: 0; color: var(--quiet); font-size: 0.9375rem; line-height: 1.45; text-wrap: pretty; }
.trace-body > div:has(+ .formula:empty) { grid-column: 1 / -1; max-width: 80ch; }
.formula:empty { display: none; }
.formula math { font-size: 1.0625rem; }
@container (max-width: 44rem) {
    .trace { padding-inline: 0.875rem 0.375rem; }
    .trace-body { grid-template-columns: minmax(0, 1fr); align-content: start; height: 11rem; }
    .trace-steps { order: 1; flex-basis: 100%; max-width: none; margin-inline-start: -0.5rem; }
    .trace-steps .count { min-width: 5.5rem; }
}
`;

const values = `
.values { grid-area: values; position: relative; border-block-start: 1px solid var(--line); font-size: 0.875rem; }
.values-inner { padding: 0.25rem 1.125rem 1.5rem; }
.object + .object { border-block-start: 1px solid var(--line); }
.object > summary { display: flex; align-items: center; gap: 0.5rem; min-height: 44px; cursor: pointer; list-style: none; border-radius: 6px; }
.object > summary::-webkit-details-marker { display: none; }
.object > summary::before { content: ""; width: 6px; height: 6px; margin-inline: 3px; border: solid var(--quiet);
    border-width: 0 1.5px 1.5px 0; transform: rotate(-45deg); }
.object[open] > summary::before { transform: rotate(45deg); }
.object > summary h2 { margin: 0; }
.step { position: sticky; inset-block-end: 0; padding: 0.375rem 1.125rem; background: var(--ground);
    border-block-start: 1px solid var(--line); }
.values h2 { margin: 1.125rem 0 0.25rem; font-size: 1rem; font-weight: 650; letter-spacing: -0.005em; }
.values h3 { margin: 0; font-size: 0.875rem; font-weight: 600; }
.values .shape { margin: 0 0 0.5rem; color: var(--quiet); }
.group { margin: 0; padding: 0; border: 0; min-width: 0; }
.group > legend { padding: 0.875rem 0 0.125rem; font-weight: 600; font-size: 0.8125rem;
    color: var(--quiet); }
.field { display: grid; grid-template-columns: minmax(6.5rem, 2fr) minmax(0, 3fr); align-items: center;
    gap: 0 0.75rem; padding-block: 0.1875rem; }
.field > label, .field > .name { color: var(--ink); overflow-wrap: anywhere; }
.field .controls { display: flex; align-items: center; gap: 0.5rem; min-width: 0; }
.flags { display: grid; grid-template-columns: repeat(auto-fill, minmax(8.5rem, 1fr)); gap: 0 0.75rem; }
.flag { display: flex; align-items: center; gap: 0.5rem; min-height: 28px; cursor: pointer; }
input[type="checkbox"] { appearance: none; -webkit-appearance: none; width: 18px; height: 18px;
    margin: 3px; flex: none; border: 1px solid var(--edge); border-radius: 4px; background: var(--ground);
    display: grid; place-content: center; cursor: pointer; }
input[type="checkbox"]:checked { background: var(--accent); border-color: var(--accent); }
input[type="checkbox"]:checked::before { content: ""; width: 9px; height: 5px; margin-top: -3px;
    border: solid var(--on-accent); border-width: 0 0 2px 2px; transform: rotate(-45deg); }
input[type="text"], select {
    width: 100%;
    min-width: 0;
    min-height: 28px;
    padding: 0.125rem 0.5rem;
    border: 1px solid var(--edge);
    border-radius: 6px;
    background: var(--ground);
    color: var(--ink);
    font: inherit;
    font-variant-numeric: tabular-nums;
}
input[type="range"] + input[type="text"] { width: 5rem; flex: none; }
input:disabled, select:disabled { color: var(--quiet); border-color: var(--line); }
input[aria-invalid="true"] { border-color: var(--bad); box-shadow: inset 0 0 0 1px var(--bad); }
input[type="color"] { width: 56px; height: 28px; padding: 2px; border: 1px solid var(--edge);
    border-radius: 6px; background: var(--ground); cursor: pointer; }
.complaint { grid-column: 1 / -1; margin: 0.25rem 0 0.375rem; padding: 0.375rem 0.625rem;
    border-radius: 6px; background: var(--bad-wash); border-inline-start: 3px solid var(--bad);
    font-size: 0.8125rem; overflow-wrap: anywhere; }
.complaint:empty { display: none; }
details.list { padding-block: 0.25rem; }
details.list > summary { min-height: 28px; display: flex; align-items: center; gap: 0.5rem;
    cursor: pointer; list-style: none; border-radius: 6px; }
details.list > summary::-webkit-details-marker { display: none; }
details.list > summary::before { content: ""; width: 6px; height: 6px; margin-inline: 3px 3px;
    border: solid var(--quiet); border-width: 0 1.5px 1.5px 0; transform: rotate(-45deg); }
details.list[open] > summary::before { transform: rotate(45deg); }
.count { color: var(--quiet); font-variant-numeric: tabular-nums; }
table { width: 100%; border-collapse: collapse; }
th { font-weight: 500; font-size: 0.75rem; color: var(--quiet); text-align: start;
    padding: 0.125rem 0.25rem; }
td { padding: 2px; }
td:first-child, th:first-child { width: 2.25rem; padding-inline-start: 0; color: var(--quiet);
    font-variant-numeric: tabular-nums; text-align: end; padding-inline-end: 0.5rem; font-weight: 400;
    font-size: 0.8125rem; }
td.removal { width: 32px; }
.small { min-width: 28px; min-height: 28px; padding: 0; }
.small .icon { width: 16px; height: 16px; }
.small:not(:hover) { color: var(--quiet); }
.pager { display: flex; align-items: center; gap: 0.25rem; }
.pager .count { min-width: 8rem; text-align: center; }
.pose { padding-block: 0.375rem 0.5rem; border-block-end: 1px solid var(--line); }
.pose-head { display: flex; align-items: center; justify-content: space-between; }
.pose h4 { margin: 0; font-size: 0.8125rem; font-weight: 600; color: var(--quiet); }
.pose .controls { gap: 0.25rem; }
.pose .controls input { padding-inline: 0.375rem; }
.adding { display: flex; align-items: center; gap: 0.5rem; margin-block: 0.375rem 0.25rem; }
.adding label { flex: none; }
.adding input { width: 5.5rem; }
.quiet-button { min-height: 28px; padding: 0.125rem 0.75rem; border: 1px solid var(--edge);
    border-radius: 6px; background: transparent; color: var(--ink); font: inherit; cursor: pointer; white-space: nowrap; }
.quiet-button:hover { background: var(--raised); }
.checklist { margin: 0.25rem 0 0.5rem; padding: 0; list-style: none; }
.checklist li { display: grid; grid-template-columns: 1.5rem 1.75rem minmax(0, 1fr); align-items: baseline; padding-block: 0.1875rem; }
.checklist b { font-weight: 600; }
.mark { display: grid; place-items: center; align-self: start; width: 20px; height: 20px; border-radius: 50%; color: var(--ink); border: 1px solid var(--line); }
.mark .icon { width: 13px; height: 13px; stroke-width: 2.4; }
.mark[data-holds="false"] { background: var(--bad-wash); color: var(--bad); border: 2px solid var(--bad); }
.breach { grid-column: 3; font-variant-numeric: tabular-nums; color: var(--bad); font-weight: 550; }
.graph { display: block; width: 100%; height: auto; margin-block: 0.5rem 0.25rem; fill: none; stroke-width: 2.2; stroke-linejoin: round; }
.graph .grid { stroke: var(--line); stroke-width: 1; }
.legend { display: flex; flex-wrap: wrap; gap: 0.125rem 1rem; margin: 0 0 0.5rem; padding: 0; list-style: none; font-size: 0.8125rem; }
.legend li { display: flex; align-items: center; gap: 0.5rem; }
.sample { width: 32px; height: 6px; fill: none; stroke-width: 3; }
.axiom-table { margin-block: 0.25rem 0.5rem; }
.axiom-table :is(td:first-child, th[scope="row"]) { width: 52%; }
.axiom-table th[scope="row"] { text-align: start; font-size: 0.875rem; color: var(--ink); padding-block: 0.1875rem; }
.axiom-table th[scope="row"] b { display: inline-block; min-width: 1.75rem; font-weight: 600; }
.axiom-table th[scope="col"] { text-align: center; overflow-wrap: anywhere; }
.axiom-table :is(td, .mark) { margin-inline: auto; }
.trying { flex-wrap: wrap; }
.adding.trying input { flex: 1 1 9rem; width: auto; }
.adding select { flex: 1; }
.pointed { display: block; margin-block-start: 0.25rem; font-size: 0.9375em; }
.pointed mark { background: none; color: var(--bad); text-decoration: underline wavy; font-weight: 700; }
.readout { margin: 0.5rem 0 0; display: grid; grid-template-columns: minmax(6.5rem, 2fr) minmax(0, 3fr);
    gap: 0.125rem 0.75rem; }
.readout dt { color: var(--quiet); }
.readout dd { margin: 0; font-variant-numeric: tabular-nums; overflow-wrap: anywhere; }
@container (min-width: 42rem) and (max-width: 59.99rem) {
    .values-inner > div { columns: 2; column-gap: 2rem; }
    .values :is(.group, .list, h2, .shape) { break-inside: avoid; }
    .values h2, .values .shape { column-span: all; }
}
@media (pointer: coarse) {
    input[type="text"], select, .small, .quiet-button, .flag, details.list > summary,
    input[type="color"] { min-height: 44px; }
    .small { min-width: 44px; }
    td.removal { width: 48px; }
}
`;

/** Last, since these override what comes before. */
const circumstances = `
@media (prefers-contrast: more) {
    .frame, .frame[data-theme] { --line: var(--edge); --quiet: var(--ink); }
}
@media print {
    .toolbar, .trace-bar .button, .trace-steps, .values, .refusal, .progress { display: none !important; }
    .frame { border: 0; }
    .frame, .frame[data-values] { grid-template: "column" auto / minmax(0, 1fr); }
}
@media (forced-colors: active) {
    input[type="range"], input[type="checkbox"] { appearance: auto; -webkit-appearance: auto; }
    input[type="range"]::-webkit-slider-runnable-track { border: 1px solid CanvasText; }
    .progress progress { forced-color-adjust: none; height: 10px; border: 1px solid CanvasText; background: Canvas; }
    .progress progress::-webkit-progress-bar { background: Canvas; }
    .progress progress::-webkit-progress-value { background: Highlight; }
    .progress progress::-moz-progress-bar { background: Highlight; }
    .button:is([aria-pressed="true"], [aria-expanded="true"]),
    .quiet-button[aria-pressed="true"] { outline: 2px solid Highlight; }
    .handle:not([hidden])::after { content: ""; position: absolute; inset: -13px auto auto -13px; width: 26px;
        height: 26px; border: 2px solid Highlight; border-radius: 50%; }
}
`;

/** @type {CSSStyleSheet | undefined} */
let sheet;

/** The one style sheet of all figures of the page. */
export function figureSheet() {
    if (!sheet) {
        sheet = new CSSStyleSheet();
        sheet.replaceSync(layout + toolbar + panesMenu + trace + values + circumstances);
    }
    return sheet;
}
