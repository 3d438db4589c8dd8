/// Binary messages: a 32-bit type, the 32-bit length of the head, the head as JSON, padding to a
/// multiple of 4 bytes, and the payload. Everything is little-endian.
export interface BinaryMessage {
    type: number;
    head: unknown;
    /// The bytes after the head, in a buffer of their own so that numbers of any size can be read
    /// in place.
    payload: ArrayBuffer;
}

const kHeadAt = 8;

/// The parts of a binary message. Throws if the lengths do not fit or the head is not JSON.
export function decodeBinary(message: ArrayBuffer): BinaryMessage {
    if (message.byteLength < kHeadAt) {
        throw new Error('a binary message is shorter than its two first numbers');
    }
    const numbers = new DataView(message);
    const type = numbers.getUint32(0, true);
    const length = numbers.getUint32(4, true);
    if (kHeadAt + length > message.byteLength) {
        throw new Error(`the head of a binary message has ${length} bytes, more than the message`);
    }
    const text = new TextDecoder().decode(new Uint8Array(message, kHeadAt, length));
    const payloadAt = Math.min(message.byteLength, Math.ceil((kHeadAt + length) / 4) * 4);
    return { type, head: JSON.parse(text), payload: message.slice(payloadAt) };
}

/// The payload as 64-bit numbers. Throws if bytes are left over.
export function asFloat64(payload: ArrayBuffer): Float64Array {
    if (payload.byteLength % 8 !== 0) {
        throw new Error(`${payload.byteLength} bytes are no whole number of 64-bit numbers`);
    }
    return new Float64Array(payload);
}
