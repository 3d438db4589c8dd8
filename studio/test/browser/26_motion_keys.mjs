// The places of the keys of an object's motion are handles: a drag changes that place and nothing else.
import { changedLines, dragPixels, equal, pixelOf, settle, textOf } from './harness.mjs';

export const shot = 'turnstile.yaml';

export const isExtra = true; // only in scripts/test --all, or by name

export async function check({ page }) {
    await page.waitForFunction(() => window.studio.view.context.meshNode('plank'));
    await page.evaluate(() => { window.studio.state.selection.value = ['objects', 'plank']; });
    await page.locator('canvas[aria-label="The scene"]').focus();
    await page.keyboard.press('f');
    const keys = () => page.evaluate(() => window.studio.gizmos.motionKeys()
        .map(({ at, label }) => ({ at, label })));
    const before = await textOf(page);
    equal((await keys()).map(({ label }) => label), ['plank: key 1 at 0.5 s', 'plank: key 2 at 2.5 s'],
        'the keys');
    const from = await pixelOf(page, (await keys())[1].at);
    await dragPixels(page, from, [from[0] + 50, from[1] - 30]);
    const lines = changedLines(before, await textOf(page));
    equal([lines.length, /\{at: 2\.5 s, position: \[.*\], rotate: \[0 deg, 13 deg, 0 deg\]\}/.test(lines[0])],
        [1, true], lines.join(' | '));
    const now = await pixelOf(page, (await keys())[1].at);
    equal(Math.hypot(now[0] - from[0] - 50, now[1] - from[1] + 30) <= 1, true, 'where the key is');
    const drawn = await page.evaluate(() => window.studio.gizmos.figure('motion keys').lines.length);
    equal(drawn, 1, 'lines between the keys');
    if (process.env.CAROM_STUDIO_SHOTS) {
        await page.screenshot({ path: `${process.env.CAROM_STUDIO_SHOTS}/motion_keys_view.png` });
    }
    await page.keyboard.press('Control+z');
    await settle(page);
    equal(await textOf(page), before, 'the text after one undo');
    return 'the second key of two was dragged, and is where the pointer left it';
}
