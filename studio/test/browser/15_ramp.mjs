// A point of a speed ramp is dragged: one number of the text changes, and the page shows, for every
// frame of the film, the scene time that carom plans.
import { execFileSync } from 'node:child_process';
import { changedLines, dragPixels, equal, settle, textOf } from './harness.mjs';
import { handleOf, pixelOfHandle } from './strip_harness.mjs';

export const shot = 'slow_motion.yaml';

/// The largest difference between the page's map and the times that the server planned, and the
/// frames and ends of the film.
function mapOf(page) {
    return page.evaluate(() => {
        const { state, strip } = window.studio;
        const camera = state.shot.value.cameras[0];
        const { numbers, head } = state.cameraFrames.value;
        const size = numbers.length / head.entries;
        let worst = 0;
        for (let i = 0; i < head.entries; ++i) {
            const [film, scene] = [numbers[i * size + 3], numbers[i * size + 4]];
            worst = Math.max(worst, Math.abs(strip.sceneTimeAt(camera, film) - scene));
        }
        return { worst, frames: head.entries,
            shown: [camera.video_start, camera.video_end].map((t) => strip.sceneTimeAt(camera, t)) };
    });
}

export async function check({ page, path, carom }) {
    const before = await textOf(page);
    const handle = 'cameras/0/scene/speeds/3';
    const start = await pixelOfHandle(page, handle);
    await dragPixels(page, start, [start[0] + 2, start[1] - 22]);
    const after = await textOf(page);
    const [line] = changedLines(before, after);
    const rest = (text) => text.match(/[^\s,[\]]+/g).filter((word) => word !== 's');
    const [old] = changedLines(after, before);
    const words = rest(line).filter((word, i) => word !== rest(old)[i]);
    equal(words.length, 1, `changed numbers (${line})`);
    equal((await handleOf(page, handle)).value > 1 / 40, true, 'the speed is larger');

    const map = await mapOf(page);
    equal(map.frames, 120, 'frames');
    equal(map.worst < 1e-9, true, `difference of the maps (${map.worst} s)`);
    await page.keyboard.press('Control+s');
    await page.waitForFunction(() => window.studio.state.notice.value?.text.endsWith('is saved.'));
    const info = execFileSync(carom, ['info', path], { encoding: 'utf8' });
    const [, from, to] = /shows ([\d.]+) s to ([\d.]+) s/.exec(info);
    equal(map.shown.map((t) => t.toFixed(4)), [Number(from), Number(to)].map((t) => t.toFixed(4)),
        'the scene times that carom info prints');

    // Across: in time, by whole frames. A double click adds a point, Delete takes it away.
    const moved = await pixelOfHandle(page, handle);
    await dragPixels(page, moved, [moved[0] + 40, moved[1]]);
    const time = (await handleOf(page, handle)).time * 24;
    equal(Math.abs(time - Math.round(time)) < 0.01, true, `a whole frame (${time})`);
    const [x, y] = await pixelOfHandle(page, 'cameras/0/scene/speeds/2');
    await page.mouse.dblclick(x + 90, y);
    await settle(page);
    const count = () => page.evaluate(() => window.studio.state.shot.value.cameras[0].speeds.length);
    equal(await count(), 7, 'points after a double click');
    await page.locator('[data-handle="cameras/0/scene/speeds/3"]').focus();
    await page.keyboard.press('Delete');
    await settle(page);
    equal(await count(), 6, 'points after Delete');
    for (let i = 0; i < 4; ++i) {
        await page.keyboard.press('Control+z');
        await settle(page);
    }
    equal(await textOf(page), before, 'the text after four steps of undo');
    return `one number changed, ${map.frames} frames agree with carom within 1e-9 s`;
}
