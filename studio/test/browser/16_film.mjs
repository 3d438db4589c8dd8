// A film is made at draft, stopped, and goes on with the frames that are missing. It plays in the
// page, also frame by frame, and 5 s is the frame that the film has there.
import { existsSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import { equal, holdFilm, kPatience, openText, textOf } from './harness.mjs';

export const shot = 'bank_shot.yaml';
const kFrames = 5;  // when it is stopped
const kWanted = 60;  // at 5 s

const filmState = (page) => page.evaluate(() => window.studio.films.film.value);
const waitFor = (page, state) => page.waitForFunction(
    (name) => window.studio.films.film.value?.state === name, state, { timeout: kPatience });

/// The numbers of red in the picture of the video, in a grid.
function shownPicture(page) {
    return page.evaluate(() => {
        const video = document.querySelector('video');
        const canvas = document.createElement('canvas');
        [canvas.width, canvas.height] = [64, 36];
        const context = canvas.getContext('2d');
        context.drawImage(video, 0, 0, 64, 36);
        return [...context.getImageData(0, 0, 64, 36).data].filter((_, i) => i % 4 === 0);
    });
}

const seeked = (page) => page.waitForFunction(() => {
    const video = document.querySelector('video');
    return !video.seeking && video.readyState >= 2;
});

/// The bank shot as a film of six seconds with few frames.
async function openSmall(context) {
    const text = readFileSync(context.path, 'utf8')
        .replace('video: [3 s, 5 s]', 'video: [3 s, 6 s]').replace('size: [640, 360], fps: 24', 'size: [640, 360], fps: 12');
    return openText(context, 'small.yaml', text);
}

export const ownPage = true; // it opens one itself

export async function check(context) {
    const { page, path, pid, end, complaints } = await openSmall(context);
    const frames = await page.evaluate(() => window.studio.state.shot.value.film.frames);
    const film = path.replace('.yaml', '.mp4');
    writeFileSync(film, 'somebody made this film');
    await page.getByRole('button', { name: /^Make a film/ }).click();
    await page.getByLabel('Quality').selectOption('draft');
    await page.getByLabel('Size').fill('416 x 234');
    await page.getByRole('button', { name: 'Render', exact: true }).click();
    await page.getByRole('button', { name: 'Keep it' }).click();
    equal(await filmState(page), null, 'the film of which the file was kept');
    await page.getByRole('button', { name: 'Render', exact: true }).click();
    await page.getByRole('button', { name: 'Overwrite' }).click();
    const goOn = await holdFilm(page, pid, kFrames);
    await page.keyboard.press('Escape');
    equal(await page.getByRole('dialog').count(), 0, 'open dialogs after Escape');
    await page.getByRole('button', { name: /^Make a film/ }).click();
    await page.getByRole('button', { name: 'Stop' }).click();
    goOn();
    await waitFor(page, 'stopped');
    const stopped = await filmState(page);
    equal(stopped.finished >= kFrames && stopped.finished < frames, true,
        `frames when it was stopped (${stopped.finished})`);
    equal(statSync(film).size, 23, 'the size of the file that was there before');

    await page.getByRole('button', { name: 'Resume' }).click();
    await page.getByRole('button', { name: 'Overwrite' }).click();
    await waitFor(page, 'done');
    const done = await filmState(page);
    equal([done.finished, done.frames], [frames, frames], 'finished frames');
    equal(done.reused >= stopped.finished && done.reused < frames, true,
        `frames from before (${done.reused}, ${stopped.finished} before)`);
    await page.waitForFunction((count) => window.studio.films.thumbnails.value.size === count, frames);
    equal(existsSync(film), true, 'the film');

    // It plays, and is exact to a frame.
    const video = page.locator('video');
    await page.waitForFunction(() => document.querySelector('video')?.readyState >= 2);
    const { duration, width } = await video.evaluate((one) =>
        ({ duration: one.duration, width: one.videoWidth }));
    equal(Math.abs(duration - frames / done.fps) < 0.02, true, `duration (${duration} s)`);
    equal([width, done.width], [416, 416], 'width');
    await page.getByRole('button', { name: 'Play', exact: true }).click();
    await page.waitForFunction(() => document.querySelector('video').currentTime > 0.2);
    await page.getByRole('button', { name: 'Pause', exact: true }).click();
    const wanted = kWanted;
    equal(wanted / done.fps, 5, 'the time of the frame');
    await page.getByRole('slider', { name: 'Frame' }).fill(String(wanted));
    await seeked(page);
    await page.getByText(`frame ${wanted} of ${frames}`).waitFor();
    const time = await video.evaluate((one) => one.currentTime);
    equal(Math.abs(time - wanted / done.fps) < 1 / done.fps, true, `the time (${time} s)`);
    const before = await shownPicture(page);
    await page.getByRole('button', { name: 'First frame', exact: true }).click();
    await seeked(page);
    const first = await shownPicture(page);
    const distance = (a, b) => a.reduce((sum, x, i) => sum + Math.abs(x - b[i]), 0) / a.length;
    await page.getByRole('slider', { name: 'Frame' }).fill(String(wanted - 1));
    await page.getByRole('button', { name: 'One frame forward', exact: true }).click();
    await seeked(page);
    equal(distance(await shownPicture(page), before), 0, 'the same frame after a step');
    equal(distance(first, before) > 0, true, 'another picture at the start');

    // A format that the browser does not know is said, and can be downloaded.
    await video.evaluate((one) => one.dispatchEvent(new Event('error')));
    await page.getByText('This browser cannot play the film').waitFor();
    equal(await page.getByRole('link', { name: 'Download' }).count(), 1, 'links to download it');
    await page.getByLabel('Size').fill('100');
    equal(await page.getByRole('button', { name: 'Render', exact: true }).isDisabled(), true,
        'whether a film of a wrong size can be begun');
    await page.getByLabel('Size').fill('');

    // Its frames are on the strip, and the texts were not touched.
    await page.keyboard.press('Escape');
    equal(await page.getByRole('dialog').count(), 0, 'open dialogs');
    equal(await textOf(page), readFileSync(path, 'utf8'), 'the text');
    equal(complaints, [], 'what the console says');
    await end();
    return `${frames} frames, ${stopped.finished} before it was stopped, ${done.reused} reused; `
        + `plays, and frame ${wanted} at 5 s is exact`;
}
