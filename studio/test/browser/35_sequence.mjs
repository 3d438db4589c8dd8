// A film of several shots: its parts on the strip, in the outline and in the inspector; times are
// edited there, one undo each, and the shot of a part is opened.
import { join } from 'node:path';
import { faults } from './axe.mjs';
import { kPatience, changedLines, dragPixels, equal, settle, textOf, undo } from './harness.mjs';
import { handleOf, pixelOfHandle, pixelOnStrip } from './strip_harness.mjs';

export const shot = 'lesson.yaml';

const parts = (page) => page.evaluate(() => window.studio.state.sequence.value.parts);
const selected = (page) => page.evaluate(() => window.studio.state.selection.value);
const problems = (page) => page.evaluate(() => window.studio.state.problems.value.list);
const field = (page, name) => page.locator('.inspector').getByLabel(name, { exact: true });

async function keepPictures(page, name) {
    if (!process.env.CAROM_STUDIO_SHOTS) {
        return;
    }
    for (const [width, height] of [[1280, 720], [820, 600]]) {
        await page.setViewportSize({ width, height });
        await page.evaluate(() => new Promise((done) => { setTimeout(done, 400); }));
        await page.screenshot({
            path: join(process.env.CAROM_STUDIO_SHOTS, `35_${name}_${width}.png`) });
    }
    await page.setViewportSize({ width: 1280, height: 720 });
    await page.evaluate(() => new Promise((done) => { setTimeout(done, 200); }));
}

/// The parts stand in their order, and the one at the play head is known.
async function look(page) {
    equal(await problems(page), [], 'the problems');
    const all = await parts(page);
    equal(all.map(({ kind, name }) => [kind, name]), [['title', 'The 30-degree rule'],
        ...Array(3).fill(['shot', 'half_ball.yaml'])], 'the parts');
    equal(all.slice(1).map(({ start }, i) => start - (all[i].start + all[i].frames)),
        all.slice(1).map(({ fade }) => -fade), 'starts after the parts before, less the fades');
    equal(await page.locator('.outline .item').count(), 4, 'rows of the outline');
    await page.mouse.click(...await pixelOnStrip(page, 'filmRuler', 8, true));
    await page.getByText('part 2', { exact: false }).first().waitFor();
    await page.keyboard.press(']');
    equal(await page.evaluate(() => Math.round(window.studio.state.filmTime.value * 24)), all[2].start,
        'the frame after a step to the next part');
}

/// The frame of the film at the play head, of a card and of a shot.
async function picture(page) {
    const traced = async (time) => {
        await page.mouse.click(...await pixelOnStrip(page, 'filmRuler', time, true));
        await page.waitForFunction(() => window.studio.state.pictureAsked.value);
        await settle(page);
        // The picture is drawn with the next paint.
        await page.evaluate(() => new Promise((done) => {
            requestAnimationFrame(() => requestAnimationFrame(done));
        }));
        return page.evaluate(() => {
            const canvas = document.querySelector('.sequence-view canvas');
            const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
            const mean = [0, 1, 2].map((i) => data.reduce((sum, x, at) =>
                at % 4 === i ? sum + x : sum, 0) / (data.length / 4));
            return { width: canvas.width, isGreen: mean[1] > 1.5 * mean[0] && mean[1] > 20, mean };
        });
    };
    const card = await traced(1.5);
    equal([card.width, card.isGreen, card.mean[0] > 0.5], [640, false, true],
        `the picture of a card (${card.mean})`);
    await keepPictures(page, 'card');
    const table = await traced(5.5);
    equal([table.width, table.isGreen], [640, true], `the picture of a shot (${table.mean})`);
}

/// A press on the strip selects a part; the inspector says what it is.
async function select(page) {
    const [, part] = await parts(page);
    const [x, y] = await pixelOnStrip(page, 'clips', (part.start + part.frames / 2) / 24, true, 0);
    await page.mouse.click(x, y + 85);
    equal(await selected(page), ['film', 'shots', '1'], 'the selection');
    equal(await page.locator('.inspector h2').innerText(), 'part half_ball.yaml', 'the title');
    equal([await field(page, 'shot').inputValue(), await field(page, 'fade').inputValue()],
        ['parts/half_ball.yaml', '0.5 s'], 'shot and fade');
    equal(await field(page, 'set events[0].strike.speed').inputValue(), '0.9 m/s', 'a replaced value');
    await page.getByText(`${part.frames} frames, from`).waitFor();
}

async function editFields(page, before) {
    await field(page, 'from').fill('1 s');
    await field(page, 'from').press('Enter');
    await settle(page);
    const [line] = changedLines(before, await textOf(page));
    equal(line.trim(), '- {shot: parts/half_ball.yaml, set: {"events[0].strike.speed": 0.9 m/s}, '
        + 'fade: 0.5 s, from: 1 s}', 'the changed line');
    equal((await parts(page))[1].first, 24, 'the first frame');
    await undo(page, before, 'a value');
}

/// Ends and fades, by whole frames.
async function drag(page, before) {
    const [title, first] = await parts(page);
    const end = await pixelOfHandle(page, 'film/shots/1 to');
    await dragPixels(page, end, [end[0] - 60, end[1]]);
    const shorter = (await parts(page))[1];
    equal(shorter.frames < first.frames && shorter.first === 0, true, 'frames of a shorter part');
    equal(/fade: 0\.5 s, to: [\d./ ]+ s}$/.test(changedLines(before, await textOf(page))[0]), true, 'the text');
    await undo(page, before, 'the end of a part');

    const card = await pixelOfHandle(page, 'film/shots/0 for');
    await dragPixels(page, card, [card[0] + 30, card[1]]);
    equal((await parts(page))[0].frames > title.frames, true, 'frames of a longer card');
    equal(/for: [\d./ ]+ s/.test(changedLines(before, await textOf(page))[0]), true, 'the text');
    await undo(page, before, 'the end of a card');

    const fade = await pixelOfHandle(page, 'film/shots/1 fade');
    await dragPixels(page, fade, [fade[0] - 15, fade[1]]);
    equal((await parts(page))[1].fade > first.fade, true, 'frames of a longer fade');
    equal(await problems(page), [], 'the problems');
    await undo(page, before, 'a fade');

    // By keys: one frame.
    await page.locator('[data-handle="film/shots/1 from"]').focus();
    await page.keyboard.press('ArrowRight');
    await page.waitForFunction(() => !window.studio.state.dragging.value);
    await settle(page);
    equal((await parts(page))[1].first, 1, 'the first frame after an arrow key');
    equal((await handleOf(page, 'film/shots/1 from')).text, '0.04 s', 'what the handle says');
    await undo(page, before, 'an arrow key');
}

async function move(page, before) {
    await page.locator('.outline .item', { hasText: 'The 30-degree rule' }).click();
    await page.getByRole('button', { name: 'Later' }).click();
    await settle(page);
    equal((await parts(page)).map(({ kind }) => kind), ['shot', 'title', 'shot', 'shot'], 'the order');
    equal(await selected(page), ['film', 'shots', '1'], 'the selection follows');
    await undo(page, before, 'a move');
    await page.getByRole('button', { name: 'Add', exact: true }).click();
    await page.getByRole('menuitem', { name: 'title card' }).click();
    await settle(page);
    equal((await parts(page)).length, 5, 'parts after adding');
    await undo(page, before, 'an addition');
}

/// A mistake in a shot's text, which is not saved, is one of the film.
async function mistake(page) {
    await page.getByRole('tab', { name: 'half_ball.yaml' }).click();
    const before = await textOf(page);
    await page.evaluate((at) => window.studio.edit.type(at, at + 'carom: 1'.length, 'carom: 7'),
        before.indexOf('carom: 1'));
    await settle(page);
    const found = await problems(page);
    equal([found.length, found[0].place.file.endsWith('parts/half_ball.yaml')], [1, true], 'the problem');
    await page.keyboard.press('Control+z');
    await settle(page);
    equal([await textOf(page), (await problems(page)).length], [before, 0], 'the text after one undo');
    await page.getByRole('tab', { name: 'lesson.yaml' }).click();
}

/// A few frames of a card, of a fade and of a shot become a film, which plays.
async function film(page) {
    await page.getByRole('button', { name: /^Make a film/ }).click();
    await page.getByText('The film has 640 × 360, 480 frames, 24 frames per second.').waitFor();
    await page.getByLabel('Quality').selectOption('draft');
    await page.getByLabel('Size').fill('160 x 90');
    await page.getByLabel('Frames').fill('40-79');
    await page.getByRole('button', { name: 'Render', exact: true }).click();
    await page.waitForFunction(() => ['done', 'failed'].includes(window.studio.films.film.value?.state),
        null, { timeout: kPatience });
    const state = await page.evaluate(() => window.studio.films.film.value);
    equal([state.state, state.message, state.frames, state.finished], ['done', '', 40, 40], 'the film');
    await page.waitForFunction(() => [...window.studio.films.thumbnails.value.values()]
        .filter((address) => address !== '').length === 40);
    await page.waitForFunction(() => document.querySelector('video')?.readyState >= 2);
    await page.getByRole('slider', { name: 'Frame' }).fill('35');
    await page.getByText('frame 35 of 40').waitFor();
    await keepPictures(page, 'film');
    await page.keyboard.press('Escape');
    equal(await page.getByRole('dialog').count(), 0, 'open dialogs');
}

/// Of the documents there are those of a film.
async function documents(page) {
    await page.getByRole('button', { name: 'Plan, report and contact sheet' }).click();
    await page.getByRole('tab', { name: 'Export' }).waitFor();
    equal(await page.getByRole('tab').filter({ hasNotText: 'yaml' }).allInnerTexts(),
        ['Contact sheet', 'Export'], 'the documents');
    await page.getByRole('button', { name: 'Make', exact: true }).waitFor();
    await page.getByRole('tab', { name: 'Export' }).click();
    equal(await page.locator('.export input').first().inputValue(), 'lesson_frame_0132.png', 'the file');
    await page.keyboard.press('Escape');
}

async function open(page) {
    await page.locator('.outline .item', { hasText: 'half_ball' }).first().click();
    await page.locator('.inspector').getByRole('button', { name: 'Open shot' }).click();
    await page.waitForFunction(() => window.studio.state.shot.value?.name === 'half_ball');
    await settle(page);
    equal(await page.evaluate(() => window.studio.state.sequence.value), null, 'the film of several shots');
    equal([await selected(page), await page.evaluate(() => document.querySelectorAll('.cm-lint-marker').length)],
        [null, 0], 'the selection, and marks of the mistake that was undone');
    equal(await page.locator('.view canvas').count(), 1, 'canvases of the view');
    equal(await page.getByRole('button', { name: 'Traced' }).getAttribute('aria-pressed'), 'false',
        'whether the view of a shot is traced');
}

export async function check({ page }) {
    const before = await textOf(page);
    await look(page);
    await picture(page);
    await select(page);
    await settle(page);
    await keepPictures(page, 'part');
    equal(await faults(page), [], 'what axe finds');
    await page.getByLabel('Switch to dark').or(page.getByLabel('Switch to light')).click();
    await keepPictures(page, 'other_theme');
    equal(await faults(page), [], 'what axe finds in the other theme');
    await page.getByRole('button', { name: 'Traced' }).click();  // each edit would trace it anew
    await editFields(page, before);
    await drag(page, before);
    await move(page, before);
    await mistake(page);
    await documents(page);
    await film(page);
    await open(page);
    return 'parts shown, selected, edited, dragged and moved, one undo each; its shot opened';
}
