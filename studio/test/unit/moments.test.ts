/// Moments as the strip of time names and writes them.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { momentOf, parseMoment, writeMoment } from '../../src/motion/moments';
import type { TimelineEvent } from '../../src/protocol';

function event(kind: string, time: number, a: string, b = ''): TimelineEvent {
    return { kind, time, end_time: time, a, b, place: [0, 0, 0], impulse: 0, text: '' };
}

test('an event is named by its kind and by how often it has happened', () => {
    const events = [
        event('strike', 0.5, 'cue'), event('impact', 0.8, 'cue', 'one'),
        event('impact', 1, 'cue', 'cushion'), event('impact', 1.004, 'cue', 'cushion'),
        event('impact', 2, 'cue', 'cushion'), event('potted', 3, 'one', 'corner_left_front'),
        event('rolling', 3.5, 'cue'), event('resting', 4, 'cue'), event('strike', 5, 'cue'),
    ];
    assert.deepEqual(events.map((one) => momentOf(one, events)), [
        '{strike: cue}', '{contact: [cue, one]}', '{cushion: cue}', null, '{cushion: cue, nth: 2}',
        '{potted: one}', null, '{resting: cue}', '{strike: cue, nth: 2}',
    ]);
});

test('a written moment is read with its delay, and written with another one', () => {
    const moment = parseMoment('{contact: [cue, one], before: 100 ms}');
    assert.deepEqual(moment, { what: 'contact: [cue, one]', delay: -0.1 });
    assert.equal(writeMoment(moment!, 0.25, 0.01), '{contact: [cue, one], after: 0.25 s}');
    assert.equal(writeMoment(moment!, 0.001, 0.01), '{contact: [cue, one]}');
    assert.equal(writeMoment(moment!, -0.5, 0.01), '{contact: [cue, one], before: 0.5 s}');
    assert.deepEqual(parseMoment('{after: 1 s, cushion: cue, nth: 2}'),
        { what: 'cushion: cue, nth: 2', delay: 1 });
    assert.deepEqual(parseMoment('{crossing: {object: cue, from: [0, 1], to: [1, 1]}, after: 2 s}'),
        { what: 'crossing: {object: cue, from: [0, 1], to: [1, 1]}', delay: 2 });
});

test('numbers and speed ramps are no moments', () => {
    assert.equal(parseMoment('1.5 s'), null);
    assert.equal(parseMoment('{from: 0.5 s, speeds: [[0 s, 1]]}'), null);
    assert.equal(parseMoment('{from: {strike: cue}, speeds: [[0 s, 1]]}'), null);
});
