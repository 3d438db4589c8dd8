// The parts of a film of several shots: which one a frame shows, and what their handles write.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { Change } from '../../src/edit/edit';
import type { FilmPart, SequenceState } from '../../src/protocol';
import { partAt } from '../../src/sequence/parts';
import { laneOf, layoutOfParts } from '../../src/strip/layout';
import { fadeChange, fromChange, lengthChange, partHandles } from '../../src/strip/handles/part_handles';

function part(index: number, kind: string, start: number, frames: number, fade = 0): FilmPart {
    return { path: ['film', 'shots', String(index)], kind, file: '', name: 'part', start, frames, fade,
        first: kind === 'shot' ? 12 : 0, of_frames: kind === 'shot' ? 100 : 0 };
}

/// A card of 24 frames, then two shots, each with a fade of 6 frames.
const kFilm = {
    v: 1, name: 'film', film: { width: 640, height: 360, fps: 24, frames: 96, duration: 4, samples: 0 },
    parts: [part(0, 'title', 0, 24), part(1, 'shot', 18, 48, 6), part(2, 'shot', 60, 36, 6)], places: [],
} as SequenceState;

const none = () => null;
const text = ([change]: Change[]) =>
    change && `${change.path.join('.')}: ${(change.value as { yaml: string }).yaml}`;

test('PartAt_InAFade_IsThePartThatAppears', () => {
    assert.deepEqual([0, 17, 18, 59, 60, 95, 96].map((frame) => partAt(kFilm.parts, frame)),
        [0, 0, 1, 1, 2, 2, -1]);
});

test('Changes_OfAPart_AreTimesOfItsShotOnFrames', () => {
    assert.equal(text(fromChange(kFilm, 1, 24.4, none)), 'film.shots.1.from: 1 s');
    assert.equal(text(lengthChange(kFilm, 1, 36, none)), 'film.shots.1.to: 2 s');
    assert.equal(text(lengthChange(kFilm, 0, 31, none)), 'film.shots.0.for: 31 / 24 s');
    assert.equal(text(fadeChange(kFilm, 1, 12, none)), 'film.shots.1.fade: 0.5 s');
});

test('Changes_BeyondWhatThereIs_StopAtTheEnds', () => {
    assert.equal(text(fromChange(kFilm, 1, -5, none)), 'film.shots.1.from: 0 s');
    assert.equal(text(fromChange(kFilm, 1, 99, none)), 'film.shots.1.from: 2 s');  // 12 frames of fades
    assert.equal(text(lengthChange(kFilm, 2, 999, none)), 'film.shots.2.to: 100 / 24 s'
        .replace('100 / 24', '25 / 6'));
    assert.equal(text(lengthChange(kFilm, 0, 0, none)), 'film.shots.0.for: 0.25 s');
    assert.equal(text(fadeChange(kFilm, 1, 99, none)), 'film.shots.1.fade: 1 s');  // all of the card
    assert.equal(text(fadeChange(kFilm, 2, -3, none)), 'film.shots.2.fade: 0 s');
    assert.deepEqual(fromChange(kFilm, 0, 3, none), []);  // a card has no such time
});

test('PartHandles_OfTheSelectedPart_ComeFirstInItsLane', () => {
    const layout = layoutOfParts(800, 200, { from: 0, to: 4 }, false);
    const handles = partHandles(layout, kFilm, 1);
    assert.deepEqual(handles.map(({ id }) => id.replace('film/shots/', '')),
        ['1 fade', '1 from', '1 to', '0 fade', '0 for', '2 fade', '2 from', '2 to']);
    const lane = laneOf(layout.clips, 1);
    assert.ok(handles.slice(0, 3).every(({ y }) => y >= lane.y && y <= lane.y + lane.height));
    assert.deepEqual(handles.slice(0, 3).map(({ time }) => time), [18 / 24, 18 / 24, 66 / 24]);
    // Dragged to the left, a fade becomes longer: the part before ends where it did.
    assert.equal(text(handles[0]?.change(12 / 24, 0) ?? []), 'film.shots.1.fade: 0.5 s');
});
