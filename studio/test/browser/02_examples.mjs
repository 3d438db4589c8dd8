// Opening every example, one after the other, changes no file and makes none but the cache and the
// list of recent shots. Of a film of several shots the text and the parts are shown.
import { readdirSync, readFileSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { equal } from './harness.mjs';

/// The contents of all files of a folder but those of the program's own, by their paths.
function contents(folder) {
    return Object.fromEntries(readdirSync(folder, { recursive: true }).map(String).sort()
        .filter((name) => !/^(cache|state)(\/|$)/.test(name))
        .filter((name) => statSync(join(folder, name)).isFile())
        .map((name) => [name, readFileSync(join(folder, name), 'latin1')]));
}

export async function check({ page, folder }) {
    const before = contents(folder);
    const names = readdirSync(join(folder, 'examples')).filter((name) => name.endsWith('.yaml'));
    for (const name of names) {
        await page.evaluate((file) => window.studio.open(file), `examples/${name}`);
        const isSequence = /^film:/m.test(before[`examples/${name}`]);
        await page.waitForFunction(([file, needsShot]) =>
            window.studio.state.files.value[0]?.file.endsWith(`/${file}`)
            && (needsShot ? window.studio.state.shot.value?.objects.length > 0
                : window.studio.state.sequence.value?.parts.length > 0)
            && window.studio.edit.text().length > 0, [name, !isSequence]);
        equal(await page.evaluate(() => window.studio.edit.text()),
            readFileSync(join(folder, 'examples', name), 'utf8'), `the text of ${name}`);
    }
    equal(Object.keys(contents(folder)), Object.keys(before), 'the files');
    equal(contents(folder), before, 'the contents of the files');
    return `${names.length} examples were opened and no file changed`;
}
