// Looking through a camera that is locked to the view: turning the view moves the camera in the text.
import { equal, settle, textOf } from './harness.mjs';

/// Escape takes a move back, also while the pointer goes on; the next press moves the camera again.
async function escape(page, before) {
    const at = () => page.evaluate(() => window.studio.view.camera.position.toArray());
    const box = await page.locator('canvas[aria-label="The scene"]').boundingBox();
    const [x, y] = [box.x + box.width / 2, box.y + 0.75 * box.height];
    const start = await at();
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 30, y);
    await page.mouse.move(x + 60, y);
    equal(await page.evaluate(() => window.studio.state.dragging.value), true, 'whether it is moved');
    await page.keyboard.press('Escape');
    await page.mouse.move(x + 90, y);
    await page.mouse.move(x + 120, y);
    await settle(page);
    equal(await textOf(page), before, 'the text after Escape');
    const off = Math.hypot(...(await at()).map((value, i) => value - start[i]));
    equal(off < 1e-6, true, `the view is ${off} m from where it was`);
    await page.mouse.up();
    await page.mouse.down();
    await page.mouse.move(x + 100, y);
    await page.mouse.up();
    await settle(page);
    equal(await textOf(page) !== before, true, 'whether the next drag moves the camera');
}

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
    await escape(page, before);
    return `one line changed, the view stays where it was left`;
}
