import type { KeyPath } from '../protocol';
import type { TextEdit } from './text_edit';

/// Values as carom's YAML has them: numbers in SI units (m, s, rad), texts, booleans, lists.
export type Value = number | string | boolean | Value[] | YamlText;

/// A value as it is to be written, in flow style.
export interface YamlText {
    yaml: string;
}

export interface Change {
    path: KeyPath;
    value: Value;
    /// The step that the view resolves, in SI units: a number is not written finer than this.
    precision?: number;
    /// A value of an included file is changed there if it can be written, not laid over in the shot.
    intoInclude?: boolean;
}

/// Something that the user can choose when an edit could mean several things.
export interface Choice {
    label: string;
    /// What it changes, in a sentence.
    about: string;
    apply(): void;
}

/// Where an edit went, or why it is not possible.
export interface EditResult {
    ok: boolean;
    /// The file that was edited; empty if none was.
    file: string;
    /// A sentence to show: why the edit is not possible.
    message: string;
    /// What the user has been asked, if the edit could mean several things.
    choices: Choice[];
}

/// A drag in progress. `update` types into the text outside of the history; `commit` turns all of
/// it into one undo step; `cancel` restores the text as it was.
export interface Gesture {
    update(changes: Change[]): EditResult;
    commit(label: string): void;
    cancel(): void;
}

/// Where a value comes from: the shot's own file, a writable file that it includes, a file of
/// carom's, an option of the command, or nowhere.
export type Origin = 'shot' | 'include' | 'config' | 'set' | 'absent';

/// One of the texts that a shot is made of.
export interface SourceFile {
    file: string;
    name: string;
    text: string;
    writable: boolean;
}

/// A question that has to be answered before an edit is possible.
export interface EditQuestion {
    title: string;
    message: string;
    choices: Choice[];
    /// The text that the user can add where the page cannot; empty if that is no answer.
    text: string;
    /// Where it belongs.
    path: KeyPath;
}

/// The edits of one file.
export interface FileEdits {
    file: SourceFile;
    edits: TextEdit[];
}
