/// Asks what to do with a file that another program changed while the page has changes of its own.
import { effect } from '@preact/signals';
import { bufferOf, textOf } from '../text/buffers';
import { conflictOf, resolveConflict, type Conflict } from '../text/disk_conflicts';
import { MergePanel } from './MergePanel';
import { openDialog } from './open_dialogs';

let close: (() => void) | null = null;

function baseName(name: string): string {
    return name.slice(name.lastIndexOf('/') + 1);
}

/// Shows both texts of a file, for the user to choose or to merge. `save` is called with the file
/// after the user chose a text that is not the one on disk, if the file was to be saved.
export function openMerge(first: Conflict, save: ((file: string) => void) | null): void {
    close?.();
    const buffer = bufferOf(first.file);
    if (!buffer) {
        return;
    }
    const name = baseName(buffer.name);
    const own = textOf(buffer);
    let merged = own;
    const now = () => conflictOf(first.file) ?? first;
    const finish = (text: string, label: string) => {
        resolveConflict(now(), text, label);
        if (text !== now().text) {
            save?.(first.file);
        }
    };
    const words = save ? 'Save' : 'Use';
    const end = openDialog({
        title: `${name} changed on disk`,
        size: 'full',
        body: () => (
            <>
                <p>
                    Another program wrote this file while it has changes here. The arrows take its
                    differences over into your text, which can also be edited. Undo brings your
                    own text back.
                </p>
                <div class="fills">
                    <MergePanel left={now().text} right={own} leftTitle="On disk"
                        rightTitle="Your text" onRight={(text) => { merged = text; }} />
                </div>
            </>
        ),
        actions: () => [
            { label: `${words} the text at the right`, kind: 'primary',
                run: () => finish(merged, `Merge ${name}`) },
            { label: 'Keep mine unchanged', run: () => finish(own, '') },
            { label: "Take the disk's", run: () => finish(now().text, `Take ${name} from disk`) },
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
    };
}
