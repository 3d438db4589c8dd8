// A scene of the older format is dropped on the page, and three objects of it are added to the shot;
// each is taken back by one undo.
import { readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { equal, settle, textOf } from './harness.mjs';

const kScene = join(dirname(fileURLToPath(import.meta.url)),
    '../../../tests/examples/sample_scene.txt');

/// Drops a file with that text on the middle of the page, or elsewhere.
function drop(page, name, text, place = '.middle') {
    return page.evaluate(([file, content, on]) => {
        const transfer = new DataTransfer();
        transfer.items.add(new File([content], file, { type: 'text/plain' }));
        for (const type of ['dragover', 'drop']) {
            document.querySelector(on).dispatchEvent(new DragEvent(type,
                { dataTransfer: transfer, bubbles: true, cancelable: true }));
        }
    }, [name, text, place]);
}

async function keep(page, name) {
    if (process.env.CAROM_STUDIO_SHOTS) {
        await page.screenshot({ path: join(process.env.CAROM_STUDIO_SHOTS, `${name}.png`) });
    }
}

function undo(page) {
    return page.evaluate(() => window.studio.edit.travel(true));
}

export async function check({ page, folder }) {
    const scene = readFileSync(kScene, 'utf8');
    const before = await textOf(page);
    const dialog = page.locator('dialog');
    const errors = () => page.evaluate(() => window.studio.state.hasErrors.value);

    await drop(page, 'sample_scene.txt', scene);
    await dialog.waitFor();
    await keep(page, '19_dropped');
    await dialog.locator('button:has-text("Add some of it")').click();
    await dialog.locator('.part').first().waitFor();
    const objects = dialog.locator('.section', { hasText: 'Objects' }).locator('.part');
    const names = [];
    for (const i of [0, 1, 2]) {
        names.push(await objects.nth(i).locator('.name').textContent());
        await objects.nth(i).locator('input').check();
    }
    await keep(page, '19_add');
    await dialog.locator('button:has-text("Add 3")').click();
    await page.waitForFunction(
        () => window.studio.state.notice.value?.text.endsWith('added.'));
    await settle(page);
    const added = await textOf(page);
    equal(await errors(), false, 'errors after three objects are added');
    const shown = await page.evaluate(() => window.studio.state.shot.value.objects
        .map(({ name }) => name));
    for (const name of names) {
        equal(shown.includes(name), true, `the object ${name} in the view`);
    }
    equal(added.split('\n').filter((line) => !before.includes(line)).length >= 3, true,
        'lines that were added');
    await undo(page);
    equal(await textOf(page), before, 'the text after one undo of adding');
    await settle(page);

    await drop(page, 'sample_scene.txt', scene);
    await dialog.locator('button:has-text("Replace this shot")').click();
    await page.waitForFunction((text) => window.studio.edit.text() !== text, before);
    await settle(page);
    equal(await errors(), false, 'errors after the import');
    equal(/^carom: 1$/m.test(await textOf(page)), true, 'the imported shot');
    await undo(page);
    equal(await textOf(page), before, 'the text after one undo of the import');
    await settle(page);

    // A new shot whose name is taken: what was to be left without saving is still there.
    writeFileSync(join(folder, 'sample_scene.yaml'), 'carom: 1\n');
    await page.evaluate(() => window.studio.edit.applyChanges(
        [{ path: ['balls', 'cue', 'at', '1'], value: 0.2 }], 'Move cue'));
    const unsaved = await textOf(page);
    await drop(page, 'sample_scene.txt', scene);
    await dialog.locator('button:has-text("New shot")').click();
    equal(await dialog.locator('p').textContent(), 'The open shot has changes that are in no file yet. '
        + 'They are lost if you do not save them.', 'the question');
    await dialog.locator('button.danger:has-text("Do not save")').click();
    await dialog.locator('button:has-text("Keep it")').click();
    await settle(page);
    equal(await textOf(page), unsaved, 'the text after the name was taken');
    equal(await page.evaluate(() => window.studio.state.files.value[0].file.endsWith('break.yaml')), true,
        'the open shot');
    equal(await page.evaluate(() => window.studio.state.shot.value.objects
        .find(({ name }) => name === 'cue').position[1]), 0.2, 'what the server has');
    await undo(page);
    equal(await textOf(page), before, 'the text after undo');
    await settle(page);

    await drop(page, 'broken.txt', 'object {', '.cm-content');
    await dialog.locator('.notes.errors').waitFor();
    await dialog.locator('button:has-text("Close")').last().click();
    equal(await textOf(page), before, 'the text after a scene with errors');
    return `a scene is imported, and ${names.join(', ')} are added; one undo takes each back`;
}
