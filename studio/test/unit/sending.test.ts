/// What is sent to the server, over a socket that only listens.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { Problem } from '../../src/protocol';
import { textUnderWay, textVersion, tooLongFile } from '../../src/state/state';
import { buffers, setChangeListener, textOf, typeStep } from '../../src/text/buffers';
import { marksOf } from '../../src/text/problem_marks';
import { sendSoon, watchAnswers } from '../../src/text/sending';
import { undoTitle } from '../../src/text/steps';
import { openText, sent, tell } from './listening';

const kText = 'balls: {cue: {att: [0, 0]}}\n';
const open = (writable = true): Promise<void> => openText(kText, writable);

async function type(insert: string): Promise<void> {
    typeStep([{ file: '/a.yaml', changes: { from: 0, insert } }]);
    await Promise.resolve();
}

const texts = () => sent.filter(({ t }) => t === 'text');

watchAnswers();
setChangeListener(sendSoon);

test('Sending_TextThatIsTooLong_IsNotSentUntilItIsShorter', async () => {
    await open();
    await type(`# ${'\u00e9'.repeat(2_097_152)}\n`);  // of two bytes each
    assert.deepEqual(texts(), []);
    assert.equal(tooLongFile.value, '/a.yaml');
    assert.equal(textUnderWay.value, false);
    typeStep([{ file: '/a.yaml', changes: { from: 0, to: 2_097_152 } }]);
    await Promise.resolve();
    assert.equal(texts().length, 1);
    assert.equal(tooLongFile.value, '');
    tell('problems', { v: texts()[0]?.v, complete: true, list: [] });
});

test('Sending_RefusedText_DoesNotStopLaterOnes', async () => {
    await open();
    await type('#1\n');
    await type('#2\n');
    assert.deepEqual(texts().map(({ v }) => v), [2]);
    tell('failed', { what: 'text', v: 1, message: 'no' });
    assert.deepEqual(texts().map(({ v, text }) => [v, text]),
        [[2, `#1\n${kText}`], [2, `#2\n#1\n${kText}`]]);
    tell('problems', { v: 2, complete: true, list: [] });
    assert.equal(textUnderWay.value, false);
    assert.equal(textVersion.value, 2);
});

test('Sending_TextOfAnotherWindow_IsNotSentBack', async () => {
    await open();
    tell('text_changed', { v: 2, file: '/a.yaml', text: `#theirs\n${kText}` });
    await Promise.resolve();
    assert.equal(texts().length, 0);
    assert.equal(textUnderWay.value, false);
    await type('#1\n');
    assert.deepEqual(texts().map(({ v, text }) => [v, text]), [[3, `#1\n#theirs\n${kText}`]]);
    // The server had that one before it got the text under way.
    tell('text_changed', { v: 3, file: '/a.yaml', text: `#late\n${kText}` });
    assert.equal(textOf(buffers.value[0]!), `#1\n#theirs\n${kText}`);
    tell('text_changed', { v: 4, file: '/a.yaml', text: `#1\n#theirs\n${kText}` });
    tell('problems', { v: 4, complete: true, list: [] });
    await Promise.resolve();
    assert.equal(texts().length, 1);
    assert.equal(textUnderWay.value, false);
});

test('QuickFix_OfALockedFile_IsNotOffered_ElseItIsOneStep', async () => {
    const problem = { severity: 'error', message: 'unknown key', suggestion: 'at',
        place: { file: '/a.yaml', line: 1, column: 15, length: 3 } } as Problem;
    const marks = () => marksOf(buffers.value[0]!.state.doc, '/a.yaml', [problem]);
    await open(false);
    assert.deepEqual(marks()[0]?.actions, []);
    await open();
    const [action] = marks()[0]?.actions ?? [];
    action?.apply(null as never, 0, 0);
    assert.equal(textOf(buffers.value[0]!), kText.replace('att', 'at'));
    assert.equal(undoTitle.value, "Undo: Replace with 'at'");
});
