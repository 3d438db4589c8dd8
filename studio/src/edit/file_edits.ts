/// Edits that build on each other, and what files are with them.
import type { FileEdits, SourceFile } from './edit_types';
import { applyEdits, type TextEdit } from './text_edit';

/// The files with the edits of one of them made.
export function withEdits(
    files: readonly SourceFile[], { file, edits }: FileEdits,
): SourceFile[] {
    return files.map((one) => one.file === file.file
        ? { ...one, text: applyEdits(one.text, edits) } : one);
}

/// The file with `edit` made, for edits that build on it.
export function after(file: SourceFile, edit: TextEdit): SourceFile {
    return { ...file, text: applyEdits(file.text, [edit]) };
}

/// Edits of the text before `first` was made that do both `first` and `then`.
export function both(file: SourceFile, first: TextEdit, then: readonly TextEdit[]): TextEdit[] {
    // One edit over everything that either of them touches.
    const middle = after(file, first).text;
    const grown = first.insert.length - (first.to - first.from);
    const from = Math.min(first.from, ...then.map((edit) => edit.from));
    const to = Math.max(first.from + first.insert.length, ...then.map((edit) => edit.to));
    let insert = middle.slice(from, to);
    for (const edit of [...then].sort((a, b) => b.from - a.from)) {
        insert = insert.slice(0, edit.from - from) + edit.insert + insert.slice(edit.to - from);
    }
    return [{ from, to: to - grown, insert }];
}
