// The inspector: a default is dragged by its name, a typed text stays while the page is drawn again,
// held keys and a colour are one undo each, and Escape ends a drag before it selects nothing.
import { changedLines, dragPixels, equal, pressAtOnce, settle, textOf, undo } from './harness.mjs';

const choose = (page, path) =>
    page.evaluate((one) => { window.studio.state.selection.value = one; }, path);
const state = (page, name) => page.evaluate((one) => window.studio.state[one].value, name);

/// The name of a key, pressed and moved by some pixels.
async function pressName(page, name, pixels) {
    const button = page.locator('.inspector .name', { hasText: new RegExp(`^${name}$`) });
    await button.scrollIntoViewIfNeeded();
    const box = await button.boundingBox();
    const [x, y] = [box.x + 10, box.y + box.height / 2];
    await page.mouse.move(x, y);
    await page.mouse.down();
    for (let i = 1; i <= 4; ++i) {
        await page.mouse.move(x + (pixels * i) / 4, y);
        await settle(page);
    }
}

async function dragDefault(page, before) {
    await choose(page, ['cameras', '0']);
    await pressName(page, 'roll', 30);
    const during = await textOf(page);
    equal(/roll: /.test(during), true, 'a default that is dragged stands in the text');
    equal(await state(page, 'dragging'), true, 'a drag in progress');
    await page.keyboard.press('Escape');
    equal(await state(page, 'dragging'), false, 'a drag after Escape');
    equal(await textOf(page), before, 'the text after Escape');
    equal(await state(page, 'selection'), ['cameras', '0'], 'the selection after a cancelled drag');
    await page.mouse.up();
    equal(await textOf(page), before, 'the text after the release');
    await pressName(page, 'roll', 30);
    await page.mouse.up();
    equal(await state(page, 'dragging'), false, 'a drag after the release');
    await settle(page);
    equal(/roll: /.test(await textOf(page)), true, 'the key after the drag');
    await undo(page, before, 'the drag of a default');
}

async function typeSlowly(page, before) {
    await choose(page, ['cameras', '0']);
    const name = page.locator('.inspector').getByLabel('name', { exact: true });
    await name.fill('Break #1');
    // A message of the server draws the page again.
    await page.evaluate(async () => {
        const { state } = window.studio;
        state.shot.value = { ...state.shot.value };
        await new Promise((done) => { requestAnimationFrame(() => requestAnimationFrame(done)); });
    });
    equal(await name.inputValue(), 'Break #1', 'the typed text after a message');
    await name.press('Enter');
    await settle(page);
    const [changed, ...more] = changedLines(before, await textOf(page));
    equal([changed.split('  #')[0].trim(), more.length], ['- name: "Break #1"', 0], 'the changed lines');
    equal(await page.evaluate(() => window.studio.state.shot.value.cameras[0].name), 'Break #1',
        'the name of the camera');
    await undo(page, before, 'a name');
}

async function holdKeys(page, before) {
    await choose(page, ['events', '0']);
    const speed = page.locator('.inspector').getByLabel('speed', { exact: true });
    await speed.focus();
    await pressAtOnce(page, Array(5).fill('ArrowUp'));
    equal(/speed: 8\.5 m\/s/.test(await textOf(page)), true, 'the speed after five presses');
    equal(await speed.evaluate((one) => one === document.activeElement), true, 'the focus');
    await page.locator('.inspector').getByLabel('Where the tip hits the ball').focus();
    await pressAtOnce(page, Array(3).fill('ArrowLeft'));
    equal(/tip: \[-0\.03, 0\.2\]/.test(await textOf(page)), true, 'the tip after three presses');
    await page.getByRole('slider', { name: 'Play head' }).focus();
    await page.keyboard.press('Control+z');
    await undo(page, before, 'two runs of keys');
}

/// The picker as the browser has it: many inputs, one change.
async function pickColour(page, before) {
    await page.evaluate(() => window.studio.edit.insertEntry(['materials'], 'cherry',
        '{standard: {base: "#808080"}}', 'Add'));
    await settle(page);
    const added = await textOf(page);
    await choose(page, ['materials', 'cherry']);
    const picker = page.locator('.inspector').getByLabel('base, picker');
    await picker.evaluate(async (input) => {
        for (const colour of ['#112233', '#445566', '#c8323f']) {
            input.value = colour;
            input.dispatchEvent(new Event('input', { bubbles: true }));
            await window.studio.idle();
        }
        input.dispatchEvent(new Event('change', { bubbles: true }));
    });
    equal(await state(page, 'dragging'), false, 'a drag after the picker');
    equal(/base: "#c8323f"/.test(await textOf(page)), true, 'the colour in the text');
    await undo(page, added, 'a colour');
    await undo(page, before, 'the material');
}

/// A width that was chosen comes back, also if the area was folded by a drag.
async function foldOutline(page) {
    const line = page.getByRole('separator', { name: 'Width of the outline' });
    const width = () => line.getAttribute('aria-valuenow').then(Number);
    await line.press('ArrowRight');
    const chosen = await width();
    await line.dblclick();
    equal(await width(), 0, 'the width after a double click');
    await page.getByRole('button', { name: 'Outline', exact: true }).click();
    equal(await width(), chosen, 'the width after it was unfolded');
    await page.waitForFunction((size) => document.querySelector('nav.side').offsetWidth === size, chosen);
    const box = await line.boundingBox();
    await dragPixels(page, [box.x + box.width / 2, 400], [20, 400]);
    equal(await width(), 0, 'the width after a drag to the border');
    await line.dblclick();
    equal(await width(), chosen, 'the width after that');
}

export async function check({ page }) {
    const before = await textOf(page);
    await dragDefault(page, before);
    await typeSlowly(page, before);
    await holdKeys(page, before);
    await pickColour(page, before);

    await choose(page, ['cameras', '0']);
    await page.locator('.inspector .row[data-key=fov] .name').hover();
    const about = page.locator('.inspector .about');
    equal(/Unit deg/.test(await about.textContent()), true, 'what the list says of fov');
    const id = await page.locator('.inspector').getByLabel('fov 1', { exact: true }).first()
        .getAttribute('aria-describedby');
    equal(await page.locator(`#${id}`).textContent() === '', false, 'the same for screen readers');

    await foldOutline(page);
    await page.getByRole('slider', { name: 'Play head' }).focus();
    await page.keyboard.press('Escape');
    equal(await state(page, 'selection'), null, 'the selection after Escape');
    return 'a default dragged, a text kept, held keys and a colour one undo each, keys described';
}
