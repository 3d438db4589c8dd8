/// The compiler's problems as marks in the text, with a fix by one click where it knows one.
import { forEachDiagnostic, type Diagnostic } from '@codemirror/lint';
import type { EditorState, Text } from '@codemirror/state';
import type { Problem } from '../protocol';
import { offsetsOf } from './offsets';
import { canFix, fix, fixTitle } from './problem_fix';

export { offsetsOf } from './offsets';

/// The marks of the problems that lie in `file`.
export function marksOf(doc: Text, file: string, problems: readonly Problem[]): Diagnostic[] {
    return problems.flatMap((problem): Diagnostic[] => {
        const range = problem.place.file === file ? offsetsOf(doc, problem.place) : null;
        if (!range) {
            return [];
        }
        const severity = problem.severity === 'error' ? 'error' : 'warning';
        const actions = canFix(problem)
            ? [{ name: fixTitle(problem), apply: () => fix(problem) }] : [];
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
