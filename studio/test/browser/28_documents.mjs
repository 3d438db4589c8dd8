// Plan, report, speeds and contact sheet are shown as they stand in the page; exports have the bytes
// of the command line, and a file is replaced only after a question.
import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { kPatience, equal } from './harness.mjs';

export const shot = 'bank_shot.yaml';

export async function check({ page, path, folder, carom }) {
    const cache = join(folder, 'other');
    const direct = (words, name) => {
        const file = join(dirname(path), `direct_${name}`);  // an export names files as seen from its own folder
        execFileSync(carom, [...words, file, '--cache', cache, '-q', path], { stdio: 'ignore' });
        return readFileSync(file);
    };
    const tab = (name) => page.getByRole('tab', { name, exact: true }).click();
    await page.getByRole('button', { name: 'Plan, report and contact sheet' }).click();
    const plan = page.getByRole('img', { name: 'Plan' });
    await plan.waitFor();
    await page.waitForFunction(() => document.querySelector('img.plan')?.naturalWidth > 0);
    const bytes = await page.evaluate(async () =>
        (await fetch(document.querySelector('img.plan').src)).text());
    equal(bytes === direct(['plan', '-o'], 'plan.svg').toString(), true, 'the plan of carom plan');

    await tab('Report');
    await page.getByText('it never rises between force events').waitFor();
    await tab('Speeds and energy');
    await page.waitForFunction(() => document.querySelector('img.plot')?.naturalWidth > 0);
    const plot = await page.locator('img.plot').getAttribute('src');
    // Looking at the contact sheet saves nothing and renders nothing.
    await page.evaluate(() => window.studio.edit.applyChanges(
        [{ path: ['render', 'size'], value: [320, 180] }, { path: ['render', 'samples'], value: 4 }],
        'Make it smaller'));
    await page.evaluate(() => window.studio.idle());
    await page.waitForFunction((old) => { // the speeds of the newer motion
        const shown = document.querySelector('img.plot');
        return shown !== null && shown.getAttribute('src') !== old;
    }, plot);
    await page.getByText('Stop').waitFor({ state: 'detached' });
    const saved = readFileSync(path, 'utf8');
    await tab('Contact sheet');
    await page.getByText('have to be rendered').waitFor();
    await page.evaluate(() => window.studio.idle());
    equal(readFileSync(path, 'utf8'), saved, 'the file after a look at the contact sheet');
    equal(await page.getByText('Stop').count(), 0, 'what is being made');
    await page.getByRole('button', { name: 'Save and make' }).click();
    await page.waitForFunction(() => document.querySelector('img.contact_sheet')?.naturalWidth > 0,
        null, { timeout: kPatience });
    const width = await page.evaluate(() => document.querySelector('img.contact_sheet').naturalWidth);
    equal(readFileSync(path, 'utf8') !== saved, true, 'whether the shot was saved for the sheet');
    equal(width > 1280, true, `width of the contact sheet (${width})`);

    await tab('Export');
    const count = { written: 0 };
    for (const [label, name, words] of [
        ['Motion as a table', 'm.csv', ['export', '-o']],
        ['Motion and scene as JSON', 'm.json', ['export', '-o']],
        ['Scene as glTF', 'm.glb', ['export', '-o']],
        ['Scene as USD', 'm.usda', ['export', '-o']],
        ['Events as a table', 'e.csv', ['export', '--events']],
        ['The frame at the play head', 'f.png', ['frame', '-o']]]) {
        await page.getByRole('radio', { name: label }).check();
        await page.getByLabel('File (in the shot\'s folder)').fill(name);
        await page.getByRole('button', { name: 'Write', exact: true }).click();
        const file = join(dirname(path), name);
        await page.getByText(`${file} was written.`).first().waitFor({ timeout: kPatience });
        equal(readFileSync(file).equals(direct(words, name)), true, `the bytes of ${name}`);
        count.written += 1;
    }
    const mine = join(dirname(path), 'mine.csv');
    writeFileSync(mine, 'mine');
    await page.getByRole('radio', { name: 'Motion as a table' }).check();
    await page.getByLabel('File (in the shot\'s folder)').fill('mine.csv');
    await page.getByRole('button', { name: 'Write', exact: true }).click();
    await page.getByRole('button', { name: 'Keep it' }).click();
    equal(readFileSync(mine, 'utf8'), 'mine', 'a file that was there before');
    await page.getByLabel('File (in the shot\'s folder)').fill('../../elsewhere.csv');
    await page.getByRole('button', { name: 'Write', exact: true }).click();
    await page.getByRole('alert').filter({ hasText: 'files can be written below' }).waitFor();
    equal(existsSync(join(dirname(folder), 'elsewhere.csv')), false, 'a file elsewhere');
    return `plan, report, speeds and contact sheet are shown; ${count.written} exports have the bytes `
        + 'of the command line';
}
