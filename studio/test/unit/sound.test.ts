// Which samples sound when, and the peaks that the strip draws.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { contextTimeAt, DriftWatch, filmTimeAt, grainAt, kGrain, partsBetween }
    from '../../src/sound/schedule';
import { binPeaks, SoundData } from '../../src/sound/sound_data';
import { heightOf } from '../../src/strip/draw/sound';
import { layoutOf, layoutOfParts } from '../../src/strip/layout';

const kRate = 48000;
const extent = { rate: kRate, samples: 12 * kRate + 7, piece: 5 * kRate };

test('Anchor_FilmAndContextTimes_AreInverse', () => {
    const anchor = { film: 2.5, context: 10, speed: 1 / 4 };
    assert.equal(filmTimeAt(anchor, 14), 3.5);
    assert.equal(contextTimeAt(anchor, filmTimeAt(anchor, 11.7)), 11.7);
});

test('PartsBetween_AcrossPieces_JoinWithoutGapAndEndWithTheFilm', () => {
    const anchor = { film: 4, context: 100, speed: 1 };
    const parts = partsBetween(anchor, extent, 4, 99);
    assert.deepEqual(parts.map(({ piece, from, count }) => [piece, from, count]),
        [[0, 4 * kRate, kRate], [1, 0, 5 * kRate], [2, 0, 2 * kRate + 7]]);
    assert.deepEqual(parts.map(({ at }) => at), [100, 101, 106]);
});

test('PartsBetween_SlowPlaying_StretchesTheTimesOfTheContext', () => {
    const parts = partsBetween({ film: 4, context: 100, speed: 1 / 8 }, extent, 4.5, 5.5);
    assert.deepEqual(parts.map(({ at }) => at), [104, 108]);
});

test('PartsBetween_StretchesOfAnyLength_HaveEachSampleOnce', () => {
    const anchor = { film: 0, context: 3, speed: 1 };
    let next = 0;
    let from = 0;
    for (let i = 1; i <= 40; i += 1) {
        const until = from + 0.3 * i / 40 + 1e-5 / 3;
        for (const part of partsBetween(anchor, extent, from, until)) {
            assert.equal(part.piece * extent.piece + part.from, next);
            assert.ok(Math.abs(part.at - (3 + next / kRate)) < 1e-9);
            next += part.count;
        }
        from = until;
    }
    assert.equal(next, Math.ceil(from * kRate));
});

test('DriftWatch_JumpAtOnce_SmallDifferenceOnlyIfItStays', () => {
    const watch = new DriftWatch();
    assert.ok(watch.isOff(-4));
    watch.reset();
    assert.deepEqual([0.03, 0.03, 0.01, 0.03, 0.03, 0.03, 0.03].map((off) => watch.isOff(off)),
        [false, false, false, false, false, false, true]);
});

test('GrainAt_AnyTime_IsAsLongAndHasTheEventInIt', () => {
    assert.deepEqual(grainAt(2, 10), { from: 1.99, until: 1.99 + kGrain });
    assert.deepEqual(grainAt(0, 10), { from: 0, until: kGrain });
    assert.equal(grainAt(10, 10).until, 10);
    assert.ok(Math.abs(grainAt(10, 10).from - (10 - kGrain)) < 1e-12);
    assert.deepEqual(grainAt(0.01, 0.02), { from: 0, until: 0.02 });
});

function impulse(length: number, at: number, left: number, right = 0): Int16Array {
    const piece = new Int16Array(2 * length);
    piece[2 * at] = left;
    piece[2 * at + 1] = right;
    return piece;
}

test('BinPeaks_EitherChannelAndSign_IsTheHighestMagnitude', () => {
    const peaks = binPeaks(impulse(10, 5, -32767), 4);
    assert.deepEqual([...peaks], [0, 1, 0]);
    assert.deepEqual([...binPeaks(impulse(10, 9, 0, 32767), 4)], [0, 0, 1]);
    assert.equal(binPeaks(impulse(4, 0, -32768), 4)[0], 1);
});

test('SoundData_PeakOfAStretch_IsWhereTheImpulseIs', () => {
    const data = new SoundData('/sound/1/', extent);
    assert.equal(data.peak(0, 1), null);
    data.add(1, impulse(5 * kRate, 1000, 16384));
    const at = 5 + 1000 / kRate;
    assert.equal(data.peak(0, 1), null);
    assert.ok(Math.abs((data.peak(at - 1, at + 1) ?? 0) - 0.5) < 1e-4, 'a long stretch');
    assert.ok(Math.abs((data.peak(at - 1e-9, at + 0.5 / kRate) ?? 0) - 0.5) < 1e-4, 'one sample');
    assert.equal(data.peak(at + 1.5 / kRate, at + 4e-3), 0);
    assert.equal(data.peak(at + 0.02, at + 0.5), 0);
    assert.equal(data.peak(12.5, 13), null);
});

test('SoundData_Channels_AreThoseOfThePiece', () => {
    const data = new SoundData('/sound/1/', extent);
    data.add(0, impulse(5 * kRate, 3, 32767, -32767));
    const [left, right] = data.channels(0, 2, 3);
    assert.deepEqual([...left], [0, 1, 0]);
    assert.deepEqual([...right], [0, -1, 0]);
    assert.equal(data.channels(0, 5 * kRate - 2, 100)[0].length, 2);
    assert.equal(data.channels(1, 0, 10)[0].length, 0);
});

test('HeightOf_TwentyDecibelsLess_IsAThird', () => {
    assert.equal(heightOf(1), 1);
    assert.ok(Math.abs(heightOf(0.1) - 0.316) < 1e-3);
});

test('Layout_WithSound_HasTheRowInFilmTimeAndFillsTheHeight', () => {
    const range = { from: 0, to: 1 };
    for (const [height, frames] of [[210, false], [210, true], [400, true]] as const) {
        const layout = layoutOf(800, height, range, range, frames, true);
        assert.ok(layout.sound.height > 0);
        assert.equal(layout.sound.y, layout.clips.y + layout.clips.height);
        assert.equal(layout.sound.y + layout.sound.height, layout.curve.y);
        assert.equal(layout.sceneRuler.y + layout.sceneRuler.height, height);
        assert.ok(layout.map.height >= 16);
    }
    assert.equal(layoutOf(800, 210, range, range).sound.height, 0);
    assert.equal(layoutOf(800, 100, range, range, false, true).sound.height, 0);
    const parts = layoutOfParts(800, 210, range, false, true);
    assert.equal(parts.sound.y + parts.sound.height, 210);
    assert.equal(parts.clips.y + parts.clips.height, parts.sound.y);
});
