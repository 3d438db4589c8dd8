/// Asks what to do with a file that another program took away, or that cannot be read any more.
import { runCommand } from '../state/keys';
import { bufferOf, buffers } from '../text/buffers';
import type { Conflict } from '../text/disk_conflicts';
import type { DialogAction } from './Dialog';
import { openDialog } from './open_dialogs';

/// `save` is called with the file if it is to be written again as it stands in the page; `onDismiss`
/// if the user wants something else.
export function openGone(
    { file, gone }: Conflict, save: (file: string) => void, onDismiss: () => void = () => undefined,
): void {
    const buffer = bufferOf(file);
    if (!buffer) {
        return;
    }
    const name = buffer.name.slice(buffer.name.lastIndexOf('/') + 1);
    const saveAs: DialogAction = { label: 'Save as …', run: () => {
        onDismiss();
        runCommand('saveAs');
    } };
    openDialog({
        title: `${name} ${gone}`,
        onDismiss,
        body: () => <p>There is no file of this name any more that could be read. The text is still here
            as you see it: nothing is lost if you write it again.</p>,
        actions: () => [
            { label: 'Write it again', kind: 'primary', run: () => save(file) },
            ...file === buffers.value[0]?.file ? [saveAs] : [],
            { label: 'Not now', run: onDismiss },
        ],
    });
}
