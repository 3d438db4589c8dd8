// A ball dragged with the pointer changes one line of the text; one undo restores it.
import { equal, settle, textOf } from './harness.mjs';

/// Where the middle of the cue ball is on the page.
function placeOfCue(page) {
    return page.evaluate(() => {
        const { view, state } = window.studio;
        const { position } = state.shot.value.objects.find((object) => object.name === 'cue');
        const point = view.camera.position.clone().set(...position).project(view.camera);
        const box = view.canvas.getBoundingClientRect();
        return [box.left + ((point.x + 1) / 2) * box.width, box.top + ((1 - point.y) / 2) * box.height];
    });
}

export async function check({ page }) {
    const before = await textOf(page);
    const start = await page.evaluate(() => window.studio.state.textVersion.value);
    await page.waitForFunction(() => window.studio.view.meshes.node('cue'));
    const [x, y] = await placeOfCue(page);
    await page.mouse.move(x, y);
    await page.mouse.down();
    for (let i = 1; i <= 40; ++i) {
        await page.mouse.move(x + 1.75 * i, y + 0.5 * i);
    }
    await page.mouse.up();
    await settle(page);

    const after = await textOf(page);
    const [old, now] = [before.split('\n'), after.split('\n')];
    const changed = now.flatMap((line, i) => line === old[i] ? [] : [line]);
    equal(now.length, old.length, 'lines');
    equal(changed.length, 1, `changed lines (${changed.join(' | ')})`);
    equal(/^ {2}cue: \{at: \[-0\.\d{1,4}, -0\.\d{1,4}\]\}$/.test(changed[0]), true, changed[0]);
    const state = await page.evaluate(() => ({
        v: window.studio.state.textVersion.value,
        answered: window.studio.state.timeline.value.head.v,
        selection: window.studio.state.selection.value,
        stale: window.studio.state.isStale.value,
    }));
    equal(state.answered, state.v, 'the version of the motion');
    equal(state.selection, ['balls', 'cue'], 'the selection');
    equal(state.stale, false, 'whether the motion is stale');
    await page.keyboard.press('Control+z');
    await settle(page);
    equal(await textOf(page), before, 'the text after one undo');
    await page.keyboard.press('Control+y');
    await settle(page);
    equal(await textOf(page), after, 'the text after redo');
    return `1 line changed, 1 undo; ${state.v - start} versions of the text`;
}
