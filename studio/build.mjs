// Builds the page: `node build.mjs OUTDIR [--check] [--readable]`.
//
// Writes index.html, main.js, main.css, favicon.svg, the fonts and LICENCES.txt into OUTDIR, all in
// one folder without subfolders. --check looks at the types first; --readable leaves names and
// lines as they are, with a map to the sources. Ends with 1, and says why, if anything is wrong.
import { spawnSync } from 'node:child_process';
import { copyFile, mkdir, writeFile } from 'node:fs/promises';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';
import { collectLicences } from './licences.mjs';

const here = dirname(fileURLToPath(import.meta.url));

/// Whether the types of all sources and tests agree; prints what does not.
function typesAgree() {
    const compiler = join(here, 'node_modules', 'typescript', 'bin', 'tsc');
    return spawnSync(process.execPath, [compiler, '-p', here], { stdio: 'inherit' }).status === 0;
}

/// Bundles the sources into `out`. Returns esbuild's list of what went into the bundle.
async function bundle(out, readable) {
    const result = await build({
        absWorkingDir: here,
        entryPoints: { main: 'src/main.tsx' },
        outdir: out,
        bundle: true,
        format: 'esm',
        target: ['chrome109', 'firefox115', 'safari16.4'],
        jsx: 'automatic',
        jsxImportSource: 'preact',
        loader: { '.woff2': 'file', '.svg': 'text' },
        assetNames: '[name]-[hash]',
        minify: !readable,
        sourcemap: readable ? 'inline' : false,
        legalComments: 'none',
        metafile: true,
        logLevel: 'warning',
    });
    return Object.keys(result.metafile.inputs);
}

async function main(words) {
    const out = words.find((word) => !word.startsWith('--'));
    if (!out) {
        throw new Error('usage: node build.mjs OUTDIR [--check] [--readable]');
    }
    if (words.includes('--check') && !typesAgree()) {
        throw new Error('the types do not agree');
    }
    await mkdir(out, { recursive: true });
    const inputs = await bundle(resolve(out), words.includes('--readable'));
    await writeFile(join(out, 'LICENCES.txt'), await collectLicences(here, inputs));
    await copyFile(join(here, 'index.html'), join(out, 'index.html'));
    await copyFile(join(here, 'src/style/favicon.svg'), join(out, 'favicon.svg'));
}

try {
    await main(process.argv.slice(2));
} catch (error) {
    console.error(`studio page: ${error.message}`);
    process.exitCode = 1;
}
