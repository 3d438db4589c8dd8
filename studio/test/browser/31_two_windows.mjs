// Two windows on one server: edits of both alternate, a drag in one is a step in the other, both end
// with the last edit, and undo in each takes the last change back.
import { equal, open, settle, textOf } from './harness.mjs';

function edit(page, value) {
    return page.evaluate((to) => window.studio.edit.applyChanges(
        [{ path: ['balls', 'cue', 'at'], value: to, precision: 1e-4 }], 'Move cue').ok, value);
}

/// Drags the cue ball by 16 cm in eight frames.
function drag(page) {
    return page.evaluate(async () => {
        const gesture = window.studio.edit.beginGesture();
        for (let i = 1; i <= 8; ++i) {
            gesture.update([{ path: ['balls', 'cue', 'at'], value: [-0.3 + i / 50, 0.12], precision: 1e-4 }]);
            await new Promise((resolve) => requestAnimationFrame(resolve));
        }
        gesture.commit('Move cue');
    });
}

/// Waits until all pages have that text, and nothing is under way.
async function agree(pages, text, what) {
    for (const page of pages) {
        await page.waitForFunction((expected) => window.studio.edit.text() === expected, text,
            { timeout: 5000 }).catch(async () => equal(await textOf(page), text, what));
        await settle(page);
    }
    // Nothing comes after it.
    for (const page of pages) {
        await settle(page);
        equal(await textOf(page), text, `${what}, a moment later`);
    }
}

export async function check({ page, browser, address }) {
    const other = await open(browser, address);
    const pages = [page, other.page];
    const before = await textOf(page);
    const moved = (x) => before.replace('[-0.75, 0.12]', `[${x}, 0.12]`);
    for (let i = 1; i <= 6; ++i) {
        equal(await edit(pages[i % 2], [-0.7 - i / 100, 0.12]), true, 'an edit');
        await agree(pages, moved(-0.7 - i / 100), `edit ${i}`);
    }
    // Both at once: one of the two counts, in both windows.
    await Promise.all([edit(page, [-0.5, 0.12]), edit(other.page, [-0.6, 0.12])]);
    await Promise.all(pages.map(settle));
    await page.waitForFunction((texts) => texts.includes(window.studio.edit.text()),
        [moved(-0.5), moved(-0.6)]);
    await agree(pages, await textOf(other.page), 'two edits at once');

    // Undo takes the last change back, in whichever window it was made.
    await edit(page, [-0.4, 0.12]);
    await agree(pages, moved(-0.4), 'an edit of the first window');
    await edit(other.page, [-0.3, 0.12]);
    await agree(pages, moved(-0.3), 'an edit of the second window');
    await page.evaluate(() => window.studio.edit.travel(true));
    await agree(pages, moved(-0.4), 'undo in the first window');
    await other.page.evaluate(() => window.studio.edit.travel(true));
    await agree(pages, moved(-0.3), 'undo of that in the second window');

    // A drag in one window is one step in the other, unless a busy processor lets more than a second
    // pass between its changes.
    let steps = 0;
    for (let i = 0; i < 4 && steps !== 1; i += 1) {
        await edit(other.page, [-0.3, 0.12]);
        await agree(pages, moved(-0.3), 'the place before a drag');
        await page.evaluate(() => new Promise((done) => { setTimeout(done, 1200); }));
        const stepsBefore = await page.evaluate(() => window.studio.edit.steps());
        await drag(other.page);
        await agree(pages, moved(-0.14), 'a drag in the second window');
        steps = await page.evaluate(() => window.studio.edit.steps()) - stepsBefore;
    }
    equal(steps, 1, 'steps of the drag in the first window');
    await page.evaluate(() => {
        while (window.studio.edit.travel(true)) { /* all */ }
    });
    await agree(pages, before, 'all steps taken back');
    equal(other.complaints, [], 'what the second window complains about');
    await other.page.close();
    return 'both windows have the same text after each edit, and undo works in each';
}
