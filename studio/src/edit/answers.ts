/// What the user has answered about repeated values. An answer counts for one edit, or until another
/// shot is opened.
import type { AliasDecision } from './decisions';
import type { SourceFile } from './edit_types';

export type Answers = ReadonlyMap<string, AliasDecision>;

export const kNoAnswers: Answers = new Map();

let shot = '';
let lasting: Answers = kNoAnswers;

/// The answers of one edit, and those that last.
export function answersFor(files: readonly SourceFile[], own: Answers): Answers {
    const open = files[0]?.file ?? '';
    if (open !== shot) {
        shot = open;
        lasting = kNoAnswers;
    }
    return new Map([...lasting, ...own]);
}

/// Keeps an answer as long as the shot is open.
export function keepAnswer(key: string, decision: AliasDecision): void {
    lasting = new Map([...lasting, [key, decision]]);
}
