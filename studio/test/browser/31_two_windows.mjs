// Two windows on one server: edits of both alternate, a drag in one is a step in the other, both end
// with the last edit, and undo in each takes the last change back. A drag goes on while the other window
// types or drags something else.
import { kPatience, equal, open, pixelOf, settle, textOf } from './harness.mjs';

function edit(page, value) {
    return page.evaluate((to) => window.studio.edit.applyChanges(
        [{ path: ['balls', 'cue', 'at'], value: to, precision: 1e-4 }], 'Move cue').ok, value);
}

const kOthers = '# another window\n';

/// Drags a ball with the pointer, some moves before and some after `between`.
async function dragBall(page, name, between) {
    const place = await page.evaluate((one) => window.studio.state.shot.value.objects
        .find((object) => object.name === one).position, name);
    const [x, y] = await pixelOf(page, place);
    await page.mouse.move(x, y);
    await page.mouse.down();
    for (let i = 1; i <= 6; ++i) {
        await page.mouse.move(x - 4 * i, y);
    }
    await between?.();
    for (let i = 7; i <= 16; ++i) {
        await page.mouse.move(x - 4 * i, y);
    }
    await page.mouse.up();
}

/// The places of two balls in the text; null: it has none.
function placesIn(text) {
    return ['cue', 'nine'].map((name) =>
        new RegExp(`^ {2}${name}: \\{at: (.*)\\}$`, 'm').exec(text)?.[1] ?? null);
}

/// A drag in one window goes on while the other one types in another line, and both drag at once.
async function atOnce(page, other) {
    const before = await textOf(page);
    await dragBall(page, 'cue', async () => {
        await other.locator('.cm-content').focus();
        await other.keyboard.press('Control+Home');
        await other.keyboard.type(kOthers.trimEnd());
        await other.keyboard.press('Enter');
        await page.waitForFunction((words) => window.studio.edit.text().startsWith(words), kOthers);
    });
    await settle(page);
    const [cue] = placesIn(await textOf(page));
    const both = kOthers + before.replace('[-0.3, 0.12]', cue);
    equal(cue !== '[-0.3, 0.12]' && cue !== null, true, `the place of the cue ball, ${cue}`);
    await agree([page, other], both, 'a drag and what was typed meanwhile');
    await page.evaluate(() => window.studio.edit.travel(true));
    await agree([page, other], kOthers + before, 'the drag undone');
    await page.evaluate(() => window.studio.edit.travel(false));
    await agree([page, other], both, 'the drag again');

    await Promise.all([dragBall(page, 'cue'), dragBall(other, 'nine')]);
    await Promise.all([settle(page), settle(other)]);
    await other.waitForFunction((words) => !window.studio.edit.text().includes(words), cue);
    const places = placesIn(await textOf(other));
    equal(places.every((place) => place !== null) && places[0] !== cue, true,
        `two drags at once: ${places.join(' and ')}`);
    await agree([page, other], await textOf(other), 'two drags at once');
    for (const each of [other, page]) {
        await each.evaluate(() => { window.studio.state.selection.value = null; });
    }
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
            { timeout: kPatience }).catch(async () => equal(await textOf(page), text, what));
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
    for (let i = 0; i < 12 && steps !== 1; i += 1) {
        await edit(other.page, [-0.3, 0.12]);
        await agree(pages, moved(-0.3), 'the place before a drag');
        await page.evaluate(() => new Promise((done) => { setTimeout(done, 1200); }));
        const stepsBefore = await page.evaluate(() => window.studio.edit.steps());
        await drag(other.page);
        await agree(pages, moved(-0.14), 'a drag in the second window');
        steps = await page.evaluate(() => window.studio.edit.steps()) - stepsBefore;
    }
    equal(steps, 1, 'steps of the drag in the first window');
    await edit(page, [-0.3, 0.12]);
    await agree(pages, moved(-0.3), 'the place before two windows work at once');
    await atOnce(page, other.page);
    await page.evaluate(() => {
        while (window.studio.edit.travel(true)) { /* all */ }
    });
    await agree(pages, before, 'all steps taken back');
    equal(other.complaints, [], 'what the second window complains about');
    await other.page.close();
    return 'both windows have the same text after each edit, also made at once, and undo works in each';
}
