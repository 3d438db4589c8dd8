import assert from 'node:assert/strict';
import { test } from 'node:test';
import { asFloat64, decodeBinary } from '../../src/connection/decode';

/// A message as the server makes it.
function encode(type: number, head: object, numbers: number[]): ArrayBuffer {
    let text = JSON.stringify(head);
    text = text.padEnd(Math.ceil((8 + text.length) / 4) * 4 - 8, ' ');
    const message = new ArrayBuffer(8 + text.length + 8 * numbers.length);
    const view = new DataView(message);
    view.setUint32(0, type, true);
    view.setUint32(4, text.length, true);
    new Uint8Array(message, 8).set(new TextEncoder().encode(text));
    numbers.forEach((number, i) => view.setFloat64(8 + text.length + 8 * i, number, true));
    return message;
}

test('DecodeBinary_AnyLengthOfHead_GivesHeadAndNumbers', () => {
    for (let length = 0; length < 9; length += 1) {
        const head = { v: 3, name: 'x'.repeat(length) };
        const { type, head: found, payload } = decodeBinary(encode(7, head, [1.5, -2]));
        assert.equal(type, 7);
        assert.deepEqual(found, head);
        assert.deepEqual([...asFloat64(payload)], [1.5, -2]);
    }
});

test('DecodeBinary_HeadLongerThanMessage_Throws', () => {
    const message = encode(1, {}, []);
    new DataView(message).setUint32(4, 1000, true);
    assert.throws(() => decodeBinary(message), /has 1000 bytes/);
    assert.throws(() => decodeBinary(new ArrayBuffer(4)), /shorter/);
    assert.throws(() => asFloat64(new ArrayBuffer(12)), /12 bytes/);
});
