import { notice } from '../state/state';
import { activeFile, bufferOf, textOf } from './buffers';

/// Puts the shown text on the clipboard.
export function copyShownText(): void {
    const buffer = bufferOf(activeFile.value);
    if (buffer) {
        void navigator.clipboard.writeText(textOf(buffer)).then(() => {
            notice.value = { kind: 'info', text: `The text of ${buffer.name} is copied.` };
        });
    }
}
