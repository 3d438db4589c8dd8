/// Asks what to do with a file that another program changed while the page has changes of its own.
import { effect } from '@preact/signals';
import { mergeLines } from '../edit/merge_lines';
import { bufferOf, textOf } from '../text/buffers';
import { conflictOf, resolveConflict, type Conflict } from '../text/disk_conflicts';
import { MergePanel } from './MergePanel';
import { openDialog } from './open_dialogs';

let close: (() => void) | null = null;

function baseName(name: string): string {
    return name.slice(name.lastIndexOf('/') + 1);
}

/// Shows both texts of a file, for the user to choose or to merge. `save` is called with the file
/// after the user chose a text that is not the one on disk, if the file was to be saved; `onDismiss`
/// if the user chose none.
export function openMerge(
    first: Conflict, save: ((file: string) => void) | null, onDismiss: () => void = () => undefined,
): void {
    close?.();
    const buffer = bufferOf(first.file);
    if (!buffer) {
        return;
    }
    const name = baseName(buffer.name);
    const own = textOf(buffer);
    const start = mergeLines(buffer.savedText, own, first.text);
    let merged = start.text;
    const now = () => conflictOf(first.file) ?? first;
    let isOpen = true;
    const finished = (then: () => void) => {
        if (isOpen) {
            isOpen = false;
            then();
        }
    };
    const finish = (text: string, label: string) => finished(() => {
        resolveConflict(now(), text, label);
        if (text !== now().text) {
            save?.(first.file);
        }
    });
    const words = save ? 'Save' : 'Use';
    const end = openDialog({
        title: `${name} changed on disk`,
        size: 'full',
        onDismiss: () => finished(onDismiss),
        body: () => (
            <>
                <p>
                    Another program wrote this file while it has changes here. At the right are
                    your changes together with those of the other program
                    {start.conflicts > 0 ? ' where it changed other lines than you' : ''}. Arrows
                    take over what differs, and the text can be edited. Undo brings back your own.
                </p>
                <div class="fills">
                    <MergePanel left={now().text} right={start.text}
                        leftTitle="On disk" rightTitle="Merged" onRight={(text) => { merged = text; }} />
                </div>
            </>
        ),
        actions: () => [
            { label: `${words} the merged text`, kind: 'primary',
                run: () => finish(merged, `Merge ${name}`) },
            { label: 'Keep mine unchanged', run: () => finish(own, '') },
            { label: 'Use the version on disk', run: () => finish(now().text, `Take ${name} from disk`) },
        ],
    });
    // If the conflict ends in another way, there is nothing left to ask.
    const stop = effect(() => {
        if (!conflictOf(first.file)) {
            queueMicrotask(() => close?.());
        }
    });
    close = () => {
        close = null;
        stop();
        end();
        finished(onDismiss);
    };
}
