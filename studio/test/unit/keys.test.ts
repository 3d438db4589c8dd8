import assert from 'node:assert/strict';
import { test } from 'node:test';
import { bindingOf, keyName, kKeyBindings, onCommand, runCommand } from '../../src/state/keys';

function press(key: string, modifiers: Partial<KeyboardEvent> = {}) {
    return keyName({
        key, ctrlKey: false, metaKey: false, altKey: false, shiftKey: false, ...modifiers,
    });
}

test('KeyName_ModifiersAndSigns_AreWrittenAsInTheTable', () => {
    assert.equal(press('Z', { ctrlKey: true, shiftKey: true }), 'ctrl+shift+z');
    assert.equal(press('s', { metaKey: true }), 'ctrl+s');
    assert.equal(press('?', { shiftKey: true }), '?');
    assert.equal(press(' '), 'space');
    assert.equal(press('ArrowLeft', { shiftKey: true }), 'shift+arrowleft');
});

test('Keys_OfTwoCommands_AreNeverTheSame', () => {
    const keys = kKeyBindings.flatMap((binding): readonly string[] => binding.keys);
    assert.equal(new Set(keys).size, keys.length);
    for (const key of keys) {
        assert.ok(bindingOf(key));
    }
});

test('OnCommand_LaterActionTakenBack_LeavesTheEarlierOne', () => {
    let done = '';
    const first = onCommand('refine', () => { done = 'first'; });
    const second = onCommand('refine', () => { done = 'second'; });
    runCommand('refine');
    assert.equal(done, 'second');
    second();
    runCommand('refine');
    assert.equal(done, 'first');
    first();
    assert.equal(runCommand('refine'), false);
});
