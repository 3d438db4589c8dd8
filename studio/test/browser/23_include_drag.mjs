// A ball that a file of the shot's own folder places: a drag lays its place over in the shot, with Shift
// finer, and with Ctrl and Shift it changes that file and says so.
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { dragPixels, equal, openText, pixelOf, settle, textOf } from './harness.mjs';

const kBalls = 'balls:\n  cue: {at: [-0.4, 0]}\n';
const kShot = `carom: 1
include: [../configs/tables/pool_9ft.yaml, own_balls.yaml]
cameras:
  - {name: seat, video: [0 s, 1 s], scene: [0 s, 1 s], position: [0, -3, 2], target: [0, 0, 0], fov: 40 deg}
`;

export const shot = 'bank_shot.yaml';

export const ownPage = true; // it opens one itself

export const isExtra = true; // only in scripts/test --all, or by name

export async function check(context) {
    writeFileSync(join(context.folder, 'examples', 'own_balls.yaml'), kBalls);
    const { page, end } = await openText(context, 'including.yaml', kShot);
    await page.waitForFunction(() => window.studio.view.context.meshNode('cue'));
    await page.locator('canvas[aria-label="The scene"]').focus();
    await page.keyboard.press('1');
    const included = async () => {
        await page.getByRole('tab', { name: 'own_balls.yaml' }).click();
        const text = await textOf(page);
        await page.getByRole('tab', { name: 'including.yaml' }).click();
        await page.locator('canvas[aria-label="The scene"]').focus();
        return text;
    };
    const place = () => page.evaluate(() => window.studio.state.shot.value.objects
        .find(({ name }) => name === 'cue').position);
    const drag = async (...keys) => {
        const [x, y] = await pixelOf(page, await place());
        const before = (await place())[0];
        for (const key of keys) {
            await page.keyboard.down(key);
        }
        await dragPixels(page, [x, y], [x + 40, y]);
        for (const key of keys) {
            await page.keyboard.up(key);
        }
        return (await place())[0] - before;
    };
    const far = await drag('Control');
    equal([/cue: \{at: \[/.test(await textOf(page)), await included()], [true, kBalls], 'laid over');
    const fine = await drag('Shift');
    equal(await included(), kBalls, 'the included file after a finer drag');
    equal(Math.abs(fine) < far / 3, true, `the finer drag: ${fine} m, the other ${far} m`);
    await page.keyboard.press('Control+z');
    await page.keyboard.press('Control+z');
    await settle(page);
    equal(await textOf(page), kShot, 'the text after two undos');
    await drag('Control', 'Shift');
    equal([await textOf(page), /cue: \{at: \[-0\.[0-3]/.test(await included())], [kShot, true],
        'the included file is changed');
    await page.getByText('This changes', { exact: false }).first().waitFor();
    await end();
    return 'over the shot, finer with Shift, and into the file with Ctrl and Shift';
}
