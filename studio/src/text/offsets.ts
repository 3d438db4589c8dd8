/// Places as the server tells them, in a document.
import type { Text } from '@codemirror/state';
import type { TextRange } from '../protocol';

/// The offsets of a range; columns and lengths are in code points.
export function offsetsOf(doc: Text, place: TextRange): { from: number; to: number } | null {
    if (place.line < 1) {
        return { from: 0, to: 0 };  // of the whole file
    }
    if (place.line > doc.lines) {
        return null;
    }
    const line = doc.line(place.line);
    const characters = [...line.text];
    const start = Math.max(0, place.column - 1);
    const before = characters.slice(0, start).join('').length;
    const inside = characters.slice(start, start + place.length).join('').length;
    return { from: line.from + before, to: line.from + before + inside };
}
