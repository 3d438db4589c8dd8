/// Edits of the shot by key path. Nothing but the text is changed, and of it only the bytes of the
/// value; what the page draws follows from the server's answer.
import type { KeyPath } from '../protocol';

/// Values as carom's YAML has them: numbers in SI units (m, s, rad), texts, booleans, lists.
export type Value = number | string | boolean | Value[];

export interface Change {
    path: KeyPath;
    value: Value;
    /// The step that the view resolves, in SI units: a number is not written finer than this.
    precision?: number;
}

/// Where an edit went, or why it is not possible.
export interface EditResult {
    ok: boolean;
    /// The file that was edited; empty if none was.
    file: string;
    /// A sentence to show: why the edit is not possible, or what it did beside the obvious.
    message: string;
}

/// A drag in progress. `update` types into the text outside of the history; `commit` turns all of
/// it into one undo step; `cancel` restores the text as it was.
export interface Gesture {
    update(changes: Change[]): EditResult;
    commit(label: string): void;
    cancel(): void;
}

export type Origin = 'shot' | 'include' | 'config' | 'set' | 'absent';

const kNotYet: EditResult = { ok: false, file: '', message: 'This page cannot edit yet.' };

/// Starts a drag. One may be in progress at a time: the one before is committed.
export function beginGesture(): Gesture {
    return { update: () => kNotYet, commit: () => undefined, cancel: () => undefined };
}

/// Makes all changes as one undo step.
export function applyChanges(_changes: Change[], _label: string): EditResult {
    return kNotYet;
}

/// Takes a key with its value, or an item of a list, out of the text.
export function removeValue(_path: KeyPath, _label: string): EditResult {
    return kNotYet;
}

/// Adds an item, written as YAML with an indent of 0, to a list before the item `index`.
export function insertItem(
    _listPath: KeyPath, _index: number, _yaml: string, _label: string,
): EditResult {
    return kNotYet;
}

/// Where the value of a key path comes from.
export function originOf(_path: KeyPath): Origin {
    return 'absent';
}
