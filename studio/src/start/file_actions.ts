/// What the start page and the file menu ask of the server: to open a shot, to begin a new one, to
/// save under another name. A file that exists is written over only after a question.
import { effect } from '@preact/signals';
import { onMessage } from '../connection/receive';
import { send } from '../connection/socket';
import { ask } from '../dialogs/open_dialogs';
import { isStarting, notice } from '../state/state';
import { buffers, isChanged } from '../text/buffers';
import { discardTexts } from '../text/discard';
import { saveAll } from '../text/saving';
import { existsQuestion, unsavedQuestion } from './questions';

/// Sends again what was refused because the file exists.
let overwrite: (() => void) | null = null;

function request(what: 'open' | 'save_as', message: { file: string; from: string; text: string }) {
    const again = (isSure: boolean) => {
        overwrite = () => again(true);
        const { file, from, text } = message;
        const isSent = what === 'open'
            ? send('open', { file, from, text, overwrite: isSure })
            : send('save_as', { file, overwrite: isSure });
        if (!isSent) {
            notice.value = { kind: 'error', text: 'There is no connection to the server.' };
        }
    };
    again(false);
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

/// Resolves when all changes are saved, or to false if the server refused that.
function saved(): Promise<boolean> {
    return new Promise((resolve) => {
        const stop: (() => void)[] = [];
        const end = (isSaved: boolean) => {
            stop.forEach((one) => one());
            resolve(isSaved);
        };
        stop.push(onMessage('disk_changed', ({ refused }) => refused && end(false)));
        stop.push(onMessage('failed', ({ what }) => what === 'save' && end(false)));
        saveAll();
        queueMicrotask(() => stop.push(effect(() => { !hasUnsaved() && end(true); })));
    });
}

/// Saves all changes, if there are any. Resolves to whether the files are as the page has them.
export async function saveIfChanged(): Promise<boolean> {
    return !hasUnsaved() || saved();
}

/// Whether the open shot may be left: asks if there are unsaved changes.
export async function mayLeave(): Promise<boolean> {
    if (!hasUnsaved()) {
        return true;
    }
    const answer = await ask('Save the changes first?', unsavedQuestion,
        [{ label: 'Save' }, { label: 'Do not save' }]);
    if (answer === 'Do not save') {
        discardTexts();
    }
    return answer === 'Save' ? saved() : answer === 'Do not save';
}

/// Opens a shot.
export async function openShot(file: string): Promise<void> {
    if (await mayLeave()) {
        request('open', { file, from: '', text: '' });
    }
}

/// Writes a new shot from a template or an example, and opens it.
export async function beginShot(file: string, from: string): Promise<void> {
    if (await mayLeave()) {
        request('open', { file, from, text: '' });
    }
}

/// Writes a new shot of that text, and opens it.
export async function writeShot(file: string, text: string): Promise<void> {
    if (await mayLeave()) {
        request('open', { file, from: '', text });
    }
}

/// Shows the start page.
export async function closeShot(): Promise<void> {
    if (await mayLeave()) {
        send('open', { file: '', from: '', text: '', overwrite: false });
    }
}

/// Writes the shot as it stands in the page to another file, and opens that.
export function saveShotAs(file: string): void {
    request('save_as', { file, from: '', text: '' });
}
