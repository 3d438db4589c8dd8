// By keys, every way to write a strike keeps one way to aim and one speed; an aim in the view and one
// on the dial take turns. What the last scene without mistakes shows is only written into a text in
// which it still is. T goes to the text.
import { dragPixels, equal, openText, pixelOf, settle, textOf } from './harness.mjs';

const kShot = `carom: 1  # aim by keys
table: {kind: pool}
simulation: {duration: 2 s}
balls:
  cue: {at: [-0.5, 0]}
  one: {at: [0.4, 0.25]}
objects:
  tile:
    box: [0.02, 0.06, 0.12]
    at: [0.6, -0.3, 0.06]
    repeat: {count: 3, along: {step: [0.1, 0, 0]}}
events:
  - strike: {ball: cue, at: 0.2 s, toward: one, speed: 3 m/s}
`;
const kForms = ['toward: one, speed: 3 m/s', 'toward: [0.4, 0.25], speed: 3 m/s',
    'direction: 12 deg, ball_speed: 2 m/s', 'ball_speed: 2 m/s, toward: one, tip: [0, 0.2]'];

async function errors(page) {
    await settle(page);
    return page.evaluate(() => window.studio.state.problems.value.list
        .filter(({ severity }) => severity === 'error').map(({ message }) => message));
}

/// Gives the open text another content, as one who types.
async function replace(page, from, to) {
    const text = await textOf(page);
    await page.evaluate(([a, b, word]) => window.studio.edit.type(a, b, word),
        [text.indexOf(from), text.indexOf(from) + from.length, to]);
    await settle(page);
}

const strikeOf = async (page) => /strike: \{(.*)\}/.exec(await textOf(page))[1];

/// Presses of arrows with the server's answer between them: one step of undo, if that comes soon.
async function press(page, label, keys) {
    await page.getByLabel(label).focus();
    for (const key of keys) {
        await page.keyboard.press(key);
        await settle(page);
    }
    await page.waitForFunction(() => !window.studio.state.dragging.value);
}

export const ownPage = true; // it opens one itself

export const isExtra = true; // only in scripts/test --all, or by name

export async function check(context) {
    const { page, complaints, end } = await openText(context, 'aim_keys.yaml', kShot);
    await page.evaluate(() => { window.studio.state.selection.value = ['events', '0']; });
    for (const form of kForms) {
        await replace(page, await strikeOf(page), `ball: cue, at: 0.2 s, ${form}`);
        const before = await textOf(page);
        await press(page, 'Direction of the aim', ['ArrowLeft', 'ArrowLeft', 'Shift+ArrowUp']);
        equal(await errors(page), [], `errors after the aim of ${form}`);
        const aimed = await strikeOf(page);
        equal([/toward/.test(aimed), aimed.match(/direction: [\d.]+ deg/g).length], [false, 1], aimed);
        await press(page, 'Where the tip hits the ball', ['ArrowLeft', 'ArrowUp', 'ArrowUp']);
        equal(await errors(page), [], `errors after the tip of ${form}`);
        for (let i = 0; i < 6 && await textOf(page) !== before; ++i) {
            await page.keyboard.press('Control+z');
            await settle(page);
        }
        equal(await textOf(page), before, `the text of ${form} after undo`);
    }

    // The speed by its handle keeps the key that the text has.
    const handle = await page.evaluate(() =>
        window.studio.gizmos.handles().find(({ kind }) => kind === 'speed').at);
    const from = await pixelOf(page, handle);
    await dragPixels(page, from, [from[0] - 40, from[1] + 4]);
    equal([await errors(page), /[^_]speed/.test(await strikeOf(page))], [[], false], 'the ball speed');

    // A mistake takes the tiles out of the text; the view still shows them.
    await page.evaluate(() => { window.studio.state.selection.value = null; });
    await replace(page, 'repeat:', 'repaet:');
    const broken = await textOf(page);
    const count = (await errors(page)).length;
    equal(count > 0, true, 'the mistake is told');
    const tile = await pixelOf(page, [0.7, -0.3, 0.1]);
    await dragPixels(page, tile, [tile[0] + 60, tile[1] + 20]);
    equal([await textOf(page), (await errors(page)).length], [broken, count], 'after a drag of a tile');
    const told = await page.evaluate(() => window.studio.state.notice.value.text);
    equal(/'objects\.tile_\d' is not where it was .* must be mended first/.test(told), true, told);
    const cue = await pixelOf(page, [-0.5, 0, 0.03]);
    await dragPixels(page, cue, [cue[0] + 50, cue[1]]);
    equal(/cue: \{at: \[-0\.[1-4]/.test(await textOf(page)), true, 'what is in the text can be dragged');

    // T unfolds the text and goes to the place; what is typed is text.
    await page.keyboard.press('Control+j');
    await page.locator('canvas').first().focus();
    await page.evaluate(() => { window.studio.state.selection.value = ['events', '0']; });
    await page.keyboard.press('t');
    await page.waitForFunction(() => document.activeElement.closest('.cm-content') !== null);
    await page.keyboard.type('t f');
    equal(/^ {2}- t fstrike/m.test(await textOf(page)), true, await textOf(page));
    if (process.env.CAROM_STUDIO_SHOTS) {
        await page.screenshot({ path: `${process.env.CAROM_STUDIO_SHOTS}/24_aim_keys.png` });
    }
    await page.keyboard.press('Control+k');
    await page.keyboard.type('show it in the text');
    await page.keyboard.press('Enter');
    await page.waitForFunction(() => document.activeElement.closest('.cm-content') !== null);
    equal(complaints, [], 'the console');
    await end();
    return `${kForms.length} ways to write a strike stay valid; a broken text gets nothing of the last scene`;
}
