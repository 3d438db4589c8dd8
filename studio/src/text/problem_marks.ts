/// The compiler's problems as marks in the text, with a fix by one click where it knows one.
import { forEachDiagnostic, type Diagnostic } from '@codemirror/lint';
import type { EditorView } from '@codemirror/view';
import type { EditorState, Text } from '@codemirror/state';
import type { Problem, TextRange } from '../protocol';

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

/// The marks of the problems that lie in `file`.
export function marksOf(doc: Text, file: string, problems: readonly Problem[]): Diagnostic[] {
    return problems.flatMap((problem): Diagnostic[] => {
        const range = problem.place.file === file ? offsetsOf(doc, problem.place) : null;
        if (!range) {
            return [];
        }
        const severity = problem.severity === 'error' ? 'error' : 'warning';
        const actions = problem.suggestion === '' ? [] : [{
            name: `Replace by '${problem.suggestion}'`,
            apply: (view: EditorView, from: number, to: number) =>
                view.dispatch({ changes: { from, to, insert: problem.suggestion } }),
        }];
        return [{ ...range, severity, message: problem.message, actions }];
    });
}

/// The marks that a text shows, for tests: line and column from 1, in code points.
export function marksIn(
    state: EditorState,
): { severity: string; line: number; column: number; message: string }[] {
    const marks: { severity: string; line: number; column: number; message: string }[] = [];
    forEachDiagnostic(state, ({ severity, message }, from) => {
        const line = state.doc.lineAt(from);
        const column = [...line.text.slice(0, from - line.from)].length + 1;
        marks.push({ severity, line: line.number, column, message });
    });
    return marks;
}
