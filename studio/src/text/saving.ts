/// Saves the changed files. The server refuses a file that changed on disk meanwhile.
import { onMessage } from '../connection/receive';
import { send } from '../connection/socket';
import { connection, files, notice } from '../state/state';
import { bufferOf, buffers, isChanged, textOf } from './buffers';
import { openGone } from '../dialogs/gone_dialog';
import { openMerge } from '../dialogs/merge_dialog';
import { conflictOf, forgetConflict, noteDisk, noteReturn, type Conflict } from './disk_conflicts';
import { endDrag } from './live_drag';
import { sendSoon } from './sending';
import { takeFiles } from './take_files';

/// The texts that are being written, by file.
const underWay = new Map<string, string>();

/// Asks the server to write every changed file. `onFailure` is called if one cannot be asked for, or
/// the user does not say which text of it to save.
export function saveAll(onFailure: () => void = () => undefined): void {
    endDrag(true);
    for (const { file } of buffers.value.filter((one) => one.writable && isChanged(one))) {
        const conflict = conflictOf(file);
        if (conflict) {
            askAbout(conflict, (one) => saveFile(one, onFailure), onFailure);
        } else {
            saveFile(file, onFailure);
        }
    }
}

/// Asks what to save where the file on disk is another one, or none.
function askAbout(
    conflict: Conflict, save: (file: string) => void, onDismiss?: () => void,
): void {
    (conflict.gone === '' ? openMerge : openGone)(conflict, save, onDismiss);
}

/// Writes a file that was taken away again, as it stands in the page.
export function writeAgain(file: string): void {
    endDrag(true);
    saveFile(file);
}

function saveFile(file: string, onFailure: () => void = () => undefined): void {
    const buffer = bufferOf(file);
    if (!buffer) {
        onFailure();
        return;
    }
    const text = textOf(buffer);
    if (send('save', { file, text, base_hash: buffer.hash, force: false })) {
        underWay.set(file, text);
    } else {
        if (connection.value !== 'open') {
            notice.value = { kind: 'error', text: 'There is no connection: nothing was saved.' };
        }
        onFailure();
    }
}

/// Takes over what the server says about files; to be called once.
export function watchFiles(): void {
    files.subscribe((list) => {
        const kept = takeFiles(list);
        list.filter(({ file }) => !kept.includes(file))
            .forEach(({ file, hash }) => noteReturn(file, hash));
        kept.forEach(sendSoon);
    });
    onMessage('saved', ({ file, hash }) => {
        const buffer = bufferOf(file);
        if (buffer) {
            buffer.hash = hash;
            forgetConflict(file);
            buffer.savedText = underWay.get(file) ?? textOf(buffer);
            underWay.delete(file);
            buffers.value = [...buffers.value];
            notice.value = { kind: 'info', text: `${buffer.name} is saved.` };
        }
    });
    onMessage('disk_changed', ({ refused, ...conflict }) => {
        if (noteDisk(conflict) && refused) {
            askAbout(conflict, saveFile);
        }
    });
    onMessage('failed', ({ message }) => {
        notice.value = { kind: 'error', text: message };
    });
}
