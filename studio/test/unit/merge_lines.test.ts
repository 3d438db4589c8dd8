import assert from 'node:assert/strict';
import { test } from 'node:test';
import { mergeLines } from '../../src/edit/merge_lines';

const merge = (base: string, own: string, other: string) =>
    mergeLines(...[base, own, other].map((text) => text.split('').join('\n')) as
        [string, string, string]);

test('MergeLines_ChangesOfOtherLines_AreBothKept', () => {
    assert.deepEqual(merge('abcdef', 'aBcdef', 'abcdeF'),
        { text: 'aBcdeF'.split('').join('\n'), conflicts: 0 });
    assert.deepEqual(merge('abcdef', 'abcdefg', 'zabcdef').text, 'zabcdefg'.split('').join('\n'));
    assert.deepEqual(merge('abcdef', 'acdef', 'abcdf').text, 'acdf'.split('').join('\n'));
    assert.deepEqual(merge('abc', 'abc', 'xyz').text, 'xyz'.split('').join('\n'));
    assert.deepEqual(merge('abc', 'xyz', 'abc').text, 'xyz'.split('').join('\n'));
    assert.deepEqual(mergeLines('', 'a\n', ''), { text: 'a\n', conflicts: 0 });
});

test('MergeLines_TheSameLine_KeepsTheOwnAndCounts', () => {
    assert.deepEqual(merge('abc', 'aXc', 'aYc'), { text: 'a\nX\nc', conflicts: 1 });
    assert.deepEqual(merge('abc', 'aXc', 'aXc'), { text: 'a\nX\nc', conflicts: 0 });
    assert.equal(merge('abcd', 'aXXd', 'abYd').conflicts, 1);
});

test('MergeLines_RandomChanges_OfOneSideOnlyGiveThatSide', () => {
    let seed = 1;
    const random = (most: number) => {
        seed = (seed * 48271) % 2147483647;
        return seed % most;
    };
    const change = (text: string) => {
        const lines = text.split('');
        for (let i = 0; i < 3; ++i) {
            lines.splice(random(lines.length + 1), random(3), ...'XYZ'.slice(0, random(3)));
        }
        return lines.join('');
    };
    for (let i = 0; i < 300; ++i) {
        const base = Array.from({ length: random(20) + 1 }, () => 'abc'[random(3)]).join('');
        const other = change(base);
        assert.equal(merge(base, base, other).text, other.split('').join('\n'));
        assert.equal(merge(base, other, base).text, other.split('').join('\n'));
        assert.deepEqual(merge(base, other, other),
            { text: other.split('').join('\n'), conflicts: 0 });
    }
});
