// Looking through a camera that is locked to the view: turning the view moves the camera in the text.
import { equal, settle, textOf } from './harness.mjs';

export async function check({ page }) {
    await page.locator('canvas[aria-label="The scene"]').focus();
    await page.keyboard.press('c');
    await page.getByRole('button', { name: 'Moving the view moves the camera' }).click();
    const before = await textOf(page);
    const box = await page.locator('canvas[aria-label="The scene"]').boundingBox();
    const [x, y] = [box.x + box.width / 2, box.y + 0.75 * box.height];
    await page.mouse.move(x, y);
    await page.mouse.down();
    for (let i = 1; i <= 4; ++i) {
        await page.mouse.move(x + 20 * i, y - 5 * i);
    }
    const held = await page.evaluate(() => window.studio.view.camera.position.toArray());
    await page.mouse.up();
    await settle(page);
    const after = await textOf(page);
    const old = before.split('\n');
    const changed = after.split('\n').filter((line, i) => line !== old[i]);
    equal(changed.length, 1, `changed lines: ${changed.join(' | ')}`);
    const now = await page.evaluate(() => window.studio.view.camera.position.toArray());
    const off = Math.hypot(...now.map((value, i) => value - held[i]));
    equal(off < 2e-3, true, `the camera is ${off} m from where the view was left`);
    await page.locator('canvas[aria-label="The scene"]').focus();
    await page.keyboard.press('Control+z');
    await settle(page);
    equal(await textOf(page), before, 'the text after one undo');
    return `one line changed, the view stays where it was left`;
}
