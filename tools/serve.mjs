// Serves dist/ on this machine only:  node tools/serve.mjs [FILE.json | LINK | URL] [--port N]
import { createReadStream } from 'node:fs';
import { readFile, stat } from 'node:fs/promises';
import { createServer } from 'node:http';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';

const distribution = fileURLToPath(new URL('../dist/', import.meta.url));
const usualPort = 8080;
const documentFolder = '/document/';

/** The policy under which the page must run without a report; the one-file page is all inline. */
const policy = "script-src 'self' 'wasm-unsafe-eval'; style-src 'self'";
const inlinePolicy = "script-src 'unsafe-inline' 'wasm-unsafe-eval'; style-src 'unsafe-inline'";

/** @type {Record<string, string>} */
const types = {
    '.css': 'text/css; charset=utf-8',
    '.html': 'text/html; charset=utf-8',
    '.js': 'text/javascript; charset=utf-8',
    '.json': 'application/json; charset=utf-8',
    '.mjs': 'text/javascript; charset=utf-8',
    '.png': 'image/png',
    '.svg': 'image/svg+xml; charset=utf-8',
    '.ts': 'text/plain; charset=utf-8',
    '.txt': 'text/plain; charset=utf-8',
    '.wasm': 'application/wasm',
};

/** @typedef {{ directory?: string, document?: string, port?: number }} Options */

/**
 * The file that a request names, or undefined for one outside what is served.
 * @param {string} pathname
 * @param {Required<Pick<Options, 'directory'>> & Options} options
 */
function fileFor(pathname, { directory, document }) {
    if (document && pathname === documentFolder + path.basename(document)) return document;
    const file = path.join(directory, pathname.endsWith('/') ? `${pathname}index.html` : pathname);
    return file.startsWith(path.join(directory, path.sep)) ? file : undefined;
}

/** @param {string} file */
function headersFor(file) {
    const type = types[path.extname(file)] ?? 'application/octet-stream';
    /** @type {Record<string, string>} */
    const headers = {
        'Content-Type': type,
        'Cache-Control': 'no-store',
        'X-Content-Type-Options': 'nosniff',
    };
    if (type.startsWith('text/html')) {
        const inline = path.basename(file) === 'standalone.html';
        headers['Content-Security-Policy'] = inline ? inlinePolicy : policy;
    }
    return headers;
}

/**
 * @param {import('node:http').IncomingMessage} request
 * @param {import('node:http').ServerResponse} response
 * @param {Required<Pick<Options, 'directory'>> & Options} options
 */
async function answer(request, response, options) {
    if (request.method !== 'GET' && request.method !== 'HEAD') {
        response.writeHead(405, { Allow: 'GET, HEAD' }).end();
        return;
    }
    const pathname = readablePath(request.url ?? '/');
    const file = pathname === undefined ? undefined : fileFor(pathname, options);
    const found = file === undefined ? undefined : await stat(file).catch(() => undefined);
    if (file === undefined || !found?.isFile()) {
        response.writeHead(404, { 'Content-Type': types['.txt'] }).end('Not found\n');
        return;
    }
    response.writeHead(200, { ...headersFor(file), 'Content-Length': found.size });
    if (request.method === 'HEAD') response.end();
    else createReadStream(file).on('error', () => response.destroy()).pipe(response);
}

/**
 * The decoded path of a request, or undefined when it cannot be decoded.
 * @param {string} url
 */
function readablePath(url) {
    try {
        return decodeURIComponent(new URL(url, 'http://localhost').pathname);
    } catch {
        return undefined;
    }
}

/**
 * Starts to serve; `port` 0 takes any free one.
 * @param {Options} [options]
 * @returns {Promise<{ url: string, close: () => Promise<void> }>}
 */
export function serve({ directory = distribution, document, port = 0 } = {}) {
    const served = { directory: path.resolve(directory), document };
    const server = createServer((request, response) => {
        answer(request, response, served).catch(() => response.destroy());
    });
    return new Promise((resolve, reject) => {
        server.once('error', reject);
        server.listen(port, '127.0.0.1', () => {
            const address = /** @type {import('node:net').AddressInfo} */ (server.address());
            resolve({
                url: `http://127.0.0.1:${address.port}/`,
                close: () => new Promise((done) => {
                    server.close(() => done());
                    server.closeAllConnections?.();
                }),
            });
        });
    });
}

/** @param {Options} options */
async function serveOnUsualPort(options) {
    for (let port = usualPort; port < usualPort + 20; ++port) {
        try {
            return await serve({ ...options, port });
        } catch (error) {
            if (/** @type {NodeJS.ErrnoException} */ (error).code !== 'EADDRINUSE') throw error;
        }
    }
    return serve(options);
}

/** @param {string} message */
function refuse(message) {
    process.stderr.write(`${message}\n`);
    process.exit(2);
}

/** @param {string | undefined} text */
function portNumber(text) {
    if (text === undefined) return undefined;
    const port = Number(text);
    if (!/^\d+$/.test(text) || port > 65535) {
        refuse(`--port ${text}: a port is a whole number from 0 (any free one) to 65535.`);
    }
    return port;
}

/**
 * What the page is asked to open: the part of the address after its root, and the file behind it.
 * @param {string | undefined} argument
 */
async function opening(argument) {
    if (argument === undefined) return { suffix: '', document: undefined };
    if (/^#?v\d+\./.test(argument)) {
        return { suffix: `#${argument.replace(/^#/, '')}`, document: undefined };
    }
    if (/^https?:\/\//.test(argument)) {
        return { suffix: `?src=${encodeURIComponent(argument)}`, document: undefined };
    }
    const document = path.resolve(argument);
    try {
        JSON.parse(await readFile(document, 'utf8'));
    } catch (error) {
        refuse(`${argument} cannot be opened as a document: ${/** @type {Error} */ (error).message}`);
    }
    const name = encodeURIComponent(path.basename(document));
    return { suffix: `?src=${encodeURIComponent(documentFolder.slice(1) + name)}`, document };
}

async function main() {
    const { values, positionals } = parseArgs({
        options: { port: { type: 'string' } },
        allowPositionals: true,
    });
    if (positionals.length > 1) refuse(`One document at a time, please: ${positionals.join(' ')}`);
    const { suffix, document } = await opening(positionals[0]);
    const port = portNumber(values.port);
    const { url } = await (port === undefined
        ? serveOnUsualPort({ document })
        : serve({ document, port }));
    process.stdout.write(`\nKnotwork is served at  ${url}${suffix}\nCtrl+C stops it.\n`);
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
    main().catch((error) => refuse(error.message));
}
