import assert from 'node:assert/strict';
import { test } from 'node:test';
import { aliasKey } from '../../src/edit/decisions';
import { EditError } from '../../src/edit/edit_error';
import type { SourceFile, Value } from '../../src/edit/edit_types';
import {
    planEntry, planInsert, planRemove, planSet, planTakeList, Undecided, type Decisions, type FileEdits,
} from '../../src/edit/plan';
import { setAlone } from '../../src/edit/plan_replace';
import { applyEdits } from '../../src/edit/text_edit';
import type { KeyPath } from '../../src/protocol';

function files(shot: string, config = '', writable = false): SourceFile[] {
    return [
        { file: '/shots/a.yaml', name: 'a.yaml', text: shot, writable: true },
        { file: '/carom/configs/x.yaml', name: 'x.yaml', text: config, writable },
    ];
}

function decided(decision: 'anchor' | 'copy') {
    return new Map([[aliasKey('/shots/a.yaml', 'n'), decision]]);
}

function made({ file, edits }: FileEdits): string {
    return `${file.name}\n${applyEdits(file.text, edits)}`;
}

function set(all: SourceFile[], path: string, value: Value, decisions: Decisions = {}): string {
    return made(planSet(all, path.split('.'), value, { unit: '' }, decisions));
}

test('PlanSet_OfAPartThatIsOnlyAName_MakesItAMap', () => {
    const film = files('film:\n  shots:\n    - a.yaml  # first\n    - {shot: b.yaml}\n');
    assert.equal(set(film, 'film.shots.0.from', { yaml: '1 s' }),
        'a.yaml\nfilm:\n  shots:\n    - {shot: a.yaml, from: 1 s}  # first\n    - {shot: b.yaml}\n');
    assert.equal(set(film, 'film.shots.0.shot', 'c.yaml'),
        'a.yaml\nfilm:\n  shots:\n    - c.yaml  # first\n    - {shot: b.yaml}\n');
    assert.equal(set(film, 'film.shots.1.from', { yaml: '1 s' }),
        'a.yaml\nfilm:\n  shots:\n    - a.yaml  # first\n    - {shot: b.yaml, from: 1 s}\n');
});

test('PlanSet_AbsentKeys_AreTheSmallestAddition', () => {
    assert.equal(set(files('balls:\n  cue: {at: [0, 1]}  # c\n'), 'balls.cue.spin', 2),
        'a.yaml\nballs:\n  cue: {at: [0, 1], spin: 2}  # c\n');
    assert.equal(set(files('balls:\n  cue: {at: [0, 1]}  # c\n'), 'balls.nine.at', [1, 2]),
        'a.yaml\nballs:\n  cue: {at: [0, 1]}  # c\n  nine: {at: [1, 2]}\n');
    assert.equal(set(files('carom: 1\n\nrack: {}\n\ncameras: []\n'), 'balls.nine.at', [1, 2]),
        'a.yaml\ncarom: 1\n\nrack: {}\n\nballs:\n  nine: {at: [1, 2]}\n\ncameras: []\n');
    assert.equal(set(files('balls:\nrender: {}\n'), 'balls.nine.at', [1, 2]),
        'a.yaml\nballs:\n  nine: {at: [1, 2]}\nrender: {}\n');
    assert.equal(set(files('render: {}\n'), 'render.fps', 24), 'a.yaml\nrender: {fps: 24}\n');
});

test('PlanSet_ValueOfAnInclude_IsLaidOverInTheShot', () => {
    const all = files('include: x.yaml\n', 'rack: {gap: 1 mm}\nlist: [{a: 1}, {a: 2}]\n');
    assert.equal(set(all, 'rack.gap', 2), 'a.yaml\ninclude: x.yaml\nrack: {gap: 2}\n');
    assert.throws(() => set(all, 'list.1.a', 3), Undecided);
    const own = files('include: x.yaml\n', 'list: [{a: 1}, {a: 2}]\n', true);
    assert.equal(set(own, 'list.1.a', 3), 'x.yaml\nlist: [{a: 1}, {a: 3}]\n');
});

test('PlanSet_Rig_IsChangedBesideItsInclude', () => {
    const all = files('cameras:\n  - {include: x.yaml, video: [0, 1]}\n',
        'cameras:\n  - name: o\n    fov: 46 deg\n');
    assert.equal(set(all, 'cameras.0.fov', 1),
        'a.yaml\ncameras:\n  - {include: x.yaml, video: [0, 1], fov: 1}\n');
});

test('PlanSet_Alias_AsksThenChangesTheAnchorOrCopies', () => {
    const all = files('a: &n {b: 1, c: 2}\nd: *n\n');
    assert.throws(() => set(all, 'd.b', 3), Undecided);
    assert.equal(set(all, 'd.b', 3, { aliases: decided('anchor') }),
        'a.yaml\na: &n {b: 3, c: 2}\nd: *n\n');
    assert.equal(set(all, 'd.b', 3, { aliases: decided('copy') }),
        'a.yaml\na: &n {b: 1, c: 2}\nd: {b: 3, c: 2}\n');
});

test('PlanRemove_Entries_TakesTheirLinesOrComma', () => {
    const text = 'balls:\n  cue: {at: [0, 1], spin: 2}  # c\n  one: {at: [1, 1]}\nrender: {}\n';
    const remove = (path: string) => made(planRemove(files(text), path.split('.')));
    assert.equal(remove('balls.one'),
        'a.yaml\nballs:\n  cue: {at: [0, 1], spin: 2}  # c\nrender: {}\n');
    assert.equal(remove('balls.cue.spin'), `a.yaml\n${text.replace(', spin: 2', '')}`);
    assert.equal(remove('balls.cue.at'), `a.yaml\n${text.replace('at: [0, 1], ', '')}`);
});

test('PlanInsert_Items_KeepTheIndent', () => {
    const text = 'events:\n  - strike: {ball: cue}\n  - force: {}\n';
    const insert = (index: number) =>
        made(planInsert(files(text), ['events'], index, 'impulse:\n  on: one'));
    const item = '  - impulse:\n      on: one\n';
    assert.equal(insert(0), `a.yaml\nevents:\n${item}  - strike: {ball: cue}\n  - force: {}\n`);
    assert.equal(insert(1), `a.yaml\nevents:\n  - strike: {ball: cue}\n${item}  - force: {}\n`);
    assert.equal(insert(2), `a.yaml\n${text}${item}`);
    assert.equal(made(planEntry(files('balls:\n  a: {}\n'), ['balls'], 'b', '{at: [0, 0]}')),
        'a.yaml\nballs:\n  a: {}\n  b: {at: [0, 0]}\n');
});

test('SetAlone_RivalOfTheShot_LeavesItsPlace_OfAnIncludeIsHidden', () => {
    const replaced = (all: SourceFile[], path: string, old: string, value: Value) =>
        setAlone(all, path.split('.'), () => [old], value, { unit: 'rad', precision: 1e-3 })[0]?.text;
    const own = files('events:\n  - strike: {ball: cue, toward: one, speed: 8 m/s}  # c\n');
    assert.equal(replaced(own, 'events.0.strike.direction', 'toward', 0.25),
        'events:\n  - strike: {ball: cue, direction: 0.25 rad, speed: 8 m/s}  # c\n');
    const block = files('balls:\n  a:\n    touching:\n      ball: b\n      direction: 0.1\n    mass: 1\n');
    assert.equal(replaced(block, 'balls.a.at', 'touching', [0, 0]),
        'balls:\n  a:\n    at: [0, 0]\n    mass: 1\n');
    const included = files('include: x.yaml\n', 'balls: {a: {touching: {ball: b}}}\n');
    assert.equal(replaced(included, 'balls.a.at', 'touching', [0, 0]),
        'include: x.yaml\nballs:\n  a: {at: [0, 0], touching: null}\n');
    assert.equal(replaced(files('balls: {a: {}}\n'), 'balls.a.at', 'touching', [0, 0]),
        'balls: {a: {at: [0, 0]}}\n');
    // Both are there: the one that is set stays. A null only hides what an include has.
    assert.equal(replaced(files('balls: {a: {at: [1, 1], touching: {ball: b}}}\n'),
        'balls.a.at', 'touching', [0, 0]), 'balls: {a: {at: [0, 0]}}\n');
    const hidden = files('include: x.yaml\nballs: {a: {touching: null, at: [1, 1]}}\n',
        'balls: {a: {touching: {ball: b}}}\n');
    assert.equal(replaced(hidden, 'balls.a.at', 'touching', [0, 0]),
        'include: x.yaml\nballs: {a: {touching: null, at: [0, 0]}}\n');
});

test('SetAlone_WhatItBelongsToBecameSomethingElse_IsRefused', () => {
    const rivals = (path: KeyPath) => path.at(-1) === 'strike' ? ['impulse'] : [];
    const impulse = files('events:\n  - impulse: {body: cue}\n');
    assert.throws(() => setAlone(impulse, ['events', '0', 'strike', 'speed'], rivals, 2, { unit: '' }),
        /'events\.0\.strike\.speed' cannot be set: the text has 'impulse' there/);
});

test('PlanSet_IntoInclude_WritesThereIfItCan', () => {
    const config = 'rack: {gap: 1 mm}\n';
    const into = { intoInclude: true };
    assert.equal(set(files('include: x.yaml\n', config, true), 'rack.gap', 2e-3, into),
        'x.yaml\nrack: {gap: 2 mm}\n');
    assert.equal(set(files('include: x.yaml\n', config, false), 'rack.gap', 2e-3, into),
        'a.yaml\ninclude: x.yaml\nrack: {gap: 0.002}\n');
});

test('PlanTakeList_ListOfAnInclude_IsCopiedAsItIsWritten', () => {
    const all = files('include: x.yaml\n', 'list: [{a: 1 mm}, {a: 2}]  # c\n');
    assert.equal(made(planTakeList(all, ['list'])),
        'a.yaml\ninclude: x.yaml\nlist: [{a: 1 mm}, {a: 2}]\n');
    assert.throws(() => planRemove(all, ['list', '1']), Undecided);
    assert.throws(() => planInsert(all, ['list'], 0, 'x'), Undecided);
    const own = files('include: x.yaml\n', 'list: [{a: 1 mm}, {a: 2}]\n', true);
    assert.equal(made(planRemove(own, ['list', '1'])), 'x.yaml\nlist: [{a: 1 mm}]\n');
});

test('PlanRemove_RepeatedValue_IsRefused', () => {
    assert.throws(() => planRemove(files('a: &n 1\nb: *n\n'), ['a']), EditError);
    assert.equal(made(planRemove(files('a: &n 1\nb: *n\n'), ['b'])), 'a.yaml\na: &n 1\n');
});

test('PlanSet_AbsentKeyInAListOfAnInclude_KeepsTheList', () => {
    const config = 'cameras:\n  - {name: a, video: [0, 1]}\n  - {name: b, video: [1, 2]}\n'
        + 'events:\n  - strike: {ball: cue}\n';
    const writable = files('include: x.yaml\n', config, true);
    assert.equal(set(writable, 'cameras.1.fade', 0.5),
        `x.yaml\n${config.replace('[1, 2]}', '[1, 2], fade: 0.5}')}`);
    assert.equal(set(writable, 'events.0.strike.tip', [0, 1]),
        `x.yaml\n${config.replace('cue}', 'cue, tip: [0, 1]}')}`);
    assert.equal(set(writable, 'events.1.force.on', 'cue'),
        `x.yaml\n${config}  - {force: {on: cue}}\n`);
    const locked = files('include: x.yaml\n', config, false);
    for (const path of ['cameras.1.fade', 'events.0.strike.tip', 'events.1.force.on']) {
        const list = path.split('.')[0];
        assert.throws(() => set(locked, path, 1), (error) => error instanceof Undecided
            && error.kind === 'list' && error.subject === list, path);
    }
    const taken = [{ ...locked[0], text: applyEdits(locked[0]!.text,
        planTakeList(locked, ['events']).edits) }, locked[1]] as SourceFile[];
    assert.equal(set(taken, 'events.0.strike.speed', 2),
        'a.yaml\ninclude: x.yaml\nevents: [{strike: {ball: cue, speed: 2}}]\n');
    assert.throws(() => planEntry(locked, ['cameras', '0'], 'focus', 'auto'), Undecided);
    assert.throws(() => planInsert(locked, ['cameras', '0', 'speed'], 0, '1'), Undecided);
    assert.equal(set(locked, 'rack.gap', 1), 'a.yaml\ninclude: x.yaml\nrack: {gap: 1}\n');
});

test('PlanSet_RigOfAnIncludedCamera_IsChangedBesideItsInclude', () => {
    const all = (writable: boolean): SourceFile[] => [
        { file: '/s/a.yaml', name: 'a.yaml', text: 'include: x.yaml\n', writable: true },
        { file: '/s/x.yaml', name: 'x.yaml', writable, text: 'cameras:\n  - {include: rig.yaml}\n' },
        { file: '/s/rig.yaml', name: 'rig.yaml', writable: true, text: 'cameras:\n  - fov: 1\n' },
    ];
    for (const [path, key] of [['cameras.0.fov', 'fov'], ['cameras.0.fade', 'fade']] as const) {
        assert.equal(set(all(true), path, 2),
            `x.yaml\ncameras:\n  - {include: rig.yaml, ${key}: 2}\n`);
        assert.throws(() => set(all(false), path, 2), (error) => error instanceof Undecided
            && error.subject === 'cameras');
    }
});

test('PlanSet_ListWithAliases_AsksOnlyForThoseThatChange', () => {
    const all = files('x: &n 0.1\nballs:\n  a: {at: [*n, 0.3]}\n');
    assert.equal(set(all, 'balls.a.at', [0.1, 0.4]),
        'a.yaml\nx: &n 0.1\nballs:\n  a: {at: [*n, 0.4]}\n');
    assert.throws(() => set(all, 'balls.a.at', [0.2, 0.4]), Undecided);
    assert.equal(set(all, 'balls.a.at', [0.2, 0.4], { aliases: decided('copy') }),
        'a.yaml\nx: &n 0.1\nballs:\n  a: {at: [0.2, 0.4]}\n');
    assert.equal(set(all, 'balls.a.at', [0.2, 0.4], { aliases: decided('anchor') }),
        'a.yaml\nx: &n 0.2\nballs:\n  a: {at: [*n, 0.4]}\n');
});

test('PlanRemove_KeyOfARig_IsHiddenBesideTheInclude', () => {
    const shot = 'cameras:\n  - {include: x.yaml, video: [0, 1]}\n';
    const rig = 'cameras:\n  - name: o\n    fov: 46 deg\n    speed: [1, 2]\n';
    for (const writable of [true, false]) {
        const all = files(shot, rig, writable);
        assert.equal(made(planRemove(all, ['cameras', '0', 'fov'])),
            `a.yaml\n${shot.replace('[0, 1]', '[0, 1], fov: null')}`);
    }
    assert.throws(() => planRemove(files(shot, rig), ['cameras', '0', 'speed', '1']),
        (error) => error instanceof Undecided && error.subject === 'cameras/0/speed');
});

test('PlanRemove_LastItem_LeavesNothingOfAnIncludedList', () => {
    const shot = 'include: x.yaml\nevents:\n  - strike: {ball: cue}\nrack: {}\n';
    assert.equal(made(planRemove(files(shot, 'events: [{force: {}}]\n'), ['events', '0'])),
        'a.yaml\ninclude: x.yaml\nevents: []\nrack: {}\n');
    assert.equal(made(planRemove(files(shot, 'balls: {}\n'), ['events', '0'])),
        'a.yaml\ninclude: x.yaml\nrack: {}\n');
});
