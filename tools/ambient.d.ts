// Modules that only the bundler knows: Emscripten's glue, named by tools/bundle/modules.mjs.

declare module 'knotwork-glue' {
    const create: (options: { wasmBinary: ArrayBuffer | Uint8Array, [name: string]: unknown }) => Promise<any>;
    export default create;
}

declare module 'knotwork-page-glue' {
    const create: (options: { wasmBinary: ArrayBuffer | Uint8Array, [name: string]: unknown }) => Promise<any>;
    export default create;
}
