// A trick shot with three cameras, from the template that has two: a box to knock over is added, and a camera that
// shows it again, slowly, on its way around the table.
import { dragPixels, equal, pixelOf, settle } from '../browser/harness.mjs';
import { pixelOfHandle } from '../browser/strip_harness.mjs';
import {
    command, film, filmDone, keep, placeOf, scheme, select, toView,
} from './steps.mjs';

/// The edge of a path at which the eight passes, on the cloth.
const kBox = [0.02, -0.5, 0.05];

export async function tour(page) {
    await scheme(page, 'light');
    await page.locator('.card[data-name=trick]').click();
    await page.fill('input[name=name]', 'my_trick');
    await page.getByRole('button', { name: 'Create' }).click();
    await page.waitForFunction(() => window.studio.state.problems.value?.complete
        && window.studio.view?.context.meshNode('cue'));
    await settle(page);
    await toView(page);
    await keep(page, 'trick_1_template');

    await command(page, 'Add box');
    await settle(page);
    await toView(page);
    await page.keyboard.press('1');
    const from = await placeOf(page, 'box');
    await dragPixels(page, await pixelOf(page, from), await pixelOf(page, [kBox[0], kBox[1], from[2]]), 12);
    await keep(page, 'trick_2_box');
    equal(await page.evaluate(() => window.studio.state.timeline.value.head.events
        .some(({ a, b }) => [a, b].includes('eight') && [a, b].includes('box'))), true,
        'whether the eight hits the box');

    await command(page, 'Add camera of a rig');
    await settle(page);
    const cameras = () => page.evaluate(() => window.studio.state.shot.value.cameras.map(({ name }) => name));
    equal((await cameras()).length, 3, 'cameras');
    const [start, end] = [await pixelOfHandle(page, 'cameras/2 scene 0'),
        await pixelOfHandle(page, 'cameras/2 scene 1')];
    await dragPixels(page, end, [start[0] + 0.45 * (end[0] - start[0]), end[1]], 12);
    const all = await page.evaluate(() => window.studio.state.shot.value.film.frames);
    equal(all > 100, true, `${all} frames`);
    await toView(page);
    await page.keyboard.press('3');
    await keep(page, 'trick_3_cameras');
    await select(page, null);
    await film(page, 'draft');
    await filmDone(page, 130);
    await keep(page, 'trick_4_film');
}
