// Tools of the text: numbers are changed by a drag with Alt and by keys, colours by a click on their
// square, F12 leads to what a name means, maps are folded, and Ctrl-F searches.
import { equal, settle, textOf } from './harness.mjs';

/// Puts the cursor at the first occurrence of a word, plus an offset, and returns its place.
function at(page, word, plus = 0) {
    return page.evaluate(([text, more]) => {
        const { view } = window.studio.editor;
        const anchor = view.state.doc.toString().indexOf(text) + more;
        view.dispatch({ selection: { anchor }, scrollIntoView: true });
        view.focus();
        const { left, top, bottom } = view.coordsAtPos(anchor, 1);
        return [left + 2, (top + bottom) / 2];
    }, [word, plus]);
}

export async function check({ page }) {
    const before = await textOf(page);
    const undone = async (message) => {
        await page.keyboard.press('Control+z');
        await settle(page);
        equal(await textOf(page), before, message);
    };
    const [x, y] = await at(page, '0.12]', 1);
    await page.keyboard.down('Alt');
    await page.mouse.move(x, y);
    await page.mouse.down();
    for (let i = 1; i <= 10; ++i) {
        await page.mouse.move(x + 4 * i, y);
    }
    equal(await page.evaluate(() => window.studio.state.dragging.value), true, 'a drag');
    await page.mouse.up();
    await page.keyboard.up('Alt');
    equal(await textOf(page), before.replace('0.12]', '0.22]'), 'the dragged number');
    await page.keyboard.press('Control+ArrowUp');
    equal(await textOf(page), before.replace('0.12]', '0.23]'), 'the nudged number');
    await page.keyboard.press('Control+z');
    equal(await textOf(page), before.replace('0.12]', '0.22]'), 'one undo of the key');
    await undone('one undo of the drag');

    await page.mouse.move(x, y);
    await page.keyboard.down('Alt');
    await page.mouse.down();
    await page.mouse.move(x + 40, y);
    await page.keyboard.press('Escape');
    await page.mouse.up();
    await page.keyboard.up('Alt');
    equal(await textOf(page), before, 'the text after Escape');

    // Undo ends the drag, which no longer follows the pointer; redo brings it back.
    await page.mouse.move(x, y);
    await page.keyboard.down('Alt');
    await page.mouse.down();
    await page.mouse.move(x + 40, y);
    await page.keyboard.up('Alt');
    await page.keyboard.press('Control+z');
    await page.mouse.move(x + 80, y);
    await page.mouse.up();
    await settle(page);
    equal(await textOf(page), before, 'undo while a number is dragged');
    await page.keyboard.press('Control+y');
    equal(await textOf(page), before.replace('0.12]', '0.22]'), 'redo of the drag');

    // The undo of the browser's own menu.
    const menu = (inputType) => page.evaluate((type) => document.querySelector('.cm-content')
        .dispatchEvent(new InputEvent('beforeinput', { inputType: type, bubbles: true, cancelable: true })),
    inputType);
    equal(await menu('historyUndo'), false, 'whether the browser undoes itself');
    equal(await textOf(page), before, "undo by the browser's menu");
    await menu('historyRedo');
    equal(await textOf(page), before.replace('0.12]', '0.22]'), "redo by the browser's menu");
    await undone('undo by the key after that');

    await page.keyboard.press('Control+Shift+m');
    equal(await page.locator('.cm-panel-lint').count(), 0, "lists of problems of the editor's own");

    await at(page, '30 deg', 1);
    await page.keyboard.press('Control+Shift+ArrowUp');
    equal(await textOf(page), before.replace('30 deg', '40 deg'), 'the nudged angle');
    await undone('one undo of the key for the angle');

    await at(page, 'ball: cue', 7);
    await page.keyboard.press('F12');
    await page.waitForFunction(() => {
        const { main } = window.studio.editor.view.state.selection;
        return window.studio.editor.view.state.sliceDoc(main.from, main.to) === 'cue'
            && window.studio.editor.view.state.doc.lineAt(main.from).text.startsWith('  cue:');
    });
    await at(page, 'balls/pool.yaml', 3);
    await page.keyboard.press('F12');
    await page.locator('.tab[aria-selected=true]', { hasText: 'pool.yaml' }).waitFor();

    // A colour of a look; the file is in the test's folder and can be written.
    await page.locator('.tab', { hasText: 'club_unlit.yaml' }).click();
    const look = await textOf(page);
    const swatch = page.locator('.cm-swatch').first();
    await swatch.waitFor();
    await swatch.evaluate((input) => {
        input.value = '#bc3f22';
        input.dispatchEvent(new Event('change'));
    });
    const painted = await textOf(page);
    equal(painted.split('\n').filter((line, i) => line !== look.split('\n')[i]).length, 1,
        'lines changed by a colour');
    equal(painted.includes('[0.503, 0.05, 0.016]'), true, 'the colour in linear light');
    await page.evaluate(() => window.studio.edit.travel(true));
    equal(await textOf(page), look, 'the look after undo');

    await page.locator('.tab').first().click();
    await at(page, 'cameras:', 2);
    await page.keyboard.press('Control+Shift+BracketLeft');
    equal(await page.locator('.cm-foldPlaceholder').count(), 1, 'folds');
    await page.keyboard.press('Control+Shift+BracketRight');
    equal(await page.locator('.cm-foldPlaceholder').count(), 0, 'folds after unfolding');
    await page.keyboard.press('Control+f');
    await page.keyboard.type('bezier');
    equal(await page.locator('.cm-searchMatch').count() > 2, true, 'what was found');
    equal(await page.locator('.find-count').textContent(), '6', 'the count');
    await page.keyboard.press('Enter');
    equal(await page.locator('.find-count').textContent(), '1 of 6', 'the count at the first');
    await page.locator('.find-field[name=replace]').fill('spline');
    await page.getByRole('button', { name: 'Replace all' }).click();
    await settle(page);
    equal(await textOf(page), before.replaceAll('bezier', 'spline'), 'the replaced text');
    await page.keyboard.press('Escape');
    equal(await page.locator('.find').count(), 0, 'panels after Escape');
    await undone('one undo of replacing all');
    return 'drag, keys, colours, meanings, folds, search';
}
