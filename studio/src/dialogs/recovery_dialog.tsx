/// Asks whether texts that were not saved when the studio ended unexpectedly are to be used.
import { signal } from '@preact/signals';
import { onMessage } from '../connection/receive';
import { send } from '../connection/socket';
import type { RecoveredText } from '../protocol';
import { notice } from '../state/state';
import { bufferOf } from '../text/buffers';
import { MergePanel } from './MergePanel';
import { openDialog } from './open_dialogs';
import './recovery_dialog.css';

const chosen = signal(0);
let close: (() => void) | null = null;

function nameOf(file: string): string {
    const name = bufferOf(file)?.name ?? file;
    return name.slice(name.lastIndexOf('/') + 1);
}

function Files({ files }: { files: readonly RecoveredText[] }) {
    return (
        <div class="recovered-files" role="tablist" aria-label="Files with unsaved changes">
            {files.map(({ file }, i) => (
                <button key={file} type="button" role="tab" aria-selected={i === chosen.value}
                    onClick={() => { chosen.value = i; }}>{nameOf(file)}</button>
            ))}
        </div>
    );
}

function Recovery({ files }: { files: readonly RecoveredText[] }) {
    const one = files[chosen.value] ?? files[0];
    if (!one) {
        return null;
    }
    const since = one.hash === one.base_hash ? ''
        : one.hash === '' ? ' The file was deleted since.'
            : ' The file on disk was written by another program since.';
    return (
        <div class="recovery fills">
            <p>
                {files.length === 1
                    ? <>Changes of <strong>{nameOf(one.file)}</strong> were not saved.</>
                    : <>Changes of {files.length} files were not saved.</>}
                {' '}At the right is the text as you left it.
                {since}
            </p>
            {files.length > 1 ? <Files files={files} /> : null}
            <MergePanel key={one.file} left={bufferOf(one.file)?.savedText ?? ''} right={one.text}
                leftTitle="On disk" rightTitle="Not saved" />
        </div>
    );
}

function openRecovery(files: readonly RecoveredText[]): void {
    close?.();
    chosen.value = 0;
    const answer = (use: boolean) => {
        send('recover', { use });
        notice.value = { kind: 'info', text: use
            ? 'The unsaved changes are back.' : 'The unsaved changes are forgotten.' };
    };
    close = openDialog({
        title: 'The studio ended before your changes were saved',
        size: 'full',
        body: () => <Recovery files={files} />,
        actions: () => [
            { label: 'Use the changes', kind: 'primary', run: () => answer(true) },
            { label: 'Forget them', kind: 'danger', run: () => answer(false) },
        ],
    });
}

/// Asks whenever the server has such texts; to be called once. The question ends with the shot that it
/// is about.
export function watchRecovery(): void {
    onMessage('welcome', () => {
        close?.();
        close = null;
    });
    onMessage('recovered', ({ files }) => {
        if (files.length > 0) {
            openRecovery(files);
        }
    });
}
