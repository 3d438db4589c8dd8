// Runs the unit tests: `node test/unit.mjs [WORD...]`. Each test/unit/NAME.test.ts whose name
// contains one of the words (all, if none is given) is bundled and run by `node --test`.
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const unit = dirname(fileURLToPath(import.meta.url));
const packages = process.env.CAROM_NODE_MODULES || join(unit, '../node_modules');
const { build } = createRequire(join(packages, 'x.js'))('esbuild');
const here = join(unit, 'unit');
const words = process.argv.slice(2);
const tests = readdirSync(here)
    .filter((name) => name.endsWith('.test.ts') || name.endsWith('.test.tsx'))
    .filter((name) => words.length === 0 || words.some((word) => name.includes(word)));
const out = mkdtempSync(join(tmpdir(), 'carom-studio-'));
try {
    await build({
        entryPoints: tests.map((name) => join(here, name)),
        outdir: out,
        outExtension: { '.js': '.mjs' },
        nodePaths: [packages],
        bundle: true,
        platform: 'neutral',
        mainFields: ['module', 'main'],
        conditions: ['browser'],
        external: ['node:*'],
        format: 'esm',
        target: 'node18',
        jsx: 'automatic',
        jsxImportSource: 'preact',
        loader: { '.svg': 'text', '.css': 'empty' },
        define: { __REPOSITORY__: JSON.stringify(join(here, '../../..')) },
        sourcemap: 'inline',
        logLevel: 'warning',
    });
    const bundled = readdirSync(out).filter((name) => name.endsWith('.mjs'));
    const { status } = spawnSync(
        process.execPath,
        ['--enable-source-maps', '--test', ...bundled.map((name) => join(out, name))],
        { stdio: 'inherit' },
    );
    process.exitCode = status ?? 1;
} finally {
    rmSync(out, { recursive: true, force: true });
}
