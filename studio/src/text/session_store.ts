/// Texts that are not saved, and the history of all steps, survive a reload of the page in the
/// browser's storage of the tab.
import { undoDepth, redoDepth } from '@codemirror/commands';
import { buffers, isChanged, type Buffer } from './buffers';
import { stateToJson } from './states';
import { redoable, setSteps, undoable, type Step } from './steps';

export interface StoredFile {
    state: unknown;
    savedText: string;
    hash: string;
}

interface Stored {
    files: Record<string, StoredFile>;
    back: Step[];
    forward: Step[];
}

const kDelay = 1000;  // milliseconds from the last change to writing

function keyOf(shot: string): string {
    return `carom.texts.${shot}`;
}

function isWorthKeeping({ state, ...buffer }: Buffer): boolean {
    return undoDepth(state) > 0 || redoDepth(state) > 0 || isChanged({ ...buffer, state });
}

/// Writes everything now. What does not fit into the storage is not kept.
export function storeTexts(): void {
    const shot = buffers.peek()[0]?.file;
    if (shot === undefined) {
        return;
    }
    const files = Object.fromEntries(buffers.peek().filter(isWorthKeeping).map(
        ({ file, state, savedText, hash }) => [file, { state: stateToJson(state), savedText, hash }]));
    const stored: Stored = { files, back: [...undoable.peek()], forward: [...redoable.peek()] };
    try {
        sessionStorage.setItem(keyOf(shot), JSON.stringify(stored));
    } catch {
        sessionStorage.removeItem(keyOf(shot));
    }
}

/// What a page left behind for a shot; null if there is nothing.
export function storedTexts(shot: string): Stored | null {
    try {
        return JSON.parse(sessionStorage.getItem(keyOf(shot)) ?? 'null') as Stored | null;
    } catch {
        return null;
    }
}

export function forgetStored(shot: string): void {
    sessionStorage.removeItem(keyOf(shot));
}

/// Puts the steps back whose files all have their history.
export function restoreSteps({ back, forward }: Stored, files: ReadonlySet<string>): void {
    const isWhole = (step: Step) => step.files.every((file) => files.has(file));
    setSteps(back.filter(isWhole), forward.filter(isWhole));
}

/// Writes after each change, and when the page is left; to be called once.
export function keepTexts(): void {
    let timer = 0;
    buffers.subscribe(() => {
        clearTimeout(timer);
        timer = window.setTimeout(storeTexts, kDelay);
    });
    addEventListener('pagehide', storeTexts);
    document.addEventListener('visibilitychange', () => {
        if (document.visibilityState === 'hidden') {
            storeTexts();
        }
    });
}
