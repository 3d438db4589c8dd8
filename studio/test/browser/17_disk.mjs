// A file that another program writes is shown at once if the page has not changed it; a changed one
// keeps its text, and saving does not write over the other program's.
import { mkdirSync, readFileSync, renameSync, rmdirSync, unlinkSync, writeFileSync } from 'node:fs';
import { equal, settle, textOf } from './harness.mjs';

/// Files that are deleted or renamed keep their text in the page, which says what became of them and
/// writes them again.
async function gone(page, path, theirs) {
    await page.locator('.conflict button').click();
    await page.getByRole('button', { name: 'Use the version on disk' }).click();
    const text = await textOf(page);
    const bar = page.locator('.conflict');
    const written = () => page.waitForFunction(() =>
        window.studio.state.notice.value?.text.includes('is saved'));
    unlinkSync(path);
    await bar.getByText('This file was deleted.').waitFor();
    equal([await textOf(page), await page.locator('.toolbar .dirty').count()], [text, 1], 'the text');
    await page.keyboard.press('Control+s');
    const dialog = page.locator('dialog[open]');
    await dialog.getByRole('heading', { name: /\.yaml was deleted$/ }).waitFor();
    if (process.env.CAROM_STUDIO_SHOTS) {
        await page.screenshot({ path: `${process.env.CAROM_STUDIO_SHOTS}/17_deleted.png` });
    }
    await dialog.getByRole('button', { name: 'Write it again' }).click();
    await written();
    equal([readFileSync(path, 'utf8'), await bar.count()], [text, 0], 'the file after it was written again');

    renameSync(path, `${path}.old.yaml`);
    await bar.getByText(/This file was renamed to '.*\.old\.yaml'\./).waitFor();
    writeFileSync(path, text);
    await bar.waitFor({ state: 'detached' });
    equal(await page.locator('.toolbar .dirty').count(), 0, 'unsaved changes once the file is back');
    unlinkSync(path);
    mkdirSync(path);
    await bar.getByText('This file is a folder.').waitFor();
    rmdirSync(path);
    writeFileSync(path, theirs);
    await page.waitForFunction((all) => window.studio.edit.text() === all, theirs);
}

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
    await gone(page, path, before);
    return 'what another program writes is shown, and neither its text nor the page\'s is lost';
}
