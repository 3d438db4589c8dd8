// The page's interpolation between keys is carom's own: positions and orientations at many times.
import { spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';

const kRate = 173; // samples a second, so that they rarely fall on keys
const kMostDistance = 1e-6; // m
const kMostAngle = 1e-5; // rad

export async function check({ page, path, folder, carom }) {
    const file = join(folder, 'motion.csv');
    const words = ['export', path, '-o', file, '--rate', String(kRate), '--cache', join(folder, 'cache')];
    const run = spawnSync(carom, words, { encoding: 'utf8' });
    if (run.status !== 0) {
        throw new Error(run.stderr);
    }
    const [head, ...rows] = readFileSync(file, 'utf8').trim().split('\n');
    if (!head.startsWith('object,time,x,y,z,qw,qx,qy,qz')) {
        throw new Error(`columns ${head}`);
    }
    const samples = rows.map((row) => {
        const [name, ...numbers] = row.split(',');
        return [name, ...numbers.slice(0, 8).map(Number)];
    });
    const worst = await page.evaluate((samples) => {
        const { tracks } = window.studio;
        let [distance, angle, compared] = [0, 0, 0];
        for (const [name, time, x, y, z, w, i, j, k] of samples) {
            const track = tracks.value.get(name);
            if (!track) {
                continue;
            }
            const place = track.position(time);
            const turn = track.orientation(time);
            distance = Math.max(distance, Math.hypot(place[0] - x, place[1] - y, place[2] - z));
            const sign = turn[0] * w + turn[1] * i + turn[2] * j + turn[3] * k < 0 ? -1 : 1;
            const chord = Math.hypot(turn[0] - sign * w, turn[1] - sign * i, turn[2] - sign * j,
                turn[3] - sign * k);
            angle = Math.max(angle, 4 * Math.asin(chord / 2));
            compared += 1;
        }
        return { distance, angle, compared };
    }, samples);
    if (worst.compared < 1000 || !(worst.distance <= kMostDistance) || !(worst.angle <= kMostAngle)) {
        throw new Error(JSON.stringify(worst));
    }
    return `${worst.compared} poses within ${worst.distance.toExponential(1)} m and `
        + `${worst.angle.toExponential(1)} rad of carom export`;
}
