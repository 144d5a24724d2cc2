// Modules that only the bundler knows: Emscripten's glue, named by tools/bundle/modules.mjs.

declare module 'knotwork-glue' {
    const create: (options: { wasmBinary: ArrayBuffer | Uint8Array, [name: string]: unknown }) => Promise<any>;
    export default create;
}

declare module 'knotwork-page-glue' {
    const create: (options: { wasmBinary: ArrayBuffer | Uint8Array, [name: string]: unknown }) => Promise<any>;
    export default create;
}

/** What the build knows of the files that are kept for offline. */
declare const __KEPT__: { version: string, files: [name: string, hash: string][] };

declare module 'pngjs' {
    export class PNG {
        constructor(size: { width: number, height: number });
        data: Uint8Array;
        static sync: { write(png: PNG): Uint8Array };
    }
}
