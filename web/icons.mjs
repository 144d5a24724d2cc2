// The icons: single paths on a grid of 24, drawn as lines by the style sheets.

/** @type {Record<string, string>} */
export const icons = {
    undo: 'M9 5 4.5 9.5 9 14M5 9.5h9.5a5 5 0 0 1 0 10H11',
    redo: 'M15 5l4.5 4.5L15 14M19 9.5H9.5a5 5 0 0 0 0 10H13',
    play: 'M8 5.5v13l10.5-6.5z',
    pause: 'M8.5 5.5v13M15.5 5.5v13',
    reset: 'M5.2 9.5A7.5 7.5 0 1 1 4.5 13M5 4.5v5h5',
    fit: 'M4.5 9V4.5H9M15 4.5h4.5V9M19.5 15v4.5H15M9 19.5H4.5V15',
    expert: 'M4.5 7h8M17 7h2.5M4.5 12h2.5M11.5 12h8M4.5 17h9M18 17h1.5M14.75 4.75v4.5M9.25 9.75v4.5M15.75 14.75v4.5',
    values: 'M4.5 5.5h15v13h-15zM4.5 10h15M10 10v8.5',
    panes: 'M4.5 5.5h15v13h-15zM12.5 5.5v13M12.5 12h7',
    theme: 'M12 4.5a7.5 7.5 0 1 0 0 15zM12 4.5a7.5 7.5 0 0 1 0 15',
    add: 'M12 6v12M6 12h12',
    remove: 'M6.5 6.5l11 11M17.5 6.5l-11 11',
    holds: 'M5 12.5l4.5 4.5L19 7.5',
    open: 'M4 18.5v-12.5h5.5l2 2.5H20v10z',
    save: 'M12 4.5v10.5M7.5 11l4.5 4.5 4.5-4.5M4.5 19.5h15',
    scenes: 'M4.5 4.5h6v6h-6zM13.5 4.5h6v6h-6zM4.5 13.5h6v6h-6zM13.5 13.5h6v6h-6z',
    previous: 'M14.5 6 8.5 12l6 6',
    next: 'M9.5 6l6 6-6 6',
    language: 'M12 4a8 8 0 1 0 0 16a8 8 0 1 0 0-16zM4 12h16M12 4c-5 5-5 11 0 16c5-5 5-11 0-16',
    fullScreen: 'M9 4.5H4.5V9M4.5 4.5l5.5 5.5M15 19.5h4.5V15M19.5 19.5l-5.5-5.5',
    help: 'M12 4a8 8 0 1 0 0 16a8 8 0 1 0 0-16zM9.7 9.7a2.4 2.4 0 1 1 3.4 2.2c-.8.4-1.1.9-1.1 1.8M12 16.4v.1',
    share: 'M10 14a4 4 0 0 0 5.7 0l3-3a4 4 0 0 0-5.7-5.7l-.9.9M14 10a4 4 0 0 0-5.7 0l-3 3a4 4 0 0 0 5.7 5.7l.9-.9',
};
