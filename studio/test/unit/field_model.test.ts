// What the inspector lists: what the text says, what stands behind it, and the rest.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { fieldsOf, type Texts } from '../../src/inspector/field_model';
import type { Schema } from '../../src/schema/value_types';

const schema = JSON.parse(
    readFileSync(join(__REPOSITORY__, 'configs/carom.schema.json'), 'utf8')) as Schema;

/// A camera that says its name, with a rig behind it that gives the field of view.
const texts: Texts = {
    keysOf: (path) => path.length === 2 ? ['include', 'name'] : [],
    originOf: (path) => path[2] === 'fov' ? 'config' : 'shot',
    sourceOf: (path) => {
        const text = { include: 'rigs/overhead.yaml', name: 'above', fov: '36 deg' }[path[2] ?? ''];
        return text === undefined ? null
            : { text, kind: 'scalar', file: '/x.yaml', line: 1, origin: 'shot' };
    },
};

test('FieldsOf_CameraWithARig_ListsWhatTheRigGives', () => {
    const { given, more } = fieldsOf(schema, texts, ['cameras', '0']);
    assert.deepEqual(given.map(({ name }) => name), ['include', 'name', 'fov']);
    assert.equal(given[2]?.origin, 'config');
    assert.equal(given[2]?.source?.text, '36 deg');
    assert.ok(more.some(({ name }) => name === 'aperture'));
    assert.ok(!more.some(({ name }) => name === 'fov'));
});
