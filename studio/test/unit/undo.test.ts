/// Any row of steps, drags and typing over two files is undone and done again byte by byte.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { applyChanges, beginGesture, removeValue } from '../../src/edit/edit';
import { buffers, setText, textOf, travel, typeStep } from '../../src/text/buffers';
import { takeFiles } from '../../src/text/take_files';
import { undoable } from '../../src/text/steps';

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
