// By touch: a tap selects a ball, a drag moves it, a long press opens its menu, two fingers zoom the
// strip, and a drag of a name in the inspector changes its number.
import { changedLines, equal, open, pixelOf, settle, textOf } from './harness.mjs';
import { pixelOnStrip } from './strip_harness.mjs';

/// Fingers on the page: each is [x, y].
async function fingers(page) {
    const session = await page.context().newCDPSession(page);
    const send = (type, points) => session.send('Input.dispatchTouchEvent',
        { type, touchPoints: points.map(([x, y], id) => ({ x, y, id })) });
    const along = async (from, to, steps = 6) => {
        for (let i = 1; i <= steps; ++i) {
            await send('touchMove', from.map(([x, y], k) =>
                [x + ((to[k][0] - x) * i) / steps, y + ((to[k][1] - y) * i) / steps]));
        }
    };
    return {
        down: (...points) => send('touchStart', points),
        along,
        up: () => send('touchEnd', []),
        drag: async (from, to) => {
            await send('touchStart', from);
            await along(from, to);
            await send('touchEnd', []);
            await settle(page);
        },
    };
}

const placeOf = (page, name) => page.evaluate((one) =>
    window.studio.state.shot.value.objects.find((object) => object.name === one).position, name);

export async function check({ browser, address }) {
    const context = await browser.newContext(
        { hasTouch: true, viewport: { width: 1280, height: 720 }, deviceScaleFactor: 1 });
    const { page, complaints } = await open({ newContext: () => context }, address);
    await page.waitForFunction(() => window.studio.view.meshes.node('cue'));
    const hand = await fingers(page);
    const before = await textOf(page);
    const chosen = () => page.evaluate(() => window.studio.state.selection.value);

    const cue = await pixelOf(page, await placeOf(page, 'cue'));
    await page.touchscreen.tap(...cue);
    await page.waitForFunction(() => window.studio.state.selection.value !== null);
    equal(await chosen(), ['balls', 'cue'], 'the selection after a tap');
    equal(await textOf(page), before, 'the text after a tap');
    // While the page is busy with the selection, a finger would rest for long enough to open a menu.
    await settle(page);

    await hand.drag([cue], [[cue[0] + 50, cue[1] + 16]]);
    const [moved] = changedLines(before, await textOf(page));
    equal(changedLines(before, await textOf(page)).length, 1, 'changed lines');
    equal(/^ {2}cue: \{at: \[-0\.\d+, -?0\.\d+\]\}$/.test(moved), true, moved);
    equal(await page.evaluate(() => window.studio.state.dragging.value), false, 'a drag in progress');

    const nine = await pixelOf(page, await placeOf(page, 'nine'));
    await hand.down(nine);
    await page.getByRole('menu').waitFor();
    await hand.along([nine], [[nine[0] + 30, nine[1] + 30]]);
    await hand.up();
    equal(await page.getByRole('menu').getAttribute('aria-label'), 'nine', 'the title of the menu');
    equal(await page.evaluate(() => window.studio.state.dragging.value), false,
        'a drag under the menu');
    equal(changedLines(before, await textOf(page)), [moved], 'changed lines after a long press');
    await page.touchscreen.tap(640, 20);
    await page.getByRole('menu').waitFor({ state: 'detached' });

    const left = await pixelOnStrip(page, 'clips', 4, true);
    const right = await pixelOnStrip(page, 'clips', 5.5, true);
    const times = () => page.evaluate(() => {
        const { film, scene } = window.studio.strip.layout.value;
        return [film.to - film.from, scene.to - scene.from];
    });
    const [film, scene] = await times();
    await hand.drag([left, right], [[left[0] - 60, left[1]], [right[0] + 60, right[1]]]);
    const [zoomed, same] = await times();
    equal(zoomed < 0.8 * film, true, `seconds of the film that the strip shows (${zoomed})`);
    equal(same, scene, 'seconds of the scene that the strip shows');
    equal(changedLines(before, await textOf(page)), [moved], 'changed lines after the pinch');

    await page.evaluate(() => { window.studio.state.selection.value = ['events', '0']; });
    const name = page.locator('.inspector .name', { hasText: /^speed$/ });
    await name.scrollIntoViewIfNeeded();
    const box = await name.boundingBox();
    await hand.drag([[box.x + 8, box.y + 8]], [[box.x + 38, box.y + 8]]);
    equal(/speed: 9 m\/s/.test(await textOf(page)), true, 'the speed after its name was dragged');
    equal(/^speed/.test(await page.locator('.inspector .about').textContent()), true,
        'the key that the inspector describes');
    equal(complaints, [], 'what the console says');
    await context.close();
    return 'tapped, dragged, long pressed and pinched; one line changed by each drag';
}
