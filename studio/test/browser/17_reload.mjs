// Unsaved texts and the history of all steps survive a reload of the page; changes that the user
// leaves without saving do not come back.
import { readFileSync } from 'node:fs';
import { equal, settle, textOf } from './harness.mjs';

export async function check({ page, path }) {
    const before = readFileSync(path, 'utf8');
    const titles = () => page.evaluate(() => [...document.querySelectorAll('.toolbar .tool')]
        .map((tool) => tool.getAttribute('aria-label')).filter((label) => /^(Undo|Redo)/.test(label)));
    const apply = (value) => page.evaluate((to) => window.studio.edit.applyChanges(
        [{ path: ['balls', 'cue', 'at'], value: to, precision: 1e-4 }], 'Move cue'), value);
    await apply([-0.7, 0.1]);
    const first = await textOf(page);
    await apply([-0.6, 0.2]);
    const second = await textOf(page);
    await page.evaluate(() => window.studio.edit.travel(true));
    await settle(page);

    await page.reload();
    await page.waitForFunction(() => window.studio?.state.problems.value?.complete);
    await settle(page);
    equal(await textOf(page), first, 'the text after a reload');
    equal(await page.locator('.toolbar .dirty').count(), 1, 'signs of unsaved changes');
    equal(await titles(), ['Undo: Move cue (Ctrl+Z)', 'Redo: Move cue (Ctrl+Y)'], 'the steps');
    await page.keyboard.press('Control+y');
    equal(await textOf(page), second, 'the text after redo');
    await page.keyboard.press('Control+z');
    await page.keyboard.press('Control+z');
    await settle(page);
    equal(await textOf(page), before, 'the text after undo');
    equal(await page.locator('.toolbar .dirty').count(), 0, 'signs of unsaved changes at the end');
    await apply([-0.5, 0.3]);
    await settle(page);
    const show = async (name, words) => {
        const asked = page.evaluate((file) => window.studio.open(file),
            path.replace('nine_ball_break', name));
        if (words) {
            await page.getByRole('button', { name: words }).click();
        }
        await asked;
        await page.waitForFunction((part) => window.studio.state.files.value[0]?.file.includes(part)
            && window.studio.state.problems.value?.complete, name);
        await settle(page);
    };
    await show('jump_shot', 'Do not save');
    await show('nine_ball_break');
    equal(await textOf(page), before, 'the text after it was left without saving');
    equal(await page.locator('.toolbar .dirty').count(), 0, 'unsaved changes of a shot left');
    return 'texts and steps are there again';
}
