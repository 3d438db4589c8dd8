/// Sends changed texts to the server: one is under way, and of each file the newest waits. Takes
/// those that another window on the same shot sent.
import { onMessage } from '../connection/receive';
import { trySend } from '../connection/socket';
import type { Text } from '@codemirror/state';
import { mergeWords } from '../edit/merge_lines';
import type { TextChanged } from '../protocol';
import { connection, deferred, problems, textUnderWay, textVersion, tooLongFile } from '../state/state';
import { bufferOf, setText, textOf, type Buffer } from './buffers';
import { ancestorOf, forgetRecent, noteRecent } from './recent_texts';
import { stateWithoutDrag } from './live_drag';
import { forgetNoted, noteTexts } from './shown_texts';
import { tellOfConflict } from './drag_typing';

/// What is known of the server's text of a file.
interface Known {
    text: string;
    /// The version under which this page sent it or an earlier one; 0: never.
    sentAs: number;
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
        const result = trySend('text', { v, file: buffer.file, text });
        tooLongFile.value = result === 'too long' ? buffer.file : '';
        if (result === 'sent') {
            known.set(buffer.file, { text, sentAs: v, taken: null });
            noteRecent(buffer.file, text);
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

/// The text that another window sent with what this page changed and that window did not know of. If
/// both changed the same, what is not sent yet counts, else what came last.
function withOwnChanges(buffer: Buffer, text: string, isNewer: boolean): string {
    const base = ancestorOf(buffer.file, text);
    const own = stateWithoutDrag(buffer.file)?.sliceDoc() ?? textOf(buffer);
    if (base === null || (base === text && !isNewer)) {
        return text;
    }
    const merged = mergeWords(base, own, text);
    if (merged.conflicts > 0 && !isNewer) {
        tellOfConflict();
        return text;
    }
    return merged.text;
}

/// Takes the text that another window sent, as a step of undo; a drag of it is as one step. What
/// was changed here meanwhile is merged with it, and a drag goes on.
function takeText({ v, file, text }: TextChanged): void {
    const last = known.get(file);
    if (last && (v <= last.sentAs || text === last.text)) {
        return;  // the server had this page's own text later, or tells it
    }
    const buffer = bufferOf(file);
    if (!buffer) {
        return;
    }
    const isNewer = waiting.has(file) && stateWithoutDrag(file) === undefined;
    if (textOf(buffer) !== text) {
        setText(file, withOwnChanges(buffer, text, isNewer), 'Change in another window', true);
    }
    noteRecent(file, text);
    const taken = textOf(buffer) === text ? buffer.state.doc : null;
    known.set(file, { text, sentAs: last?.sentAs ?? 0, taken });
    if (!taken) {
        sendSoon(file);
    }
    noteTexts();
}

/// Forgets what the server has: a new connection or another shot begins with versions of its own.
function forget(): void {
    asked = 0;
    known.clear();
    forgetRecent();
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
    onMessage('files', ({ files }) => {
        for (const { file, text } of files) {
            known.set(file, { sentAs: 0, ...known.get(file), text, taken: null });
            noteRecent(file, text);
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
