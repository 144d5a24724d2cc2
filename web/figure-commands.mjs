// What the buttons and the keys of a figure do with it.

/**
 * @typedef {Pick<import('./figure.mjs').Figure, 'undo' | 'redo' | 'reset' | 'fit' | 'seek' | 'setPlaying' |
 *     'playing' | 'moves' | 'host' | 'panes' | 'toggleExpert' | 'toggleValues' | 'selectFirst'>} Commanded
 */

/**
 * @param {Commanded} figure
 * @returns {import('./figure-toolbar.mjs').Actions}
 */
export function buttonActions(figure) {
    return {
        undo: () => figure.undo(),
        redo: () => figure.redo(),
        togglePlay: () => figure.setPlaying(!figure.playing),
        reset: () => figure.reset(),
        fit: () => figure.fit(),
        toggleExpert: () => figure.toggleExpert(),
        toggleValues: () => figure.toggleValues(),
        nextTheme: () => figure.host.nextTheme(),
        togglePanes: () => figure.panes.toggle(),
        seek: (phase) => figure.seek(phase),
    };
}

/**
 * Keys of the figure that the application has no use for; answers whether this was one.
 * @param {Commanded} figure
 * @param {KeyboardEvent} event
 */
export function pressKey(figure, event) {
    const command = event.ctrlKey || event.metaKey;
    const key = event.key.toLowerCase();
    if (key === ' ' && figure.moves) figure.setPlaying(!figure.playing);
    else if (key === 'pagedown' || key === 'pageup') return figure.selectFirst();
    else if (command && key === 'z' && !event.shiftKey) figure.undo();
    else if (command && (key === 'y' || key === 'z')) figure.redo();
    else return false;
    return true;
}
