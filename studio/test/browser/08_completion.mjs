// Completion offers every key of the schema at its place, the names of the balls after `toward:`,
// units after numbers, and whole entries that carom accepts.
import { equal, settle, textOf } from './harness.mjs';

/// The keys of all maps below a part of the schema, as {path, keys, companions}; each definition once.
/// Companions, [key, partner], are offered beside their partner only.
function mapsBelow(schema, node, path, known, found) {
    const { $ref, properties, items, additionalProperties, anyOf = [], allOf = [] } = node;
    if ($ref) {
        const name = $ref.replace('#/definitions/', '').replace('-(merged)', '');
        if (!known.has(name)) {
            known.add(name);
            mapsBelow(schema, schema.definitions[$ref.replace('#/definitions/', '')], path, known, found);
        }
        return;
    }
    if (properties) {
        const partners = Object.entries(properties)
            .map(([key, value]) => [key, value['x-only-with']?.[0]]);
        found.push({
            path,
            keys: partners.filter(([, partner]) => !partner).map(([key]) => key),
            companions: partners.filter(([, partner]) => partner),
        });
        for (const [key, value] of Object.entries(properties)) {
            mapsBelow(schema, value, [...path, key], known, found);
        }
    }
    if (items) {
        mapsBelow(schema, items, [...path, 0], known, found);
    }
    if (additionalProperties) {
        mapsBelow(schema, additionalProperties, [...path, 'name'], known, found);
    }
    for (const one of [...anyOf, ...allOf]) {
        mapsBelow(schema, one, path, known, found);
    }
}

/// A text that ends where a key of the map at `path` would be written: in lines, or in brackets.
function textUpTo(path, isFlow) {
    if (isFlow) {
        return path.slice(1).reduce((text, key) =>
            key === 0 ? `${text}[` : `${text}{${key}: `, path.length > 0 ? `${path[0]}: ` : '')
            + (path.length > 0 ? '{' : '');
    }
    let text = '';
    let indent = 0;
    let isAfterDash = false;
    for (const key of path) {
        text += isAfterDash ? '' : ' '.repeat(indent);
        text += key === 0 ? '- ' : `${key}:\n`;
        isAfterDash = key === 0;
        indent += 2;
    }
    return isAfterDash ? text : text + ' '.repeat(indent);
}

/// Types into the editor, with the list of what is offered shown.
async function offered(page, text) {
    await page.keyboard.type(text);
    await page.locator('.cm-tooltip-autocomplete li').first().waitFor();
    // A list that has only just appeared takes no keys, so that Enter is not caught by accident.
    const shown = await page.evaluate(() => performance.now());
    await page.waitForFunction((since) => performance.now() > since + 80, shown);
    return page.locator('.cm-tooltip-autocomplete .cm-completionLabel').allTextContents();
}

async function cursorAfter(page, line, column) {
    await page.evaluate(([l, c]) => {
        const { state } = window.studio.editor.view;
        const at = l < 0 ? state.doc.length : state.doc.line(l).from + c;
        window.studio.editor.view.dispatch({ selection: { anchor: at } });
        window.studio.editor.view.focus();
    }, [line, column]);
}

export async function check({ page }) {
    const schema = await page.evaluate(async () => (await fetch(`/${localStorage.getItem('carom.read_key')}/schema.json`)).json());
    const maps = [];
    mapsBelow(schema, schema, [], new Set(), maps);
    let count = 0;
    for (const { path, keys, companions } of maps) {
        for (const [key, partner] of companions) {
            const text = `${textUpTo(path, true)}${partner}: 1, `;
            const labels = await page.evaluate(
                (words) => window.studio.labelsAt(words, words.length), text);
            equal(labels.includes(key), true, `${key} beside ${partner} at ${path.join('.')}`);
            count += 1;
        }
        for (const isFlow of [false, true]) {
            const text = textUpTo(path, isFlow);
            const labels = await page.evaluate(
                (words) => window.studio.labelsAt(words, words.length), text);
            const missing = keys.filter((key) => !labels.includes(key));
            equal(missing, [], `keys that are not offered at ${path.join('.')}: ${text}`);
            count += keys.length;
        }
    }
    equal(maps.length > 60, true, `${maps.length} maps`);

    const before = await textOf(page);
    const lines = before.split('\n');
    const strike = lines.findIndex((line) => line.includes('toward'));
    const line = lines[strike];
    await page.evaluate((text) => window.studio.edit.type(text.indexOf('one, elevation'),
        text.indexOf('one, elevation') + 'one'.length, ''), before);
    await cursorAfter(page, strike + 1, line.indexOf('toward: ') + 'toward: '.length);
    const balls = await offered(page, 'n');
    equal(balls.includes('nine'), true, `balls after toward: (${balls})`);
    await page.keyboard.press('Enter');
    await settle(page);
    equal((await textOf(page)).split('\n')[strike], line.replace('toward: one', 'toward: nine'),
        'the line of the strike');

    await cursorAfter(page, strike + 1, line.indexOf('8 m/s') + 1);
    await page.keyboard.press('ArrowRight');
    await page.keyboard.press('Shift+End');
    const units = await offered(page, ' k');
    equal(units, ['km/h'], 'units');
    await page.keyboard.press('Tab');
    await page.keyboard.type('}');
    await settle(page);
    equal((await textOf(page)).split('\n')[strike].endsWith('speed: 8 km/h}'), true, 'the unit');

    await cursorAfter(page, strike + 1, 0);
    await page.keyboard.press('End');
    const entries = await offered(page, '\n- fo');
    equal(entries[0], 'force', 'the entry that is offered first');
    await page.keyboard.press('Enter');
    await settle(page);
    const problems = await page.evaluate(() =>
        window.studio.state.problems.value.list.filter(({ severity }) => severity === 'error'));
    equal(problems, [], 'errors of the new entry');
    return `${count} keys of ${maps.length} maps at their places, in lines and in brackets`;
}
