// The key ] visits the events of `carom report --json` in order; a click on one puts the ball there.
import { execFileSync } from 'node:child_process';
import { equal } from './harness.mjs';
import { pixelOnStrip } from './strip_harness.mjs';

export const shot = 'bank_shot.yaml';

export async function check({ page, path, carom }) {
    const report = JSON.parse(execFileSync(carom, ['report', path, '--json'],
        { encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore'] }));
    const expected = report.events.map(({ time, kind, a }) => [time, kind, a]);
    await page.getByRole('button', { name: 'Events on the strip' }).click();
    await page.getByRole('menuitemcheckbox', { name: /^Motion/ }).click();
    await page.keyboard.press('Escape');
    await page.locator('canvas[data-play-head]').focus();
    const visited = [];
    for (let i = 0; i < expected.length; ++i) {
        await page.keyboard.press(']');
        visited.push(await page.evaluate(() => {
            const { strip, state } = window.studio;
            const event = strip.event.value;
            return event && event.time === state.sceneTime.value ? [event.time, event.kind, event.a] : null;
        }));
    }
    equal(visited, expected, 'the visited events');
    await page.keyboard.press(']');
    equal(await page.evaluate(() => window.studio.state.sceneTime.value), expected.at(-1)[0], 'the last');
    await page.keyboard.press('[');
    equal(await page.evaluate(() => window.studio.strip.event.value.kind), expected.at(-2)[1], 'back');

    const [time, , ball] = expected.find(([, kind]) => kind === 'potted');
    const [x, y] = await pixelOnStrip(page, 'events', time, false, 0.85);
    await page.mouse.click(x, y);
    const place = await page.evaluate((name) => {
        const { state, strip } = window.studio;
        return { time: state.sceneTime.value, at: strip.placeOf(name),
            pockets: state.shot.value.pockets };
    }, ball);
    equal(Math.abs(place.time - time) < 0.05, true, `the clock (${place.time}, ${time})`);
    const away = Math.min(...place.pockets.map((pocket) =>
        Math.hypot(pocket.place[0] - place.at[0], pocket.place[1] - place.at[1]) - pocket.radius));
    equal(away < 0.03, true, `the potted ball is over a pocket (${away} m away)`);
    return `${expected.length} events in order; a potted ball over its pocket`;
}
