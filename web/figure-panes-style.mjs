// The look of the seams between panes and of their menu.

/** A line that can be taken hold of a little beside it, too. */
export const seams = `
.seam { position: absolute; inset: 0 auto auto 0; margin: 0; border: 0; overflow: visible; outline: none;
    touch-action: none; z-index: 1; }
.seam[aria-orientation="vertical"] { width: 11px; margin-inline-start: -5px; cursor: col-resize; }
.seam[aria-orientation="horizontal"] { height: 11px; margin-block-start: -5px; cursor: row-resize; }
.seam::before, .seam::after { content: ""; position: absolute; border-radius: 2px; }
.seam[aria-orientation="vertical"]::before { inset: 0 5px; background: var(--line); }
.seam[aria-orientation="horizontal"]::before { inset: 5px 0; background: var(--line); }
.seam::after { inset: 0; margin: auto; background: var(--edge); opacity: 0.55; }
.seam[aria-orientation="vertical"]::after { width: 3px; height: 28px; }
.seam[aria-orientation="horizontal"]::after { width: 28px; height: 3px; }
.seam:is(:hover, :focus-visible)::before { background: var(--accent); }
.seam:is(:hover, :focus-visible)::after { background: var(--accent); opacity: 1; }
.seam[aria-orientation="vertical"]:focus-visible::before { inset: 0 4px; }
.seam[aria-orientation="horizontal"]:focus-visible::before { inset: 4px 0; }
@media (pointer: coarse) {
    .seam[aria-orientation="vertical"] { width: 25px; margin-inline-start: -12px; }
    .seam[aria-orientation="horizontal"] { height: 25px; margin-block-start: -12px; }
    .seam[aria-orientation="vertical"]::before { inset: 0 12px; }
    .seam[aria-orientation="horizontal"]::before { inset: 12px 0; }
}
@media (forced-colors: active) {
    .seam::before, .seam::after { forced-color-adjust: none; background: CanvasText; }
    .seam:focus-visible::before { background: Highlight; }
}
@media print { .seam { display: none; } }
`;

/** Above its button, as wide as its words. */
export const panesMenu = `
.toolbar { position: relative; }
.panes { position: absolute; inset: auto 0.5rem calc(100% + 4px) auto; z-index: 2; width: max-content; min-width: 15rem;
    max-width: calc(100% - 1rem); overflow: auto; padding: 0.625rem 1rem 0.75rem; border: 1px solid var(--line); border-radius: 10px;
    background: var(--ground); font-size: 0.875rem;
    box-shadow: 0 8px 28px color-mix(in srgb, #000 16%, transparent); }
.panes h2 { margin: 0 0 0.25rem; font-size: 0.8125rem; font-weight: 600; color: var(--quiet); }
.panes-list { display: grid; }
.panes .flag { min-height: 30px; }
.panes-sizes:not(:empty) { margin-block-start: 0.5rem; padding-block-start: 0.5rem; border-block-start: 1px solid var(--line); }
.panes-size { display: grid; grid-template-columns: minmax(0, 1fr) 8rem; align-items: center; gap: 0.75rem; }
.panes input[aria-disabled="true"] { opacity: 0.5; }
@media (pointer: coarse) { .panes .flag { min-height: 44px; } }
`;
