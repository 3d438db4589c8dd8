// A server that was killed and started again on the same port does not know the old page: the page says
// so, and goes on with its text as soon as the new address was opened in the same browser.
import { equal, open, serve, settle, textOf } from './harness.mjs';

const kMine = 'cue: {at: [-0.61, 0.17]}';

export const ownPage = true; // it opens one itself

export async function check({ browser, path, folder, carom }) {
    let server = await serve(carom, path, folder);
    const { page } = await open(browser, server.address);
    try {
        await page.evaluate(() => window.studio.edit.applyChanges(
            [{ path: ['balls', 'cue', 'at'], value: [-0.61, 0.17], precision: 1e-4 }], 'Move cue'));
        await settle(page);
        await server.kill();
        await page.getByText('connects again as soon as the server answers').waitFor();
        const { port } = new URL(server.address);
        server = await serve(carom, path, folder, ['--port', port]);
        await page.getByText('does not know this page').waitFor();
        equal((await textOf(page)).includes(kMine), true, 'the text of a page that is not known');

        const newer = await page.context().newPage();
        await newer.goto(server.address);
        await page.waitForFunction(() => window.studio.state.connection.value === 'open');
        equal(await page.getByText('does not know this page').count(), 0, 'what it said before');
        // A server that found the text in the journal asks whether to use it.
        const question = page.getByRole('button', { name: 'Use the changes' });
        await page.waitForFunction(() => window.studio.state.files.value.length > 0);
        await settle(page);
        if (await question.isVisible()) {
            await question.click();
        }
        await page.waitForFunction((part) => window.studio.edit.text().includes(part), kMine);
        await settle(page);
        await newer.close();
        await page.reload();
        await page.waitForFunction(() => window.studio?.state.problems.value?.complete);
        await settle(page);
        equal((await textOf(page)).includes(kMine), true, 'the text after a reload');
        await page.close();
        return 'the old page says what happened, and goes on when the new address was opened';
    } finally {
        await server.end();
    }
}
