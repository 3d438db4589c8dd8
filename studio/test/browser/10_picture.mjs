// R shows the path-traced frame at the play head; when it has all samples, `carom render` finds it.
import { spawnSync } from 'node:child_process';
import { join } from 'node:path';
import { equal, settle } from './harness.mjs';

export async function check({ page, path, folder, carom }) {
    await page.evaluate(() => window.studio.state.filmTime.value = 3.5);
    await page.locator('canvas[aria-label="The scene"]').focus();
    await page.keyboard.press('r');
    await page.waitForFunction(() => window.studio.state.picture.value?.head.complete);
    await settle(page);
    const head = await page.evaluate(() => window.studio.state.picture.value.head);
    equal([head.width, head.height], [640, 360], 'the size of the last round');
    equal(head.samples, head.of_samples, 'samples');
    equal(head.stored, true, 'whether the frame is stored');
    const words = ['render', path, '--frames', '84', '--dry-run', '--cache', join(folder, 'cache')];
    const plan = spawnSync(carom, words, { encoding: 'utf8' });
    const said = plan.stdout + plan.stderr;
    equal(said.includes('1 stored, 0 to render'), true, said);
    return `${head.samples} samples, stored under the frame's key`;
}
