// The aim of a strike shows within which directions it pots, and the chance; the map of directions and
// speeds sets both by one click.
import { faults } from './axe.mjs';
import { changedLines, equal, openText, settle, textOf, undo } from './harness.mjs';

const kShot = `carom: 1  # map
table: {kind: pool}
simulation: {duration: 12 s}
balls:
  cue: {at: [-0.3, -0.1]}
  one: {at: [0.4, 0.2]}
  two: {at: [0.1, -0.4]}
events:
  - strike: {ball: cue, at: 0.5 s, pot: one, in: corner_right_back, speed: 2 m/s}  # the strike
`;

/// The wedge and its label as they are drawn, once they belong to the newest text.
async function windowOf(page, text) {
    await page.waitForFunction((one) => {
        const { figure } = window.studio.gizmos;
        return figure('aim-window').labels?.[0]?.text.startsWith(one);
    }, text);
    return page.evaluate(() => ({ judged: window.studio.gizmos.judged(),
        lines: window.studio.gizmos.figure('aim-window').lines,
        text: window.studio.gizmos.figure('aim-window').labels[0].text }));
}

export const ownPage = true; // it opens one itself

export async function check(context) {
    const { page, complaints, end } = await openText(context, 'map.yaml', kShot);
    await page.keyboard.press('1');
    await page.evaluate(() => { window.studio.state.selection.value = ['events', '0']; });
    const { judged, lines, text } = await windowOf(page, 'one: ');
    equal(/^one: \d+ %, −\d\.\d\d° to \+\d\.\d\d°$/.test(text), true, text);
    equal(lines.length > 10 && judged.window[0] < judged.direction
        && judged.direction < judged.window[1], true, 'the wedge');
    const map = page.getByRole('slider', { name: 'Direction and speed' });
    await map.waitFor();
    equal(await faults(page), [], 'what axe finds in the map');
    if (process.env.CAROM_STUDIO_SHOTS) {
        await page.screenshot({ path: `${process.env.CAROM_STUDIO_SHOTS}/39_map.png` });
    }

    // A cell that pots, in another row.
    const cell = await page.evaluate(() => {
        const { cells, columns, rows } = window.studio.state.strikeMap.value;
        const row = Math.round(rows * 0.7);
        const at = [...cells].findIndex((one, i) => Math.floor(i / columns) >= row && one === 'w');
        return [((at % columns) + 0.5) / columns, (Math.floor(at / columns) + 0.5) / rows];
    });
    const box = await map.boundingBox();
    await page.mouse.click(box.x + cell[0] * box.width, box.y + (1 - cell[1]) * box.height);
    await settle(page);
    const after = await textOf(page);
    const line = changedLines(kShot, after)[0];
    equal([/ direction: [\d.]+ deg[,}]/.test(line), / speed: \d\.?\d* m\/s[,}]/.test(line),
        / pot:/.test(line), line.endsWith('# the strike')], [true, true, false, true], line);
    const strike = await page.evaluate(() => {
        const { directions, speeds } = window.studio.state.strikeMap.value;
        const { direction, speed } = window.studio.state.shot.value.events[0];
        return [(direction - directions[0]) / (directions[1] - directions[0]),
            (speed - speeds[0]) / (speeds[1] - speeds[0])];
    });
    equal([Math.abs(strike[0] - cell[0]) < 0.02, Math.abs(strike[1] - cell[1]) < 0.03], [true, true],
        `the strike at ${strike} of the map, the click at ${cell}`);
    await windowOf(page, 'one: ');
    await undo(page, kShot, 'a click in the map');

    // The keyboard, too; then a strike that pots nothing has no window.
    await page.evaluate(() => { window.studio.state.selection.value = ['events', '0']; });
    await map.focus();
    await page.keyboard.press('ArrowUp');
    await page.waitForTimeout(800); // the step of undo ends
    await settle(page);
    equal(/speed: 2\.\d+ m\/s/.test(await textOf(page)), true, await textOf(page));
    await undo(page, kShot, 'an arrow key in the map');
    await page.evaluate(() => window.studio.edit.applyChanges([
        { path: ['events', '0', 'strike', 'direction'], value: Math.PI, precision: 1e-3 }], 'Away'));
    await settle(page);
    await page.waitForFunction(() => window.studio.state.judged.value.pots.length === 0);
    equal(await page.evaluate(() => window.studio.gizmos.figure('aim-window').lines ?? []), [],
        'the window of a strike that pots nothing');
    equal(complaints, [], 'the console');
    await end();
    return `${text}; a click sets ${changedLines(kShot, after)[0].trim()}`;
}
