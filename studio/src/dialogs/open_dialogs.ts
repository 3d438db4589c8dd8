/// The dialogs that are open, the uppermost last, for parts of the page that ask a question without
/// drawing anything themselves.
import { signal } from '@preact/signals';
import type { ComponentChildren } from 'preact';
import type { DialogAction } from './Dialog';

export interface OpenDialog {
    title: string;
    /// Drawn anew whenever a signal that it reads changes.
    body?: () => ComponentChildren;
    actions?: () => readonly DialogAction[];
    size?: 'small' | 'wide' | 'full';
    /// Called once when it is closed by something else than a button.
    onDismiss?: () => void;
}

/// A dialog with its number, by which it is closed.
interface Numbered extends OpenDialog {
    id: number;
}

export const openDialogs = signal<readonly Numbered[]>([]);
let lastId = 0;

/// Shows a dialog over everything. Returns a function that closes it.
export function openDialog(dialog: OpenDialog): () => void {
    lastId += 1;
    const id = lastId;
    openDialogs.value = [...openDialogs.value, { ...dialog, id }];
    return () => closeDialog(id);
}

export function closeDialog(id: number): void {
    openDialogs.value = openDialogs.value.filter((one) => one.id !== id);
}

/// Asks a question with a few answers. Resolves to the label of the chosen one, or to null if the
/// user chose none. The first answer is the one that Enter gives.
export function ask(
    title: string, body: () => ComponentChildren,
    answers: readonly { label: string; kind?: DialogAction['kind']; about?: string }[],
): Promise<string | null> {
    return new Promise((resolve) => {
        openDialog({
            title, body, onDismiss: () => resolve(null),
            actions: () => answers.map((answer, i) => ({
                kind: i === 0 ? 'primary' : 'plain', ...answer,
                run: () => resolve(answer.label),
            })),
        });
    });
}
