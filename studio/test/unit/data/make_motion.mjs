// Writes motion.json, which the tests of src/motion compare with: `node make_motion.mjs CAROM`.
// It has the keys of motion.yaml's tracks, samples of them that carom computed, and its cameras.
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
const carom = process.argv[2] ?? 'carom';
const folder = mkdtempSync(join(tmpdir(), 'carom-motion-'));

/// What `carom export` writes as JSON, with the given options.
function exported(...options) {
    const file = join(folder, 'out.json');
    const shot = join(here, 'motion.yaml');
    const words = ['export', shot, '--quiet', '--cache', folder, '-o', file, ...options];
    const { status, stderr } = spawnSync(carom, words, { encoding: 'utf8' });
    if (status !== 0) {
        throw new Error(stderr);
    }
    return JSON.parse(readFileSync(file, 'utf8'));
}

try {
    const keys = exported();
    const samples = exported('--rate', '13');
    const lines = [];
    for (const name of ['cue', 'two']) {
        const track = keys.tracks.find((one) => one.name === name);
        const sampled = samples.tracks.find((one) => one.name === name);
        lines.push(`"${name}": ${JSON.stringify({ keys: track.keys, samples: sampled.keys })}`);
    }
    lines.push(`"cameras": ${JSON.stringify(keys.cameras)}`);
    writeFileSync(join(here, 'motion.json'), `{\n${lines.join(',\n')}\n}\n`);
} finally {
    rmSync(folder, { recursive: true });
}
