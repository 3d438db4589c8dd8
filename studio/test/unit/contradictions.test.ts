/// Gestures on keys of which only one may be given, such as the ways to aim a strike.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { beforeEach, test } from 'node:test';
import { applyChanges, beginGesture } from '../../src/edit/edit';
import { rivalsFor } from '../../src/edit/schema_facts';
import { keyStep, endKeyRun } from '../../src/input/key_run';
import { rivalsOf } from '../../src/schema/keys';
import { schema } from '../../src/schema/schema';
import type { Schema } from '../../src/schema/value_types';
import { buffers, textOf } from '../../src/text/buffers';
import { takeFiles } from '../../src/text/take_files';
import { undoStep } from '../../src/text/undo_commands';

const all = JSON.parse(
    readFileSync(join(__REPOSITORY__, 'configs/carom.schema.json'), 'utf8')) as Schema;
const kStrike = ['events', '0', 'strike'];
const kAim = [...kStrike, 'direction'];

function open(text: string): void {
    buffers.value = [];
    takeFiles([{ file: '/a.yaml', name: 'a.yaml', text, hash: 'a', writable: true, changed: false }]);
}

const shown = () => textOf(buffers.value[0]!);

beforeEach(() => { schema.value = all; });

test('RivalsOf_Keys_AreThoseThatContradictThem', () => {
    const of = (path: string) => rivalsOf(all, path.split('.')).sort();
    assert.deepEqual(of('events.0.strike.direction'),
        ['cut', 'fullness', 'hit', 'in', 'of', 'pot', 'side', 'through', 'toward']);
    assert.deepEqual(of('events.0.strike.hit'),
        ['cut', 'direction', 'in', 'of', 'pot', 'through', 'toward']); // `side` belongs to it, too
    assert.deepEqual(of('events.0.strike.speed'), ['ball_speed']);
    assert.deepEqual(of('events.0.strike.tip'), []);
    assert.deepEqual(of('balls.cue.at'), ['touching']);
    assert.deepEqual(of('cameras.0.fov'), ['focal_length']);
    assert.deepEqual(of('objects.x.axes'), ['rotate', 'scale']);
    assert.ok(of('objects.x.box').includes('sphere'));
    assert.ok(of('events.0.strike').includes('impulse'));
});

test('Gesture_DirectionOnEveryFormOfAStrike_LeavesOneWayToAim', () => {
    for (const [before, after] of [
        ['{ball: cue, toward: one, speed: 3 m/s}', '{ball: cue, direction: 17 deg, speed: 3 m/s}'],
        ['{ball: cue, toward: [1, 0.2], speed: 3}', '{ball: cue, direction: 17 deg, speed: 3}'],
        ['{ball: cue, direction: 5 deg, speed: 3}', '{ball: cue, direction: 17 deg, speed: 3}'],
        ['{toward: one, direction: 5 deg, speed: 3}', '{direction: 17 deg, speed: 3}'],
        ['{ball: cue, speed: 3}', '{ball: cue, speed: 3, direction: 17 deg}'],
        ['{ball: cue, pot: one, speed: 3}', '{ball: cue, direction: 17 deg, speed: 3}'],
        ['{ball: cue, pot: one, in: top left, speed: 3}', '{ball: cue, speed: 3, direction: 17 deg}'],
        ['{cut: 30 deg, of: one, side: left, speed: 3}', '{speed: 3, direction: 17 deg}'],
        ['\n      toward: one  # aim\n      speed: 3', '\n      direction: 17 deg  # aim\n      speed: 3'],
    ] as const) {
        const text = `events:\n  - strike: ${before}\n`;
        open(text);
        const gesture = beginGesture();
        for (const degrees of [3, 9, 17]) {
            gesture.update([{ path: kAim, value: degrees * Math.PI / 180, precision: 0.1 * Math.PI / 180 }]);
        }
        gesture.commit('Aim');
        assert.equal(shown(), `events:\n  - strike: ${after}\n`);
        assert.ok(undoStep(true));
        assert.equal(shown(), text);
    }
});

test('Gesture_DirectionOfARepeatedStrike_ReplacesTheAimOfACopy', () => {
    open('s: &s {ball: cue, toward: one, speed: 3}\nevents:\n  - strike: *s\n');
    const result = applyChanges([{ path: kAim, value: 0.5, precision: 1e-3 }], 'Aim');
    result.choices.find(({ label }) => label === 'Only here')?.apply();
    assert.match(shown(), /- strike: \{ball: cue, speed: 3, direction: [\d.]+ deg\}/);
    assert.match(shown(), /^s: &s \{ball: cue, toward: one, speed: 3\}$/m);
});

test('ApplyChanges_OfEachKeyWithRivals_LeavesItAlone', () => {
    for (const path of ['events.0.strike.ball_speed', 'balls.cue.touching', 'cameras.0.focal_length',
        'cameras.0.f_number', 'objects.x.mass', 'annotations.0.arrow.direction', 'output.crf']) {
        const keys = path.split('.');
        const [name = ''] = keys.slice(-1);
        for (const rival of rivalsFor(keys)) {
            const nest = (deep: string[]): string => deep.length === 0 ? `{${rival}: 1, other: 2}`
                : /^\d+$/.test(deep[0]!) ? `[${nest(deep.slice(1))}]`
                    : `{${deep[0]}: ${nest(deep.slice(1))}}`;
            open(`${nest(keys.slice(0, -1))}\n`);
            assert.ok(applyChanges([{ path: keys, value: { yaml: '5' } }], 'Set').ok, path);
            assert.ok(shown().includes(`{${name}: 5, other: 2}`), `${path}: ${shown()}`);
        }
    }
});

/// The presses that follow the server's answer know of another strike than the text before them.
test('KeyStep_AfterTheServerAnswered_WritesAsTheFirstPress', () => {
    const listeners = globalThis as unknown as { window?: unknown };
    listeners.window ??= Object.assign(globalThis, {
        addEventListener: () => undefined, removeEventListener: () => undefined,
    });
    open('events:\n  - strike: {ball: cue, at: 0.2 s, toward: one, speed: 3 m/s}\n');
    schema.value = null;  // without it, nothing tells that the keys contradict each other
    for (const toward of ['one', '', '']) {
        keyStep({
            id: 'aim', label: 'Aim', start: 0, next: (from: number) => from + 1,
            changes: (degrees) => toward === ''
                ? [{ path: kAim, value: degrees }] : [{ path: [...kStrike, 'toward'], value: `b${degrees}` }],
        });
    }
    endKeyRun();
    assert.equal(shown(), 'events:\n  - strike: {ball: cue, at: 0.2 s, toward: b3, speed: 3 m/s}\n');
});
