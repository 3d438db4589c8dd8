/// Texts that another window on the same shot sends.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { receive } from '../../src/connection/receive';
import { applyChanges } from '../../src/edit/edit';
import { textVersion } from '../../src/state/state';
import { buffers, setChangeListener, textOf } from '../../src/text/buffers';
import { sendSoon, watchAnswers } from '../../src/text/sending';
import { undoable } from '../../src/text/steps';
import { takeFiles } from '../../src/text/take_files';
import { undoStep } from '../../src/text/undo_commands';

const kText = 'balls:\n  cue: {at: [0.5, 1.25]}\n  one: {at: [1, 2], spin: 3}\n';
const kSpin = ['balls', 'one', 'spin'];

watchAnswers();
setChangeListener(sendSoon);

function open(text = kText): void {
    buffers.value = [];
    receive(JSON.stringify({ t: 'welcome', protocol: '', version: '', v: 1, shot: '/a', root: '/', output: '' }));
    const files = [{ file: '/a.yaml', name: 'a', text, hash: 'a', writable: true, changed: false }];
    receive(JSON.stringify({ t: 'files', v: 1, files }));
    takeFiles(files);
}

function tell(text: string): void {
    receive(JSON.stringify({ t: 'text_changed', v: textVersion.value + 1, file: '/a.yaml', text, base: textVersion.value }));
}

const shown = () => textOf(buffers.value[0]!);

test('TextChanged_OfADrag_IsOneStepOfItsOwn', () => {
    open();
    applyChanges([{ path: kSpin, value: 4 }], 'Spin');
    const own = shown();
    tell(own);  // as it would be if there were a connection to send it
    for (let i = 0; i < 5; ++i) {
        tell(own.replace('0.5', `0.${i}`));
    }
    assert.equal(shown(), own.replace('0.5', '0.4'));
    assert.deepEqual(undoable.value.map(({ label }) => label), ['Spin', 'Change in another window']);
    assert.ok(undoStep(true));
    assert.equal(shown(), own);
    assert.ok(undoStep(true));
    assert.equal(shown(), kText);
    assert.ok(undoStep(false) && undoStep(false));
    assert.equal(shown(), own.replace('0.5', '0.4'));
    // After an undo, what comes from there begins another step.
    assert.ok(undoStep(true));
    tell(own);
    tell(own.replace('0.5', '0.9'));
    assert.equal(undoStep(false), false);
    assert.ok(undoStep(true));
    assert.equal(shown(), own);
});

test('TextChanged_FileWithCarriageReturns_IsTakenWhole', () => {
    const text = kText.replaceAll('\n', '\r\n');
    open(text);
    tell(text.replace('spin: 3', 'spin: 31'));
    assert.equal(shown(), text.replace('spin: 3', 'spin: 31'));
    assert.ok(undoStep(true));
    assert.equal(shown(), text);
});
