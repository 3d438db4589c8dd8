// Clips, fades, scene times, lines of the map, lenses and events are dragged on the strip of time:
// each drag is one step of undo, and film times stay on whole frames.
import { changedLines, dragPixels, equal, pressAtOnce, settle, textOf } from './harness.mjs';
import { handleOf, pixelOfHandle, pixelOnStrip } from './strip_harness.mjs';

async function undo(page, before, what) {
    await page.keyboard.press('Control+z');
    await settle(page);
    equal(await textOf(page), before, `the text after one undo of ${what}`);
}

function isWhole(time, what) {
    equal(Math.abs(time * 24 - Math.round(time * 24)) < 0.01, true, `${what} on a frame (${time} s)`);
}

export async function check({ page }) {
    const before = await textOf(page);
    const cameras = () => page.evaluate(() => window.studio.state.shot.value.cameras.map((one) =>
        ({ start: one.video_start, end: one.video_end, fade: one.fade,
            scene: [one.scene_start, one.scene_end] })));
    const noErrors = async () => equal(
        await page.evaluate(() => window.studio.state.problems.value.list), [], 'problems');

    const edge = await pixelOfHandle(page, 'cameras/1 start');
    await dragPixels(page, edge, [edge[0] + 37, edge[1]]);
    let [first, second] = await cameras();
    equal(second.start > 2.76, true, 'the second camera begins later');
    isWhole(second.start, 'the edge');
    equal(first.end, second.start, 'the first camera ends there');
    equal(await handleOf(page, 'cameras/0 start') ?? null, null, "a handle of the film's start");
    equal(changedLines(before, await textOf(page)).length, 2, 'changed lines');
    await noErrors();
    await undo(page, before, 'the edge');

    // The selected camera has a handle to draw out a fade.
    await page.evaluate(() => { window.studio.state.selection.value = ['cameras', '1']; });
    const fade = await pixelOfHandle(page, 'cameras/1 fade');
    await dragPixels(page, fade, [fade[0] + 33, fade[1]]);
    [first, second] = await cameras();
    equal(second.fade > 0.2, true, `a fade (${second.fade} s)`);
    isWhole(second.fade, 'the fade');
    equal(Math.abs(first.end - second.start - second.fade) < 1e-9, true, 'the end of the first camera');
    await noErrors();
    await undo(page, before, 'the fade');

    const end = await pixelOfHandle(page, 'cameras/2 scene 1');
    await dragPixels(page, end, [end[0] + 30, end[1]]);
    equal((await cameras())[2].scene[1] > 0.5, true, 'the scene time at the end');
    equal(changedLines(before, await textOf(page)).length, 1, 'changed lines');
    await undo(page, before, 'the scene time');

    // A line of the map moves both ends of the part of the scene.
    await page.evaluate(() => { window.studio.state.selection.value = ['cameras', '1']; });
    const line = await page.evaluate(() => window.studio.strip.lines(1)[8]);
    const top = await pixelOnStrip(page, 'map', line.film, true, 0);
    const bottom = await pixelOnStrip(page, 'map', line.scene, false, 1);
    const middle = [(top[0] + bottom[0]) / 2, (top[1] + bottom[1]) / 2];
    await dragPixels(page, middle, [middle[0] + 30, middle[1]]);
    const [, shifted] = await cameras();
    equal(shifted.scene[0] > 0.6, true, `the scene is shown later (${shifted.scene})`);
    equal(Math.abs(shifted.scene[1] - shifted.scene[0] - 0.46875) < 2e-3, true, 'and as long as before');
    await undo(page, before, 'the lines');

    const strike = await pixelOfHandle(page, 'events/0');
    await dragPixels(page, strike, [strike[0] + 25, strike[1]]);
    equal((await handleOf(page, 'events/0')).time > 0.6, true, 'the strike is later');
    equal(changedLines(before, await textOf(page)).length, 1, 'changed lines');
    await undo(page, before, 'the strike');

    await page.evaluate(() => { window.studio.state.selection.value = ['cameras', '1']; });
    await page.getByLabel('Camera curve').selectOption('fov');
    const lens = await pixelOfHandle(page, 'cameras/1/fov/1');
    await dragPixels(page, lens, [lens[0], lens[1] - 9]);
    const [changed] = changedLines(before, await textOf(page));
    equal(/^ {4}fov: \[30 deg, (3[7-9]|4\d)(\.\d)? deg\]$/.test(changed), true, changed);
    await undo(page, before, 'the field of view');

    // By keys: one frame.
    await page.locator('[data-handle="cameras/1 start"]').focus();
    await page.keyboard.press('ArrowRight');
    await settle(page);
    equal(Math.round((await cameras())[1].start * 24), 67, 'the frame after an arrow key');
    await undo(page, before, 'an arrow key');

    // Frame 67 is no decimal number of seconds: it belongs to the camera that begins there.
    await page.locator('[data-handle="cameras/1 start"]').focus();
    await pressAtOnce(page, ['ArrowRight', 'ArrowRight', 'ArrowLeft']);
    await page.waitForFunction(() => !window.studio.state.dragging.value);
    await settle(page);
    equal(changedLines(before, await textOf(page)).map((line) => line.trim()),
        ['video: [0 s, 67 / 24 s]', 'video: [67 / 24 s, 6.5 s]'], 'the written times');
    const filmed = await page.evaluate(() => {
        const { head, numbers } = window.studio.state.cameraFrames.value;
        const size = numbers.length / head.entries;
        return [66, 67].map((frame) => [...Array(head.entries).keys()]
            .filter((i) => numbers[i * size] === frame).map((i) => numbers[i * size + 1]));
    });
    equal(filmed, [[0], [1]], 'the cameras of frames 66 and 67');
    await undo(page, before, 'a run of keys');

    // Both clocks move together; a time of the scene that two cameras show is a choice.
    await page.mouse.click(...await pixelOnStrip(page, 'sceneRuler', 0.8, false));
    const others = await page.evaluate(() => window.studio.strip.others.value.map((one) => one.camera));
    equal(others, [1, 2], 'the other cameras that show it');
    const filmTimeThen = await page.evaluate(() => window.studio.state.filmTime.value);
    await page.getByLabel('Other moments of the film that show this scene time')
        .selectOption({ index: 1 });
    const now = await page.evaluate(() => [window.studio.state.filmTime.value,
        window.studio.state.sceneTime.value]);
    equal(Math.abs(now[1] - 0.8) < 0.02 && now[0] !== filmTimeThen, true, `both clocks (${now})`);

    // The wheel zooms, and all times come back.
    const [x, y] = await pixelOnStrip(page, 'clips', 4, true);
    await page.mouse.move(x, y);
    await page.mouse.wheel(0, -600);
    const length = () => page.evaluate(() => {
        const { film } = window.studio.strip.layout.value;
        return film.to - film.from;
    });
    await page.waitForFunction(() => {
        const { film } = window.studio.strip.layout.value;
        return film.to - film.from < 6;
    });
    await page.keyboard.press('Shift+F');
    equal(Math.round(await length()), 10, 'seconds that the strip shows');
    return 'edge, fade, scene time, lines, strike and lens dragged; one undo each, whole frames';
}
