// By the keyboard alone: a ball is selected and nudged, struck harder, and the film scrubbed. axe finds
// no serious or critical fault, in dark and in light.
import { faults } from './axe.mjs';
import { changedLines, equal, holdFilm, settle, textOf } from './harness.mjs';

function focused(page) {
    return page.evaluate(() => {
        const element = document.activeElement;
        return element === document.body ? ''
            : element?.getAttribute('aria-label') ?? element?.textContent ?? '';
    });
}

/// Presses a key until the focus is where it should be.
async function reach(page, key, words, most = 40) {
    for (let i = 0; i < most; ++i) {
        if ((await focused(page)).includes(words)) {
            return;
        }
        await page.keyboard.press(key);
    }
    throw new Error(`'${words}' is not reached by ${key}`);
}

/// Waits until the button with these words has the focus by itself.
function hasFocus(page, words) {
    return page.waitForFunction((text) => document.activeElement?.textContent === text, words);
}

export async function check({ page, pid }) {
    const before = await textOf(page);
    const state = (name) => page.evaluate((one) => window.studio.state[one].value, name);
    // The list of what the view shows: the cue ball.
    await reach(page, 'F6', 'ball one');
    await reach(page, 'PageDown', 'ball cue');
    await page.keyboard.press('Enter');
    equal(await state('selection'), ['balls', 'cue'], 'the selection');
    await page.keyboard.press('ArrowUp');
    await page.keyboard.press('ArrowUp');
    await page.waitForFunction(() => !window.studio.state.dragging.value);
    await settle(page);
    const [nudged] = changedLines(before, await textOf(page));
    equal(/^ {2}cue: \{at: \[-0\.7\d+, 0\.1\d*\]\}$/.test(nudged), true, nudged);

    // The strike, by the outline and its fields.
    await page.keyboard.press('/');
    await page.keyboard.type('strike');
    await reach(page, 'Tab', 'Events');
    await page.keyboard.press('ArrowDown');
    await page.keyboard.press('Enter');
    equal(await state('selection'), ['events', '0'], 'the selection');
    const speed = page.locator('.inspector').getByLabel('speed', { exact: true });
    await speed.focus();
    await page.keyboard.press('ArrowUp');
    await settle(page);
    equal(/speed: 8\.1 m\/s/.test(await textOf(page)), true, 'the speed after an arrow key');
    // Undo works in a field that shows the text; what is typed into it has an undo of its own.
    await page.keyboard.press('Control+z');
    await settle(page);
    equal(/speed: 8 m\/s/.test(await textOf(page)), true, 'the speed after undo in its field');
    await page.keyboard.press('Control+y');
    await settle(page);
    await page.keyboard.type('9');
    equal(await speed.inputValue() === '8.1 m/s', false, 'a draft');
    await page.keyboard.press('Control+z');
    await settle(page);
    equal([await speed.inputValue(), /speed: 8\.1 m\/s/.test(await textOf(page))], ['8.1 m/s', true],
        'the field and the text after undo of a draft');
    await reach(page, 'Shift+Tab', 'Where the tip hits the ball');
    await page.keyboard.press('Shift+ArrowLeft');
    await settle(page);
    equal(/tip: \[-0\.1, 0\.2\]/.test(await textOf(page)), true, 'the tip');

    await page.getByLabel('Playback speed').focus();
    await page.keyboard.press('Control+z');
    await settle(page);
    equal(/tip: \[0, 0\.2\]/.test(await textOf(page)), true, 'the tip after undo in a choice');
    await page.keyboard.press('Control+y');
    await settle(page);

    // The aim: the second press comes after the server has answered the first one.
    await page.getByLabel('Direction of the aim').focus();
    await page.keyboard.press('ArrowLeft');
    await settle(page);
    await page.keyboard.press('ArrowLeft');
    await settle(page);
    equal([/at: 0\.5 s, direction: -?[\d.]+ deg, elevation/.test(await textOf(page)), await page.evaluate(
        () => window.studio.state.hasErrors.value)], [true, false], 'the aim, and errors');
    for (let i = 0; i < 2 && !/toward: one/.test(await textOf(page)); ++i) {
        await page.keyboard.press('Control+z');  // once, unless the answer took longer than a pause of keys
        await settle(page);
    }
    equal(/toward: one/.test(await textOf(page)), true, 'the aim after undo');

    const aimed = await textOf(page);
    // T goes to the text, where what is typed is text.
    await page.locator('canvas').first().focus();
    await page.keyboard.press('t');
    await page.keyboard.type('# t');
    equal(/^ {2}- # tstrike/m.test(await textOf(page)), true, 'what is typed after T');
    for (let i = 0; i < 3 && await textOf(page) !== aimed; ++i) {
        await page.keyboard.press('Control+z');
        await settle(page);
    }
    equal(await textOf(page), aimed, 'the text after undo of what was typed');

    // Scrubbing, and the palette of commands.
    await reach(page, 'F6', 'Play head');
    await page.keyboard.press('Shift+ArrowRight');
    equal(Math.round(await state('filmTime') * 24), 10, 'the frame');
    await page.keyboard.press('Control+k');
    await page.getByRole('combobox', { name: 'Find a command' }).waitFor();
    await page.keyboard.type('camera slow');
    await page.keyboard.press('Enter');
    equal(await state('lookThrough'), 'slow', 'the camera that is looked through');
    equal(await page.evaluate(() => location.hash), '#t=0.417&camera=slow&select=events/0', 'the address');

    // A film: begun, left, and stopped.
    await page.keyboard.press('Control+Enter');
    await page.waitForFunction(() => document.activeElement?.closest('label')?.textContent
        .startsWith('Quality'));
    await page.keyboard.press('Tab');
    await page.keyboard.type('0-20');
    await page.keyboard.press('Enter');
    await page.waitForFunction(() => window.studio.films.film.value?.state === 'running');
    const goOn = await holdFilm(page, pid, 0);
    await reach(page, 'Tab', 'Stop');
    await page.keyboard.press('Enter');
    goOn();
    await page.waitForFunction(() => window.studio.films.film.value?.state === 'stopped');
    await hasFocus(page, 'Resume');
    await page.keyboard.press('Escape');

    const counts = [];
    for (const theme of ['dark', 'light']) {
        await page.evaluate((one) => { window.studio.state.theme.value = one; }, theme);
        for (const key of ['', '?', 'Control+k', 'Control+Enter', 'Control+Shift+E']) {
            if (key !== '') {
                await page.keyboard.press(key);
            }
            counts.push(...(await faults(page)).map((one) => `${theme} ${key} ${one}`));
            if (key !== '') {
                await page.keyboard.press('Escape');
                await page.waitForFunction(() => window.studio.state.panel.value === null);
            }
        }
    }
    equal(counts, [], 'what axe finds');
    return 'selected, nudged, struck, scrubbed and filmed by keys; axe finds nothing serious in dark and light';
}
