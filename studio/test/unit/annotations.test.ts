// Annotations of the page: their names, where and when they are on the picture, their keys, entries.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { fieldsOfKind, type Texts } from '../../src/inspector/field_model';
import { annotationName, withoutValues } from '../../src/outline/annotation_name';
import type { ShotAnnotation } from '../../src/protocol';
import { keysAt } from '../../src/schema/keys';
import type { Schema } from '../../src/schema/value_types';
import { snippetsFor } from '../../src/text/complete/snippets';
import { annotationAt, isDrawnAt, movedCentre, onPicture } from '../../src/view/annotation_boxes';

const schema = JSON.parse(
    readFileSync(join(__REPOSITORY__, 'configs/carom.schema.json'), 'utf8')) as Schema;

test('AnnotationName_SaysWhatItIsAbout', () => {
    assert.equal(annotationName({ kind: 'path', subject: 'cue' }), 'path of cue');
    assert.equal(annotationName({ kind: 'ghost', subject: 'cue, one' }), 'ghost of cue on one');
    assert.equal(annotationName({ kind: 'angle', subject: 'cue, one' }), 'angle of cue, one');
    assert.equal(annotationName({ kind: 'text', subject: '' }), 'text');
});

test('WithoutValues_LeavesBracesThatAreMeant', () => {
    assert.equal(withoutValues('{cue.speed:.1f} m/s {{x}}'), '… m/s {x}');
});

test('IsDrawnAt_EachEndHasItsClock', () => {
    const one = { from: { time: 2, is_scene_time: false }, to: { time: 1, is_scene_time: true } };
    assert.equal(isDrawnAt(one, 1.9, 0.5), false);
    assert.equal(isDrawnAt(one, 2, 0.5), true);
    assert.equal(isDrawnAt(one, 3, 1), false);
    assert.equal(isDrawnAt({}, 0, 0), true);
});

function boxed(index: number, centre: [number, number], size: [number, number]): ShotAnnotation {
    return { path: ['annotations', String(index)], kind: 'text', subject: '', text: 'a', box: { centre, size } };
}

test('AnnotationAt_TheOneOnTopCounts', () => {
    const all = onPicture([boxed(0, [0.5, 0.5], [0.4, 0.2]), boxed(1, [0.6, 0.5], [0.2, 0.1]),
        { path: ['annotations', '2'], kind: 'path', subject: 'cue', text: '' }]);
    assert.equal(all.length, 2);
    assert.equal(annotationAt(all, 0.6, 0.52)?.path[1], '1');
    assert.equal(annotationAt(all, 0.35, 0.5)?.path[1], '0');
    assert.equal(annotationAt(all, 0.6, 0.7), undefined);
});

test('MovedCentre_StaysOnThePicture', () => {
    const box = { centre: [0.5, 0.5] as [number, number], size: [0.4, 0.2] as [number, number] };
    assert.deepEqual(movedCentre(box, 0.1, -0.12345), [0.6, 0.377]);
    assert.deepEqual(movedCentre(box, 2, -2), [0.8, 0.1]);
    assert.deepEqual(movedCentre({ ...box, size: [1.5, 0.2] }, 0.3, 0), [0.5, 0.5]);
});

/// "- path: {of: cue}", "  from: 1 s"
const texts: Texts = {
    keysOf: (path) => path.length === 2 ? ['path', 'from'] : path.length === 3 ? ['of'] : [],
    originOf: () => 'shot',
    sourceOf: (path) => {
        const [, , first = '', second = ''] = path;
        const text = ({ path: '{of: cue}', from: '1 s' } as Record<string, string>)[first];
        const isMap = first === 'path' && path.length === 3;
        return text === undefined || (path.length > 3 && second !== 'of') ? null
            : { text, kind: isMap ? 'map' : 'scalar', file: '/x.yaml', line: 1, origin: 'shot' };
    },
};

test('FieldsOfKind_ListsTheKeysBelowAndBesideTheKind', () => {
    const { given, more } = fieldsOfKind(schema, texts, ['annotations', '0'], 'path');
    assert.deepEqual(given.map(({ path }) => path.slice(2).join('.')), ['path.of', 'from']);
    const names = more.map(({ name }) => name);
    for (const name of ['marks', 'length', 'to', 'fade', 'colour', 'dash']) {
        assert.ok(names.includes(name), name);
    }
    for (const name of ['position', 'aim', 'text', 'of']) {
        assert.ok(!names.includes(name), name);
    }
});

test('KeysAt_KeysOfOtherKinds_AreLeftOut', () => {
    const names = (present: string[]) => keysAt(schema, ['annotations', '0'], present).map(({ name }) => name);
    assert.ok(names(['text']).includes('position'));
    assert.ok(!names(['text']).includes('dash'));
    assert.ok(names(['from']).includes('dash'));  // of no kind yet
    assert.ok(names(['from']).includes('path'));
});

test('Snippets_OfAnnotations_FitOneLine', () => {
    const names = { balls: ['cue', 'one'], objects: [], materials: [], lights: [], cameras: [],
        surfaces: [], spots: [], pockets: [] };
    const kinds = (some: typeof names) => snippetsFor(['annotations'], some, 0);
    assert.ok(kinds(names).every(({ yaml }) => !yaml.includes('\n')));
    assert.ok(kinds(names).some(({ yaml }) => yaml === 'ghost: {of: ${cue}, on: ${one}}'));
    assert.ok(!kinds({ ...names, balls: ['cue'] }).some(({ yaml }) => yaml.startsWith('ghost')));
});
