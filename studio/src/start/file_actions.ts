/// What the start page and the file menu ask of the server: to open a shot, to begin a new one, to
/// save under another name. A file that exists is written over only after a question.
import { effect } from '@preact/signals';
import { onMessage } from '../connection/receive';
import { send } from '../connection/socket';
import { ask } from '../dialogs/open_dialogs';
import { connection, isStarting, notice } from '../state/state';
import { buffers, isChanged } from '../text/buffers';
import { leaveTexts } from '../text/discard';
import { saveAll } from '../text/saving';
import { existsQuestion, unsavedQuestion } from './questions';

/// Sends again what was refused because the file exists.
let overwrite: (() => void) | null = null;

interface Request {
    what: 'open' | 'save_as';
    file: string;
    from?: string;
    text?: string;
    /// The changes of the open shot are forgotten if the request is granted.
    isDiscarding?: boolean;
}

function sendRequest({ what, file, from = '', text = '' }: Request, isSure: boolean): void {
    if (what === 'open') {
        send('open', { file, from, text, overwrite: isSure });
    } else {
        send('save_as', { file, overwrite: isSure });
    }
}

function request(wanted: Request, isSure = false): void {
    overwrite = () => request(wanted, true);
    if (connection.value !== 'open') {
        notice.value = { kind: 'error', text: 'There is no connection to the server.' };
        return;
    }
    if (wanted.isDiscarding) {
        leaveTexts(wanted.file);
    }
    sendRequest(wanted, isSure);
}

/// Asks before a file is written over; to be called once.
export function watchExisting(): void {
    onMessage('exists', ({ what, name }) => {
        const write = overwrite;
        if (what !== 'open' && what !== 'save_as') {
            return;  // others ask themselves
        }
        void ask(`${name} exists already`, existsQuestion(name),
            [{ label: 'Keep it' }, { label: 'Overwrite', kind: 'danger' }]).then((answer) => {
            if (answer === 'Overwrite') {
                write?.();
            }
        });
    });
}

export function hasUnsaved(): boolean {
    return !isStarting.value && buffers.value.some((one) => one.writable && isChanged(one));
}

/// Resolves when all changes are saved, or to false if the server refuses that, the connection is
/// lost, or the user does not say which text to save.
function saved(): Promise<boolean> {
    return new Promise((resolve) => {
        const stop: (() => void)[] = [];
        let isOver = false;
        const end = (isSaved: boolean) => {
            isOver = true;
            stop.splice(0).forEach((one) => one());
            resolve(isSaved);
        };
        stop.push(onMessage('disk_changed', ({ refused }) => refused && end(false)));
        stop.push(onMessage('failed', ({ what }) => what === 'save' && end(false)));
        saveAll(() => end(false));
        queueMicrotask(() => !isOver && stop.push(effect(() => {
            if (connection.value !== 'open' || !hasUnsaved()) {
                const isSaved = !hasUnsaved();
                queueMicrotask(() => end(isSaved));
            }
        })));
    });
}

/// Saves all changes, if there are any. Resolves to whether the files are as the page has them.
export async function saveIfChanged(): Promise<boolean> {
    return !hasUnsaved() || saved();
}

/// Asks whether the changes of the open shot are to be saved, if there are any, then opens another
/// one; nothing happens if the user wants neither, or saving fails.
async function leaveFor(wanted: Request): Promise<void> {
    if (!hasUnsaved()) {
        request(wanted);
        return;
    }
    const answer = await ask('Save the changes first?', unsavedQuestion,
        [{ label: 'Save' }, { label: 'Do not save', kind: 'danger' }]);
    if (answer === 'Do not save') {
        request({ ...wanted, isDiscarding: true });
    } else if (answer === 'Save' && await saved()) {
        request(wanted);
    }
}

/// Opens a shot.
export async function openShot(file: string): Promise<void> {
    await leaveFor({ what: 'open', file });
}

/// Writes a new shot from a template or an example, and opens it.
export async function beginShot(file: string, from: string): Promise<void> {
    await leaveFor({ what: 'open', file, from });
}

/// Writes a new shot of that text, and opens it.
export async function writeShot(file: string, text: string): Promise<void> {
    await leaveFor({ what: 'open', file, text });
}

/// Shows the start page.
export async function closeShot(): Promise<void> {
    await leaveFor({ what: 'open', file: '' });
}

/// Writes the shot as it stands in the page to another file, and opens that.
export function saveShotAs(file: string): void {
    request({ what: 'save_as', file });
}
