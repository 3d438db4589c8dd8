// The start page: a new shot from a template and from an example, recent shots, another name.
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { equal, settle } from './harness.mjs';

export const shot = '';

/// Waits until a shot is shown and all is answered.
async function shows(page, file) {
    await page.waitForFunction((name) => window.studio.state.welcome.value?.shot.endsWith(name)
        && window.studio.state.problems.value?.complete, `/${file}`);
    await settle(page);
}

async function keep(page, name) {
    if (process.env.CAROM_STUDIO_SHOTS) {
        await page.screenshot({ path: join(process.env.CAROM_STUDIO_SHOTS, `${name}.png`) });
    }
}

export async function check({ page, folder }) {
    const dialog = (words) => page.locator('dialog', { hasText: words });
    await page.waitForFunction(() =>
        window.studio.state.start.value.templates.every(({ still }) => still !== ''));
    await page.waitForFunction(() => [...document.querySelectorAll('.card img')]
        .slice(0, 8).every((image) => image.complete && image.naturalWidth > 0));
    equal(await page.locator('.card').count(), 30, 'cards of 8 templates and 22 examples');
    await keep(page, '01_start_page');

    // By keyboard only: the second template, a name, Enter.
    await page.locator('.card').first().focus();
    await page.keyboard.press('ArrowRight');
    equal(await page.locator('.card[aria-checked=true]').getAttribute('data-name'), 'bank',
        'the chosen card');
    await page.fill('input[name=name]', 'first');
    await page.keyboard.press('Enter');
    await shows(page, 'first.yaml');
    equal(existsSync(join(folder, 'first.yaml')), true, 'the new file');
    equal(await page.evaluate(() => window.studio.state.hasErrors.value), false, 'errors');

    // An example that needs other files, under a name that is taken first.
    await page.click('button:has-text("File")');
    await keep(page, '01_file_menu');
    await page.click('[role=menuitem]:has-text("New")');
    await page.locator('.recent', { hasText: 'first' }).waitFor();
    await page.locator('.card[data-name=tower]').click();
    await page.fill('input[name=name]', 'first');
    await page.click('.create');
    const before = readFileSync(join(folder, 'first.yaml'), 'utf8');
    await keep(page, '01_exists');
    await dialog('exists already').waitFor();
    await page.click('dialog button:has-text("Keep it")');
    equal(readFileSync(join(folder, 'first.yaml'), 'utf8'), before, 'the file that exists');
    await page.fill('input[name=name]', 'my_tower');
    await page.click('.create');
    await shows(page, 'my_tower.yaml');
    equal(existsSync(join(folder, 'assets/ramp.obj')), true, 'the mesh of the example');

    // Another name for changed text; the file of the first name stays as it was.
    await page.evaluate(() => window.studio.edit.type(0, 0, '# mine\n'));
    await settle(page);
    await page.keyboard.press('Control+Shift+S');
    await dialog('Save as').waitFor();
    await keep(page, '01_save_as');
    await page.fill('dialog input', 'examples/other');
    await page.keyboard.press('Enter');
    await shows(page, 'examples/other.yaml');
    equal(readFileSync(join(folder, 'examples/other.yaml'), 'utf8').startsWith('# mine\n'), true,
        'the text of the page in the new file');
    equal(readFileSync(join(folder, 'my_tower.yaml'), 'utf8').startsWith('# mine\n'), false,
        'the text of the page in the old file');
    equal(await page.evaluate(() => window.studio.state.hasErrors.value), false, 'errors');

    // The recent shots, and one opened through the folders.
    await page.click('button:has-text("File")');
    await page.click('[role=menuitem]:has-text("Open")');
    await dialog('Open a shot').locator('.entries button').first().waitFor();
    await keep(page, '01_open');
    await page.waitForFunction(() => document.activeElement.closest('.entries') !== null);
    await page.click('.ways_to button >> nth=0');
    await page.click('.entries button:has-text("first.yaml")');
    await shows(page, 'first.yaml');
    equal(await page.evaluate(() => window.studio.state.start.value.recent.length > 0), true,
        'recent shots in the menu');
    return 'new shots from a template and an example, save as, open and recent shots';
}
