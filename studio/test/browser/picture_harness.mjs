// Pictures of the studio's path-traced view, and of `carom frame`.
import { spawnSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { equal, settle } from './harness.mjs';

/// The head of the path-traced picture when it has all samples.
export async function traced(page) {
    await page.waitForFunction(() => window.studio.state.picture.value?.head.complete);
    await settle(page);
    return page.evaluate(() => window.studio.state.picture.value.head);
}

/// Red, green and blue from the upper left corner, of a bitmap that starts with its last row.
function rowsOfBitmap(bytes) {
    const [width, height] = [bytes.readInt32LE(18), bytes.readInt32LE(22)];
    const first = bytes.readUInt32LE(10);
    const pixel = bytes.readUInt16LE(28) / 8;
    const stride = Math.ceil((width * pixel) / 4) * 4;
    const rows = Buffer.alloc(width * height * 3);
    for (let y = 0; y < height; ++y) {
        for (let x = 0; x < width; ++x) {
            const at = first + (height - 1 - y) * stride + x * pixel;
            rows.set([bytes[at + 2], bytes[at + 1], bytes[at]], 3 * (y * width + x));
        }
    }
    return rows;
}

function hash(bytes) {
    return createHash('sha256').update(bytes).digest('hex');
}

/// Of the pixels that the page has.
export async function hashOfPicture(page) {
    const shown = await page.evaluate(() => {
        const { pixels } = window.studio.state.picture.value;
        let text = '';
        for (let i = 0; i < pixels.length; i += 4) {
            text += String.fromCharCode(pixels[i], pixels[i + 1], pixels[i + 2]);
        }
        return btoa(text);
    });
    return hash(Buffer.from(shown, 'base64'));
}

/// Of the pixels of `carom frame`, rendered in a cache of its own.
export function hashOfFrame(carom, path, frame, folder) {
    const file = join(folder, 'frame.bmp');
    const made = spawnSync(carom, ['frame', path, '--frame', String(frame), '-o', file, '--cache',
        join(folder, 'other')], { encoding: 'utf8' });
    equal(made.status, 0, made.stderr);
    return hash(rowsOfBitmap(readFileSync(file)));
}
