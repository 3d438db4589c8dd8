import type { Text } from '@codemirror/state';
import { buffers } from '../text/buffers';
import type { SourceFile } from './edit_types';

const texts = new WeakMap<Text, string>();

/// The text of a document. A drag asks for the same ones at each move.
export function textOfDocument(document: Text): string {
    const known = texts.get(document) ?? document.toString();
    texts.set(document, known);
    return known;
}

/// The shot's files as they stand in the page. Line breaks are "\n", as in the editor. Read inside a
/// component, it follows every change.
export function currentFiles(): SourceFile[] {
    return buffers.value.map(({ file, name, writable, state }) =>
        ({ file, name, writable, text: textOfDocument(state.doc) }));
}
