import assert from 'node:assert/strict';
import { test } from 'node:test';
import { decimalsOf, panned, resolved, roundStep, ticksOf, timeAt, xOf, zoomed }
    from '../../src/strip/axis';
import { filmClock, speedText } from '../../src/strip/clock_text';
import { advanced, nextEvent } from '../../src/strip/playback';

const axis = { from: 2, to: 4, left: 100, width: 1000 };

test('Axis_TimeAndPixels_AreInverse', () => {
    assert.equal(xOf(axis, 3), 600);
    assert.equal(timeAt(axis, xOf(axis, 2.345)), 2.345);
});

test('Zoomed_AroundATime_KeepsItWhereItIs', () => {
    const whole = { from: 0, to: 10 };
    const next = zoomed({ from: 2, to: 4 }, 2.5, 0.5, whole);
    assert.deepEqual(next, { from: 2.25, to: 3.25 });
    assert.deepEqual(zoomed({ from: 2, to: 4 }, 3, 100, whole), whole);
    const closest = zoomed({ from: 2, to: 4 }, 3, 1e-9, whole);
    assert.ok(Math.abs(closest.to - closest.from - 1e-4) < 1e-12);
});

test('Panned_PastAnEnd_StopsThere', () => {
    assert.deepEqual(panned({ from: 2, to: 4 }, 100, { from: 0, to: 10 }), { from: 8, to: 10 });
    assert.deepEqual(panned({ from: 2, to: 4 }, -100, { from: 0, to: 10 }), { from: 0, to: 2 });
});

test('RoundStep_AnyLeast_IsTheNextOneTwoOrFive', () => {
    assert.deepEqual([0.3, 0.5, 1, 1.1, 7].map(roundStep), [0.5, 0.5, 1, 2, 10]);
});

test('TicksOf_Axis_AreRoundAndInside', () => {
    const major = ticksOf(axis, 80).filter((tick) => tick.major).map((tick) => tick.time);
    assert.deepEqual(major.map((time) => Number(time.toFixed(6))),
        [2, 2.2, 2.4, 2.6, 2.8, 3, 3.2, 3.4, 3.6, 3.8, 4]);
    assert.equal(decimalsOf(axis, 80), 1);
});

test('Resolved_APixel_DecidesTheDecimals', () => {
    assert.equal(resolved(axis, 2.34567).step, 0.001);
    assert.ok(Math.abs(resolved(axis, 2.34567).time - 2.346) < 1e-12);
});

test('Advanced_PastTheEnd_StopsOrRepeats', () => {
    assert.deepEqual(advanced(9.9, 0.2, 10, false), { time: 10, ended: true });
    assert.ok(Math.abs(advanced(9.9, 0.2, 10, true).time - 0.1) < 1e-9);
    assert.deepEqual(advanced(1, 0.5, 10, false), { time: 1.5, ended: false });
});

test('NextEvent_EventsAtOneTime_AreVisitedOneByOne', () => {
    const events = [0.5, 0.5, 0.75, 2].map((time) => ({ time }));
    assert.equal(nextEvent(events, null, 0.2, 1), events[0]);
    assert.equal(nextEvent(events, events[0] ?? null, 0.5, 1), events[1]);
    assert.equal(nextEvent(events, events[1] ?? null, 0.5, 1), events[2]);
    assert.equal(nextEvent(events, null, 0.6, -1), events[1]);
    assert.equal(nextEvent(events, events[3] ?? null, 2, 1), null);
});

test('Texts_OfTimesAndSpeeds_AreAsPeopleSayThem', () => {
    assert.equal(filmClock(2.75), '00:02.75');
    assert.equal(filmClock(59.999), '01:00.00');
    assert.equal(speedText(1 / 8), '1/8×');
    assert.equal(speedText(-1), '−1×');
    assert.equal(speedText(0), '0×');
    assert.equal(speedText(0.37), '0.37×');
});
