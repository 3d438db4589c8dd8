// A file that changed on disk while the page has changes is not written over: saving shows both
// texts, and the merged one is saved; undo brings the page's own text back.
import { readFileSync, writeFileSync } from 'node:fs';
import { equal, settle, textOf } from './harness.mjs';

const kTheirs = '# from another program\n';

function edit(page, place) {
    return page.evaluate((value) => window.studio.edit.applyChanges(
        [{ path: ['balls', 'cue', 'at'], value, precision: 1e-4 }], 'Move cue').ok, place);
}

async function saved(page) {
    await page.waitForFunction(() => window.studio.state.notice.value?.text.includes('is saved'));
    await page.evaluate(() => { window.studio.state.notice.value = null; });
}

export async function check({ page, path }) {
    const before = readFileSync(path, 'utf8');
    const theirs = before + kTheirs;
    const mine = before.replace('[-0.75, 0.12]', '[-0.7, 0.1]');
    equal(await edit(page, [-0.7, 0.1]), true, 'the edit');
    await settle(page);
    writeFileSync(path, theirs);
    await page.locator('.conflict').waitFor();
    await page.locator('.cm-content').first().click();
    await page.keyboard.press('Control+s');
    const dialog = page.locator('dialog[open]');
    await dialog.waitFor();
    equal(readFileSync(path, 'utf8'), theirs, 'the file on disk while the user is asked');

    // Escape leaves everything as it is.
    await page.keyboard.press('Escape');
    await dialog.waitFor({ state: 'detached' });
    equal([readFileSync(path, 'utf8'), await textOf(page)], [theirs, mine], 'both texts');

    // Another shot is not opened, also not later, if the user does not say what to save.
    const asked = page.evaluate((file) => window.studio.open(file),
        path.replace('nine_ball_break', 'jump_shot'));
    await dialog.getByRole('button', { name: 'Save', exact: true }).click();
    await dialog.locator('.take').first().waitFor();
    await page.keyboard.press('Escape');
    await asked;
    equal(await textOf(page), mine, 'the text after another shot was not opened');

    // Both changes are in the merged text, which is saved. What differs can be taken over.
    await page.keyboard.press('Control+s');
    const texts = () => dialog.locator('.cm-merge-b .cm-line').allTextContents();
    await dialog.waitFor();
    await dialog.locator('.take').first().waitFor();
    equal(await dialog.locator('.take').count(), 1, 'differences from the disk: only the own one');
    await dialog.locator('.take').click();
    equal((await texts()).some((line) => line.includes('[-0.75, 0.12]')), true, 'what was taken');
    await dialog.locator('.cm-merge-b .cm-content').focus();
    await page.keyboard.press('Control+z');
    equal((await texts()).some((line) => line.includes('[-0.7, 0.1]')), true, 'the own line');
    await dialog.getByRole('button', { name: 'Save the merged text' }).click();
    await saved(page);
    const merged = mine + kTheirs;
    equal([readFileSync(path, 'utf8'), await textOf(page)], [merged, merged], 'the merged text');
    equal(await page.locator('.conflict').count(), 0, 'bars about a conflict');
    await page.keyboard.press('Control+z');
    await settle(page);
    equal(await textOf(page), mine, 'the own text after one undo');
    await page.keyboard.press('Control+y');

    // The other program's text is taken, and undo brings the own one back.
    equal(await edit(page, [-0.6, 0.2]), true, 'another edit');
    await settle(page);
    const own = await textOf(page);
    writeFileSync(path, theirs);
    await page.locator('.conflict button').click();
    await dialog.getByRole('button', { name: 'Use the version on disk' }).click();
    await settle(page);
    equal(await textOf(page), theirs, "the other program's text");
    equal(await page.locator('.toolbar .dirty').count(), 0, 'signs of unsaved changes');
    await page.keyboard.press('Control+z');
    await settle(page);
    equal(await textOf(page), own, 'the own text after undo');
    equal(await page.evaluate(() => window.studio.state.welcome.value.shot), path, 'the open shot');
    return 'saving is refused, both texts are shown, neither is lost';
}
