// The layers of src/ include downward only, and each reaches only the libraries that it may use.
import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import path from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

const source = fileURLToPath(new URL('../../src/', import.meta.url));

/** From the bottom up. */
const layers = ['geometry', 'scene', 'drawing', 'render', 'ui', 'app', 'bindings'];

/** Libraries that are not for everyone, and the layers that may include them. */
const restricted = [
    { name: 'a JSON library', pattern: /^(nlohmann|rapidjson)\//, layers: ['scene', 'bindings'] },
    { name: 'OpenGL', pattern: /^(GLES|GL|EGL)/, layers: ['render'] },
    { name: 'Dear ImGui', pattern: /(^|\/)im(gui|config|stb)/, layers: ['ui', 'app'] },
    { name: 'JavaScript', pattern: /^emscripten/, layers: ['render', 'app', 'bindings'] },
];

/**
 * What is wrong with the includes of one file.
 * @param {string} file its path below src/
 * @param {string} text
 * @returns {string[]}
 */
function offences(file, text) {
    const layer = file.split('/')[0];
    const headers = Array.from(text.matchAll(/^\s*#\s*include\s*[<"]([^>"]+)[>"]/gm), (match) => match[1]);
    return headers.flatMap((header) => {
        const found = restricted
            .filter(({ pattern, layers: allowed }) => pattern.test(header) && !allowed.includes(layer))
            .map(({ name }) => `${file} includes ${header}: ${layer} may not use ${name}`);
        const target = layers.indexOf(header.split('/')[0]);
        if (target > layers.indexOf(layer)) found.push(`${file} includes ${header}: upward`);
        if (header.startsWith('.')) found.push(`${file} includes ${header}: write paths from src/`);
        return found;
    });
}

/** Every C++ file below src/, as paths with forward slashes. */
function sourceFiles(folder = '') {
    return readdirSync(path.join(source, folder), { withFileTypes: true }).flatMap((entry) => {
        const name = folder ? `${folder}/${entry.name}` : entry.name;
        if (entry.isDirectory()) return sourceFiles(name);
        return /\.(hpp|cpp|h|inl)$/.test(entry.name) ? [name] : [];
    });
}

test('no file of src/ includes upward or reaches a library that is not for its layer', () => {
    const files = sourceFiles();
    assert.ok(files.length > 0, 'there are no files to look at');
    const found = files.flatMap((file) => offences(file, readFileSync(path.join(source, file), 'utf8')));
    assert.deepEqual(found, []);
});

test('every folder of src/ is a layer', () => {
    const folders = new Set(sourceFiles().map((file) => file.split('/')[0]));
    assert.deepEqual([...folders].filter((folder) => !layers.includes(folder)), []);
});

test('the check sees an upward include', () => {
    assert.equal(offences('geometry/curve.cpp', '#include "scene/document.hpp"\n').length, 1);
    assert.equal(offences('drawing/svg.cpp', '# include "app/app.hpp"').length, 1);
    assert.deepEqual(offences('drawing/svg.cpp', '#include "scene/document.hpp"\n#include <vector>'), []);
});

test('the check sees JSON, OpenGL, Dear ImGui and JavaScript in the geometry', () => {
    for (const header of ['nlohmann/json.hpp', 'GLES3/gl3.h', 'imgui.h', 'emscripten/val.h']) {
        assert.equal(offences('geometry/curve.cpp', `#include <${header}>`).length, 1, header);
    }
    assert.deepEqual(offences('scene/json.cpp', '#include <nlohmann/json.hpp>'), []);
});
