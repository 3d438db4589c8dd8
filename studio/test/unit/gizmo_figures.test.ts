import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Track } from '../../src/motion/track';
import type { SceneObject, TimelineEvent, Triple } from '../../src/protocol';
import {
    arrowFigure, arrowScales, arrowTip, type Arrow,
} from '../../src/view/gizmos/arrow_figure';
import { pinsOf } from '../../src/view/gizmos/event_pins';
import { fanLines } from '../../src/view/gizmos/fan';
import { fanText } from '../../src/view/gizmos/fan_text';
import { objectHandles, type Selected } from '../../src/view/gizmos/object_handles';
import { frameOf } from '../../src/view/gizmos/object_frame';
import { parseValue } from '../../src/view/gizmos/shot_values';
import {
    buttPlace, speedOfLength, strikeFigure, strikeHandles, tipPlace, type StrikeView,
} from '../../src/view/gizmos/strike_figure';
import { secondContacts, trailShapes } from '../../src/view/trail_lines';

const kRadius = 0.0286;

function event(kind: string, time: number, a = '', b = ''): TimelineEvent {
    return { kind, time, end_time: time, a, b, place: [0.1, 0.2, kRadius], impulse: 0, text: kind };
}

function ball(name: string): SceneObject {
    return {
        name, kind: 'ball', path: ['balls', name], shape: 'sphere', moves: true, position: [0, 0, 0],
        orientation: [1, 0, 0, 0], radius: kRadius, colour: [1, 0, 0], material: '',
    };
}

/// A track at constant speed along x between times 0 and 1.
function straight(name: string, speed: number): Track {
    const key = (time: number) => [time, speed * time, 0, kRadius, 1, 0, 0, 0, speed, 0, 0, speed, 0, 0,
        0, 0, 0, 0, 0, 0];
    return new Track({ name, first: 0, keys: 2 }, new Float64Array([...key(0), ...key(1)]));
}

function near(actual: readonly number[], expected: readonly number[]): void {
    actual.forEach((value, i) => assert.ok(Math.abs(value - (expected[i] ?? NaN)) < 1e-9,
        `${actual} is not ${expected}`));
}

test('Pins_OfEvents_AreFirstContactsOfStrikesAndPottedBalls', () => {
    const events = [
        event('impact', 0, 'one', 'two'), event('strike', 0.5, 'cue'), event('impact', 0.6, 'cue', 'cushion'),
        event('impact', 0.7, 'cue', 'nine'), event('impact', 0.8, 'nine', 'two'),
        event('potted', 1, 'nine', 'side'), event('strike', 2, 'cue'), event('impact', 3, 'cue', 'one'),
    ];
    const pins = pinsOf(events, new Set(['cue', 'one', 'two', 'nine']));
    assert.deepEqual(pins.map((pin) => pin.event.time), [0.7, 1, 3]);
    assert.ok((pins[0]?.at[2] ?? 0) > 0.08);
});

test('SecondContacts_OfEvents_LeaveOutTheCloth', () => {
    const found = secondContacts([
        event('impact', 1, 'cue', 'cloth'), event('impact', 2, 'cue', 'one'),
        event('impact', 3, 'cue', 'cushion'), event('impact', 4, 'one', 'cushion'),
    ]);
    assert.deepEqual([found.get('cue'), found.get('one')], [3, 4]);
});

test('Trails_OfTracks_FadeAfterATimeAndHaveDotsWhereTheyAreApart', () => {
    const fast = trailShapes([ball('cue')], new Map([['cue', straight('cue', 1)]]),
        { opacity: 1, fadedOpacity: 0.2 }, new Map());
    assert.deepEqual([fast.lines.length / 6, fast.dots.length / 3], [1, 10]);
    const slow = trailShapes([ball('cue')], new Map([['cue', straight('cue', 0.1)]]),
        { opacity: 1, fadedOpacity: 0.2 }, new Map([['cue', 0.3]]));
    assert.equal(slow.dots.length, 0);
    assert.deepEqual([slow.lineColours[3], slow.lineColours[7]], [0.2, 0.2]);
    // What does not move has no path.
    const still = trailShapes([{ ...ball('cue'), moves: false }],
        new Map([['cue', straight('cue', 1)]]), { opacity: 1, fadedOpacity: 1 }, new Map());
    assert.equal(still.lines.length, 0);
    const stick = trailShapes([{ ...ball('stick/tip'), kind: 'table' }],
        new Map([['stick/tip', straight('stick/tip', 1)]]), { opacity: 1, fadedOpacity: 1 }, new Map());
    assert.equal(stick.lines.length, 0);
});

const strike: StrikeView = {
    centre: [0, 0, kRadius], radius: kRadius, direction: 0, elevation: 0, tip: [0, 0], speed: 3,
    isBallSpeed: false, others: [{ name: 'one', place: [0.5, 0.01], radius: kRadius }], plan: null,
    colours: new Map(),
};

test('Strike_AsAFigure_HasStickBehindTheBallAndGhostBeforeTheOther', () => {
    near(tipPlace(strike), [-kRadius, 0, kRadius]);
    const length = -(buttPlace(strike)[0] + kRadius);
    near([speedOfLength(length)], [3]);
    const raised = { ...strike, elevation: Math.PI / 6 };
    assert.ok(buttPlace(raised)[2] > 0.1);
    near(tipPlace({ ...strike, tip: [0.5, 0] }).slice(1), [-0.5 * kRadius, kRadius]);
    near(tipPlace({ ...strike, tip: [0, 0.5] }).slice(1), [0, 1.5 * kRadius]);
    const figure = strikeFigure(strike, true);
    const [ghost] = figure.balls ?? [];
    near([Math.hypot(0.5 - (ghost?.at[0] ?? 0), 0.01)], [2 * kRadius]);
    assert.equal(strikeFigure(strike, false).lines?.every((line) => line.isFaint), true);
    // Near a ball the handle of the aim stays apart from the cue ball.
    const close = { ...strike, others: [{ name: 'one', place: [0.06, 0], radius: kRadius }] } as StrikeView;
    near(strikeHandles(close)[0]?.at ?? [], [0.2, 0, kRadius]);
});

function arrow(kind: Arrow['kind'], vector: Triple): Arrow {
    return { path: [], kind, base: [0, 0, 1], vector, turn: null, count: 3, isChosen: true };
}

test('Arrows_ScalesAreKeptWhileTheySuit', () => {
    const first = arrowScales([arrow('force', [0.7, 0, 0]), arrow('impulse', [0, 7, 0])], new Map());
    near([first.get('force') ?? 0, first.get('impulse') ?? 0], [0.5, 0.05]);
    assert.equal(arrowScales([arrow('force', [1.2, 0, 0])], first).get('force'), first.get('force'));
    near([arrowScales([arrow('force', [7, 0, 0])], first).get('force') ?? 0], [0.05]);
    const turned: Arrow = { ...arrow('force', [1, 0, 0]), turn: [Math.SQRT1_2, 0, 0, Math.SQRT1_2] };
    near(arrowTip(turned, 0.5), [0, 0.5, 1]);
    const figure = arrowFigure([arrow('force', [0, 0, 0]), arrow('velocity', [3, 4, 0])], new Map());
    assert.deepEqual([figure.tips?.length, figure.labels?.[0]?.text], [1, '5 m/s']);
});

test('Fan_OutcomesInWords_AndPathsOfTheShownBalls', () => {
    const outcome = { kind: 'potted', a: 'nine', b: 'side', text: '', runs: 3, first: 1, last: 1.2 };
    const tracks = [{ name: 'cue', run: 0, first: 0, points: 3 }, { name: 'one', run: 0, first: 12, points: 2 }];
    const head = { v: 1, runs: 8, finished: 8, tracks, outcomes: [outcome] };
    const pins = pinsOf([event('potted', 1, 'nine', 'side')], new Set());
    assert.deepEqual(fanText({ head }, pins, []).map(({ text }) => text), ['nine is potted in 3 of 8']);
    const pocket = { name: 'side', place: [0, 0.6] as [number, number], radius: 0.06 };
    assert.equal(fanText({ head }, [], [pocket])[0]?.tone, 'faint');
    assert.deepEqual(fanText(null, pins, [pocket]), []);
    const numbers = new Float64Array([0, 1, 2, 3, 1, 4, 5, 6, 2, 7, 8, 9, 0, 0, 0, 0, 1, 1, 1, 1]);
    assert.deepEqual(fanLines(head, numbers, [ball('cue')]).places,
        [1, 2, 3, 4, 5, 6, 4, 5, 6, 7, 8, 9]);
});

test('ObjectHandles_OfATool_AreItsArmsMeasuresOrCorners', () => {
    const selected = (shape: string, text: string, tool: Selected['tool']): Selected => ({
        shape, value: parseValue(text), tool, metresPerPixel: 0.001, isBall: false, hiddenAxes: [],
        frame: frameOf([1, 0, 0], { kind: 'none' }, [2, 1, 1]),
    });
    const kinds = (one: Selected) => objectHandles(one).map(({ kind }) => kind);
    assert.deepEqual(kinds(selected('box', '[1 cm, 2 cm, 3 cm]', 'move')), ['axis', 'axis', 'axis']);
    const box = objectHandles(selected('box', '[1 cm, 2 cm, 3 cm]', 'scale'));
    near(box[0]?.at ?? [], [1.01, 0, 0]);  // twice as long along x
    assert.deepEqual(kinds(selected('mesh', 'a.obj', 'scale')), ['scale']);
    assert.deepEqual(kinds(selected('triangle', '[[0, 0, 0], [1, 0, 0], [0, 1, 0]]', 'turn')),
        ['vertex', 'vertex', 'vertex']);
    assert.deepEqual(parseValue('{a: [1 mm, x], b: 90 deg}'), { a: [0.001, 'x'], b: Math.PI / 2 });
});
