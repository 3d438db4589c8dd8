// Edits of a camera simulate nothing; an edit of a ball does.
import { equal, settle } from './harness.mjs';

export async function check({ page }) {
    const change = async (path, value) => {
        await page.evaluate(([p, v]) => window.studio.edit.applyChanges(
            [{ path: p, value: v }], 'Change'), [path, value]);
        await settle(page);
        return page.evaluate(() => ({
            kept: window.studio.state.timeline.value.head.kept,
            answered: window.studio.state.timeline.value.head.v === window.studio.state.textVersion.value,
        }));
    };
    equal(await change(['cameras', '1', 'fov', '0'], 0.5), { kept: true, answered: true },
        'after an edit of a camera');
    equal(await change(['balls', 'cue', 'at', '0'], -0.7), { kept: false, answered: true },
        'after an edit of a ball');
    return 'the camera kept the motion, the ball did not';
}
