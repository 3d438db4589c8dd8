// The measures of an orbit and of a lens are dragged by their handles: one line changes, and the
// handle is where the pointer was.
import { equal, settle, textOf } from './harness.mjs';

export const shot = 'bullet_time.yaml';
const kWay = 26; // pixels

/// The handles that move along lines or in planes: where they are, and a way on the page in which
/// they can go.
function handlesOf(page) {
    return page.evaluate((pixels) => {
        const { context } = window.studio.view;
        const box = context.canvas.getBoundingClientRect();
        const all = window.studio.cameraHandles.value;
        const centre = all.find(({ key }) => key.endsWith('position/0')).at;
        const cross = (a, b) => [0, 1, 2].map((i) =>
            a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3]);
        return all.filter(({ way }) => way.kind !== 'free').map(({ key, at, way }) => {
            const along = way.along ?? cross(way.normal, at.map((value, i) => value - centre[i]));
            const size = Math.hypot(...along);
            const place = context.toScreen(at);
            const next = context.toScreen(at.map((value, i) => value + (0.001 * along[i]) / size));
            const step = [next[0] - place[0], next[1] - place[1]];
            // The tangent leaves the ellipse.
            const scale = (way.along ? pixels : pixels / 3) / Math.hypot(...step);
            return { key, at: [place[0] + box.left, place[1] + box.top],
                way: step.map((value) => value * scale) };
        });
    }, kWay);
}

export async function check({ page }) {
    const scene = page.locator('canvas[aria-label="The scene"]');
    const original = await textOf(page);
    await page.evaluate(() => { window.studio.state.selection.value = ['cameras', '0']; });
    await scene.focus();
    await page.keyboard.press('f');
    const done = [];
    for (const { key } of await handlesOf(page)) {
        const handle = (await handlesOf(page)).find((one) => one.key === key);
        const pointer = handle.at.map((value, i) => value + handle.way[i]);
        await page.mouse.move(...handle.at);
        await page.mouse.down();
        await page.mouse.move(handle.at[0] + handle.way[0] / 2, handle.at[1] + handle.way[1] / 2);
        await page.mouse.move(...pointer);
        await page.mouse.up();
        await settle(page);
        const lines = original.split('\n');
        const changed = (await textOf(page)).split('\n').filter((line, i) => line !== lines[i]);
        const name = key.split('/').slice(2).join('.');
        equal(changed.length, 1, `${name} changed ${changed.join(' | ')}`);
        equal(await page.evaluate(() => window.studio.state.hasErrors.value), false, name);
        const now = (await handlesOf(page)).find((one) => one.key === key).at;
        const off = Math.hypot(now[0] - pointer[0], now[1] - pointer[1]);
        equal(off < (name.includes('angles') ? 4 : 1.5), true, `${name} is ${off.toFixed(2)} pixels off`);
        done.push(name);
        await scene.focus();
        await page.keyboard.press('Control+z');
        await settle(page);
        equal(await textOf(page), original, `the text after undoing ${name}`);
    }
    equal(done.length, 6, `handles: ${done.join(', ')}`);
    return done.join(', ');
}
