// A shot of somebody else that is far too large: a thousand seconds in which nothing comes to rest, a
// mesh that is too large to read, a picture of 16384 x 16384. The page answers, says what is wrong, and goes on.
import { readFileSync, truncateSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { kPatience, equal, openText, settle, textOf } from './harness.mjs';

const kText = `carom: 1
simulation: {duration: 1000 s}
table: {kind: cloth}
balls:
  cue: {at: [0, 0]}
objects:
${Array.from({ length: 90 }, (_, i) => `  box_${i}: {box: [0.1, 0.1, 0.1], physics: {density: 500 kg/m^3}, `
    + `at: [${(i % 3) * 0.102}, ${(Math.floor(i / 3) % 3) * 0.102}, ${0.3 + Math.floor(i / 9) * 0.12}]}`)
    .join('\n')}
events:
${Array.from({ length: 18 }, (_, i) =>
        `  - torque: {object: box_${5 * i}, at: 0 s, for: 1000 s, newton_metres: [0, 0, 0.5]}`).join('\n')}
lights:
  lamp: {rectangle: [1, 0.4], at: [0, 0, 3], facing: [0, 0, -1], radiance: [10, 10, 10]}
cameras:
  - {name: seat, video: [0 s, 1 s], scene: [0 s, 1 s], position: [0, -3, 2], target: [0, 0, 0], fov: 40 deg}
render: {size: [16384, 16384], fps: 24, samples: 4096}
`;

export const shot = 'bank_shot.yaml';

export const ownPage = true; // it opens one itself

export async function check(context) {
    const { folder } = context;
    const mesh = join(folder, 'examples', 'huge.obj');
    writeFileSync(mesh, 'v 0 0 0\n');
    truncateSync(mesh, 8 * 2 ** 30);  // a file with a hole
    const { page, complaints, end } = await openText(context, 'hostile.yaml', kText);

    // The simulation is left for a button, and the shot is shown as it stands at the start.
    await page.getByRole('button', { name: 'Simulate' }).waitFor({ timeout: kPatience });
    equal(await page.evaluate(() => window.studio.state.shot.value.objects.length > 90), true,
        'whether all boxes are shown');

    // The boxes are drawn with one call, and each is found by the pointer and outlined all the same.
    await page.waitForFunction(() => window.studio.view.context.meshNode('box_81'));
    const [calls, name] = await page.evaluate(() => {
        const { context, drawing, camera, canvas } = window.studio.view;
        drawing.renderer.render(drawing.scene, camera);
        const box = canvas.getBoundingClientRect();
        const [x, y] = context.toScreen(window.studio.state.shot.value.objects
            .find((one) => one.name === 'box_81').position);
        return [drawing.renderer.info.render.calls,
            context.objectAt({ clientX: x + box.left, clientY: y + box.top })?.name];
    });
    equal([calls < 40, name], [true, 'box_81'], `${calls} draw calls; what is at a box`);

    // A picture has to wait, and says for what.
    await page.locator('canvas[aria-label="The scene"]').focus();
    await page.keyboard.press('c');
    await page.keyboard.press('r');
    await page.getByRole('status').filter({ hasText: 'The motion has not been simulated yet.' })
        .waitFor();
    await settle(page); // nothing is asked for that cannot come
    await page.locator('canvas[aria-label="The scene"]').focus();
    await page.keyboard.press('r');

    const replace = async (from, to) => {
        await page.evaluate(([a, b]) => {
            const text = window.studio.edit.text();
            const at = text.indexOf(a);
            window.studio.edit.type(at, at + a.length, b);
        }, [from, to]);
        await settle(page);
    };
    // A mesh that is too large is a problem at its place.
    await replace('box_0: {box: [0.1, 0.1, 0.1]', 'box_0: {mesh: huge.obj');
    const [problem] = await page.evaluate(() => window.studio.state.problems.value.list);
    equal(/'huge.obj' has more than 128 MiB/.test(problem?.message), true, problem?.message);
    await replace('box_0: {mesh: huge.obj', 'box_0: {box: [0.1, 0.1, 0.1]');

    // A shot of a usual size moves again.
    await replace('duration: 1000 s', 'duration: 0.2 s');
    await page.waitForFunction(() => window.studio.state.timeline.value?.head.end === 0.2, null,
        { timeout: kPatience });

    // The picture of its 268 million pixels begins small.
    await page.locator('canvas[aria-label="The scene"]').focus();
    await page.evaluate(() => window.studio.state.picture.subscribe((picture) => {
        window.firstHead ??= picture?.head;
    }));
    await page.keyboard.press('r');
    await page.waitForFunction(() => window.firstHead, null, { timeout: kPatience });
    const { width, height } = await page.evaluate(() => window.firstHead);
    equal(width * height <= 360_000, true, `the size of the first picture (${width}x${height})`);
    await page.keyboard.press('r');
    equal(await textOf(page), kText.replace('1000 s', '0.2 s'), 'the text');
    equal(readFileSync(join(folder, 'examples', 'hostile.yaml'), 'utf8'), kText, 'the file');
    equal(complaints, [], 'what the console says');
    await end();
    return `1000 s and their picture wait for a button, the mesh is refused, the next text moves, and the picture begins with `
        + `${width}x${height}`;
}
