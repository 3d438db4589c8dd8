// Builds the page: `node build.mjs OUTDIR [--check] [--readable]`.
//
// Writes index.html, main.js and main.css of the studio, farm.html, farm.js and farm.css of `carom farm
// watch`, favicon.svg, the fonts and LICENCES.txt into OUTDIR, all in one folder without subfolders.
// --check looks at the types first; --readable leaves names and lines as they are, with a map to the
// sources. Ends with 1, and says why, if anything is wrong.
//
// The packages are those of the folder that CAROM_NODE_MODULES names (an absolute path), or of
// node_modules beside this file.
import { spawnSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { copyFile, mkdir, symlink, writeFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { collectLicences } from './licences.mjs';

const here = dirname(fileURLToPath(import.meta.url));
const packages = process.env.CAROM_NODE_MODULES || join(here, 'node_modules');
const { build } = createRequire(join(packages, 'x.js'))('esbuild');

/// Whether the types of all sources and tests agree; prints what does not. The compiler looks for
/// packages above the sources, so it sees the sources beside the packages, by links.
async function typesAgree() {
    const project = dirname(packages);
    for (const name of ['src', 'test', 'tsconfig.json']) {
        if (!existsSync(join(project, name))) {
            await symlink(join(here, name), join(project, name));
        }
    }
    const compiler = join(packages, 'typescript', 'bin', 'tsc');
    const words = [compiler, '-p', project, '--preserveSymlinks'];
    return spawnSync(process.execPath, words, { stdio: 'inherit' }).status === 0;
}

/// Bundles the sources into `out`. Returns esbuild's list of what went into the bundle.
async function bundle(out, readable) {
    const result = await build({
        absWorkingDir: here,
        nodePaths: [packages],
        entryPoints: { main: 'src/main.tsx', farm: 'src/farm/farm.tsx' },
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
    if (words.includes('--check') && !(await typesAgree())) {
        throw new Error('the types do not agree');
    }
    await mkdir(out, { recursive: true });
    const inputs = await bundle(resolve(out), words.includes('--readable'));
    await writeFile(join(out, 'LICENCES.txt'), await collectLicences(here, inputs));
    for (const name of ['index.html', 'farm.html']) {
        await copyFile(join(here, name), join(out, name));
    }
    await copyFile(join(here, 'src/style/favicon.svg'), join(out, 'favicon.svg'));
}

try {
    await main(process.argv.slice(2));
} catch (error) {
    console.error(`studio page: ${error.message}`);
    process.exitCode = 1;
}
