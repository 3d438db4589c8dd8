import assert from 'node:assert/strict';
import { test } from 'node:test';
import { fileOfName, freeName, problemOfName, titleOf } from '../../src/start/shot_name';

test('a name gets the ending .yaml once', () => {
    assert.equal(fileOfName('bank'), 'bank.yaml');
    assert.equal(fileOfName(' bank.yaml '), 'bank.yaml');
    assert.equal(fileOfName('a/b.yml'), 'a/b.yml');
    assert.equal(fileOfName('v1.2'), 'v1.2.yaml');
});

test('a name that is taken gets a number', () => {
    assert.equal(freeName('bank', []), 'bank');
    assert.equal(freeName('bank', ['bank.yaml', 'bank_2.yaml']), 'bank_3');
});

test('names that cannot be files are refused with a sentence', () => {
    assert.equal(problemOfName('a folder/bänk 2'), '');
    for (const name of ['', '  ', 'a/', '.hidden', 'a/.b', 'a:b', 'a\nb', 'x'.repeat(201)]) {
        assert.notEqual(problemOfName(name), '', JSON.stringify(name));
    }
});

test('a title has words and a capital', () => {
    assert.equal(titleOf('nine_ball_break'), 'Nine ball break');
});
