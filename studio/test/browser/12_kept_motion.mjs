// Edits of a camera, a material or the exposure simulate nothing; an edit of a ball does. Another
// exposure of a picture that is complete is complete at once: it takes no new sample.
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
    equal(await change(['materials', 'cloth', 'standard', 'roughness'], 0.8), { kept: true, answered: true },
        'after an edit of a material');
    equal(await change(['balls', 'cue', 'at', '0'], -0.7), { kept: false, answered: true },
        'after an edit of a ball');
    await page.evaluate(() => { window.studio.state.filmTime.value = 3.5; });
    await page.locator('canvas[aria-label="The scene"]').focus();
    await page.keyboard.press('c');
    await page.keyboard.press('r');
    await page.waitForFunction(() => window.studio.state.picture.value?.head.complete);
    await page.evaluate(() => {
        window.heads = [];
        const before = window.studio.state.picture.value.head.v;
        window.studio.state.picture.subscribe(({ head }) => head.v > before && window.heads.push(head));
    });
    equal(await change(['output', 'exposure'], 0.5), { kept: true, answered: true },
        'after an edit of the exposure');
    await page.waitForFunction(() => window.heads.some((head) => head.complete));
    equal(await page.evaluate(() => window.heads.map(({ samples, of_samples }) => samples === of_samples)),
        [true], 'whether all pictures of the other exposure have all samples');
    return 'the camera, the material and the exposure kept the motion, the ball did not; '
        + 'the exposure took no new sample';
}
