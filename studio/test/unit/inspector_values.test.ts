// What is typed into the inspector, how a key is described, and where rows stand during a drag.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import type { Source } from '../../src/edit/edit';
import { applyEdits } from '../../src/edit/text_edit';
import { planSet } from '../../src/edit/plan';
import { describe } from '../../src/inspector/describe';
import { inPlace, type Field } from '../../src/inspector/field_model';
import { shownText, typedValue } from '../../src/inspector/typed_value';
import { keyAt, typesAt } from '../../src/schema/keys';
import type { Schema, ValueType } from '../../src/schema/value_types';
import type { KeyPath } from '../../src/protocol';

const schema = JSON.parse(
    readFileSync(join(__REPOSITORY__, 'configs/carom.schema.json'), 'utf8')) as Schema;

function source(text: string, kind: Source['kind'] = 'scalar'): Source {
    return { text, kind, file: '/x.yaml', line: 1, origin: 'shot' };
}

/// The text after a value was typed at a path.
function typedInto(text: string, path: KeyPath, next: string): string {
    const { value } = typedValue(next, typesAt(schema, path));
    assert.notEqual(value, null);
    const file = { file: '/x.yaml', name: 'x.yaml', text, writable: true };
    return applyEdits(text, planSet([file], path, value as string, { unit: '' }).edits);
}

test('TypedValue_TextWithSignsOfYaml_IsQuoted', () => {
    const text = 'cameras: [{name: wide, fov: 40 deg}]\n';
    for (const name of ['Break #1', 'a: b', 'one, two', '{x}', '#5', 'on']) {
        assert.equal(typedInto(text, ['cameras', '0', 'name'], name),
            `cameras: [{name: ${JSON.stringify(name)}, fov: 40 deg}]\n`);
    }
    assert.equal(typedInto(text, ['cameras', '0', 'name'], 'Break 1'),
        'cameras: [{name: Break 1, fov: 40 deg}]\n');
});

test('TypedValue_QuantitiesAndLists_StayAsTheyAreTyped', () => {
    const text = 'balls:\n  cue: {at: [0, 0]}\n';
    assert.equal(typedInto(text, ['balls', 'cue', 'at'], '[1 cm, 2 cm]'),
        'balls:\n  cue: {at: [1 cm, 2 cm]}\n');
    const film = 'cameras: [{fov: 40 deg}]\n';
    assert.equal(typedInto(film, ['cameras', '0', 'fov'], '35 deg'), 'cameras: [{fov: 35 deg}]\n');
    assert.equal(typedInto(film, ['cameras', '0', 'fov'], '3 deg # x'),
        'cameras: [{fov: "3 deg # x"}]\n');
});

test('TypedValue_BrokenList_IsRefused', () => {
    const list = typesAt(schema, ['balls', 'cue', 'at']);
    for (const text of ['[1, 2', '[1, 2] # x', '[1, 2], {a']) {
        assert.equal(typedValue(text, list).value, null, text);
    }
});

test('ShownText_OfAQuotedText_HasNoQuotes', () => {
    assert.equal(shownText(source('"#c8323f"')), '#c8323f');
    assert.equal(shownText(source("'it''s'")), "it's");
    assert.equal(shownText(source('plain')), 'plain');
    assert.equal(shownText(source('[1, "a"]', 'list')), '[1, "a"]');
    assert.equal(shownText(null), '');
});

function field(path: KeyPath, more: Partial<Field> = {}): Field {
    return { path, name: path.at(-1) ?? '', info: keyAt(schema, path),
        types: typesAt(schema, path) as ValueType[], source: null, origin: 'absent', parts: [], ...more };
}

test('Describe_AKey_SaysMeaningUnitRangeDefaultAndOrigin', () => {
    const own = describe(field(['cameras', '0', 'fade'],
        { origin: 'include', source: { ...source('0.2 s'), file: '/home/me/felt.yaml', line: 7 } }));
    assert.match(own.meaning, /^[A-Z].*\.$/);
    assert.match(own.facts, /^Unit s · 0 s to .* · Default 0.* · From felt\.yaml, line 7$/);
    const absent = describe(field(['cameras', '0', 'aperture']));
    assert.match(absent.facts, /^Unit /);
    assert.match(absent.facts, /Not in the text$/);
});

test('InPlace_ADefaultThatGotAValue_KeepsItsPlace', () => {
    const [a, b, c, d] = ['a', 'b', 'c', 'd'].map((name) => field(['x', name])) as
        [Field, Field, Field, Field];
    const { given, more } = inPlace({ given: [a, c], more: [b, d] }, ['x/b', 'x/c', 'x/d']);
    assert.deepEqual(given, [a]);
    assert.deepEqual(more, [b, c, d]);
});
