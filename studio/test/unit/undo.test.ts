/// Any row of steps, drags and typing over two files is undone and done again byte by byte.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { applyChanges, beginGesture, cancelGesture, removeValue } from '../../src/edit/edit';
import { buffers, setText, textOf, travel, typeStep } from '../../src/text/buffers';
import { takeFiles } from '../../src/text/take_files';
import { addStep, kMostSteps, redoTitle, undoable, undoTitle } from '../../src/text/steps';
import { undoStep } from '../../src/text/undo_commands';

const kShot = 'include: x.yaml\nballs:\n  cue: {at: [0.5, 1.25]}  # c\n  one: {at: [1, 2], spin: 3}\nlist:\n  - a\n  - b\n';
const kOther = 'rack: {gap: 1 mm}\nitems: [1, 2, 3]\n';

function open(): void {
    buffers.value = [];
    const file = (name: string, text: string) => ({ file: `/${name}`, name, text, hash: name,
        writable: true, changed: false });
    takeFiles([file('a.yaml', kShot), file('x.yaml', kOther)]);
}

const texts = () => buffers.value.map(textOf);

function makeRandom(seed: number): (below: number) => number {
    let state = seed;
    return (below) => {
        state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
        return Math.floor(state / 65536) % below;
    };
}

const kPaths = [['balls', 'cue', 'at', '0'], ['balls', 'cue', 'at', '1'], ['balls', 'cue', 'at'],
    ['balls', 'one', 'spin'], ['balls', 'two', 'at'], ['items', '1'], ['items', '2'],
    ['rack', 'gap'], ['list', '1']];

function change(random: (below: number) => number) {
    const path = kPaths[random(kPaths.length)] ?? [];
    const isList = path[path.length - 1] === 'at';
    const number = () => random(2000) / 100 - 10;
    return { path, value: isList ? [number(), number()] : number() };
}

function step(random: (below: number) => number): void {
    const kind = random(6);
    if (kind <= 1) {
        const gesture = beginGesture();
        for (let i = 0; i < 5; ++i) {
            gesture.update([change(random)]);
        }
        (random(4) === 0 ? gesture.cancel : () => gesture.commit('Drag'))();
    } else if (kind === 2) {
        applyChanges([change(random), change(random)], 'Change');
    } else if (kind === 3) {
        removeValue(kPaths[random(kPaths.length)] ?? [], 'Remove');
    } else if (kind === 4) {
        const buffer = buffers.value[random(2)];
        const at = random((buffer?.state.doc.length ?? 0) + 1);
        typeStep([{ file: buffer?.file ?? '', changes: { from: at, to: at, insert: `#${random(10)}\n` } }]);
    } else {
        setText('/x.yaml', kOther.replace('1 mm', `${random(9)} mm`), 'Reload');
    }
}

test('Undo_RandomSteps_RestoreEveryByte', () => {
    let count = 0;
    for (let seed = 1; seed <= 60; ++seed) {
        open();
        const random = makeRandom(seed);
        const known = [texts()];
        for (let i = 0; i < 25; ++i) {
            const before = undoable.value.length;
            step(random);
            if (undoable.value.length > before) {
                known.push(texts());
            }
            assert.deepEqual(texts(), known[known.length - 1], `seed ${seed}, step ${i}`);
        }
        count += known.length;
        for (let i = known.length - 2; i >= 0; --i) {
            assert.ok(travel(true), `seed ${seed}: ${i} steps are left`);
            assert.deepEqual(texts(), known[i], `seed ${seed}: undo to ${i}`);
        }
        assert.equal(travel(true), false);
        for (let i = 1; i < known.length; ++i) {
            assert.ok(travel(false));
            assert.deepEqual(texts(), known[i], `seed ${seed}: redo to ${i}`);
        }
    }
    assert.ok(count > 800, `${count} steps`);
});

const kSpin = ['balls', 'one', 'spin'];
const kGap = ['rack', 'gap'];

test('Gesture_CancelledOrCommitted_IsDeafToLaterMoves', () => {
    open();
    const first = beginGesture();
    first.update([{ path: kSpin, value: 4 }]);
    assert.ok(cancelGesture());
    assert.ok(first.update([{ path: kSpin, value: 5 }]).ok);
    assert.deepEqual(texts(), [kShot, kOther]);
    assert.equal(undoable.value.length, 0);

    const second = beginGesture();
    second.update([{ path: kSpin, value: 6 }]);
    applyChanges([{ path: ['balls', 'cue', 'at', '0'], value: 2 }], 'Move');
    const both = texts();
    second.update([{ path: kSpin, value: 7 }]);
    second.commit('Late');
    assert.deepEqual(texts(), both);
    assert.equal(undoable.value.length, 2);
});

test('UndoStep_WhileAGestureRuns_TakesTheGestureBack', () => {
    open();
    applyChanges([{ path: kSpin, value: 4 }], 'Spin');
    const before = texts();
    const gesture = beginGesture();
    gesture.update([{ path: kSpin, value: 5 }]);
    const dragged = texts();
    assert.ok(undoStep(true));
    assert.deepEqual(texts(), before);
    gesture.update([{ path: kSpin, value: 6 }]);
    gesture.commit('Late');
    assert.deepEqual(texts(), before);
    assert.ok(undoStep(false));
    assert.deepEqual(texts(), dragged);
    assert.ok(undoStep(true) && undoStep(true));
    assert.deepEqual(texts(), [kShot, kOther]);
    assert.equal(undoStep(true), false);
});

test('Gesture_FileChangedFromOutside_KeepsThatChange', () => {
    open();
    const theirs = kOther.replace('1 mm', '7 mm');
    const gesture = beginGesture();
    gesture.update([{ path: kSpin, value: 5 }]);
    setText('/x.yaml', theirs, 'Reload from disk');
    gesture.update([{ path: kSpin, value: 6 }]);
    gesture.commit('Spin');
    assert.deepEqual(texts(), [kShot.replace('spin: 3', 'spin: 6'), theirs]);
    assert.deepEqual(undoable.value.map(({ label }) => label), ['Reload from disk', 'Spin']);

    const shot = textOf(buffers.value[0]!);
    const second = beginGesture();
    second.update([{ path: kSpin, value: 8 }]);
    setText('/a.yaml', `# theirs\n${shot}`, 'Reload from disk');
    second.update([{ path: kSpin, value: 9 }]);
    second.commit('Late');
    assert.deepEqual(texts(), [`# theirs\n${shot.replace('spin: 6', 'spin: 9')}`, theirs]);
    assert.ok(undoStep(true));
    assert.deepEqual(texts(), [`# theirs\n${shot}`, theirs]);
    assert.ok(undoStep(true));
    assert.deepEqual(texts(), [shot, theirs]);
});

test('Undo_HundredsOfSteps_KeepTheirTextsAndLabels', () => {
    open();
    const known = [texts()];
    for (let i = 1; i <= 300; ++i) {
        const path = i % 3 === 0 ? kGap : kSpin;
        assert.ok(applyChanges([{ path, value: i + 10 }], `Step ${i}`).ok);
        known.push(texts());
    }
    for (let i = 300; i >= 1; --i) {
        assert.equal(undoTitle.value, `Undo: Step ${i}`);
        assert.ok(undoStep(true));
        assert.deepEqual(texts(), known[i - 1], `undo to ${i - 1}`);
    }
    assert.equal(undoStep(true), false);
    for (let i = 1; i <= 300; ++i) {
        assert.equal(redoTitle.value, `Redo: Step ${i}`);
        assert.ok(undoStep(false));
        assert.deepEqual(texts(), known[i], `redo to ${i}`);
    }
});

test('Steps_BeyondTheMost_AreForgottenFromTheOldest', () => {
    open();
    for (let i = 1; i <= kMostSteps + 5; ++i) {
        addStep({ files: ['/a.yaml'], label: String(i) });
    }
    assert.equal(undoable.value.length, kMostSteps);
    assert.equal(undoable.value[0]?.label, '6');
});

test('ApplyChanges_NoFiniteNumber_IsRefused', () => {
    open();
    for (const value of [NaN, Infinity, [1, NaN]]) {
        assert.equal(applyChanges([{ path: ['balls', 'cue', 'at'], value }], 'Move').ok, false);
    }
    assert.deepEqual(texts(), [kShot, kOther]);
});

test('Answers_AboutARepeatedValue_CountForOneEditOrAlways', () => {
    const text = 'a: &n 1\nb: *n\nc: [2]\n';
    const openText = (file: string) => {
        buffers.value = [];
        takeFiles([{ file, name: file, text, hash: file, writable: true, changed: false }]);
    };
    const set = (value: number) => applyChanges([{ path: ['b'], value }], 'Change');
    openText('/b.yaml');
    set(2).choices[0]?.apply();
    assert.equal(textOf(buffers.value[0]!), text.replace('&n 1', '&n 2'));
    assert.equal(set(3).ok, false);
    set(3).choices[2]?.apply();
    assert.equal(set(4).ok, true);
    assert.equal(textOf(buffers.value[0]!), text.replace('&n 1', '&n 4'));
    openText('/c.yaml');
    assert.equal(set(5).ok, false);
});
