// A ball that is dragged snaps to others, cushions and marks; overlaps are shown; arrows nudge it.
import { changedLines, dragPixels, equal, openText, pixelOf, pressAtOnce, settle, textOf } from './harness.mjs';

const kShot = `carom: 1  # places
table: {kind: pool}
simulation: {duration: 4 s}
balls:
  cue: {at: [-0.3, -0.2]}  # the cue ball
  eight: {at: [0.4, 0.25]}
  nine: {touching: {ball: eight, direction: 30 deg}}
events:
  - strike: {ball: cue, at: 0.5 s, toward: eight, speed: 3 m/s}
`;
const kRadius = 0.028575;

function balls(page) {
    return page.evaluate(() => Object.fromEntries(window.studio.state.shot.value.objects
        .filter(({ kind }) => kind === 'ball').map(({ name, position }) => [name, position])));
}

/// Drags the cue ball from where it is to a place on its level.
async function dragCue(page, to, key) {
    const { cue } = await balls(page);
    const [from, goal] = [await pixelOf(page, cue), await pixelOf(page, [...to, kRadius])];
    if (key) {
        await page.keyboard.down(key);
    }
    await dragPixels(page, from, goal);
    if (key) {
        await page.keyboard.up(key);
    }
}

export const ownPage = true; // it opens one itself

export const isExtra = true; // only in scripts/test --all, or by name

export async function check(context) {
    const { page, complaints, end } = await openText(context, 'places.yaml', kShot);
    await page.waitForFunction(() => window.studio.view.context.meshNode('cue'));
    await page.keyboard.press('1');

    // Near the eight ball: it touches that ball.
    await dragCue(page, [0.4 - 0.0595, 0.25]);
    const touching = await balls(page);
    const gap = Math.hypot(touching.cue[0] - 0.4, touching.cue[1] - 0.25) - 2 * kRadius;
    equal(gap >= 0 && gap < 3e-6, true, `a gap of ${gap} m`);
    const lines = changedLines(kShot, await textOf(page));
    equal(lines.length, 1, 'changed lines');
    equal(lines[0].endsWith('  # the cue ball'), true, lines[0]);
    // Ctrl ignores it: the balls overlap, which is shown, and the old paths stay.
    const before = await page.evaluate(() => window.studio.state.timeline.value.head.v);
    await dragCue(page, [0.36, 0.25], 'Control');
    const shown = await page.evaluate(() => ({
        stale: window.studio.state.isStale.value, v: window.studio.state.timeline.value.head.v,
        label: document.querySelector('.gizmo-labels .wrong')?.textContent,
    }));
    equal([shown.stale, shown.v], [true, before], 'whether the motion is that of the last valid text');
    equal(/overlap by/.test(shown.label), true, shown.label);
    if (process.env.CAROM_STUDIO_SHOTS) {
        await page.screenshot({ path: `${process.env.CAROM_STUDIO_SHOTS}/23_overlap.png` });
    }
    await page.keyboard.press('Control+z');
    await settle(page);
    // A cushion, then the foot spot.
    await dragCue(page, [-0.5, 0.635 - kRadius - 0.004]);
    equal((await balls(page)).cue[1].toFixed(6), (0.635 - kRadius).toFixed(6), 'y at the cushion');
    await dragCue(page, [-0.632, 0.003]);
    equal((await balls(page)).cue.slice(0, 2), [-0.635, 0], 'the head spot');
    // A ball that is placed against another one stays there; with Alt it gets a place.
    const { nine } = await balls(page);
    const way = [await pixelOf(page, nine), await pixelOf(page, [0.4, 0.4, kRadius])];
    await dragPixels(page, ...way);
    equal(/nine: \{touching: \{ball: eight, direction: 90(\.\d+)? deg\}\}/.test(await textOf(page)),
        true, await textOf(page));
    await page.keyboard.press('Control+z');
    await settle(page);
    await page.keyboard.down('Alt');
    await dragPixels(page, ...way);
    await page.keyboard.up('Alt');
    equal(/nine: \{at: \[0\.4\d*, 0\.4\d*\]\}/.test(await textOf(page)), true, await textOf(page));

    // Arrows: three presses are one step of undo.
    await page.evaluate(() => { window.studio.state.selection.value = ['balls', 'cue']; });
    const still = await textOf(page);
    const frame = await page.evaluate(() => window.studio.state.filmTime.value);
    await pressAtOnce(page, ['ArrowRight', 'ArrowRight', 'Alt+ArrowUp', 'Shift+ArrowLeft']);
    await page.mouse.move(5, 5);
    await page.keyboard.press('Control');
    await page.evaluate(() => window.dispatchEvent(new PointerEvent('pointerdown')));
    await settle(page);
    equal((await balls(page)).cue.slice(0, 2).map((x) => x.toFixed(4)), ['-0.6430', '0.0001'],
        'the nudged place');
    equal(await page.evaluate(() => window.studio.state.filmTime.value), frame, 'the film time');
    await page.keyboard.press('Control+z');
    await settle(page);
    equal(await textOf(page), still, 'the text after one undo');
    equal(complaints, [], 'the console');
    await end();
    return 'touches, cushion, spot, overlap shown, touching kept and freed, 4 presses 1 undo';
}
