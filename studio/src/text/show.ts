/// Shows a range of a file in the editor.
import { EditorView } from '@codemirror/view';
import type { TextRange } from '../protocol';
import { activeFile, bufferOf } from './buffers';
import { offsetsOf } from './offsets';

let view: EditorView | null = null;

export function setShownView(shown: EditorView | null): void {
    view = shown;
}

/// Opens the file's tab, selects the range and gives the editor the focus.
export function showRange(range: TextRange): void {
    const buffer = bufferOf(range.file);
    const place = buffer && offsetsOf(buffer.state.doc, range);
    if (!place) {
        return;
    }
    activeFile.value = range.file;
    queueMicrotask(() => {
        view?.dispatch({
            selection: { anchor: place.from, head: place.to },
            effects: EditorView.scrollIntoView(place.from, { y: 'center' }),
        });
        view?.focus();
    });
}
