/// A dash at the start of a line begins the next item of the list above, at the column of its dash.
import { EditorView } from '@codemirror/view';
import type { Text } from '@codemirror/state';

/// The column of the dash of the item whose content begins at `column`, above a line; null if the
/// line does not follow one.
export function dashColumn(doc: Text, line: number, column: number): number | null {
    for (let number = line - 1; number >= 1; --number) {
        const { text } = doc.line(number);
        const indent = text.length - text.trimStart().length;
        const dash = /^( *)-( +)\S/.exec(text);
        if (dash && indent + 1 + (dash[2]?.length ?? 0) === column) {
            return indent;
        }
        if (text.trim() !== '' && indent < column) {
            return null;
        }
    }
    return null;
}

export const dashInput = EditorView.inputHandler.of((view, from, to, text) => {
    const line = view.state.doc.lineAt(from);
    const before = view.state.sliceDoc(line.from, from);
    if (text !== '-' || from !== to || before === '' || before.trim() !== '') {
        return false;
    }
    const column = dashColumn(view.state.doc, line.number, before.length);
    if (column === null) {
        return false;
    }
    const insert = `${' '.repeat(column)}-`;
    view.dispatch({
        changes: { from: line.from, to, insert },
        selection: { anchor: line.from + insert.length }, userEvent: 'input.type',
    });
    return true;
});
