/// Sends changed texts to the server: one is under way, and of each file the newest waits. Takes
/// those that another window on the same shot sent.
import { onMessage } from '../connection/receive';
import { trySend } from '../connection/socket';
import type { Text } from '@codemirror/state';
import { mergeWords } from '../edit/merge_lines';
import type { TextChanged } from '../protocol';
import { connection, deferred, problems, textUnderWay, textVersion, tooLongFile } from '../state/state';
import { bufferOf, setText, textOf, type Buffer } from './buffers';
import { stateWithoutDrag } from './live_drag';
import { forgetTexts, noteText, textAt } from './server_texts';
import { forgetNoted, noteTexts } from './shown_texts';
import { tellOfConflict } from './drag_typing';

/// What is known of the server's text of a file.
interface Known {
    text: string;
    /// The version under which this page sent it or an earlier one; 0: never.
    sentAs: number;
    /// The newest version that the page has taken over.
    seen: number;
    /// What the text is in the page if another window sent it, and nothing was typed since.
    taken: Text | null;
}

const waiting = new Set<string>();
const known = new Map<string, Known>();
let asked = 0;  // the version under way; 0: none
let isHeld = false;

/// The next text that the server does not have.
function nextWaiting(): Buffer | null {
    for (const file of waiting) {
        waiting.delete(file);
        const buffer = bufferOf(file);
        if (buffer && buffer.state.doc !== known.get(file)?.taken) {
            return buffer;
        }
    }
    return null;
}

function sendNext(): void {
    const isFree = asked === 0 && !isHeld && connection.value === 'open';
    const buffer = isFree ? nextWaiting() : null;
    if (buffer) {
        const v = textVersion.value + 1;
        const text = textOf(buffer);
        const base = known.get(buffer.file)?.seen ?? 0;
        const result = trySend('text', { v, file: buffer.file, text, base });
        tooLongFile.value = result === 'too long' ? buffer.file : '';
        if (result === 'sent') {
            known.set(buffer.file, { text, sentAs: v, seen: v, taken: null });
            noteText(buffer.file, v, text);
            asked = v;
            textVersion.value = v;
            noteTexts();
        } else if (result === 'lost') {
            waiting.add(buffer.file);
        }
    }
    textUnderWay.value = asked !== 0 || waiting.size > 0;
}

/// Sends the text of a file as soon as the server has answered the one before.
export function sendSoon(file: string): void {
    waiting.add(file);
    textUnderWay.value = true;
    queueMicrotask(sendNext);
}

/// Lets texts wait, or sends them again: while the server forgets those that it has.
export function holdSending(isOn: boolean): void {
    isHeld = isOn;
    queueMicrotask(sendNext);
}

function answered(): void {
    asked = 0;
    sendNext();
}

/// The text that another window made from version `base`, with what this page changed since. If both
/// changed the same, what is not sent yet counts, else what came last.
function withOwnChanges(buffer: Buffer, { text, base }: TextChanged): string {
    const { file } = buffer;
    const dragged = stateWithoutDrag(file);
    const own = dragged?.sliceDoc() ?? textOf(buffer);
    const before = textAt(file, base) ?? known.get(file)?.text ?? own;
    if (waiting.has(file) && !dragged) {
        return mergeWords(before, own, text).text;
    }
    const merged = mergeWords(before, text, own);
    if (merged.conflicts > 0) {
        tellOfConflict();
    }
    return merged.text;
}

/// Takes the text that another window sent, as a step of undo; a drag of it is as one step. What
/// was changed here meanwhile is merged with it, and a drag goes on.
function takeText(message: TextChanged): void {
    const { v, file, text } = message;
    const last = known.get(file);
    if (last && text === last.text) {
        noteText(file, v, text);
        last.seen = v;  // the server tells which version this page's own text became
        return;
    }
    noteText(file, v, text);
    if (last && v <= last.sentAs) {
        last.seen = Math.max(last.seen, v + 1);  // the server had this page's own text later
        noteText(file, last.seen, last.text);
        return;
    }
    const buffer = bufferOf(file);
    if (!buffer) {
        return;
    }
    if (textOf(buffer) !== text) {
        setText(file, withOwnChanges(buffer, message), 'Change in another window', true);
    }
    const taken = textOf(buffer) === text ? buffer.state.doc : null;
    known.set(file, { text, sentAs: last?.sentAs ?? 0, seen: v, taken });
    if (!taken) {
        sendSoon(file);
    }
    noteTexts();
}

/// Forgets what the server has: a new connection or another shot begins with versions of its own.
function forget(): void {
    asked = 0;
    known.clear();
    forgetTexts();
    forgetNoted();
    textUnderWay.value = waiting.size > 0;
}

/// Takes note of the server's answers; to be called once.
export function watchAnswers(): void {
    problems.subscribe((list) => {
        if (list && asked !== 0 && list.v >= asked) {
            answered();
        }
    });
    deferred.subscribe((one) => {
        if (one && asked !== 0 && one.v >= asked) {
            answered();
        }
    });
    onMessage('failed', ({ what, v }) => {
        if (what === 'text' && asked !== 0) {
            textVersion.value = v;  // the refused text has none
            answered();
        }
    });
    onMessage('text_changed', takeText);
    onMessage('files', ({ v, files }) => {
        for (const { file, text } of files) {
            known.set(file, { sentAs: 0, ...known.get(file), text, seen: v, taken: null });
            noteText(file, v, text);
        }
        queueMicrotask(() => {
            noteTexts();
            sendNext();  // what waited for a connection
        });
    });
    onMessage('welcome', forget);
    // After a connection was lost, the files that the server tells anew show which texts it lacks.
    connection.subscribe((state) => state !== 'open' && forget());
}
