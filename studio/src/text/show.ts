/// Shows a range of a file in the editor.
import { EditorView } from '@codemirror/view';
import type { TextRange } from '../protocol';
import { activeFile, bufferOf } from './buffers';
import { offsetsOf } from './offsets';

let view: EditorView | null = null;
let unfold = () => {};

export function setShownView(shown: EditorView | null): void {
    view = shown;
}

/// Says how the text is unfolded if it is folded away.
export function setUnfolding(how: () => void): void {
    unfold = how;
}

/// Opens the file's tab, selects the range and gives the editor the focus.
export function showRange(range: TextRange): void {
    const buffer = bufferOf(range.file);
    const place = buffer && offsetsOf(buffer.state.doc, range);
    if (!place) {
        return;
    }
    unfold();
    activeFile.value = range.file;
    // After the page has drawn the text that was folded away.
    queueMicrotask(() => {
        view?.dispatch({
            selection: { anchor: place.from, head: place.to },
            effects: EditorView.scrollIntoView(place.from, { y: 'center' }),
        });
        view?.focus();
    });
}
