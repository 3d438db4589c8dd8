/// What the server's messages change, and when.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { effect } from '@preact/signals';
import { forgetVersions, receive } from '../../src/connection/receive';
import { kCamerasType, kTimelineType } from '../../src/protocol';
import { cameraFrames, shot, timeline } from '../../src/state/state';

function tellShot(v: number, moves: boolean): void {
    receive(JSON.stringify({ t: 'shot', v, moves, name: `shot ${v}` }));
}

/// A message with a head and no numbers.
function tellHead(type: number, v: number): void {
    const head = new TextEncoder().encode(JSON.stringify({ v }).padEnd(24));
    const bytes = new Uint8Array(8 + head.length);
    const numbers = new DataView(bytes.buffer);
    numbers.setUint32(0, type, true);
    numbers.setUint32(4, head.length, true);
    bytes.set(head, 8);
    receive(bytes.buffer);
}

/// The versions of the shot, its cameras and its motion, one row for each change.
function watch(): { rows: (number | undefined)[][]; end: () => void } {
    const rows: (number | undefined)[][] = [];
    const end = effect(() => {
        rows.push([shot.value?.v, cameraFrames.value?.head.v, timeline.value?.head.v]);
    });
    return { rows, end };
}

test('Receiving_ShotWithMotion_IsShownWithItAtOnce', () => {
    forgetVersions();
    const { rows, end } = watch();
    tellShot(1, true);
    tellHead(kCamerasType, 1);
    tellHead(kTimelineType, 1);
    tellShot(2, true);
    tellHead(kTimelineType, 2); // the cameras are the same
    end();
    assert.deepEqual(rows, [[undefined, undefined, undefined], [1, 1, 1], [2, 1, 2]]);
});

test('Receiving_ShotAtRest_IsShownWithoutMotion', () => {
    forgetVersions();
    const { rows, end } = watch();
    tellShot(1, false);
    tellShot(1, true);
    tellHead(kTimelineType, 1);
    end();
    assert.deepEqual(rows.slice(1), [[1, undefined, undefined], [1, undefined, 1]]);
});

test('Receiving_NewerShot_TakesThePlaceOfTheOneThatWaits', () => {
    forgetVersions();
    const { rows, end } = watch();
    tellShot(1, true);
    tellShot(2, false);
    tellHead(kTimelineType, 1);
    end();
    assert.deepEqual(rows.slice(1), [[2, undefined, undefined], [2, undefined, 1]]);
});
