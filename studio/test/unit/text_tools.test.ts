import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Text } from '@codemirror/state';
import { dashColumn } from '../../src/text/dash_input';
import { hoveredAt } from '../../src/text/hover';
import { stepped } from '../../src/text/scrub';

test('Stepped_Numbers_ChangeByTheirLastDigit', () => {
    const cases: [string, number, string][] = [
        ['0.12', 3, '0.15'], ['0.12', -12, '0'], ['30 deg', 1, '31 deg'], ['57.15 mm', 2, '57.17 mm'],
        ['-0.75', -1, '-0.76'], ['8 m/s', 10, '18 m/s'], ['0.10', 5, '0.15'], ['0.10', 10, '0.20'],
        ['1e-3', 2, '0.003'], ['2.5e3', 1, '2600'], ['word', 3, 'word'],
    ];
    for (const [text, steps, expected] of cases) {
        assert.equal(stepped(text, steps), expected, text);
    }
});

test('HoveredAt_KeysAndScalars_HaveTheirPath', () => {
    const text = 'balls:\n  cue: {at: [0, -1.5]}  # c\nlist:\n  - a: b\n';
    const at = (word: string, plus = 0) => hoveredAt(text, text.indexOf(word) + plus);
    assert.deepEqual(at('at'), { path: ['balls', 'cue', 'at'], from: 15, to: 17, value: '',
        onKey: true });
    assert.deepEqual(at('-1.5', 2), { path: ['balls', 'cue', 'at', '1'], from: 23, to: 27,
        value: '-1.5', onKey: false });
    assert.deepEqual(at('a: b')?.path, ['list', '0', 'a']);
    assert.equal(at('# c'), null);
});

test('DashColumn_AfterAnItem_IsThatOfItsDash', () => {
    const doc = Text.of(['events:', '  - strike: {}', '    ', 'a:', '    b: 1', '    ']);
    assert.equal(dashColumn(doc, 3, 4), 2);
    assert.equal(dashColumn(doc, 6, 4), null);
});
