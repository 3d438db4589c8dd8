// The menu of a place: for the pointer and the keyboard, with what a camera can do with an object.
import { dragPixels, equal, settle, textOf } from './harness.mjs';

const kScene = 'canvas[aria-label="The scene"]';

/// Where a ball is on the page.
function placeOf(page, name) {
    return page.evaluate((ball) => {
        const { context } = window.studio.view;
        const box = context.canvas.getBoundingClientRect();
        const object = window.studio.state.shot.value.objects.find((one) => one.name === ball);
        const [x, y] = context.toScreen(object.position);
        return [box.left + x, box.top + y];
    }, name);
}

function changedLines(before, after) {
    const old = before.split('\n');
    return after.split('\n').filter((line, i) => line !== old[i]);
}

/// Selects a point of a path that belongs to a ball, and returns where it is on the page.
function pointOfBall(page) {
    return page.evaluate(() => {
        const { cameras } = window.studio.state.shot.value;
        const camera = cameras.find(({ position }) => position.points.some(({ of }) => of !== ''));
        const point = camera.position.points.find(({ of }) => of !== '');
        window.studio.state.selection.value = point.path;
        const { context } = window.studio.view;
        const box = context.canvas.getBoundingClientRect();
        const [x, y] = context.toScreen(point.position);
        return [box.left + x, box.top + y];
    });
}

/// A point of a path that belongs to a ball becomes a place: by the menu, or by a drag with Alt.
async function freePoint(page, how) {
    const [x, y] = await pointOfBall(page);
    if (how === 'menu') {
        await page.mouse.click(x, y, { button: 'right' });
        await page.getByRole('menuitem', { name: 'Free this point' }).click();
    } else {
        await page.keyboard.down('Alt');
        await dragPixels(page, [x, y], [x + 20, y + 10]);
        await page.keyboard.up('Alt');
    }
    await settle(page);
    const text = await textOf(page);
    equal(text.includes('{of: cue, at: 0.3 s'), false, 'the point of the ball');
    equal(await page.evaluate(() => window.studio.state.hasErrors.value), false, 'errors');
}

export async function check({ page }) {
    await page.waitForFunction(() => window.studio.view.context.meshNode('cue'));
    const before = await textOf(page);
    await page.locator(kScene).focus();
    await page.keyboard.press('1');
    // From above the lamp is not shown, so that a click does not meet it.
    await page.waitForFunction(() => !window.studio.view.context.meshNode('lamp_1/shade').visible);
    const open = async () => {
        await page.mouse.click(...await placeOf(page, 'nine'), { button: 'right' });
        await page.getByRole('menu').waitFor();
    };
    const undo = async () => {
        await page.locator(kScene).focus();
        await page.keyboard.press('Control+z');
        await settle(page);
        equal(await textOf(page), before, 'the text after one undo');
    };
    await open();
    const labels = await page.getByRole('menuitem').allInnerTexts();
    await page.keyboard.press('Escape');
    equal(await page.getByRole('menu').count(), 0, 'menus after Escape');
    equal(await page.evaluate(() => window.studio.state.selection.value), ['balls', 'nine'],
        'the selection');

    await open();
    await page.getByRole('menuitem', { name: 'Track nine with “break”' }).click();
    await settle(page);
    equal(changedLines(before, await textOf(page)), ['    target: {follow: nine}'], 'looking at it');
    const kind = await page.evaluate(() => window.studio.state.shot.value.cameras[0].target.kind);
    equal(kind, 'follow', 'the kind of the path');
    await undo();

    await open();
    await page.getByRole('menuitem', { name: 'Focus “break” on nine' }).click();
    await settle(page);
    equal(changedLines(before, await textOf(page)),
        ['    focus: {from: nine, to: auto, easing: smooth}'], 'the focus');
    await undo();

    await page.evaluate(() => { window.studio.state.selection.value = ['balls', 'cue']; });
    await page.keyboard.press('Shift+F10');
    await page.getByRole('menu').waitFor();
    await page.keyboard.press('s');
    await page.keyboard.press('Enter');
    const cursor = await page.evaluate(() => {
        const { state } = window.studio.editor.view;
        return state.doc.lineAt(state.selection.main.head).text;
    });
    equal(cursor, '  cue: {at: [-0.75, 0.12]}', 'the line that is shown');

    await page.mouse.click(...await placeOf(page, 'one'), { button: 'right' });
    await page.getByRole('menuitem', { name: 'Add a point of “break” here' }).click();
    await settle(page);
    const points = await page.evaluate(() =>
        window.studio.state.shot.value.cameras[0].position.points.length);
    equal(points, 4, 'points of the path');
    await undo();
    await freePoint(page, 'menu');
    await undo();
    await freePoint(page, 'drag');
    await undo();
    return labels.map((label) => label.split('\n')[0]).join(', ');
}
