// Each corner of a triangle, a parallelogram and a hull follows the pointer to a pixel, and the text
// changes in exactly that corner; boxes, spheres and cylinders are moved, turned and measured.
import { changedLines, dragPixels, equal, openText, pixelOf, settle, textOf } from './harness.mjs';

const kMoves = 3; // of a drag: each makes other meshes
const kShot = `carom: 1  # shapes
table: {kind: pool}
simulation: {duration: 1 s}
balls: {cue: {at: [-0.9, -0.4]}}
objects:
  sail: {triangle: [[0 mm, 0, 0], [300 mm, 0, 0], [0.1, 0.05, 0.25]], at: [-0.6, 0.1, 0.1]}  # a sail
  ramp:
    parallelogram:
      - [0, 0, 0]  # the corner
      - [0.3, 0, 0.1]
      - [0, 0.2, 0.05]
    at: [0.1, 0.2, 0.1]
    rotate: [0, 0, 30 deg]
    scale: 1.5
  rock: {hull: [[0, 0, 0], [0.1, 0, 0], [0, 0.1, 0], [0, 0, 0.1]], at: [0.5, -0.3, 0.05]}
  block: {box: [40 mm, 120 mm, 40 mm], at: [-0.2, -0.3, 0.02], rotate: [0, 0, 30 deg]}  # a block
  post: {cylinder: {radius: 28 mm, height: 80 mm}, at: [0.1, -0.3, 0.04]}
  ring: {sphere: 30 mm, at: [0.8, -0.2, 0.03], rotate: {axis: [0, 0, 1], angle: 10 deg}}
`;

function handlesOf(page, path) {
    return page.evaluate((chosen) => {
        window.studio.state.selection.value = chosen;
        return window.studio.gizmos.objectHandles();
    }, path);
}

async function corners(page, name, shape) {
    let count = 0;
    const all = await handlesOf(page, ['objects', name]);
    for (const { index } of all.filter(({ kind }) => kind === 'vertex')) {
        const before = await textOf(page);
        const vertex = (await handlesOf(page, ['objects', name])).find((one) => one.index === index);
        const from = await pixelOf(page, vertex.at);
        const to = [from[0] + 37, from[1] - 23];
        await dragPixels(page, from, to, kMoves);
        const after = await textOf(page);
        const lines = changedLines(before, after);
        equal(lines.length, 1, `lines changed by corner ${index} of ${name}: ${lines.join(' | ')}`);
        const now = (await handlesOf(page, ['objects', name])).find((one) => one.index === index);
        const at = await pixelOf(page, now.at);
        const off = Math.hypot(at[0] - to[0], at[1] - to[1]);
        equal(off < 1, true, `corner ${index} of ${name} is ${off} px beside the pointer`);
        const values = await page.evaluate(([path, b]) => {
            const { sourceOf } = window.studio.edit;
            return b.map((_, i) => sourceOf([...path, String(i)])?.text);
        }, [['objects', name, shape], all.filter(({ kind }) => kind === 'vertex')]);
        await page.keyboard.press('Control+z');
        await settle(page);
        const old = await page.evaluate(([path, b]) => {
            const { sourceOf } = window.studio.edit;
            return b.map((_, i) => sourceOf([...path, String(i)])?.text);
        }, [['objects', name, shape], values]);
        equal(values.map((value, i) => value === old[i]), values.map((_, i) => i !== index),
            `the corners of ${name} that kept their text`);
        equal(await textOf(page), before, 'the text after undo');
        count += 1;
    }
    return count;
}

/// Drags the handle that `choose` picks by some pixels; returns the only line that changed.
async function drag(page, name, choose, by, key) {
    const before = await textOf(page);
    const handle = (await handlesOf(page, ['objects', name])).find(choose);
    const from = await pixelOf(page, handle.at);
    if (key) {
        await page.keyboard.down(key);
    }
    await dragPixels(page, from, [from[0] + by[0], from[1] + by[1]], kMoves);
    if (key) {
        await page.keyboard.up(key);
    }
    const lines = changedLines(before, await textOf(page));
    equal(lines.length, 1, `lines changed: ${lines.join(' | ')}`);
    await page.keyboard.press('Control+z');
    await settle(page);
    return lines[0];
}

export const ownPage = true; // it opens one itself

export async function check(context) {
    const { page, complaints, end } = await openText(context, 'shapes.yaml', kShot);
    await page.waitForFunction(() => window.studio.view.context.meshNode('block'));
    await page.locator('canvas[aria-label="The scene"]').focus();
    const shoot = async (name) => process.env.CAROM_STUDIO_SHOTS
        && page.screenshot({ path: `${process.env.CAROM_STUDIO_SHOTS}/22_${name}.png` });

    let count = await corners(page, 'sail', 'triangle');
    await shoot('sail');
    count += await corners(page, 'ramp', 'parallelogram');
    count += await corners(page, 'rock', 'hull');
    equal(count, 10, 'corners');

    // Arms: only that coordinate changes.
    const moved = await drag(page, 'block', ({ kind, axis }) => kind === 'axis' && axis === 0, [40, 0]);
    // From above, the arrow that points at the viewer would hide the object.
    await page.keyboard.press('1');
    await page.waitForFunction(() => window.studio.view.camera.isOrthographicCamera);
    equal((await handlesOf(page, ['objects', 'block'])).filter(({ kind }) => kind === 'axis')
        .map(({ axis }) => axis), [0, 1], 'arrows of the view from above');
    await page.keyboard.press('3');
    await page.waitForFunction(() => window.studio.view.camera.isPerspectiveCamera);
    equal(/^ {2}block: \{box: \[40 mm, 120 mm, 40 mm\], at: \[-?0\.\d+, -0\.3, 0\.02\], rotate: \[0, 0, 30 deg\]\} {2}# a block$/
        .test(moved), true, moved);
    // The body itself: in the view's plane; with y held along y.
    const block = (await handlesOf(page, ['objects', 'block'])).length > 0
        && await page.evaluate(() => window.studio.state.shot.value.objects
            .find(({ name }) => name === 'block').position);
    const body = await pixelOf(page, block);
    const before = await textOf(page);
    await page.keyboard.down('y');
    await dragPixels(page, [body[0] + 6, body[1] + 2], [body[0] + 36, body[1] - 18]);
    await page.keyboard.up('y');
    const [along] = changedLines(before, await textOf(page));
    equal(/at: \[-0\.2, -0\.\d+, 0\.02\]/.test(along), true, along);
    await page.keyboard.press('Control+z');
    await settle(page);
    // A little upwards: it stays on the cloth, but not with Ctrl.
    for (const [key, height] of [['Alt', '0\\.02'], ['Control', '0\\.0[23]\\d+']]) {
        await page.keyboard.down(key);
        await dragPixels(page, [body[0] + 6, body[1] + 2], [body[0] + 30, body[1] - 1]);
        await page.keyboard.up(key);
        const [line] = changedLines(before, await textOf(page));
        equal(new RegExp(`at: \\[-0\\.\\d+, -0\\.\\d+, ${height}\\]`).test(line), true, `${key}: ${line}`);
        await page.keyboard.press('Control+z');
        await settle(page);
    }

    await page.keyboard.press('s');
    equal((await handlesOf(page, ['objects', 'block'])).map(({ measure }) => measure.key.join('.')),
        ['box.0', 'box.1', 'box.2'], 'handles of the box');
    await shoot('measures');
    const longer = await drag(page, 'block', ({ measure }) => measure?.key[1] === '1', [-30, -25]);
    equal(/box: \[40 mm, (?!120 )\d+(\.\d+)? mm, 40 mm\], at: \[-0\.2, -0\.3, 0\.02\]/.test(longer), true, longer);
    const wider = await drag(page, 'post', ({ measure }) => measure?.key[1] === 'radius', [20, 0]);
    equal(/cylinder: \{radius: (?!28 )\d+(\.\d+)? mm, height: 80 mm\}/.test(wider), true, wider);
    const larger = await drag(page, 'ring', ({ measure }) => measure?.key[0] === 'sphere', [20, 0]);
    equal(/sphere: (?!30 )\d+(\.\d+)? mm/.test(larger), true, larger);

    // Rings: about the vertical, in the way in which the text has the rotation.
    await page.keyboard.press('e');
    for (const [name, pattern] of [
        ['block', /rotate: \[0, 0, (?!30 )-?\d+(\.\d+)? deg\]/],
        ['ring', /rotate: \{axis: \[0, 0, 1\], angle: (?!10 )-?\d+(\.\d+)? deg\}/],
        ['post', /rotate: \[0, 0, -?\d+(\.\d+)? deg\]/],
    ]) {
        const old = await textOf(page);
        await page.evaluate((path) => { window.studio.state.selection.value = path; }, ['objects', name]);
        await shoot(`turn_${name}`);
        const ring = await page.evaluate(() => window.studio.gizmos.ring(2));
        await dragPixels(page, await pixelOf(page, ring[2]), await pixelOf(page, ring[12]));
        const lines = changedLines(old, await textOf(page));
        equal(lines.length === 1 && pattern.test(lines[0]), true, lines.join(' | '));
        await page.keyboard.press('Control+z');
        await settle(page);
    }
    equal(await textOf(page), kShot, 'the text after all undos');
    equal(complaints, [], 'the console');
    await end();
    return `${count} corners under the pointer; arms, bodies, 3 measures and 3 rings change one value`;
}
