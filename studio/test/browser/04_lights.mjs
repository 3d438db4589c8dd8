// Lights are moved, turned and resized by their handles; each drag changes one line of the text.
import { equal, settle, textOf } from './harness.mjs';

export const shot = 'tower.yaml';

function handlesOf(page) {
    return page.evaluate(() => {
        const { context } = window.studio.view;
        const box = context.canvas.getBoundingClientRect();
        return window.studio.lightHandles.value.map(({ key, at }) => {
            const [x, y] = context.toScreen(at);
            return { key, at: [x + box.left, y + box.top] };
        });
    });
}

export const isExtra = true; // only in scripts/test --all, or by name

export async function check({ page }) {
    const original = await textOf(page);
    const scene = page.locator('canvas[aria-label="The scene"]');
    const done = [];
    for (const light of ['spot', 'panel', 'bulb']) {
        await page.evaluate((name) => {
            window.studio.state.selection.value = ['lights', name];
        }, light);
        await scene.focus();
        await page.keyboard.press('f');
        const box = await scene.boundingBox();
        const isInView = ([x, y]) => x > box.x + 10 && x < box.x + box.width - 60
            && y > box.y + 70 && y < box.y + box.height - 60;
        for (const { key, at } of (await handlesOf(page)).filter((one) => isInView(one.at))) {
            await page.mouse.move(...at);
            await page.mouse.down();
            await page.mouse.move(at[0] + 12, at[1] + 9);
            await page.mouse.move(at[0] + 24, at[1] + 18);
            await page.mouse.up();
            await settle(page);
            const text = await textOf(page);
            const lines = original.split('\n');
            const changed = text.split('\n').filter((line, i) => line !== lines[i]);
            equal([changed.length, changed[0]?.trim().startsWith(`${light}:`)], [1, true],
                `${key} changed ${changed.join(' | ')}`);
            equal(await page.evaluate(() => window.studio.state.hasErrors.value), false, key);
            done.push(key.split('/').slice(1, 3).join('.'));
            await scene.focus();
            await page.keyboard.press('Control+z');
            await settle(page);
            equal(await textOf(page), original, `the text after undoing ${key}`);
        }
    }
    equal(new Set(done).size >= 4, true, `dragged: ${done.join(', ')}`);
    return done.join(', ');
}
