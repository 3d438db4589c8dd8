// A misspelt key is reported as `carom check --json` reports it, at the same place.
import { spawnSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { equal, settle, textOf } from './harness.mjs';

export async function check({ page, path, carom }) {
    const text = readFileSync(path, 'utf8');
    const from = text.indexOf('toward');
    await page.evaluate(([a, b]) => window.studio.edit.type(a, b, 'towrad'),
        [from, from + 'toward'.length]);
    await settle(page);
    const shown = await page.evaluate(() => window.studio.state.problems.value.list
        .map(({ severity, place, message }) =>
            ({ severity, line: place.line, column: place.column, message })));
    writeFileSync(path, await textOf(page));
    const said = JSON.parse(spawnSync(carom, ['check', '--json', path]).stdout.toString())
        .map(({ severity, line, column, message }) => ({ severity, line, column, message }));
    equal(shown, said, 'the problems');
    equal(said.some(({ message }) => message.includes("'toward'")), true, 'a hint');
    equal(await page.evaluate(() => window.studio.state.isStale.value), true,
        'whether the motion is stale');
    equal(await page.locator('.cm-lint-marker-error').count() > 0, true, 'a mark in the text');
    return `${said.length} problem${said.length === 1 ? '' : 's'}, as carom check says`;
}
