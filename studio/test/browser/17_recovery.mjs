// After the server was killed, the page still shows the text and offers to copy it; a new server
// offers the unsaved text, which can be used or forgotten.
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { setTimeout as wait } from 'node:timers/promises';
import { equal, open, serve, settle, textOf } from './harness.mjs';

const kMine = 'cue: {at: [-0.61, 0.17]}';

/// Resolves when a journal in the cache has the text; the server writes it every two seconds. Files
/// that are still being written do not count: a server that is killed before it renames them leaves
/// no journal.
async function journalHas(folder, words) {
    const journals = join(folder, 'cache/studio');
    const has = () => existsSync(journals) && readdirSync(journals)
        .filter((name) => name.endsWith('.json'))
        .some((name) => readFileSync(join(journals, name), 'utf8').includes(words));
    for (let i = 0; i < 1200 && !has(); ++i) {
        await wait(50);
    }
    equal(has(), true, 'whether the journal has the text');
}

/// Edits, waits for the journal, kills the server, and opens the shot by a new one.
async function crash({ page, server, browser, carom, path, folder }) {
    await page.evaluate(() => window.studio.edit.applyChanges(
        [{ path: ['balls', 'cue', 'at'], value: [-0.61, 0.17], precision: 1e-4 }], 'Move cue'));
    await settle(page);
    await journalHas(folder, kMine);
    await server.kill();
    await page.waitForFunction(() => window.studio.state.connection.value === 'lost');
    equal((await textOf(page)).includes(kMine), true, 'the text without a server');
    equal(await page.locator('[role=alert]').count(), 1, 'bars that say so');
    equal(await page.getByRole('button', { name: 'Copy the text' }).count(), 1, 'buttons to copy it');
    await page.close();
    const again = await serve(carom, path, folder);
    const opened = await open(browser, again.address);
    await opened.page.locator('dialog[open]').waitFor();
    return { ...opened, server: again };
}

export const ownPage = true; // it opens one itself

export async function check({ browser, path, folder, carom }) {
    const before = readFileSync(path, 'utf8');
    const server = await serve(carom, path, folder);
    const all = { browser, carom, path, folder };
    let now = { ...await open(browser, server.address), server };
    try {
        now = await crash({ ...all, ...now });
        equal(await textOf(now.page), before, 'the text before an answer');
        equal(await now.page.locator('dialog .cm-merge-b .cm-changedLine').count() > 0, true,
            'marked differences');
        await now.page.getByRole('button', { name: 'Use the changes' }).click();
        await now.page.waitForFunction((part) => window.studio.edit.text().includes(part), kMine);
        await settle(now.page);
        equal(await now.page.locator('.toolbar .dirty').count(), 1, 'signs of unsaved changes');
        equal(readFileSync(path, 'utf8'), before, 'the file on disk');

        now = await crash({ ...all, ...now });
        await now.page.getByRole('button', { name: 'Forget them' }).click();
        await now.page.locator('dialog').waitFor({ state: 'detached' });
        equal(await textOf(now.page), before, 'the text after they were forgotten');
        await now.page.reload();
        await now.page.waitForFunction(() => window.studio?.state.problems.value?.complete);
        equal(await now.page.locator('dialog[open]').count(), 0, 'questions after a reload');
        await now.page.close();
        return 'a killed server leaves the text readable, and a new one offers it';
    } finally {
        await now.server.end();
    }
}
