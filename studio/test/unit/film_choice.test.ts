import assert from 'node:assert/strict';
import { test } from 'node:test';
import { problemOfSize, sizeOf } from '../../src/films/film_state';

test('SizeOf_TextsOfASize_AreWidthAndHeight', () => {
    for (const text of ['1920x1080', '1920 x 1080', ' 1920 × 1080 ', '1920, 1080']) {
        assert.deepEqual(sizeOf(text), [1920, 1080], text);
        assert.equal(problemOfSize(text), '');
    }
    for (const text of ['1920', '15 x 200', '1920 x', 'HD', '99999 x 20', '-1 x 20']) {
        assert.equal(sizeOf(text), null, text);
        assert.notEqual(problemOfSize(text), '', text);
    }
    assert.equal(problemOfSize(' '), '');
});
