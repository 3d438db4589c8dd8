/// Takes over the shot's files as the server tells them.
import type { OpenFile } from '../protocol';
import { activeFile, bufferOf, buffers, isChanged, setText, textOf, type Buffer } from './buffers';
import { restoreSteps, storedTexts, type StoredFile } from './session_store';
import { makeState, stateFromJson } from './states';
import { setSteps } from './steps';

/// The buffer of a file that the page did not have, with the history that it had before a reload.
/// `isKept` of the result: the text is newer than the server's.
function newBuffer(
    file: OpenFile, stored: StoredFile | undefined,
): { buffer: Buffer; isKept: boolean; isRevived: boolean } {
    const { file: path, name, writable, hash } = file;
    const state = stored && writable ? stateFromJson(stored.state, writable) : null;
    if (state && stored) {
        const text = state.sliceDoc();
        if (text === file.text) {
            const savedText = file.changed ? stored.savedText : file.text;
            return { buffer: { file: path, name, writable, hash, savedText, state },
                isKept: false, isRevived: true };
        }
        // A server that was started anew has only the file on disk.
        if (!file.changed && text !== stored.savedText) {
            const isSame = stored.hash === hash;
            const savedText = isSame ? file.text : stored.savedText;
            return { buffer: { file: path, name, writable, hash: stored.hash, savedText, state },
                isKept: true, isRevived: true };
        }
    }
    const savedText = file.changed ? '' : file.text;
    return { buffer: { file: path, name, writable, hash, savedText,
        state: makeState(file.text, writable) }, isKept: false, isRevived: false };
}

/// Files that the page has not changed take the server's text, as a step of undo: typed outside of
/// the history instead, it would move the places of older steps that changed the same characters.
function followServer(file: OpenFile): void {
    const known = bufferOf(file.file);
    const isPlain = !file.text.includes('\r') && !known?.savedText.includes('\r');
    if (known && isPlain && !isChanged(known)) {
        setText(file.file, file.text, file.changed ? 'Take unsaved changes' : 'Reload from disk');
    }
}

/// New files get a buffer, files that the page has not changed take the server's text, and changed
/// ones keep theirs. Returns the files that keep theirs.
export function takeFiles(files: readonly OpenFile[]): string[] {
    const kept: string[] = [];
    const shot = files[0]?.file ?? '';
    const isNew = shot !== buffers.value[0]?.file;
    const stored = isNew ? storedTexts(shot) : null;
    const revived = new Set<string>();
    files.forEach(followServer);
    buffers.value = files.map((file) => {
        const known = bufferOf(file.file);
        if (known && isChanged(known) && textOf(known) !== file.text) {
            kept.push(file.file);
            return known;
        }
        if (known && textOf(known) === file.text) {
            known.hash = file.hash;
            known.savedText = file.changed ? known.savedText : file.text;
            return known;
        }
        const { buffer, isKept, isRevived } = newBuffer(file, stored?.files[file.file]);
        if (isKept) {
            kept.push(file.file);
        }
        if (isRevived) {
            revived.add(file.file);
        }
        return buffer;
    });
    if (isNew) {
        setSteps([], []);
        if (stored) {
            restoreSteps(stored, revived);
        }
    }
    if (!bufferOf(activeFile.value)) {
        activeFile.value = shot;
    }
    return kept;
}
