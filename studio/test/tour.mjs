// Makes the pictures of docs/studio.md and docs/studio_walk.md: `node tour.mjs CAROM FOLDER [WORD]`. The first part shows the
// page; the second authors a bank shot from an empty file, as a user does: with the pointer and the keyboard. It fails if
// the shot does not come out as it should.
import { join, resolve } from 'node:path';
import {
    copyShots, dragPixels, equal, launch, open, pixelOf, remove, serve, settle,
} from './browser/harness.mjs';

const kSize = { width: 1440, height: 860 };
const kRadius = 0.028575;
const [carom, pictures] = process.argv.slice(2, 4).map((word) => resolve(word));
const only = process.argv[4] ?? '';
if (!pictures) {
    console.error('usage: node tour.mjs CAROM FOLDER [break | walk]');
    process.exit(2);
}

/// Hides where the shots of the tour are.
async function hidePlaces(page) {
    await page.evaluate(() => {
        for (const node of document.querySelectorAll('.where, .head p, footer, .written, .cm-line span')) {
            for (const text of node.childNodes) {
                if (text.nodeType === Node.TEXT_NODE) {
                    text.data = text.data.replace(/\/\S*carom-studio-\w+/, '~/shots')
                        .replace(/=\/\S*\/configs\//, '=configs/');
                }
            }
        }
    });
}

async function keep(page, name) {
    if (await page.evaluate(() => !window.studio.state.isStarting.value)) {
        await settle(page);
    }
    // A frame is drawn after the answers have come.
    await page.evaluate(() => new Promise((done) =>
        requestAnimationFrame(() => requestAnimationFrame(done))));
    await hidePlaces(page);
    await page.screenshot({ path: join(pictures, `${name}.png`) });
    console.log(name);
}

/// Gives the view the keys.
function toView(page) {
    return page.locator('canvas[aria-label="The scene"]').focus();
}

async function scheme(page, colorScheme) {
    await page.emulateMedia({ colorScheme });
    await page.evaluate((name) => { window.studio.state.theme.value = name; }, colorScheme);
}

async function traced(page) {
    await page.waitForFunction(() => window.studio.state.picture.value?.head.complete
        && !window.studio.state.pictureAsked.value, null, { timeout: 300000 });
}

/// Finds a command by its words and runs it.
async function command(page, words) {
    await page.keyboard.press('Control+k');
    await page.getByRole('combobox', { name: 'Find a command' }).fill(words);
    await page.keyboard.press('Enter');
}

function select(page, path) {
    return page.evaluate((keys) => { window.studio.state.selection.value = keys; }, path);
}

function placeOf(page, name) {
    return page.evaluate((one) => window.studio.state.shot.value.objects
        .find((object) => object.name === one).position, name);
}

async function film(page, quality) {
    await page.keyboard.press('Control+Enter');
    await page.getByLabel('Quality').selectOption(quality);
    await page.getByRole('button', { name: /ender$/ }).click();
}

async function filmDone(page, frame) {
    await page.waitForFunction(() => window.studio.films.film.value?.state === 'done', null,
        { timeout: 900000 });
    await page.waitForFunction(() => document.querySelector('video')?.readyState >= 2);
    await page.getByRole('slider', { name: 'Frame' }).fill(String(frame));
    await page.waitForFunction(() => !document.querySelector('video').seeking);
}

async function showBreak(page) {
    await scheme(page, 'light');
    await page.waitForFunction(() => window.studio.view.context.meshNode('cue'));
    await keep(page, 'break');
    await select(page, ['cameras', '0']);
    await scheme(page, 'dark');
    await keep(page, 'camera');
    await toView(page);
    await select(page, null);
    await page.evaluate(() => { location.hash = '#t=3.5'; });
    await page.waitForFunction(() => window.studio.state.filmTime.value === 3.5);
    await page.keyboard.press('c');
    await page.keyboard.press('r');
    await traced(page);
    await keep(page, 'picture');
    await page.keyboard.press('r');
    await film(page, 'draft');
    await page.waitForFunction(() => window.studio.films.thumbnails.value.size > 90, null,
        { timeout: 300000 });
    await keep(page, 'film');
    await page.getByRole('button', { name: 'Stop' }).click();
    await page.waitForFunction(() => window.studio.films.film.value?.state === 'stopped');
    await page.keyboard.press('Escape');
    await scheme(page, 'light');
    await page.getByRole('button', { name: 'Plan, report and contact sheet' }).click();
    await page.waitForFunction(() => document.querySelector('img.plan')?.naturalWidth > 0);
    await keep(page, 'plan');
    await page.getByRole('tab', { name: 'Export' }).click();
    await keep(page, 'export');
    await page.keyboard.press('Escape');
    await command(page, 'Show this page of keys');
    await keep(page, 'keys');
}

async function walk(page) {
    await scheme(page, 'light');
    await page.waitForFunction(() => [...document.querySelectorAll('.card img')]
        .slice(0, 10).every((image) => image.complete && image.naturalWidth > 0));
    await page.locator('.card[data-name=empty]').click();
    await page.fill('input[name=name]', 'my_bank_shot');
    await keep(page, 'walk_1_start');

    await page.getByRole('button', { name: 'Create' }).click();
    await page.waitForFunction(() => window.studio.state.problems.value?.complete
        && window.studio.view?.context.meshNode('cue'));
    await settle(page);
    await toView(page);
    await page.keyboard.press('1');
    await dragPixels(page, await pixelOf(page, await placeOf(page, 'cue')),
        await pixelOf(page, [0.55, -0.35, kRadius]), 12);
    await keep(page, 'walk_2_cue_ball');

    await command(page, 'Add ball');
    await settle(page);
    const added = await page.evaluate(() => window.studio.state.selection.value.at(-1));
    await dragPixels(page, await pixelOf(page, await placeOf(page, added)),
        await pixelOf(page, [0.3, 0.1, kRadius]), 12);
    await keep(page, 'walk_3_object_ball');

    const [x, y] = await pixelOf(page, await placeOf(page, added));
    await page.mouse.click(x, y, { button: 'right' });
    await keep(page, 'walk_4_menu');
    await page.getByRole('menuitem', { name: `Strike cue at ${added}` }).click();
    await settle(page);
    await toView(page);
    await page.waitForFunction(() =>
        window.studio.gizmos.handles().some(({ kind }) => kind === 'aim'));
    const aim = await page.evaluate(() =>
        window.studio.gizmos.handles().find(({ kind }) => kind === 'aim').at);
    const cue = await placeOf(page, 'cue');
    const length = Math.hypot(aim[0] - cue[0], aim[1] - cue[1]);
    const turned = (degrees) => [cue[0] + length * Math.cos(degrees / 57.29578),
        cue[1] + length * Math.sin(degrees / 57.29578), aim[2]];
    await dragPixels(page, await pixelOf(page, aim), await pixelOf(page, turned(116.9)), 16);
    await keep(page, 'walk_5_aim');
    await page.keyboard.press('v');
    await page.waitForFunction(() => window.studio.state.fan.value?.head.finished === 8);
    await keep(page, 'walk_6_sure');
    await page.keyboard.press('v');
    equal(await page.evaluate(() => window.studio.state.timeline.value.head.events
        .filter(({ kind }) => kind === 'potted').map(({ a, b }) => [a, b])),
        [[added, 'corner_left_front']], 'potted balls');

    // The camera goes to the far corner, and looks along the table.
    await select(page, ['cameras', '0']);
    const handle = (key) => page.evaluate((name) => {
        const { cameraHandles, view } = window.studio;
        const box = view.context.canvas.getBoundingClientRect();
        const found = cameraHandles.value.find(({ path }) => path.at(-1) === name);
        const place = found && view.context.toScreen(found.at);
        return place && [place[0] + box.left, place[1] + box.top];
    }, key);
    await dragPixels(page, await handle('target'), await pixelOf(page, [-0.2, 0, 0]), 12);
    const field = (name) => page.locator('.inspector').getByLabel(name, { exact: true }).last();
    for (const [name, value] of [['fov', '42 deg'], ['focus', added]]) {
        await field(name).fill(value);
        await field(name).press('Enter');
        await settle(page);
    }
    await toView(page);
    await keep(page, 'walk_7_camera');

    await select(page, null);
    for (let i = 0; i < 3; ++i) {
        await page.keyboard.press('Shift+ArrowRight');
    }
    await page.keyboard.press('c');
    await page.keyboard.press('r');
    await traced(page);
    await keep(page, 'walk_8_picture');
    await page.keyboard.press('r');

    await film(page, 'draft');
    await filmDone(page, 30);
    await keep(page, 'walk_9_film');
}

const folder = copyShots();
const browser = await launch();

async function withShot(shot, act) {
    const served = await serve(carom, shot ? join(folder, 'examples', shot) : '', folder);
    const { page, complaints } = await open(browser, served.address, kSize);
    page.setDefaultTimeout(20000);
    try {
        await act(page);
        equal(complaints, [], 'what the console says');
    } finally {
        await page.close();
        await served.end();
    }
}

try {
    if (only !== 'walk') {
        await withShot('nine_ball_break.yaml', showBreak);
    }
    if (only !== 'break') {
        await withShot('', walk);
    }
} finally {
    await browser.close();
    remove(folder);
}
