// Arrows of impulses, forces, torques and velocities: a dragged tip changes its vector in its unit.
import { changedLines, dragPixels, equal, openText, pixelOf, settle, textOf } from './harness.mjs';

const kShot = `carom: 1  # arrows
table: {kind: pool}
simulation: {duration: 3 s}
balls:
  cue: {at: [-0.5, 0]}
  eight: {at: [0.4, 0.25], velocity: [0.3, -0.2]}  # it rolls
events:
  - impulse: {object: cue, at: 0.2 s, newton_seconds: [0.12 N s, 0, 0]}
  - force: {object: cue, at: 1 s, for: 0.5 s, newtons: [300 mN, 100 mN, 0]}
  - torque: {object: cue, at: 1.5 s, for: 0.2 s, newton_metres: [0, 0, 0.002]}
  - velocity: {object: cue, at: 2 s, linear: [0.8, 0.3, 0]}
`;

function tips(page, path) {
    return page.evaluate((chosen) => {
        window.studio.state.selection.value = chosen;
        return window.studio.gizmos.arrows();
    }, path);
}

async function drag(page, path, by, key) {
    const before = await textOf(page);
    const [tip] = await tips(page, path);
    const from = await pixelOf(page, tip.at);
    const to = [from[0] + by[0], from[1] + by[1]];
    if (key) {
        await page.keyboard.down(key);
    }
    await dragPixels(page, from, to);
    if (key) {
        await page.keyboard.up(key);
    }
    const lines = changedLines(before, await textOf(page));
    equal(lines.length, 1, `changed lines: ${lines.join(' | ')}`);
    const [now] = await tips(page, path);
    const at = await pixelOf(page, now.at);
    await page.keyboard.press('Control+z');
    await settle(page);
    return { line: lines[0], off: Math.hypot(at[0] - to[0], at[1] - to[1]) };
}

export const ownPage = true; // it opens one itself

export const isExtra = true; // only in scripts/test --all, or by name

export async function check(context) {
    const { page, complaints, end } = await openText(context, 'arrows.yaml', kShot);
    const impulse = await drag(page, ['events', '0'], [30, -15]);
    equal(/newton_seconds: \[0?\.\d+ N s, 0?\.\d+, 0\]/.test(impulse.line), true, impulse.line);
    equal(impulse.off < 2, true, `the tip is ${impulse.off} px beside the pointer`);
    const force = await drag(page, ['events', '1'], [25, 12]);
    equal(/newtons: \[\d+(\.\d+)? mN, -?\d+(\.\d+)? mN, 0\]/.test(force.line), true, force.line);
    const torque = await drag(page, ['events', '2'], [0, -30], 'z');
    equal(/newton_metres: \[0, 0, 0\.00[2-9]\d*\]/.test(torque.line), true, torque.line);
    const velocity = await drag(page, ['events', '3'], [-20, -10]);
    equal(/linear: \[-?\d\.\d+, -?\d\.\d+, 0\]/.test(velocity.line), true, velocity.line);
    const start = await drag(page, ['balls', 'eight'], [20, 10]);
    equal(/velocity: \[-?\d(\.\d+)?, -?\d(\.\d+)?\]\} {2}# it rolls$/.test(start.line), true, start.line);
    await page.evaluate(() => { window.studio.state.selection.value = ['balls', 'cue']; });
    if (process.env.CAROM_STUDIO_SHOTS) {
        await page.screenshot({ path: `${process.env.CAROM_STUDIO_SHOTS}/26_all.png` });
    }
    equal(await textOf(page), kShot, 'the text after all undos');
    equal(complaints, [], 'the console');
    await end();
    return 'impulse, force, torque, velocity and start velocity, each in its unit, under the pointer';
}
