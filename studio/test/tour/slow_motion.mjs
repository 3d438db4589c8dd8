// An existing film made slower and filmed from another seat: the start of the jump shot.
import { dragPixels, equal, textOf } from '../browser/harness.mjs';
import { pixelOfHandle } from '../browser/strip_harness.mjs';
import { film, filmDone, keep, scheme, select, toView, traced } from './steps.mjs';

export const shot = 'jump_shot.yaml';

/// How fast the first camera shows the scene.
function speedOf(page) {
    return page.evaluate(() => {
        const { state, strip } = window.studio;
        const [camera] = state.shot.value.cameras;
        const [from, to] = [camera.video_start, camera.video_end];
        return (strip.sceneTimeAt(camera, to) - strip.sceneTimeAt(camera, from)) / (to - from);
    });
}

export async function tour(page) {
    await scheme(page, 'dark');
    await page.waitForFunction(() => window.studio.view.context.meshNode('cue'));
    const before = await textOf(page);
    await select(page, ['cameras', '0']);
    await keep(page, 'slow_1_before');

    // The film shows less of the scene in the same time.
    const [start, end] = [await pixelOfHandle(page, 'cameras/0 scene 0'),
        await pixelOfHandle(page, 'cameras/0 scene 1')];
    await dragPixels(page, end, [start[0] + 0.35 * (end[0] - start[0]), end[1]], 16);
    const speed = await speedOf(page);
    equal(speed > 0.2 && speed < 0.5, true, `the speed of the film (${speed})`);
    await keep(page, 'slow_2_slower');

    // Another seat: the view looks through the camera, and moves it.
    await toView(page);
    await page.keyboard.press('ArrowRight');
    await select(page, null);
    await page.keyboard.press('c');
    await page.getByRole('button', { name: 'Moving the view moves the camera' }).click();
    const box = await page.locator('canvas[aria-label="The scene"]').boundingBox();
    const [x, y] = [box.x + box.width / 2, box.y + 0.8 * box.height];
    await dragPixels(page, [x, y], [x + 120, y + 25], 12);
    await keep(page, 'slow_3_seat');
    equal(await textOf(page) !== before, true, 'whether the text changed');
    await toView(page);
    await page.keyboard.press('r');
    await traced(page);
    await keep(page, 'slow_4_picture');
    await page.keyboard.press('r');
    await film(page, 'draft');
    await filmDone(page, 20);
}
