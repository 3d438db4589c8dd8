// Annotations: the outline adds one, the inspector changes it, the film view drags a text, the strip
// drags when it appears; each is one undo.
import { join } from 'node:path';
import { changedLines, dragPixels, equal, settle, textOf, undo } from './harness.mjs';
import { handleOf, pixelOfHandle } from './strip_harness.mjs';

export const shot = 'thirty_degrees.yaml';

const choose = (page, path) =>
    page.evaluate((one) => { window.studio.state.selection.value = one; }, path);
const selected = (page) => page.evaluate(() => window.studio.state.selection.value);
const annotations = (page) => page.evaluate(() => window.studio.state.shot.value.annotations);

async function add(page, before) {
    const rows = page.locator('.outline .item');
    equal(await rows.filter({ hasText: 'ghost of cue on one' }).count(), 1, 'rows of the ghost ball');
    const count = (await annotations(page)).length;
    await page.getByRole('button', { name: 'Add', exact: true }).click();
    await page.getByRole('menuitem', { name: 'text', exact: true }).click();
    await settle(page);
    const added = (await annotations(page)).at(-1);
    equal([added.kind, added.text, added.path], ['text', 'Text', ['annotations', String(count)]],
        'the new annotation');
    equal(await selected(page), added.path, 'the selection after adding');
    equal(await page.locator('.inspector h2').innerText(), 'annotation text', 'the title');
    equal(await page.evaluate(() => window.studio.state.problems.value.list), [], 'the problems');
    await undo(page, before, 'an addition');
}

/// The keys of a path stand below its kind and beside it.
async function inspect(page, before) {
    await page.locator('.outline .item', { hasText: 'path of one' }).click();
    equal(await selected(page), ['annotations', '2'], 'the selection');
    const field = (name) => page.locator('.inspector').getByLabel(name, { exact: true });
    equal([await field('of').inputValue(), await field('from').inputValue()], ['one', '0.3 s'],
        'of and from');
    equal(await field('position').count(), 0, 'a place on the picture of one in the scene');
    await field('marks').fill('0.2 s');
    await field('marks').press('Enter');
    await settle(page);
    const [line] = changedLines(before, await textOf(page));
    equal(line.trim(), '- {path: {of: one, marks: 0.2 s}, from: 0.3 s}', 'the changed line');
    await undo(page, before, 'a value');
}

/// The rectangle of an annotation on the page.
function boxOf(page, index) {
    return page.evaluate((at) => {
        const { centre, size } = window.studio.state.shot.value.annotations[at].box;
        const { context } = window.studio.view;
        const canvas = context.canvas.getBoundingClientRect();
        const film = context.box();
        return { x: canvas.left + film.left + centre[0] * film.width,
            y: canvas.top + film.top + centre[1] * film.height,
            width: size[0] * film.width, height: size[1] * film.height, film };
    }, index);
}

async function drag(page, before) {
    await page.evaluate(() => {
        window.studio.state.filmTime.value = 0.5;
        window.studio.state.lookThrough.value = '(film)';
    });
    const index = (await annotations(page)).findIndex(({ kind }) => kind === 'text');
    const drawn = await page.locator('.annotation-frames .text').boundingBox();
    const box = await boxOf(page, index);
    equal([drawn.width, drawn.height].map(Math.round), [box.width, box.height].map(Math.round),
        'the frame of the text');
    const old = (await annotations(page))[index].box.centre;
    await dragPixels(page, [box.x + 5, box.y], [box.x + 5 + 0.2 * box.film.width, box.y - 0.3 * box.film.height]);
    equal(await selected(page), ['annotations', String(index)], 'the selection after a drag');
    const [line] = changedLines(before, await textOf(page));
    const [, x, y] = /position: \[([\d.]+), ([\d.]+)\], to: 1\.6 s/.exec(line) ?? [];
    // To a pixel of the page.
    equal([Number(x), Number(y)].map((one, i) =>
        Math.abs(one - old[i] - [0.2, -0.3][i]) < 1 / box.film.height), [true, true], `the place in ${line}`);
    const { centre } = (await annotations(page))[index].box;
    equal(centre.map((one) => one.toFixed(3)), [x, y].map((one) => Number(one).toFixed(3)),
        'the place that the server says');
    if (process.env.CAROM_STUDIO_SHOTS) {
        for (const [width, height] of [[1280, 720], [820, 600]]) {
            await page.setViewportSize({ width, height });
            await page.evaluate(() => new Promise((done) => { setTimeout(done, 400); }));
            await page.screenshot({
                path: join(process.env.CAROM_STUDIO_SHOTS, `34_annotations_${width}.png`) });
        }
        await page.setViewportSize({ width: 1280, height: 720 });
    }
    await undo(page, before, 'a drag');

    const again = await boxOf(page, index);
    await page.mouse.move(again.x, again.y);
    await page.mouse.down();
    await page.mouse.move(again.x + 60, again.y - 40, { steps: 4 });
    await page.keyboard.press('Escape');
    await page.mouse.up();
    await settle(page);
    equal(await textOf(page), before, 'the text after Escape');
    await page.evaluate(() => { window.studio.state.lookThrough.value = null; });
    equal(await page.locator('.annotation-frames .frame').count(), 0, 'frames in the free view');
}

/// On the film's clock, and on that of the scene.
async function dragTimes(page, before) {
    for (const [path, key, pattern] of [[['annotations', '11'], 'to', /to: \d+ \/ 24 s, fade/],
        [['annotations', '5'], 'from', /length: 0\.45\}, from: 0\.\d+ s/]]) {
        await choose(page, path);
        const id = `${path.join('/')} ${key}`;
        const { time } = await handleOf(page, id);
        const [x, y] = await pixelOfHandle(page, id);
        await dragPixels(page, [x, y], [x - 40, y]);
        const [line, ...more] = changedLines(before, await textOf(page));
        equal([pattern.test(line), more.length], [true, 0], `the changed line: ${line}`);
        equal((await handleOf(page, id)).time < time, true, 'an earlier time');
        await undo(page, before, `the time ${id}`);
    }
}

export async function check({ page }) {
    const before = await textOf(page);
    await add(page, before);
    await inspect(page, before);
    await drag(page, before);
    await dragTimes(page, before);
    return 'one added, keys changed, a text and times dragged, each one undo';
}
