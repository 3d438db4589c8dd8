// For broken shots the list of problems, the marks in the text and `carom check --json` agree; a
// click on a suggestion mends the text. All of tests/broken with CAROM_STUDIO_ALL=1.
import { spawnSync } from 'node:child_process';
import { cpSync, readdirSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { equal, settle, textOf } from './harness.mjs';

const kBroken = join(dirname(fileURLToPath(import.meta.url)), '../../../tests/broken');
const kSample = ['unknown_key', 'camera_paths', 'names', 'missing_include', 'contradiction_with_include',
    'apostrophe_in_quotes', 'empty_file', 'no_break_space'];

/// Opens another shot in the same page.
async function show(page, file) {
    const v = await page.evaluate((path) => window.studio.open(path), file);
    await page.waitForFunction(([path]) => window.studio.state.welcome.value?.shot === path
        && window.studio.state.files.value[0]?.file === path
        && window.studio.state.problems.value?.complete, [file, v]);
    await settle(page);
}

function line({ severity, line, column, message }) {
    return `${line}:${column} ${severity}: ${message}`;
}

/// What the page's list says, in the words of its lines.
async function listed(page) {
    return page.locator('.problems li').evaluateAll((all) => all.map((one) =>
        `${one.className}: ${one.querySelector('.message').textContent}`));
}

async function compare(page, carom, file) {
    await show(page, file);
    const said = JSON.parse(spawnSync(carom, ['check', '--json', file],
        { maxBuffer: 1 << 26 }).stdout.toString());
    const told = await page.evaluate(() => window.studio.state.problems.value.list.map(
        ({ severity, place, message, suggestion }) => ({ severity, file: place.file,
            line: place.line, column: place.column, message, suggestion })));
    equal(told.map(line), said.map(line), `${file}: the problems`);
    equal(await listed(page), said.map(({ severity, message }) => `${severity}: ${message}`),
        `${file}: the list`);
    const tabs = await page.evaluate(() => window.studio.state.files.value.map((one) => one.file));
    for (const [i, tab] of tabs.entries()) {
        const own = told.filter((one) => one.file === tab);
        if (own.length > 0 || i === 0) {
            await page.locator('.tab').nth(i).click();
            const marks = await page.evaluate(() => window.studio.editor.marks());
            equal(marks.map(line).sort(), own.map((one) => line({ ...one,
                line: Math.max(1, one.line), column: Math.max(1, one.column) })).sort(),
            `${tab}: the marks`);
        }
    }
    return told.length;
}

export async function check({ page, carom, folder }) {
    const copy = join(folder, 'broken');
    cpSync(kBroken, copy, { recursive: true });
    const all = readdirSync(copy).filter((name) => name.endsWith('.yaml'))
        .map((name) => name.replace('.yaml', ''));
    const names = process.env.CAROM_STUDIO_ALL ? all : kSample;
    const wrong = [];
    let count = 0;
    for (const name of names) {
        try {
            count += await compare(page, carom, join(copy, `${name}.yaml`));
        } catch (error) {
            wrong.push(`${name}: ${error.message}`);
        }
    }
    equal(wrong, [], 'shots that do not agree');

    // The suggestion of the list, then that of the tooltip.
    await show(page, join(folder, 'examples/nine_ball_break.yaml'));
    const before = await textOf(page);
    const misspell = async () => {
        const at = before.indexOf('toward');
        await page.evaluate(([from, to]) => window.studio.edit.type(from, to, 'towrad'),
            [at, at + 'toward'.length]);
        await settle(page);
    };
    await misspell();
    await page.locator('.problems .fix').click();
    await settle(page);
    equal(await textOf(page), before, 'the text after a click in the list');
    await misspell();
    await page.keyboard.press('Control+Shift+m');
    await page.waitForFunction(() => document.activeElement.matches('.problems .show'));
    await page.keyboard.press('Enter');
    await page.keyboard.press('Control+Shift+ArrowLeft');
    await page.locator('.cm-lintRange-error').first().hover();
    await page.locator('.cm-diagnosticAction').click();
    await settle(page);
    equal(await textOf(page), before, 'the text after a click in the tooltip');
    equal(await page.locator('.problems').count(), 0, 'lists of problems');
    return `${count} problems of ${names.length} shots: list, marks and carom check agree`;
}
