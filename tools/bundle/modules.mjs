import { build } from 'esbuild';

import { distribution, project } from './paths.mjs';

/** How every bundle is made; node's own modules stay imports, so one file serves Node and browsers. */
const common = /** @satisfies {import('esbuild').BuildOptions} */ ({
    bundle: true,
    format: 'esm',
    platform: 'browser',
    target: 'es2022',
    charset: 'utf8',
    minify: true,
    legalComments: 'none',
    external: ['node:*'],
    logLevel: 'warning',
    alias: {
        'knotwork-glue': project('build/wasm/knotwork.mjs'),
        'knotwork-page-glue': project('build/wasm/knotwork_page.mjs'),
    },
});

const delivered = { ...common, outdir: distribution(), outExtension: { '.js': '.mjs' } };

/**
 * The page imports the element as a file of its own, so that there is one registry of figures, one
 * wasm module and one WebGL context, however many scripts of a page ask for them.
 * @type {import('esbuild').Plugin}
 */
const elementStaysApart = {
    name: 'element stays apart',
    setup(bundler) {
        bundler.onResolve({ filter: /\/element\.mjs$/ }, () => ({ path: './element.mjs', external: true }));
    },
};

/** Bundles web/*.mjs into the modules that package.json exports, and the page's own script. */
export async function bundleModules() {
    const modules = ['knotwork', 'element', 'element-class'];
    await Promise.all([
        build({ ...delivered, entryPoints: modules.map((name) => project('web', `${name}.mjs`)) }),
        build({ ...delivered, entryPoints: [project('web/page.mjs')], plugins: [elementStaysApart] }),
    ]);
}

/**
 * Scripts with everything that they import, as the text of one script.
 * @param {string[]} files
 */
export async function bundleToText(files) {
    const contents = files.map((file) => `import ${JSON.stringify(file)};`).join('\n');
    const result = await build({ ...common, write: false, stdin: { contents, resolveDir: project() } });
    return result.outputFiles[0].text;
}
