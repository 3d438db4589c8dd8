/// What fixes a problem by one click.
import type { Problem } from '../protocol';
import { bufferOf, typeStep } from './buffers';
import { offsetsOf } from './offsets';

/// Whether the problem has a suggestion that the page can write.
export function canFix(problem: Problem): boolean {
    const buffer = bufferOf(problem.place.file);
    return problem.suggestion !== '' && (buffer?.writable ?? false)
        && offsetsOf(buffer!.state.doc, problem.place) !== null;
}

export function fixTitle(problem: Problem): string {
    return `Replace with '${problem.suggestion}'`;
}

/// Writes the suggestion in the place of the problem, as one step of undo.
export function fix(problem: Problem): void {
    const buffer = bufferOf(problem.place.file);
    const range = buffer && offsetsOf(buffer.state.doc, problem.place);
    if (range) {
        const changes = { ...range, insert: problem.suggestion };
        typeStep([{ file: problem.place.file, changes }], fixTitle(problem));
    }
}
