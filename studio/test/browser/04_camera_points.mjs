// Every control point of every camera is dragged: it is then where the pointer was, and the text has
// no error. All examples with CAROM_STUDIO_ALL=1, or the one that it names.
import { spawnSync } from 'node:child_process';
import { writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { equal, exampleShots, open, serve, settle, textOf } from './harness.mjs';

const kFew = ['bullet_time.yaml']; // an orbit with an offset, points of objects, aliases
const kMoves = 3;
const kSize = { width: 1000, height: 560 };

/// The handles of the selected camera: their key paths, and where they are on the page.
function handlesOf(page) {
    return page.evaluate(() => {
        const { context } = window.studio.view;
        const box = context.canvas.getBoundingClientRect();
        return window.studio.cameraHandles.value.map(({ key, path, at, way }) => {
            const place = context.toScreen(at);
            return { key, path, way: way.kind, at: place && [place[0] + box.left, place[1] + box.top] };
        });
    });
}

/// Selects a value and waits until the view shows it in its middle.
async function frame(page, path) {
    await page.evaluate((chosen) => { window.studio.state.selection.value = chosen; }, path);
    await page.locator('canvas[aria-label="The scene"]').focus();
    await page.keyboard.press('f');
    await still(page);
}

/// Waits until the handles are where they were 50 ms before: the view, or the shot's answer to a
/// drag, may come late on a busy machine.
async function still(page) {
    for (let before = '', i = 0; i < 600; ++i) {
        const now = JSON.stringify(await handlesOf(page));
        if (now === before) {
            return;
        }
        before = now;
        await page.waitForTimeout(50);
    }
}

/// How far the nearest of the handles is from a point of the page, once one has followed the
/// pointer there, or after 30 s.
async function distance(page, free, [x, y]) {
    let nearest = Infinity;
    for (let i = 0; i < 600 && nearest > 1; ++i) {
        await page.waitForTimeout(i > 0 ? 50 : 0);
        nearest = Math.min(...free(await handlesOf(page)).map(({ at }) =>
            (at ? Math.hypot(at[0] - x, at[1] - y) : Infinity)));
    }
    return nearest;
}

async function drag(page, handle, way) {
    const [x, y] = handle.at;
    await page.mouse.move(x, y);
    await page.mouse.down();
    for (let i = 1; i <= kMoves; ++i) {
        await page.mouse.move(x + (way[0] * i) / kMoves, y + (way[1] * i) / kMoves);
    }
    await page.mouse.up();
    const isAsked = await page.evaluate(() => new Promise((resolve) =>
        requestAnimationFrame(() => requestAnimationFrame(() =>
            resolve(document.querySelector('dialog') !== null)))));
    if (isAsked) {
        await page.getByRole('button', { name: 'Only here' }).click();
    }
    await settle(page);
    return [x + way[0], y + way[1]];
}

/// Counts the changes of the shot's texts: a point of a rig may be written in the rig's file.
function version(page) {
    return page.evaluate(() => window.studio.state.textVersion.value);
}

/// How many points of the shot were dragged.
async function checkShot(page, carom, path) {
    const original = await textOf(page);
    const cameras = await page.evaluate(() =>
        window.studio.state.shot.value.cameras.map((camera) => camera.path));
    let count = 0;
    for (const camera of cameras) {
        await frame(page, camera);
        const free = (all) => all.filter((one) =>
            one.way === 'free' && !one.key.endsWith('/turn'));
        const points = free(await handlesOf(page));
        for (const { key } of points) {
            await frame(page, points.find((one) => one.key === key).path);
            const handle = (await handlesOf(page)).find((one) => one.key === key);
            const before = await version(page);
            const pointer = await drag(page, handle, [37, -23]);
            const off = await distance(page, free, pointer);
            equal(off <= 1, true, `${path}: ${key} is ${off.toFixed(2)} pixels from the pointer`);
            equal(await version(page) > before, true, `${path}: ${key} changed a text`);
            equal(await page.evaluate(() => window.studio.state.hasErrors.value), false, key);
            count += 1;
        }
    }
    const text = await textOf(page);
    const dragged = path.replace('.yaml', '_dragged.yaml');
    writeFileSync(dragged, text);
    const told = spawnSync(carom, ['check', dragged], { encoding: 'utf8' });
    equal(told.status, 0, told.stdout + told.stderr);
    for (let i = 0; i < count; ++i) {
        await page.evaluate(() => window.studio.edit.travel(true));
    }
    equal(await textOf(page), original, `${path}: the text after ${count} undos`);
    return count;
}

export const ownPage = true; // it opens one itself

export async function check({ browser, folder, carom }) {
    const all = exampleShots(folder);
    const named = process.env.CAROM_STUDIO_ALL;
    const names = !named ? kFew : named === '1' ? all : [named];
    let count = 0;
    for (const name of names) {
        const path = join(folder, 'examples', name);
        const { address, end } = await serve(resolve(carom), path, folder);
        try {
            const { page, complaints } = await open(browser, address, kSize);
            count += await checkShot(page, carom, path);
            equal(complaints, [], 'the console');
            await page.close();
        } finally {
            await end();
        }
    }
    return `${count} points of ${names.length} shots are where the pointer left them`;
}
