/// Strikes that pot a ball: what is shown of them, and what is written.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { receive } from '../../src/connection/receive';
import type { ShotSolution, ShotState, SolutionsHead } from '../../src/protocol';
import { schema } from '../../src/schema/schema';
import { choose, step, wishRest, writeChosen } from '../../src/solve/search';
import {
    askedNumber, chosen, chosenIndex, chosenRoute, firstNumber, found, isSearching, pocketAt, restPlace,
    wish,
} from '../../src/solve/solve_state';
import { chanceWords, degrees, percent, routeWords, speedWords, tipWords } from '../../src/solve/solution_text';
import { newStrike, solvePaths } from '../../src/solve/strike_text';
import { shot, solutions, textVersion, timeline } from '../../src/state/state';
import { buffers, textOf } from '../../src/text/buffers';
import { takeFiles } from '../../src/text/take_files';
import { undoStep } from '../../src/text/undo_commands';
import { windowFigure, windowText } from '../../src/view/gizmos/aim_window';
import { pathsOf } from '../../src/view/gizmos/solutions';

const kDegree = Math.PI / 180;

function solution(more: Partial<ShotSolution> = {}): ShotSolution {
    return {
        route: 'cue - one, one in side_back', pocket: 'side_back', is_solved: true, miss: 0, chance: 0.784,
        chance_error: 0.04, window: 0.01, direction: 12.345678 * kDegree, speed: 2.8,
        is_ball_speed: false, elevation: 0, tip: [0, 0], rest: [0.1, -0.2], ...more,
    };
}

function answer(list: ShotSolution[], more: Partial<SolutionsHead> = {}): void {
    solutions.value = {
        head: { q: 1, v: 1, complete: true, message: '', time: 0.5, solve_item: -1, trials: 100,
            milliseconds: 20, solutions: list, tracks: [], ...more },
        numbers: new Float64Array(),
    };
}

/// A shot that is shown as its text says, and a wish for its first strike.
function seek(text: string, events = 1): void {
    schema.value = JSON.parse(readFileSync(join(__REPOSITORY__, 'configs/carom.schema.json'), 'utf8'));
    buffers.value = [];
    receive(JSON.stringify({ t: 'welcome', protocol: '', version: '', v: 1, shot: '/a', root: '/', output: '' }));
    const files = [{ file: '/a.yaml', name: 'a', text, hash: 'a', writable: true, changed: false }];
    receive(JSON.stringify({ t: 'files', v: 1, files }));
    takeFiles(files);
    const event = { path: ['events', '0'], kind: 'strike', object: 'cue' };
    shot.value = { v: 1, events: Array.from({ length: events }, () => event) } as unknown as ShotState;
    timeline.value = { head: { v: textVersion.value } } as unknown as typeof timeline.value;
    firstNumber.value = 1;
    askedNumber.value = 1;
    chosenRoute.value = '';
    wish.value = { ball: 'one', pocket: '', struck: 'cue', event: 0, rest: null };
}

const shown = () => textOf(buffers.value[0]!);

test('Words_OfASolution', () => {
    assert.equal(routeWords('cue - one, one - back cushion, one in corner_left_back'),
        'cue – one, one – back cushion, one in corner left back');
    assert.deepEqual([percent(0.784), degrees(0.01), degrees(0.3)], ['78 %', '0.57°', '17.2°']);
    assert.equal(speedWords(solution({ speed: 2.8345 })), '2.83 m/s');
    assert.equal(speedWords(solution({ is_ball_speed: true })), '2.8 m/s of the ball');
    assert.equal(chanceWords(solution()), '78 % ± 4, within 0.57°');
    assert.equal(chanceWords(solution({ chance: 1, chance_error: 0 })), '100 %, within 0.57°');
    assert.equal(chanceWords(solution({ chance: 0, window: 0 })), 'chance …');
    assert.equal(chanceWords(solution({ is_solved: false, miss: 0.213 })), 'misses the place by 0.21 m');
    assert.equal(tipWords([0.3, -0.25]), 'tip 0.3 right, 0.25 low');
    assert.equal(tipWords([-0.1, 0.001]), 'tip 0.1 left');
    assert.equal(tipWords([0, 0]), 'centre of the ball');
});

test('Pocket_IsWhereABallWouldFall', () => {
    const pockets = [{ name: 'side_back', place: [0, 0.65] as [number, number], radius: 0.06 }];
    assert.equal(pocketAt([0.02, 0.63], pockets)?.name, 'side_back');
    assert.equal(pocketAt([0.02, 0.5, 0.03], pockets), undefined);
});

test('Solutions_AreGoneThroughInARing_AndTheChosenOneStays', () => {
    seek('events:\n  - strike: {ball: cue, toward: one, speed: 3 m/s}\n');
    answer([solution({ route: 'a' }), solution({ route: 'b' }), solution({ route: 'c' })]);
    assert.equal(chosenIndex.value, 0);
    step(-1);
    assert.equal(chosen.value?.route, 'c');
    step(1);
    step(1);
    assert.equal(chosen.value?.route, 'b');
    // A better one takes its place before it.
    answer([solution({ route: 'd' }), solution({ route: 'a' }), solution({ route: 'b' })]);
    assert.deepEqual([chosenIndex.value, chosen.value?.route], [2, 'b']);
    answer([solution({ route: 'a' })]);
    assert.equal(chosen.value?.route, 'a');
    choose(7);
    assert.equal(chosenIndex.value, 0);
});

test('Answers_OfAnotherPot_AreNotShown', () => {
    seek('events: []\n');
    firstNumber.value = 2;
    askedNumber.value = 2;
    answer([solution()]);
    assert.deepEqual([found.value, chosenIndex.value, isSearching.value], [[], -1, true]);
    answer([solution()], { q: 2, complete: false });
    assert.deepEqual([found.value.length, isSearching.value], [1, true]);
    answer([solution()], { q: 2 });
    assert.equal(isSearching.value, false);
    wish.value = null;
    assert.deepEqual([found.value, isSearching.value], [[], false]);
});

test('Ring_IsWhereTheBallEnds_UntilAPlaceIsWished', () => {
    seek('events: []\n');
    answer([solution()]);
    assert.deepEqual(restPlace.value, [0.1, -0.2]);
    wishRest([0.3, 0.4]);
    assert.deepEqual(restPlace.value, [0.3, 0.4]);
    wishRest(null);
    assert.deepEqual(restPlace.value, [0.1, -0.2]);
});

test('Strike_IsWrittenIntoItsLine_AndUndoneAtOnce', () => {
    const text = 'events:\n  - strike: {ball: cue, at: 0.5 s, toward: one, speed: 3 m/s}  # hard\n';
    seek(text);
    answer([solution({ tip: [0.1, -0.25] })]);
    writeChosen();
    assert.equal(shown(), 'events:\n  - strike: {ball: cue, at: 0.5 s, direction: 12.345678 deg, '
        + 'speed: 2.8 m/s, tip: [0.1, -0.25]}  # hard\n');
    assert.equal(wish.value, null);
    undoStep(true);
    assert.equal(shown(), text);
});

test('Elevation_IsWrittenWhereItIsGivenOrTheStickIsRaised', () => {
    const given = 'events:\n  - strike: {ball: cue, elevation: 4 deg, toward: one, speed: 3 m/s}\n';
    seek(given);
    answer([solution({ elevation: 4 * kDegree })]);
    writeChosen();
    assert.equal(shown(), given.replace('toward: one, speed: 3 m/s', 'direction: 12.345678 deg, speed: 2.8 m/s'));
    seek('events:\n  - strike: {ball: cue, toward: one, speed: 3 m/s}\n');
    answer([solution({ elevation: 35 * kDegree })]);
    writeChosen();
    assert.equal(shown(), 'events:\n  - strike: {ball: cue, direction: 12.345678 deg, speed: 2.8 m/s, '
        + 'elevation: 35 deg}\n');
});

test('Strike_ThatIsFoundBySolve_TakesItsPlace', () => {
    seek('# a\nsolve:\n  want:\n    - {potted: one}\n\nevents:\n  - strike: {ball: cue, tip: [0, 0.3]}\n');
    answer([solution()], { solve_item: 0 });
    writeChosen();
    assert.equal(shown(), '# a\n\nevents:\n  - strike: {ball: cue, tip: [0, 0], direction: 12.345678 deg, '
        + 'speed: 2.8 m/s}\n');
    assert.deepEqual(solvePaths(1, 3), [['solve', '1']]);
    assert.deepEqual(solvePaths(-1, 3), []);
});

test('Strike_OfAShotWithoutOne_IsAnItemOfItsEvents', () => {
    seek('balls:\n  cue: {at: [0, 0]}\n', 0);
    answer([solution({ tip: [0.1, 0] })]);
    writeChosen();
    assert.equal(shown(), 'balls:\n  cue: {at: [0, 0]}\nevents:\n  - strike: {ball: cue, at: 0.5 s, '
        + 'direction: 12.345678 deg, speed: 2.8 m/s, tip: [0.1, 0]}\n');
    assert.equal(newStrike('cue', 1, solution({ elevation: 35.5 * kDegree })),
        'strike: {ball: cue, at: 1 s, direction: 12.345678 deg, speed: 2.8 m/s, elevation: 35.5 deg}');
    assert.equal(newStrike('cue', 1.25, solution()),
        'strike: {ball: cue, at: 1.25 s, direction: 12.345678 deg, speed: 2.8 m/s}');
});

test('StaleShot_IsNotWritten', () => {
    const text = 'events:\n  - strike: {ball: cue, toward: one, speed: 3 m/s}\n';
    seek(text);
    answer([solution()]);
    textVersion.value += 1;
    writeChosen();
    assert.equal(shown(), text);
});

test('Paths_OfASolution_AreItsOwn', () => {
    answer([solution(), solution()], { tracks: [
        { name: 'cue', run: 0, first: 0, points: 1 }, { name: 'cue', run: 1, first: 4, points: 2 }] });
    const all = { head: solutions.value!.head,
        numbers: new Float64Array([0, 1, 2, 3, 0, 4, 5, 6, 1, 7, 8, 9]) };
    assert.deepEqual(pathsOf(all, 1), [{ name: 'cue', points: [[4, 5, 6], [7, 8, 9]] }]);
});

test('Window_OfAnAim_IsAWedgeWithItsEdgesInWords', () => {
    const judged = {
        q: 1, v: 1, event: 0, pots: [{ ball: 'one', pocket: 'side_back' }], direction: 0.5,
        window: [0.5 - 0.4 * kDegree, 0.5 + 0.85 * kDegree] as [number, number], chance: 0.78,
        chance_error: 0.04,
    };
    assert.equal(windowText(judged, 0.5), 'one: 78 %, −0.40° to +0.85°');
    assert.equal(windowText(judged, 0.5 + 2 * Math.PI + kDegree), 'one: 78 %, −1.40° to −0.15°');
    const view = {
        centre: [0, 0, 0.0286] as [number, number, number], radius: 0.0286, direction: 0.5, elevation: 0,
        tip: [0, 0] as [number, number], speed: 2, isBallSpeed: false,
        others: [{ name: 'one', radius: 0.0286, place: [Math.cos(0.5), Math.sin(0.5)] as [number, number] }],
        plan: null, colours: new Map(),
    };
    const figure = windowFigure(judged, view, true);
    const ends = figure.lines!.map(({ to }) => Math.atan2(to[1], to[0]));
    assert.ok(Math.abs(Math.max(...ends) - judged.window[1]) < 1e-9);
    assert.ok(Math.abs(Math.min(...ends.slice(-2)) - judged.window[0]) < 1e-9);
    assert.ok(figure.lines!.every(({ to }) => Math.hypot(to[0], to[1]) < 1));
    assert.equal(figure.labels!.length, 1);
    assert.equal(windowFigure(judged, view, false).labels!.length, 0);
});
