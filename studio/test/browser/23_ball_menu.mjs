// The menu of a ball: strike it, aim at it, place it against another one, back to the rack; a racked
// ball that is dragged gets an entry of its own.
import { dragPixels, equal, pixelOf, settle, textOf } from './harness.mjs';

const kRadius = 0.028575;

export async function check({ page }) {
    await page.waitForFunction(() => window.studio.view.context.meshNode('nine'));
    await page.keyboard.press('1');
    await settle(page);
    const before = await textOf(page);
    const place = (name) => page.evaluate((one) => window.studio.state.shot.value.objects
        .find((object) => object.name === one).position, name);
    const choose = async (name, label) => {
        const [x, y] = await pixelOf(page, await place(name));
        await page.mouse.click(x, y, { button: 'right' });
        await page.getByRole('menuitem', { name: label }).click();
        await settle(page);
        return textOf(page);
    };
    const undo = async () => {
        await page.keyboard.press('Control+z');
        await settle(page);
        equal(await textOf(page), before, 'the text after undo');
    };

    const aimed = await choose('five', 'Strike cue at five');
    equal(aimed, before.replace('toward: one', 'toward: five'), 'the aim');
    await undo();
    const struck = await choose('five', 'Strike five');
    equal(struck.includes('\n  - strike: {ball: five, at: 0.5 s, direction: 0 deg, speed: 2 m/s}\n'), true, struck);
    await undo();
    const against = await choose('cue', /^Place cue against \w+$/);
    const other = /\n {2}cue: \{touching: \{ball: (\w+), direction: -?[\d.]+ deg\}\}\n/.exec(against)?.[1];
    const [a, b] = [await place('cue'), await place(other)];
    equal(Math.abs(Math.hypot(a[0] - b[0], a[1] - b[1]) - 2 * kRadius) < 1e-6, true, 'the distance');
    await undo();

    await dragPixels(page, await pixelOf(page, await place('nine')),
        await pixelOf(page, [0.2, -0.3, kRadius]));
    const dragged = await textOf(page);
    equal(/\n {2}nine: \{at: \[0\.\d+, -0\.\d+\]\}\n/.test(dragged), true, dragged);
    equal(await choose('nine', 'Return nine to the rack'), before, 'the text with nine in the rack again');
    return `aim, strike, against ${other}, an entry of its own and back to the rack`;
}
