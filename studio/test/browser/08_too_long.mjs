// A text that is longer than the server takes is not sent: the page says so, keeps its connection, and
// goes on when the text is shorter again.
import { equal, settle, textOf } from './harness.mjs';

export async function check({ page }) {
    const before = await textOf(page);
    await page.evaluate(() => {
        window.lost = 0;
        window.studio.state.connection.subscribe((state) => { window.lost += state === 'open' ? 0 : 1; });
        window.studio.edit.type(0, 0, `# ${'\u00e9'.repeat(100)}\n`.repeat(21_000)); // 4.3 MB, 2.2 million characters
    });
    await page.getByText('is too long: carom studio takes at most 4 MiB').waitFor();
    await page.keyboard.press('Control+s');
    await page.locator('.status', { hasText: 'The text is too long' }).waitFor();
    equal(await page.evaluate(() => window.lost), 0, 'how often the connection was lost');
    await page.evaluate(() => window.studio.edit.travel(true));
    await page.locator('.shell > .lost').waitFor({ state: 'detached' });
    await settle(page);
    await page.evaluate(() => window.studio.edit.applyChanges(
        [{ path: ['balls', 'cue', 'at'], value: [-0.5, 0.1], precision: 1e-4 }], 'Move cue'));
    await settle(page);
    equal(await page.evaluate(() => window.studio.state.timeline.value.head.v
        === window.studio.state.textVersion.value), true, 'whether a shorter text is answered');
    equal(await page.evaluate(() => window.lost), 0, 'how often the connection was lost in the end');
    await page.evaluate(() => window.studio.edit.travel(true));
    await settle(page);
    equal(await textOf(page), before, 'the text at the end');
    return 'more than 4 MiB are refused with a sentence, and the connection stays';
}
