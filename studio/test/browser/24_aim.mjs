// The handles of a strike: the aim changes only `direction`, or `toward` if it is on a ball; speed and
// elevation change their numbers; the ghost ball follows.
import { changedLines, dragPixels, equal, openText, pixelOf, settle, textOf } from './harness.mjs';

const kShot = `carom: 1  # aim
table: {kind: pool}
simulation: {duration: 3 s}
balls:
  cue: {at: [-0.5, 0]}
  eight: {at: [0.4, 0.25]}
  nine: {at: [0.4, -0.25]}
events:
  - strike: {ball: cue, at: 0.5 s, toward: eight, speed: 3 m/s}  # the strike
`;

/// What the view draws of the strike, and its handles.
function drawn(page) {
    return page.evaluate(() => {
        const { handles, figure } = window.studio.gizmos;
        const strike = figure('strike');
        return {
            handles: Object.fromEntries(handles().map(({ kind, at }) => [kind, at])),
            ghost: strike.balls[0]?.at, lines: strike.lines.length,
        };
    });
}

/// Drags a handle to a place of the scene; returns the line of the strike.
async function drag(page, kind, to, key) {
    const { handles } = await drawn(page);
    const [from, goal] = [await pixelOf(page, handles[kind]), await pixelOf(page, to)];
    if (key) {
        await page.keyboard.down(key);
    }
    await dragPixels(page, from, goal);
    if (key) {
        await page.keyboard.up(key);
    }
    const text = await textOf(page);
    const lines = changedLines(kShot, text);
    equal(lines.length <= 1, true, `changed lines: ${lines.join(' | ')}`);
    return text.split('\n')[8];
}

export const ownPage = true; // it opens one itself

export const isExtra = true; // only in scripts/test --all, or by name

export async function check(context) {
    const { page, complaints, end } = await openText(context, 'aim.yaml', kShot);
    const faint = await drawn(page);
    equal([Object.keys(faint.handles), faint.lines > 2], [[], true], 'what is drawn faintly');
    await page.evaluate(() => { window.studio.state.selection.value = ['events', '0']; });
    equal(Object.keys((await drawn(page)).handles), ['aim', 'speed', 'elevation'], 'handles');
    if (process.env.CAROM_STUDIO_SHOTS) {
        await page.screenshot({ path: `${process.env.CAROM_STUDIO_SHOTS}/24_strike.png` });
    }

    // On another ball: toward it. Beside all balls: a direction, in the same place of the line.
    equal(await drag(page, 'aim', [0.4, -0.25, 0.0286]),
        '  - strike: {ball: cue, at: 0.5 s, toward: nine, speed: 3 m/s}  # the strike', 'on a ball');
    const free = await drag(page, 'aim', [0.4, 0.1, 0.0286]);
    const found = /^ {2}- strike: \{ball: cue, at: 0\.5 s, direction: (\d+\.?\d*) deg, speed: 3 m\/s\} {2}# the strike$/
        .exec(free);
    equal(found !== null && Math.abs(Number(found[1]) - (180 / Math.PI) * Math.atan2(0.1, 0.9)) < 0.3,
        true, free);
    const ghost = (await drawn(page)).ghost;
    const angle = (Math.atan2(ghost[1], ghost[0] + 0.5) * 180) / Math.PI;
    equal(Math.abs(angle - Number(found[1])) < 0.01, true, `the ghost ball lies at ${angle} degrees`);
    // From now on only the number changes.
    const again = await drag(page, 'aim', [0.9, 0.3, 0.0286]);
    equal(again.replace(/[\d.]+ deg/, ''), free.replace(/[\d.]+ deg/, ''), 'the rest of the line');

    const { handles } = await drawn(page);
    const away = handles.speed.map((value, i) => value + [-0.12, -0.02, 0][i]);
    const faster = await drag(page, 'speed', away);
    equal(Number(/speed: ([\d.]+) m\/s/.exec(faster)[1]) > 4, true, faster);
    const raised = await drag(page, 'elevation',
        (await drawn(page)).handles.elevation.map((value, i) => value + (i === 2 ? 0.1 : 0)));
    equal(/, elevation: [\d.]+ deg\}/.test(raised), true, raised);
    for (let i = 0; i < 5; ++i) {
        await page.keyboard.press('Control+z');
        await settle(page);
    }
    equal(await textOf(page), kShot, 'the text after five times undo');
    equal(complaints, [], 'the console');
    await end();
    return `toward, then ${found[1]} deg, speed, elevation; the ghost ball follows; 5 undos`;
}
