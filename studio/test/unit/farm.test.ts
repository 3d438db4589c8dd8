// The numbers of the farm's page.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { chosen, stretches } from '../../src/farm/FrameTable';
import { memoryText, nameOf, secondsText } from '../../src/farm/farm_text';
import type { FrameRow } from '../../src/farm/farm_types';
import { rateCurve, roundedUp } from '../../src/farm/frame_rate';

function row(frame: number, more: Partial<FrameRow> = {}): FrameRow {
    return { frame, state: 'done', tries: 1, failures: 0, ...more };
}

test('a steady worker has a level curve', () => {
    const rows = Array.from({ length: 481 }, (_, i) => row(i, { ended: 1000 + 30 * i }));
    const curve = rateCurve(rows);
    assert.ok(curve);
    assert.deepEqual([curve.from, curve.to, curve.rates.length, curve.most], [1000, 15400, 48, 200]);
    curve.rates.slice(0, 47).forEach((rate) => assert.ok(Math.abs(rate - 120) < 1e-9));
    assert.ok(Math.abs((curve.rates[47] ?? 0) - 132) < 1e-9, 'the last bin has both its ends');
});

test('there is no curve of one moment, nor of frames that are missing', () => {
    assert.equal(rateCurve([]), null);
    assert.equal(rateCurve([row(1, { ended: 5 }), row(2, { ended: 5 })]), null);
    assert.equal(rateCurve([row(1, { ended: 5 }), row(2, { ended: 9, state: 'missing' })]), null);
});

test('round numbers for the axis', () => {
    assert.deepEqual([0.2, 1, 3, 5, 11, 99, 100, 2001].map(roundedUp), [1, 1, 5, 5, 20, 100, 100, 5000]);
});

test('filters let through what their names say', () => {
    const rows = [row(0, { seconds: 10 }), row(1, { seconds: 21, slow: 1 }), row(2, { seconds: 10, slow: 0, failures: 2 }),
        row(3, { state: 'rendering' }), row(4, { state: 'skipped' })];
    const numbers = (list: FrameRow[]) => list.map(({ frame }) => frame);
    assert.deepEqual(numbers(chosen(rows, 'slow')), [1]);
    assert.deepEqual(numbers(chosen(rows, 'failed')), [2]);
    assert.deepEqual(numbers(chosen(rows, 'rendering')), [3]);
    assert.deepEqual(numbers(chosen(rows, 'missing')), [3, 4]);
    assert.equal(chosen(rows, 'all').length, 5);
    assert.deepEqual(stretches(rows), [['done', 0, 3], ['rendering', 3, 1], ['skipped', 4, 1]]);
});

test('times, sizes and names', () => {
    assert.deepEqual([0.25, 9.96, 42.4, 99.9, 119.6, 7205].map(secondsText),
        ['0.3 s', '10.0 s', '42 s', '1 min 40 s', '2 min 0 s', '2 h 0 min']);
    assert.deepEqual([61276160, 1.44e9].map(memoryText), ['61 MB', '1.4 GB']);
    assert.equal(nameOf('/films/break.mp4'), 'break.mp4');
});
