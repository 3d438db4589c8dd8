/// Files that another program changed while the page has changes of its own, or took away.
import { signal } from '@preact/signals';
import { notice } from '../state/state';
import { bufferOf, setDisk, setText, textOf } from './buffers';

export interface Conflict {
    file: string;
    /// What is on disk now.
    text: string;
    hash: string;
    /// What became of a file that cannot be read any more: "was deleted"; else empty.
    gone: string;
}

export const conflicts = signal<readonly Conflict[]>([]);

export function conflictOf(file: string): Conflict | undefined {
    return conflicts.value.find((one) => one.file === file);
}

export function forgetConflict(file: string): void {
    if (conflictOf(file)) {
        conflicts.value = conflicts.value.filter((one) => one.file !== file);
    }
}

/// Takes note of what is on disk. Returns whether the page has another text, which must be merged.
export function noteDisk(conflict: Conflict): boolean {
    const buffer = bufferOf(conflict.file);
    if (!buffer) {
        return false;
    }
    if (conflict.gone === ''
        && (textOf(buffer) === conflict.text || textOf(buffer) === buffer.savedText)) {
        setText(conflict.file, conflict.text, 'Take over from disk');
        setDisk(conflict.file, conflict.text, conflict.hash);
        forgetConflict(conflict.file);
        return false;
    }
    conflicts.value = [...conflicts.value.filter(({ file }) => file !== conflict.file), conflict];
    if (conflict.gone !== '') {
        setDisk(conflict.file, buffer.savedText, '');
    }
    notice.value = {
        kind: 'error', text: conflict.gone === ''
            ? `${buffer.name} changed on disk. It was not written over.`
            : `${buffer.name} ${conflict.gone}. The text is still here, but not saved.`,
    };
    return true;
}

/// A file can be read again as the page has it, or as the page shows it from now on.
export function noteReturn(file: string, hash: string): void {
    const conflict = conflictOf(file);
    if (conflict && (conflict.gone === '' ? conflict.hash : '') !== hash) {
        forgetConflict(file);
    }
}

/// Ends a conflict: the page goes on with `text`, knowing what is on disk.
export function resolveConflict(conflict: Conflict, text: string, label: string): void {
    setText(conflict.file, text, label);
    setDisk(conflict.file, conflict.text, conflict.hash);
    forgetConflict(conflict.file);
}
