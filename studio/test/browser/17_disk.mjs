// A file that another program writes is shown at once if the page has not changed it; a changed one
// keeps its text, and saving does not write over the other program's.
import { readFileSync, renameSync, unlinkSync, writeFileSync } from 'node:fs';
import { equal, settle, textOf } from './harness.mjs';

export async function check({ page, path }) {
    const before = readFileSync(path, 'utf8');
    const shows = (words) => page.waitForFunction(
        (part) => window.studio.edit.text().includes(part), words);
    writeFileSync(`${path}.new`, `${before}# renamed\n`);
    renameSync(`${path}.new`, path);
    await shows('# renamed');
    unlinkSync(path);
    writeFileSync(path, `${before}# checked out\n`);
    await shows('# checked out');
    await settle(page);
    const dirty = () => page.evaluate(() => document.querySelector('.dirty') !== null);
    equal(await dirty(), false, 'whether the page has unsaved changes');
    await page.evaluate(() => window.studio.edit.travel(true));
    equal((await textOf(page)).includes('# renamed'), true, 'the text before, by undo');
    await page.evaluate(() => window.studio.edit.travel(false));
    await settle(page);

    await page.evaluate(() => window.studio.edit.applyChanges(
        [{ path: ['balls', 'cue', 'at'], value: [-0.7, 0.1], precision: 1e-4 }], 'Move'));
    await settle(page);
    writeFileSync(path, `${before}# theirs\n`);
    await page.waitForFunction(
        () => window.studio.state.notice.value?.text.includes('changed on disk'));
    equal((await textOf(page)).includes('[-0.7, 0.1]'), true, 'the text of the page is kept');
    equal(readFileSync(path, 'utf8'), `${before}# theirs\n`, 'the file on disk');
    return 'what another program writes is shown, and neither its text nor the page\'s is lost';
}
