// Paths fade after two contacts during a drag; pins lead to their events; paths are pinned to compare
// with; eight slightly different runs show how sure a shot is.
import { equal, openText, pixelOf, settle } from './harness.mjs';

const kShot = `carom: 1
table: {kind: pool}
simulation: {duration: 5 s}
balls:
  cue: {at: [0.75, 0.25]}
  eight: {at: [1.05, 0.47]}
  nine: {at: [-0.4, 0.1]}
events:
  - strike: {ball: cue, at: 0.5 s, toward: eight, speed: 2.5 m/s}
`;

function now(page) {
    return page.evaluate(() => {
        const { trails, pins, fanPieces, figure } = window.studio.gizmos;
        return {
            ...trails(), pins: pins(), fan: fanPieces(), balls: figure('pinned').balls.length,
            scene: window.studio.state.sceneTime.value,
            labels: [...document.querySelectorAll('.gizmo-labels span')].map((one) => one.textContent),
        };
    });
}

export const ownPage = true; // it opens one itself

export async function check(context) {
    const { page, complaints, end } = await openText(context, 'trails.yaml', kShot);
    await page.waitForFunction(() => window.studio.view.context.meshNode('cue'));
    const shoot = async (name) => process.env.CAROM_STUDIO_SHOTS
        && page.screenshot({ path: `${process.env.CAROM_STUDIO_SHOTS}/25_${name}.png` });
    await page.locator('canvas[aria-label="The scene"]').focus();

    const before = await now(page);
    equal(before.pins.map(({ event }) => event.kind), ['impact', 'potted'], 'pins');
    equal([before.opacities.length, before.isGrey, before.dots > 3], [1, false, true], 'the paths');

    // A click on the potted event's pin: the ball is over its pocket.
    const [, potted] = before.pins;
    const pixel = await pixelOf(page, potted.at);
    await page.mouse.move(...pixel);
    await page.waitForFunction(() => document.querySelector('.gizmo-labels span'));
    await shoot('pin');
    equal((await now(page)).labels[0].includes('eight'), true, 'the text at the pin');
    await page.mouse.down();
    await page.mouse.up();
    const after = await now(page);
    equal(after.scene, potted.event.time, 'the scene time');
    const over = await page.evaluate(() => {
        const { state, view } = window.studio;
        const node = view.context.meshNode('eight');
        const [x, y] = [node.position.x, -node.position.z];
        return state.shot.value.pockets.filter(({ place, radius }) =>
            Math.hypot(place[0] - x, place[1] - y) < radius).map(({ name }) => name);
    });
    equal(over, [potted.event.b], 'the pockets under the ball');

    // Pinned paths stay where they were.
    await page.keyboard.press('p');
    equal((await now(page)).pinnedPieces, before.pieces, 'pinned pieces');
    const cue = await page.evaluate(() =>
        window.studio.state.shot.value.objects.find(({ name }) => name === 'cue').position);
    await page.evaluate(() => { window.studio.state.sceneTime.value = 0; });
    const from = await pixelOf(page, cue);
    await page.mouse.move(...from);
    await page.mouse.down();
    for (let i = 1; i <= 6; ++i) {
        await page.mouse.move(from[0] - 8 * i, from[1] + 3 * i);
    }
    await settle(page);
    const during = await now(page);
    equal(during.opacities.map((one) => one.toFixed(1)).sort(), ['0.2', '1.0'], 'opacities');
    await shoot('drag');
    await page.mouse.up();
    await settle(page);
    const moved = await now(page);
    equal([moved.opacities.length, moved.pinnedPieces, moved.balls], [1, before.pieces, 1],
        'after the drag');
    await page.keyboard.press('p');
    equal((await now(page)).pinnedPieces, 0, 'pinned pieces after the second press');
    await page.keyboard.press('Control+z');
    await settle(page);

    await page.keyboard.press('v');
    await page.waitForFunction(() => window.studio.state.fan.value?.head.finished === 8);
    const sure = await now(page);
    equal(sure.fan > 8, true, `${sure.fan} pieces of the fan`);
    const said = sure.labels.find((text) => / is potted in \d of 8$/.test(text));
    equal(said !== undefined, true, sure.labels.join(' | '));
    await shoot('fan');
    // What stands still is not drawn anew while time passes. What the strike pots, which is asked once
    // the shot rests, is drawn when its answer comes: that is awaited first.
    await page.waitForFunction(() => {
        const { judged, timeline } = window.studio.state;
        return judged.value?.v === timeline.value.head.v;
    });
    const drawn = await page.evaluate(async () => {
        const { state, gizmos } = window.studio;
        const still = gizmos.draws('still');
        for (const time of [0.3, 0.4, 0.5]) {
            state.filmTime.value = time;
            state.sceneTime.value = time;
            await new Promise((done) => requestAnimationFrame(done));
        }
        return gizmos.draws('still') - still;
    });
    equal(drawn, 0, 'drawings of what stands still');
    const calls = await page.evaluate(() => window.studio.view.drawing.renderer.info.render);
    equal(calls.calls <= 150 && calls.triangles <= 60000, true, JSON.stringify(calls));
    await page.keyboard.press('v');
    equal((await now(page)).fan, 0, 'the fan after the second press');
    equal(complaints, [], 'the console');
    await end();
    return `${before.pieces} pieces, ${before.dots} dots; ${potted.event.b}; ${said}; ${calls.calls} draw calls`;
}
