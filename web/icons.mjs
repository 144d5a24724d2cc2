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
    theme: 'M12 4.5a7.5 7.5 0 1 0 0 15zM12 4.5a7.5 7.5 0 0 1 0 15',
    add: 'M12 6v12M6 12h12',
    remove: 'M6.5 6.5l11 11M17.5 6.5l-11 11',
    open: 'M4 18.5v-12.5h5.5l2 2.5H20v10z',
    share: 'M10 14a4 4 0 0 0 5.7 0l3-3a4 4 0 0 0-5.7-5.7l-.9.9M14 10a4 4 0 0 0-5.7 0l-3 3a4 4 0 0 0 5.7 5.7l.9-.9',
};
