/// Edits of the shot by key path. Nothing but the text is changed, and of it only the bytes of the
/// value; what the page draws follows from the server's answer.
import { send } from '../connection/socket';
import type { KeyPath } from '../protocol';
import { dragging, notice } from '../state/state';
import { bufferOf, restore, snapshot, typeOutside, typeStep } from '../text/buffers';
import { indentRest, nestBlock } from './add_entry';
import { currentFiles } from './current_files';
import { EditError, PlaceError } from './edit_error';
import type { Change, Choice, EditResult, Gesture, SourceFile } from './edit_types';
import { originOf } from './origin';
import { replaceKey } from './plan_replace';
import {
    planEntry, planInsert, planRemove, planSet, planTakeList, Undecided, type FileEdits,
} from './plan';
import { question } from './question';
import { unitFor } from './schema_unit';
import { applyEdits, difference } from './text_edit';
import { writeValue } from './write_value';

export type { Change, Choice, EditResult, Gesture, Origin, Value } from './edit_types';
export { originOf, sourceOf, type Source } from './origin';

/// What the user has answered; kept as long as the page is open.
const aliases = new Map<string, 'anchor' | 'copy'>();

function done(file: string): EditResult {
    return { ok: true, file, message: '', choices: [] };
}

/// What an edit needs to be tried again: with an answer, or by hand.
interface Attempt {
    again: () => EditResult;
    /// What it would have written, for the user to add.
    text: string;
    path: KeyPath;
}

/// The answers to a question of a plan; each tries the edit again.
function choicesOf(error: Undecided, again: () => void): Choice[] {
    const name = error.subject;
    const decide = (decision: 'anchor' | 'copy') => () => {
        aliases.set(name, decision);
        again();
    };
    if (error.kind === 'alias') {
        return [
            { label: 'Change it everywhere', about: `All places that repeat '&${name}' follow.`,
                apply: decide('anchor') },
            { label: 'Only here', about: 'A copy of the value is put here.', apply: decide('copy') },
        ];
    }
    const list = name.split('/');
    return [{
        label: 'Copy the list into the shot', about: 'A step of its own, which undo takes back.',
        apply: () => {
            const copied = applyPlan((files) => withEdits(files, planTakeList(files, list)),
                `Copy ${list.join('.')} into the shot`, null);
            if (copied.ok) {
                again();
            }
        },
    }];
}

/// The result of an edit that was not possible; shown in the status line, too. With an attempt, the
/// user is asked what can be answered.
function refused(error: unknown, attempt: Attempt | null): EditResult {
    if (!(error instanceof Undecided) && !(error instanceof EditError)) {
        throw error;
    }
    const { message } = error;
    const isQuestion = error instanceof Undecided;
    const choices = isQuestion ? choicesOf(error, attempt?.again ?? (() => undefined)) : [];
    notice.value = { kind: isQuestion ? 'info' : 'error', text: message };
    if (attempt && (isQuestion || error instanceof PlaceError)) {
        const title = !isQuestion ? 'This cannot be written by the page'
            : error.kind === 'alias' ? 'Change the repeated value?' : 'Copy the list into the shot?';
        question.value = { title, message, choices, path: attempt.path,
            text: isQuestion ? '' : attempt.text };
    }
    return { ok: false, file: '', message, choices };
}

/// The files with the edits of one of them made.
function withEdits(files: SourceFile[], { file, edits }: FileEdits): SourceFile[] {
    return files.map((one) => one.file === file.file
        ? { ...one, text: applyEdits(one.text, edits) } : one);
}

function checkOption(path: KeyPath): void {
    if (originOf(path) === 'set') {
        throw new EditError(`'${path.join('.')}' is given by an option of the command`);
    }
}

/// The files with all changes made. Throws EditError and Undecided.
function changed(files: SourceFile[], changes: readonly Change[]): SourceFile[] {
    return changes.reduce((all, { path, value, precision, insteadOf, intoInclude }) => {
        checkOption(path);
        const decisions = { aliases, intoInclude: intoInclude ?? false };
        const style = { unit: unitFor(path), precision };
        if (insteadOf !== undefined) {
            return replaceKey(all, path, insteadOf, value, style, decisions);
        }
        return withEdits(all, planSet(all, path, value, style, decisions));
    }, files);
}

/// The changes that turn the texts of the page into `after`.
function stepTo(after: readonly SourceFile[]): { file: string; changes: TextChangeSpec }[] {
    return after.flatMap(({ file, text }) => {
        const change = difference(bufferOf(file)?.state.doc.toString() ?? text, text);
        return change ? [{ file, changes: change }] : [];
    });
}

type TextChangeSpec = { from: number; to: number; insert: string };

function showTexts(texts: readonly SourceFile[]): void {
    for (const { file, changes } of stepTo(texts)) {
        typeOutside(file, changes);
    }
}

let current: Gesture | null = null;

/// Makes what `plan` returns one undo step. `manual` is what the user can write where the page
/// cannot; null: nothing is asked.
function applyPlan(
    plan: (files: SourceFile[]) => SourceFile[], label: string,
    manual: { text: string; path: KeyPath } | null,
): EditResult {
    current?.commit('');
    try {
        const step = stepTo(plan(currentFiles()));
        typeStep(step, label);
        return done(step[0]?.file ?? '');
    } catch (error) {
        return refused(error, manual && { ...manual, again: () => applyPlan(plan, label, manual) });
    }
}

/// Starts a drag. One may be in progress at a time: the one before is committed.
export function beginGesture(): Gesture {
    current?.commit('');
    const before = currentFiles();
    const states = snapshot();
    let last = before;
    let unanswered: Change[] | null = null;  // the last changes, if they need an answer
    send('dragging', { on: true });
    dragging.value = true;
    const gesture: Gesture = {
        update: (changes) => {
            try {
                last = changed(before, changes);
                unanswered = null;
                showTexts(last);
                return done(last.find((file, i) => file.text !== before[i]?.text)?.file ?? '');
            } catch (error) {
                unanswered = error instanceof Undecided ? changes : null;
                return refused(error, null);
            }
        },
        commit: (label) => {
            if (current === gesture) {
                current = null;
                dragging.value = false;
                send('dragging', { on: false });
                restore(states);
                typeStep(stepTo(last), label);
                if (unanswered) {
                    applyChanges(unanswered, label);
                }
            }
        },
        cancel: () => {
            if (current === gesture) {
                current = null;
                dragging.value = false;
                send('dragging', { on: false });
                restore(states);
            }
        },
    };
    current = gesture;
    return gesture;
}

/// Takes the drag in progress back; whether there was one.
export function cancelGesture(): boolean {
    const running = current;
    running?.cancel();
    return running !== null;
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

/// Makes all changes as one undo step.
export function applyChanges(changes: Change[], label: string): EditResult {
    const path = changes[0]?.path ?? [];
    const text = changes.map(byHand).join('\n');
    return applyPlan((files) => changed(files, changes), label, { text, path });
}

/// Takes a key with its value, or an item of a list, out of the text.
export function removeValue(path: KeyPath, label: string): EditResult {
    return applyPlan((files) => {
        checkOption(path);
        return withEdits(files, planRemove(files, path, { aliases }));
    }, label, { text: '', path });
}

/// Adds an item, written as YAML with an indent of 0, to a list before the item `index`.
export function insertItem(
    listPath: KeyPath, index: number, yaml: string, label: string,
): EditResult {
    return applyPlan((files) =>
        withEdits(files, planInsert(files, listPath, index, yaml, { aliases })), label,
        { text: `- ${indentRest(yaml, '  ')}`, path: listPath });
}

/// Adds an entry, its value written as YAML with an indent of 0, to a map.
export function insertEntry(
    mapPath: KeyPath, key: string, yaml: string, label: string,
): EditResult {
    return applyPlan((files) =>
        withEdits(files, planEntry(files, mapPath, key, yaml, { aliases })), label,
        { text: nestBlock([...mapPath, key], yaml, true), path: mapPath });
}

/// After the last item of any list.
const kLast = 1_000_000;

/// Adds parts of another shot, as one undo step.
export function insertParts(
    parts: readonly { section: string; name: string; yaml: string }[], label: string,
): EditResult {
    const manual = parts.map(({ section, name, yaml }) =>
        nestBlock(section === 'cameras' ? [section] : [section, name], yaml, true)).join('\n');
    return applyPlan((files) => parts.reduce((all, { section, name, yaml }) =>
        withEdits(all, section === 'cameras'
            ? planInsert(all, [section], kLast, yaml, { aliases })
            : planEntry(all, [section], name, yaml, { aliases })), files), label,
    { text: manual, path: [] });
}
