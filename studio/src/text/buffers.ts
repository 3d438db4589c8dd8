/// The texts of the shot's files as they stand in the page, each with its own history, and one
/// stack of undo steps over all of them.
import { isolateHistory, redo, undo, undoDepth } from '@codemirror/commands';
import { Transaction, type ChangeSpec, type EditorState } from '@codemirror/state';
import type { EditorView } from '@codemirror/view';
import { signal } from '@preact/signals';
import { difference } from '../edit/text_edit';
import { changeUnder, endDrag } from './live_drag';
import { joinsLast } from './states';
import { addStep, isLastStep, moveStep } from './steps';

export interface Buffer {
    file: string;
    name: string;
    writable: boolean;
    /// Of the file on disk, when it was last read or saved; empty: there is none.
    hash: string;
    savedText: string;
    state: EditorState;
}

/// The open files, the shot first; a new array whenever a text or a file changes.
export const buffers = signal<Buffer[]>([]);
export const activeFile = signal('');

type Listener = (file: string) => void;
let view: EditorView | null = null;
let onChange: Listener = () => undefined;
let isTravelling = false;  // while a step is undone or redone
let grouped: string[] | null = null;  // files of a step that changes several

/// What is called with the file whenever a text changed.
export function setChangeListener(listener: Listener): void {
    onChange = listener;
}

/// The view that shows the active file; null: none does.
export function attachView(shown: EditorView | null): void {
    view = shown;
}

export function bufferOf(file: string): Buffer | undefined {
    return buffers.value.find((buffer) => buffer.file === file);
}

/// The text of a buffer with the line breaks of its file.
export function textOf(buffer: Buffer): string {
    return buffer.state.sliceDoc();
}

/// Whether the text is not on disk as it stands in the page.
export function isChanged(buffer: Buffer): boolean {
    return buffer.hash === '' || textOf(buffer) !== buffer.savedText;
}

function remember(file: string): void {
    if (!grouped) {
        addStep({ files: [file], label: '' });
    } else if (!grouped.includes(file)) {
        grouped.push(file);
    }
}

/// Takes note of a transaction that `file` has had.
export function afterTransaction(file: string, transaction: Transaction): void {
    const buffer = bufferOf(file);
    if (!buffer) {
        return;
    }
    buffer.state = transaction.state;
    if (!transaction.docChanged) {
        return;
    }
    if (!isTravelling && undoDepth(transaction.state) > undoDepth(transaction.startState)) {
        remember(file);
    }
    buffers.value = [...buffers.value];
    onChange(file);
}

/// Changes a text, whether it is shown or not.
function dispatch(file: string, change: (state: EditorState) => Transaction): void {
    const buffer = bufferOf(file);
    if (!buffer) {
        return;
    }
    if (view && view.state === buffer.state) {
        view.dispatch(change(view.state));
    } else {
        afterTransaction(file, change(buffer.state));
    }
}

/// Types into a text outside of the history; for src/text/outside_typing.ts only.
export function typeOutside(file: string, changes: ChangeSpec): void {
    dispatch(file, (state) => state.update({
        changes, annotations: Transaction.addToHistory.of(false), userEvent: 'move.drag',
    }));
}

/// Gives a file an earlier state with its history.
export function restore(file: string, state: EditorState): void {
    const buffer = bufferOf(file);
    if (!buffer || buffer.state === state) {
        return;
    }
    if (view && view.state === buffer.state) {
        const { scrollTop, scrollLeft } = view.scrollDOM;
        view.setState(state);
        view.scrollDOM.scrollTo(scrollLeft, scrollTop);
    }
    buffer.state = state;
    buffers.value = [...buffers.value];
    onChange(file);
}

export type FileChange = { file: string; changes: ChangeSpec };

/// With `isOneWithLast`, the step is one with the last one if that is recent and of the same kind.
function writeStep(changes: readonly FileChange[], label: string, isOneWithLast = false): void {
    const isSame = isOneWithLast && isLastStep(changes.map(({ file }) => file), label);
    grouped = [];
    for (const one of changes) {
        dispatch(one.file, (state) => state.update({
            changes: one.changes, scrollIntoView: false, userEvent: isOneWithLast ? undefined : 'input',
            annotations: isSame ? joinsLast.of(true)
                : isolateHistory.of(isOneWithLast ? 'before' : 'full'),
        }));
    }
    if (grouped.length > 0) {
        addStep({ files: grouped, label });
    }
    grouped = null;
}

/// Changes texts as one step of undo, after a drag in progress. `label` says what it does: "Move cue".
export function typeStep(changes: readonly FileChange[], label = ''): void {
    endDrag(true);
    writeStep(changes, label);
}

/// Undoes (or redoes) the last step of any file. Returns whether there was one.
export function travel(back: boolean): boolean {
    endDrag(true);
    const step = moveStep(back);
    if (!step) {
        return false;
    }
    isTravelling = true;
    try {
        for (const file of step.files) {
            const buffer = bufferOf(file);
            const shown = view && view.state === buffer?.state ? view : null;
            const state = shown?.state ?? buffer?.state;
            if (state) {
                (back ? undo : redo)({
                    state,
                    dispatch: (transaction) => shown
                        ? shown.dispatch(transaction) : afterTransaction(file, transaction),
                });
            }
        }
    } finally {
        isTravelling = false;
    }
    return true;
}

/// Says that a file on disk has this text now; the text in the page stays as it is.
export function setDisk(file: string, text: string, hash: string): void {
    const buffer = bufferOf(file);
    if (buffer) {
        buffer.savedText = text;
        buffer.hash = hash;
        buffers.value = [...buffers.value];
    }
}

/// Gives a file another text, as one step of undo, or as one with the last one if that was a recent
/// one of the same kind. `text` has the line breaks of the file. A drag in progress goes on.
export function setText(file: string, text: string, label: string, isOneWithLast = false): void {
    changeUnder(file, () => {
        const buffer = bufferOf(file);
        const change = buffer && difference(buffer.state.doc.toString(),
            buffer.state.lineBreak === '\r\n' ? text.replace(/\r\n/g, '\n') : text);
        if (change) {
            writeStep([{ file, changes: change }], label, isOneWithLast);
        }
    });
}
