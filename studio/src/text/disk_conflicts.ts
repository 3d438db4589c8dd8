/// Files that another program changed while the page has changes of its own.
import { signal } from '@preact/signals';
import { notice } from '../state/state';
import { bufferOf, isChanged, setDisk, setText, textOf } from './buffers';

export interface Conflict {
    file: string;
    /// What is on disk now.
    text: string;
    hash: string;
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
    if (textOf(buffer) === conflict.text || !isChanged(buffer)) {
        setText(conflict.file, conflict.text, 'Take over from disk');
        setDisk(conflict.file, conflict.text, conflict.hash);
        forgetConflict(conflict.file);
        return false;
    }
    conflicts.value = [...conflicts.value.filter(({ file }) => file !== conflict.file), conflict];
    notice.value = {
        kind: 'error', text: `${buffer.name} changed on disk. It was not written over.`,
    };
    return true;
}

/// Ends a conflict: the page goes on with `text`, knowing what is on disk.
export function resolveConflict(conflict: Conflict, text: string, label: string): void {
    setText(conflict.file, text, label);
    setDisk(conflict.file, conflict.text, conflict.hash);
    forgetConflict(conflict.file);
}
