// An edit that could mean several things asks: a repeated value is changed everywhere or here, a list
// of carom's own files is copied into the shot as a step of its own, and what the page cannot write
// is shown as text.
import { equal, settle, textOf } from './harness.mjs';

function apply(page, path, value) {
    return page.evaluate(([p, v]) => window.studio.edit.applyChanges(
        [{ path: p, value: v }], 'Change').ok, [path, value]);
}

async function replace(page, old, now) {
    await page.evaluate(([a, b]) => {
        const from = window.studio.edit.text().indexOf(a);
        window.studio.edit.type(from, from + a.length, b);
    }, [old, now]);
    await settle(page);
}

export async function check({ page }) {
    const dialog = page.locator('dialog[open]');
    const answer = async (name) => {
        await dialog.getByRole('button', { name, exact: true }).click();
        await dialog.waitFor({ state: 'detached' });
        await settle(page);
    };
    await replace(page, '../configs/looks/club.yaml', 'looks/club.yaml');  // carom's own
    await replace(page, 'aperture: 8 mm', 'aperture: &lens 8 mm');
    await replace(page, 'aperture: 6 mm', 'aperture: *lens');
    const aliased = await textOf(page);
    equal(await apply(page, ['cameras', '2', 'aperture'], 0.005), false, 'an unanswered edit');
    await dialog.waitFor();
    equal(await page.evaluate(() => document.activeElement.textContent), 'Everywhere',
        'what has the focus');
    await page.keyboard.press('Escape');
    await dialog.waitFor({ state: 'detached' });
    equal(await textOf(page), aliased, 'the text after Escape');
    await apply(page, ['cameras', '2', 'aperture'], 0.005);
    await answer('Only here');
    equal(await textOf(page), aliased.replace('*lens', '5 mm'), 'a copy here');
    await page.evaluate(() => window.studio.edit.travel(true));
    equal(await textOf(page), aliased, 'the text after one undo');

    // A list of a look: the copy and the change are two steps.
    await apply(page, ['lights', 'lamp_1', 'radiance', '1'], 0.5);
    await answer('Copy the list into the shot');
    const changed = await textOf(page);
    equal(/^lights:\n {2}lamp_1: \{radiance: \[1, 0\.50, 0\.74\]\}$/m.test(changed), true, changed);
    await page.evaluate(() => window.studio.edit.travel(true));
    const copied = await textOf(page);
    equal(/^ {2}lamp_1: \{radiance: \[1, 0\.90, 0\.74\]\}$/m.test(copied), true, copied);
    await page.evaluate(() => window.studio.edit.travel(true));
    equal(await textOf(page), aliased, 'the text after both steps were taken back');

    // What has no place is shown.
    await replace(page, 'output: {crf: 18}', 'output: 18');
    await apply(page, ['output', 'crf'], 20);
    equal((await dialog.locator('pre').textContent()).trim(), 'output: {crf: 20}', 'the text to add');
    await answer('Close');
    return 'repeated values, lists of other files and impossible places are asked about';
}
