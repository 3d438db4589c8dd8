// Opening a shot changes no file; an edit, its undo and a save write the same bytes.
import { readFileSync } from 'node:fs';
import { equal, settle, textOf } from './harness.mjs';

export async function check({ page, path }) {
    const before = readFileSync(path, 'utf8');
    equal(await textOf(page), before, 'the text of the page');
    const apply = (place) => page.evaluate((value) => window.studio.edit.applyChanges(
        [{ path: ['balls', 'cue', 'at'], value, precision: 1e-4 }], 'Move').ok, place);
    const saved = (dirty) => page.waitForFunction(
        (words) => window.studio.state.notice.value?.text.includes(words), dirty);

    equal(await apply([-0.7, 0.1]), true, 'the edit');
    await settle(page);
    equal(readFileSync(path, 'utf8'), before, 'the file before it is saved');
    await page.keyboard.press('Control+s');
    await saved('is saved');
    equal(readFileSync(path, 'utf8'), before.replace('[-0.75, 0.12]', '[-0.7, 0.1]'),
        'the saved file');
    await page.evaluate(() => { window.studio.state.notice.value = null; });
    await page.evaluate(() => window.studio.edit.travel(true));
    await settle(page);
    await page.keyboard.press('Control+s');
    await saved('is saved');
    equal(readFileSync(path, 'utf8'), before, 'the file after undo and save');
    return 'files change only when they are saved, and undo restores every byte';
}
