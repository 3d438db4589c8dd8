// A bank shot from an empty file, as a user authors it: with the pointer and the keyboard. It fails if the shot
// does not come out as it should.
import { dragPixels, equal, pixelOf, settle } from '../browser/harness.mjs';
import {
    command, film, filmDone, keep, kRadius, placeOf, scheme, select, toView, traced,
} from './steps.mjs';

export async function tour(page) {
    await scheme(page, 'light');
    await page.waitForFunction(() => [...document.querySelectorAll('.card img')]
        .slice(0, 10).every((image) => image.complete && image.naturalWidth > 0));
    await page.locator('.card[data-name=empty]').click();
    await page.fill('input[name=name]', 'my_bank_shot');
    await keep(page, 'walk_1_start');

    await page.getByRole('button', { name: 'Create' }).click();
    await page.waitForFunction(() => window.studio.state.problems.value?.complete
        && window.studio.view?.context.meshNode('cue'));
    await settle(page);
    await toView(page);
    await page.keyboard.press('1');
    await dragPixels(page, await pixelOf(page, await placeOf(page, 'cue')),
        await pixelOf(page, [0.55, -0.35, kRadius]), 12);
    await keep(page, 'walk_2_cue_ball');

    await command(page, 'Add ball');
    await settle(page);
    const added = await page.evaluate(() => window.studio.state.selection.value.at(-1));
    await dragPixels(page, await pixelOf(page, await placeOf(page, added)),
        await pixelOf(page, [0.3, 0.1, kRadius]), 12);
    await keep(page, 'walk_3_object_ball');

    const [x, y] = await pixelOf(page, await placeOf(page, added));
    await page.mouse.click(x, y, { button: 'right' });
    await keep(page, 'walk_4_menu');
    await page.getByRole('menuitem', { name: `Strike cue at ${added}` }).click();
    await settle(page);
    await toView(page);
    await page.waitForFunction(() =>
        window.studio.gizmos.handles().some(({ kind }) => kind === 'aim'));
    const aim = await page.evaluate(() =>
        window.studio.gizmos.handles().find(({ kind }) => kind === 'aim').at);
    const cue = await placeOf(page, 'cue');
    const length = Math.hypot(aim[0] - cue[0], aim[1] - cue[1]);
    const turned = (degrees) => [cue[0] + length * Math.cos(degrees / 57.29578),
        cue[1] + length * Math.sin(degrees / 57.29578), aim[2]];
    await dragPixels(page, await pixelOf(page, aim), await pixelOf(page, turned(116.9)), 16);
    await keep(page, 'walk_5_aim');
    await page.keyboard.press('v');
    await page.waitForFunction(() => window.studio.state.fan.value?.head.finished === 8);
    await keep(page, 'walk_6_sure');
    await page.keyboard.press('v');
    equal(await page.evaluate(() => window.studio.state.timeline.value.head.events
        .filter(({ kind }) => kind === 'potted').map(({ a, b }) => [a, b])),
        [[added, 'corner_left_front']], 'potted balls');

    // The camera goes to the far corner, and looks along the table.
    await select(page, ['cameras', '0']);
    const handle = (key) => page.evaluate((name) => {
        const { cameraHandles, view } = window.studio;
        const box = view.context.canvas.getBoundingClientRect();
        const found = cameraHandles.value.find(({ path }) => path.at(-1) === name);
        const place = found && view.context.toScreen(found.at);
        return place && [place[0] + box.left, place[1] + box.top];
    }, key);
    await dragPixels(page, await handle('target'), await pixelOf(page, [-0.2, 0, 0]), 12);
    const field = (name) => page.locator('.inspector').getByLabel(name, { exact: true }).last();
    for (const [name, value] of [['fov', '42 deg'], ['focus', added]]) {
        await field(name).fill(value);
        await field(name).press('Enter');
        await settle(page);
    }
    await toView(page);
    await keep(page, 'walk_7_camera');

    await select(page, null);
    for (let i = 0; i < 3; ++i) {
        await page.keyboard.press('Shift+ArrowRight');
    }
    await page.keyboard.press('c');
    await page.keyboard.press('r');
    await traced(page);
    await keep(page, 'walk_8_picture');
    await page.keyboard.press('r');

    await film(page, 'draft');
    await filmDone(page, 30);
    await keep(page, 'walk_9_film');
}
