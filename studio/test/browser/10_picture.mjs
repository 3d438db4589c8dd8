// R traces the film's frame at the play head. With all samples it is `carom frame`'s picture, byte
// for byte, and `carom render` finds it. The free view, channels and the comparison work, too.
import { spawnSync } from 'node:child_process';
import { join } from 'node:path';
import { equal } from './harness.mjs';
import { hashOfFrame, hashOfPicture, traced } from './picture_harness.mjs';

const kFrame = 84;

/// The line between both pictures is dragged in the view, and Save keeps what is shown.
async function dragLine(page) {
    const slider = page.getByRole('slider', { name: /^Place of the line/ });
    const box = await page.evaluate(() => {
        const { left, top, width, height } = window.studio.view.context.box();
        const canvas = window.studio.view.canvas.getBoundingClientRect();
        return { x: canvas.left + left, y: canvas.top + top, width, height };
    });
    const y = box.y + 0.2 * box.height;
    await page.mouse.move(box.x + 0.5 * box.width, y);
    await page.mouse.down();
    await page.mouse.move(box.x + 0.6 * box.width, y);
    await page.mouse.move(box.x + 0.75 * box.width, y);
    await page.mouse.up();
    const place = Number(await slider.inputValue());
    equal(Math.abs(place - 0.75) < 0.01, true, `the line is at ${place}`);
    const [download] = await Promise.all([page.waitForEvent('download'),
        page.getByTitle('Save the picture as PNG').click()]);
    equal(download.suggestedFilename(), 'nine_ball_break_84_object_id.png', 'the name of the picture');
}

export async function check({ page, path, folder, carom }) {
    const cache = join(folder, 'cache');
    await page.evaluate(() => window.studio.state.filmTime.value = 3.5);
    await page.locator('canvas[aria-label="The scene"]').focus();
    await page.keyboard.press('c');
    await page.keyboard.press('r');
    const head = await traced(page);
    equal([head.width, head.height], [640, 360], 'the size of the last round');
    equal(head.samples, head.of_samples, 'samples');
    equal(head.stored, true, 'whether the frame is stored');

    const words = ['render', path, '--frames', String(kFrame), '--dry-run', '--cache', cache];
    const plan = spawnSync(carom, words, { encoding: 'utf8' });
    const said = plan.stdout + plan.stderr;
    equal(said.includes('1 stored, 0 to render'), true, said);

    equal(await hashOfPicture(page), hashOfFrame(carom, path, kFrame, folder), 'the pixels of carom frame');

    await page.getByRole('button', { name: 'Compare', exact: true }).click();
    await page.getByLabel('What the picture shows').selectOption('object_id');
    const ids = await traced(page);
    equal([ids.channel, ids.stored, ids.legend !== ''], ['object_id', false, true], 'the channel');
    equal(await page.getByRole('slider', { name: /^Place of the line/ }).count(), 1, 'wipes');
    await dragLine(page);
    await page.getByLabel('What the picture shows').selectOption('');
    await page.locator('canvas[aria-label="The scene"]').focus();
    await page.keyboard.press('3');
    await page.waitForFunction(() => window.studio.state.lookThrough.value === null
        && window.studio.state.picture.value?.head.width !== 640);
    const free = await traced(page);
    const canvas = await page.locator('canvas[aria-label="The scene"]').boundingBox();
    equal([free.width, free.height, free.stored],
        [Math.round(canvas.width), Math.round(canvas.height), false], 'the free view');
    return `frame ${kFrame} has the bytes of carom frame with ${head.samples} samples; `
        + 'free view, objects and comparison are shown';
}
