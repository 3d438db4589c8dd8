/// Makes planned changes steps of undo, and asks what they leave open.
import type { KeyPath } from '../protocol';
import { notice } from '../state/state';
import { bufferOf, typeStep } from '../text/buffers';
import { endDrag } from '../text/live_drag';
import { nestBlock } from './add_entry';
import { answersFor, keepAnswer, kNoAnswers, type Answers } from './answers';
import { currentFiles, textOfDocument } from './current_files';
import type { Decisions } from './decisions';
import { EditError, PlaceError } from './edit_error';
import type { Change, Choice, EditResult, SourceFile, Value } from './edit_types';
import { withEdits } from './file_edits';
import { originOf } from './origin';
import { planTakeList, Undecided } from './plan';
import { setAlone } from './plan_replace';
import { question } from './question';
import { checkScenePath } from './scene_paths';
import { rivalsFor, unitFor } from './schema_facts';
import { difference } from './text_edit';
import { writeValue } from './write_value';

export type Plan = (files: SourceFile[], decisions: Decisions) => SourceFile[];

/// What an edit needs to be tried again: with answers, or by hand.
interface Attempt {
    again: (answers: Answers) => void;
    answers: Answers;
    /// What it would have written, for the user to add.
    text: string;
    path: KeyPath;
}

export function done(file: string): EditResult {
    return { ok: true, file, message: '', choices: [] };
}

/// The answers to the question whether a repeated value is changed where it is written.
function aliasChoices({ subject, shown }: Undecided, { again, answers }: Attempt): Choice[] {
    const everywhere = () => again(new Map([...answers, [subject, 'anchor']]));
    return [
        { label: 'Everywhere', about: `All places that repeat '&${shown}' follow.`,
            apply: everywhere },
        { label: 'Only here', about: 'A copy of the value is put here.',
            apply: () => again(new Map([...answers, [subject, 'copy']])) },
        { label: 'Always',
            about: `Everywhere, and '&${shown}' is not asked about again while this shot is open.`,
            apply: () => {
                keepAnswer(subject, 'anchor');
                everywhere();
            } },
    ];
}

function listChoices({ subject, shown }: Undecided, { again, answers }: Attempt): Choice[] {
    return [{
        label: 'Copy the list into the shot', about: 'A step of its own, which undo takes back.',
        apply: () => {
            const list = subject.split('/');
            const copied = applyPlan((files) => withEdits(files, planTakeList(files, list)),
                `Copy ${shown} into the shot`, null);
            if (copied.ok) {
                again(answers);
            }
        },
    }];
}

/// The result of an edit that was not possible; shown in the status line, too. With an attempt, the
/// user is asked what can be answered.
export function refused(error: unknown, attempt: Attempt | null): EditResult {
    if (!(error instanceof Undecided) && !(error instanceof EditError)) {
        throw error;
    }
    const { message } = error;
    const isQuestion = error instanceof Undecided;
    const choices = !isQuestion || !attempt ? []
        : error.kind === 'alias' ? aliasChoices(error, attempt) : listChoices(error, attempt);
    notice.value = { kind: isQuestion ? 'info' : 'error', text: message };
    if (attempt && (isQuestion || error instanceof PlaceError)) {
        const title = !isQuestion ? 'This cannot be written by the page'
            : error.kind === 'alias' ? 'Change the repeated value?' : 'Copy the list into the shot?';
        question.value = { title, message, choices, path: attempt.path,
            text: isQuestion ? '' : attempt.text };
    }
    return { ok: false, file: '', message, choices };
}

export function checkOption(path: KeyPath): void {
    if (originOf(path) === 'set') {
        throw new EditError(`'${path.join('.')}' is given by an option of the command`);
    }
}

function isFinite(value: Value): boolean {
    return Array.isArray(value) ? value.every(isFinite)
        : typeof value !== 'number' || Number.isFinite(value);
}

/// The files with all changes made. Throws EditError and Undecided.
export function changed(
    files: SourceFile[], changes: readonly Change[], { aliases }: Decisions,
): SourceFile[] {
    return changes.reduce((all, { path, value, precision, intoInclude }) => {
        checkOption(path);
        if (!isFinite(value)) {
            throw new EditError(`'${path.join('.')}' would not be a finite number`);
        }
        const decisions = { aliases: aliases ?? kNoAnswers, intoInclude: intoInclude ?? false };
        return setAlone(all, path, rivalsFor, value, { unit: unitFor(path), precision }, decisions);
    }, files);
}

/// The changes that turn the texts of the page into `after`.
export function stepTo(
    after: readonly SourceFile[],
): { file: string; changes: { from: number; to: number; insert: string } }[] {
    return after.flatMap(({ file, text }) => {
        const document = bufferOf(file)?.state.doc;
        const change = document ? difference(textOfDocument(document), text) : null;
        return change ? [{ file, changes: change }] : [];
    });
}

/// Makes what `plan` returns one undo step. `manual` is what the user can write where the page
/// cannot; null: nothing is asked.
export function applyPlan(
    plan: Plan, label: string, manual: { text: string; path: KeyPath } | null,
    answers: Answers = kNoAnswers,
): EditResult {
    endDrag(true);
    try {
        const files = currentFiles();
        const step = stepTo(plan(files, { aliases: answersFor(files, answers) }));
        typeStep(step, label);
        return done(step[0]?.file ?? '');
    } catch (error) {
        const again = (more: Answers) => { applyPlan(plan, label, manual, more); };
        return refused(error, manual && { ...manual, answers, again });
    }
}

/// A change as text, for the user to write.
function byHand({ path, value, precision }: Change): string {
    const written = writeValue(value, { unit: unitFor(path), precision });
    try {
        return nestBlock(path, written, true);
    } catch {
        return `${path[path.length - 1] ?? ''}: ${written}`;
    }
}

/// Makes all changes as one undo step. `isOfScene` as for a gesture: their paths come from the scene
/// that is shown.
export function applyChanges(changes: Change[], label: string, isOfScene = false): EditResult {
    const path = changes[0]?.path ?? [];
    const text = changes.map(byHand).join('\n');
    return applyPlan((files, decisions) => {
        changes.filter(() => isOfScene).forEach((one) => checkScenePath(one.path, files));
        return changed(files, changes, decisions);
    }, label, { text, path });
}
