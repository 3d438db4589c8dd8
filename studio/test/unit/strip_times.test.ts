// Film times that the strip writes are exactly those of frames, as the server compares them.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { Change } from '../../src/edit/edit';
import type { Camera, ShotState } from '../../src/protocol';
import { clipHandles, endChanges, fadeChanges, startChanges }
    from '../../src/strip/handles/clip_handles';
import { fractionOf, timeText } from '../../src/strip/film_time';
import type { Layout } from '../../src/strip/layout';

const kRates: readonly [number, number][] = [[24, 1], [25, 1], [30, 1], [60, 1], [30000, 1001]];

/// A text as the server reads it: an exact fraction.
function read(text: string): [bigint, bigint] {
    const [, number = '', divisor = '1'] = /^([\d.]+)(?: ?\/ ?(\d+))? s$/.exec(text) ?? [];
    assert.notEqual(number, '', text);
    const decimals = number.split('.')[1]?.length ?? 0;
    return [BigInt(number.replace('.', '')), 10n ** BigInt(decimals) * BigInt(divisor)];
}

const equal = (a: [bigint, bigint], b: [bigint, bigint]) => a[0] * b[1] === b[0] * a[1];
const plus = (a: [bigint, bigint], b: [bigint, bigint]): [bigint, bigint] =>
    [a[0] * b[1] + b[0] * a[1], a[1] * b[1]];

function frameTime(frame: number, [p, q]: readonly [number, number]): [bigint, bigint] {
    return [BigInt(frame) * BigInt(q), BigInt(p)];
}

function camera(index: number, start: number, end: number, fade = 0): Camera {
    return { name: `c${index}`, path: ['cameras', String(index)], video_start: start, video_end: end,
        fade, scene_start: 0, scene_end: 1, speeds: [] } as unknown as Camera;
}

function shotOf(fps: number, ...cameras: Camera[]): ShotState {
    return { film: { fps }, cameras } as unknown as ShotState;
}

const written = (change: Change | undefined) => (change?.value as { yaml: string }).yaml;
const none = () => null;

test('StartChanges_AnyFrameAndRate_AreExact', () => {
    for (const rate of kRates) {
        const fps = rate[0] / rate[1];
        for (let frame = 1; frame <= 1000; ++frame) {
            const fade = (frame % 7) / fps;
            const shot = shotOf(fps, camera(0, 0, 20), camera(1, 20 - fade, 60, fade));
            const [start, end] = startChanges(shot, 1, frame / fps, none);
            assert.ok(equal(read(written(start)), frameTime(frame, rate)), `${frame} at ${fps}`);
            assert.ok(equal(read(written(end)), frameTime(frame + frame % 7, rate)),
                `${frame} at ${fps}: ${written(end)}`);
        }
    }
});

test('FadeChanges_AnyStartAndEnd_EndWhereTheCameraBeforeEnds', () => {
    for (const rate of kRates) {
        const fps = rate[0] / rate[1];
        for (let frame = 0; frame <= 1000; ++frame) {
            // Also a camera that does not begin on a frame.
            const begin = frame % 3 === 0 ? 1.2917 : (frame * rate[1]) / rate[0];
            const text = timeText(fractionOf(begin), null);
            const shot = shotOf(fps, camera(0, 0, begin), camera(1, begin, begin + 60));
            const [fade, end] = fadeChanges(shot, 1, begin + (frame % 11) / fps, none);
            assert.ok(equal(plus(read(text), read(written(fade))), read(written(end))),
                `${text} + ${written(fade)} = ${written(end)}`);
        }
    }
});

test('EndChanges_AFadeThatIsNoFrame_KeepsTheSum', () => {
    const shot = shotOf(24, camera(0, 0, 3.3), camera(1, 3, 8, 0.3));
    const [start, end] = startChanges(shot, 1, 31 / 24, none);
    assert.equal(written(start), '31 / 24 s');
    assert.equal(written(end), '191 / 120 s');
    assert.equal(written(endChanges(shot, shot.cameras[1]!, 9.51, none)[0]), '9.5 s');
});

test('TimeText_InThePlaceOfAnOldText_KeepsItsUnitAndDivisor', () => {
    const third = { numerator: 31, denominator: 24 };
    assert.equal(timeText(third, null), '31 / 24 s');
    assert.equal(timeText(third, '2.75 s'), '31 / 24 s');
    assert.equal(timeText(third, '1/48 s'), '62/48 s');
    assert.equal(timeText(third, '62/48 s'), '62/48 s');
    assert.equal(timeText({ numerator: 11, denominator: 8 }, '62/48 s'), '66/48 s');
    assert.equal(timeText({ numerator: 1, denominator: 2 }, '250 ms'), '500 ms');
    assert.equal(timeText({ numerator: 3, denominator: 1 }, '3.0 s'), '3.0 s');
});

test('ClipHandles_TheFirstCamera_HasNoStart', () => {
    // In the text the first camera of the film comes last.
    const shot = shotOf(24, camera(0, 2, 5, 1), camera(1, 0, 3));
    const layout = { clips: { y: 0, height: 20 }, film: { from: 0, to: 5, left: 0, width: 100 } };
    const ids = clipHandles(layout as unknown as Layout, shot, -1).map(({ id }) => id);
    assert.deepEqual(ids.sort(), ['cameras/0 end', 'cameras/0 fade', 'cameras/0 start']);
    const [own, before] = startChanges(shot, 0, 1.5, none);
    assert.deepEqual([own?.path, before?.path],
        [['cameras', '0', 'video', '0'], ['cameras', '1', 'video', '1']]);
});
