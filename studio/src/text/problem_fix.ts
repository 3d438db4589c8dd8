/// What mends a problem by one click.
import type { Problem } from '../protocol';
import { bufferOf, typeStep } from './buffers';
import { offsetsOf } from './problem_marks';

/// Whether the problem has a suggestion that the page can write.
export function canFix(problem: Problem): boolean {
    const buffer = bufferOf(problem.place.file);
    return problem.suggestion !== '' && (buffer?.writable ?? false)
        && offsetsOf(buffer!.state.doc, problem.place) !== null;
}

/// Writes the suggestion in the place of the problem, as one step of undo.
export function fix(problem: Problem): void {
    const buffer = bufferOf(problem.place.file);
    const range = buffer && offsetsOf(buffer.state.doc, problem.place);
    if (range) {
        typeStep([{ file: problem.place.file, changes: { ...range, insert: problem.suggestion } }],
            `Replace by '${problem.suggestion}'`);
    }
}
