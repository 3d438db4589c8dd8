/// Edits of the shot by key path. Nothing but the text is changed, and of it only the bytes of the
/// value; what the page draws follows from the server's answer.
import { isMap, isSeq } from 'yaml';
import { send } from '../connection/socket';
import type { KeyPath } from '../protocol';
import { dragging, notice, shot } from '../state/state';
import { bufferOf, buffers, restore, snapshot, typeOutside, typeStep } from '../text/buffers';
import { EditError } from './edit_error';
import type { Change, EditResult, Gesture, Origin, SourceFile } from './edit_types';
import { locate } from './layers';
import { replaceKey } from './plan_replace';
import { planEntry, planInsert, planRemove, planSet, Undecided, type FileEdits } from './plan';
import { applyEdits, difference, lineStart } from './text_edit';
import { unitFor } from './schema_unit';
import { flowText } from './write_value';

export type { Change, Choice, EditResult, Gesture, Origin, Value } from './edit_types';

/// What the user has answered; kept as long as the page is open.
const aliases = new Map<string, 'anchor' | 'copy'>();
const takenLists = new Set<string>();

/// The shot's files as they stand in the page. Line breaks are "\n", as in the editor.
function currentFiles(): SourceFile[] {
    return buffers.value.map(({ file, name, writable, state }) =>
        ({ file, name, writable, text: state.doc.toString() }));
}

function done(file: string): EditResult {
    return { ok: true, file, message: '', choices: [] };
}

/// The result of an edit that was not possible; shown in the status line, too.
function refused(error: unknown): EditResult {
    if (error instanceof Undecided) {
        const choices = error.kind === 'alias'
            ? [
                { label: 'Change all', apply: () => aliases.set(error.subject, 'anchor') },
                { label: 'Only here', apply: () => aliases.set(error.subject, 'copy') },
            ]
            : [{ label: 'Copy the list into the shot', apply: () => takenLists.add(error.subject) }];
        notice.value = { kind: 'info', text: error.message };
        return { ok: false, file: '', message: error.message, choices };
    }
    if (error instanceof EditError) {
        notice.value = { kind: 'error', text: error.message };
        return { ok: false, file: '', message: error.message, choices: [] };
    }
    throw error;
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
    return changes.reduce((all, { path, value, precision, insteadOf }) => {
        checkOption(path);
        const style = { unit: unitFor(path), precision };
        if (insteadOf !== undefined) {
            return replaceKey(all, path, insteadOf, value, style, { aliases, takenLists });
        }
        return withEdits(all, planSet(all, path, value, style, { aliases, takenLists }));
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

/// Makes what `plan` returns one undo step.
function applyPlan(plan: (files: SourceFile[]) => SourceFile[], label: string): EditResult {
    try {
        const step = stepTo(plan(currentFiles()));
        typeStep(step, label);
        return done(step[0]?.file ?? '');
    } catch (error) {
        return refused(error);
    }
}

let current: Gesture | null = null;

/// Starts a drag. One may be in progress at a time: the one before is committed.
export function beginGesture(): Gesture {
    current?.commit('');
    const before = currentFiles();
    const states = snapshot();
    let last = before;
    send('dragging', { on: true });
    dragging.value = true;
    const gesture: Gesture = {
        update: (changes) => {
            try {
                last = changed(before, changes);
                showTexts(last);
                return done(last.find((file, i) => file.text !== before[i]?.text)?.file ?? '');
            } catch (error) {
                return refused(error);
            }
        },
        commit: (label) => {
            if (current === gesture) {
                current = null;
                dragging.value = false;
                send('dragging', { on: false });
                restore(states);
                typeStep(stepTo(last), label);
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

/// Makes all changes as one undo step.
export function applyChanges(changes: Change[], label: string): EditResult {
    return applyPlan((files) => changed(files, changes), label);
}

/// Takes a key with its value, or an item of a list, out of the text.
export function removeValue(path: KeyPath, label: string): EditResult {
    return applyPlan((files) => {
        checkOption(path);
        return withEdits(files, planRemove(files, path, { aliases }));
    }, label);
}

/// Adds an item, written as YAML with an indent of 0, to a list before the item `index`.
export function insertItem(
    listPath: KeyPath, index: number, yaml: string, label: string,
): EditResult {
    return applyPlan((files) =>
        withEdits(files, planInsert(files, listPath, index, yaml, { aliases })), label);
}

/// Adds an entry, its value written as YAML with an indent of 0, to a map.
export function insertEntry(
    mapPath: KeyPath, key: string, yaml: string, label: string,
): EditResult {
    return applyPlan((files) =>
        withEdits(files, planEntry(files, mapPath, key, yaml, { aliases })), label);
}

function isPrefix(prefix: KeyPath, path: KeyPath): boolean {
    return prefix.length <= path.length && prefix.every((key, i) => key === path[i]);
}

/// Where the value of a key path comes from.
export function originOf(path: KeyPath): Origin {
    const places = shot.value?.places ?? [];
    if (places.some((place) => place.origin === 'set' && isPrefix(place.path, path))) {
        return 'set';
    }
    const files = currentFiles();
    const located = locate(files, path);
    if (!located) {
        return 'absent';
    }
    return located.file === files[0] ? 'shot' : located.file.writable ? 'include' : 'config';
}

/// The text of a value as it is written now.
export interface Source {
    text: string;
    kind: 'scalar' | 'map' | 'list';
    file: string;
    /// From 1.
    line: number;
    origin: Origin;
}

/// The text of a key's value wherever it stands: of a scalar as it is written, of a map or list on
/// one line; null if no file has it.
export function sourceOf(path: KeyPath): Source | null {
    const located = locate(currentFiles(), path);
    const node = located?.way.steps[located.way.steps.length - 1]?.node;
    if (!located || !node) {
        return null;
    }
    const kind = isMap(node) ? 'map' : isSeq(node) ? 'list' : 'scalar';
    const before = located.tree.text.slice(0, lineStart(located.tree.text, node.range?.[0] ?? 0));
    const line = before.split('\n').length;
    const text = flowText(located.tree, node);
    return { text, kind, file: located.file.file, line, origin: originOf(path) };
}
