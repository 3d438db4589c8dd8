/// Two windows that change the texts at the same time: a drag goes on in what the other one types, and
/// what is sent at once from both sides is merged. The socket only listens.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { applyChanges, beginGesture } from '../../src/edit/edit';
import { notice, textVersion } from '../../src/state/state';
import { buffers, setChangeListener, textOf } from '../../src/text/buffers';
import { sendSoon, watchAnswers } from '../../src/text/sending';
import { undoable } from '../../src/text/steps';
import { undoStep } from '../../src/text/undo_commands';
import { openText, sent, tell } from './listening';

const kText = 'balls:\n  cue: {at: [0.5, 1.25]}\n  one: {at: [1, 2], spin: 3}\n';
const kAt = ['balls', 'cue', 'at', '0'];
const kSpin = ['balls', 'one', 'spin'];

watchAnswers();
setChangeListener(sendSoon);

const open = (text = kText): Promise<void> => openText(text);

/// The other window's text arrives, made from the version `base`.
function tellText(text: string, base = textVersion.value): void {
    tell('text_changed', { v: textVersion.value + 1, file: '/a.yaml', text, base });
}

const shown = () => textOf(buffers.value[0]!);

/// What the page shows is sent, and the server answers. Resolves to its version.
async function send(): Promise<number> {
    await Promise.resolve();
    tell('problems', { v: textVersion.value, complete: true, list: [] });
    await Promise.resolve();
    tell('problems', { v: textVersion.value, complete: true, list: [] });
    assert.equal(sent.filter(({ t }) => t === 'text').at(-1)?.text, shown());
    return textVersion.value;
}

/// The labels of the steps, the newest last.
const labels = () => undoable.value.map(({ label }) => label);
test('TextChanged_WhileADragRuns_KeepsBoth', async () => {
    await open();
    const gesture = beginGesture();
    const moved = (x: string) => kText.replace('0.5', x);
    gesture.update([{ path: kAt, value: 0.6 }]);
    const first = await send();
    gesture.update([{ path: kAt, value: 0.7 }]);
    await send();
    tellText(moved('0.6').replace('spin: 3', 'spin: 8'), first);
    assert.equal(shown(), moved('0.7').replace('spin: 3', 'spin: 8'));
    gesture.update([{ path: kAt, value: 0.8 }]);
    const second = await send();
    // On the same line, in a moment in which what is typed is no YAML.
    gesture.update([{ path: kAt, value: 0.85 }]);
    tellText(moved('0.8').replace('spin: 3', 'spin: 8').replace('1.25]}', '1.25], spin: [}'), second);
    assert.equal(shown(), 'balls:\n  cue: {at: [0.85, 1.25], spin: [}\n  one: {at: [1, 2], spin: 8}\n');
    gesture.update([{ path: kAt, value: 0.9 }]);
    await send();
    tellText(shown().replace('[}', '[1]}'));
    gesture.commit('Move');
    assert.equal(shown(), 'balls:\n  cue: {at: [0.9, 1.25], spin: [1]}\n  one: {at: [1, 2], spin: 8}\n');
    assert.deepEqual(labels(), ['Change in another window', 'Move']);
    assert.ok(undoStep(true));
    assert.equal(shown(), 'balls:\n  cue: {at: [0.5, 1.25], spin: [1]}\n  one: {at: [1, 2], spin: 8}\n');
    assert.ok(undoStep(true));
    assert.equal(shown(), kText);
});

test('TextChanged_LinesAddedAndRemovedWhileADragRuns_KeepsBoth', async () => {
    const text = kText + 'events:\n  - strike: {ball: cue, speed: 1}\n  - strike: {ball: one, speed: 2}\n';
    await open(text);
    const gesture = beginGesture();
    gesture.update([{ path: ['events', '1', 'strike', 'speed'], value: 5 }]);
    await send();
    tellText(shown().replace('  - strike: {ball: cue, speed: 1}\n', ''));  // what was item 1 is item 0
    assert.equal(shown(), `${kText}events:\n  - strike: {ball: one, speed: 5}\n`);
    gesture.update([{ path: ['events', '1', 'strike', 'speed'], value: 6 }]);
    await send();
    tellText(`# new\n${shown()}`);
    gesture.update([{ path: ['events', '1', 'strike', 'speed'], value: 7 }]);
    gesture.commit('Speed');
    assert.equal(shown(), `# new\n${kText}events:\n  - strike: {ball: one, speed: 7}\n`);
});

test('TextChanged_SameValueWhileADragRuns_TellsAndTheLastOneCounts', async () => {
    await open();
    notice.value = null;
    const gesture = beginGesture();
    gesture.update([{ path: kAt, value: 0.75 }]);
    await send();
    const theirs = kText.replace('0.5', '0.9').replace('spin: 3', 'spin: 8');
    tellText(theirs);
    assert.equal(shown(), theirs);
    assert.match(notice.value!.text, /Another window changed the same lines/);
    gesture.update([{ path: kAt, value: 0.8 }]);
    gesture.commit('Move');
    assert.equal(shown(), theirs.replace('0.9', '0.8'));
    assert.ok(undoStep(true));
    assert.equal(shown(), theirs);
});

test('TextChanged_MadeBeforeItKnewOfAnEditHere_KeepsBoth', async () => {
    await open();
    applyChanges([{ path: kSpin, value: 4 }], 'Spin');
    const own = shown();
    await send();
    tellText(kText.replace('0.5', '0.6'), 1);
    assert.equal(shown(), own.replace('0.5', '0.6'));
    const both = await send();
    // What takes the own edit back, knowing of it, is taken.
    tellText(kText.replace('0.5', '0.6'), both);
    assert.equal(shown(), kText.replace('0.5', '0.6'));
    // The same word on both sides: what came last counts, and the user is told.
    notice.value = null;
    applyChanges([{ path: kSpin, value: 5 }], 'Spin');
    await send();
    tellText(kText.replace('0.5', '0.7').replace('spin: 3', 'spin: 6'), textVersion.value - 1);
    assert.equal(shown(), kText.replace('0.5', '0.7').replace('spin: 3', 'spin: 6'));
    assert.match(notice.value!.text, /what was changed last counts/);
});

test('TextChanged_SentAtTheSameTime_IsTheBaseOfWhatFollows', async () => {
    await open();
    applyChanges([{ path: kSpin, value: 4 }], 'Spin');
    const mine = await send();
    // The server had the other one first, so the own text became the next version.
    tell('text_changed', { v: mine, file: '/a.yaml', text: kText.replace('0.5', '0.6'), base: 1 });
    tell('text_changed', { v: mine + 1, file: '/a.yaml', text: shown(), base: 1 });
    assert.equal(shown(), kText.replace('spin: 3', 'spin: 4'));
    applyChanges([{ path: kSpin, value: 5 }], 'Spin');
    await send();
    assert.equal((sent.at(-1) as unknown as { base: number }).base, mine + 1);
    // The other one merges both, and goes on.
    tell('text_changed', { v: textVersion.value + 1, file: '/a.yaml', base: mine + 1,
        text: '# c\n' + kText.replace('0.5', '0.6').replace('spin: 3', 'spin: 4') });
    assert.equal(shown(), '# c\n' + kText.replace('0.5', '0.6').replace('spin: 3', 'spin: 5'));
});
