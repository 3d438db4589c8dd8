import { Unplug } from 'lucide-preact';
import { connection, notice } from '../state/state';
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

/// Says that the server is gone, and that the text can still be copied.
export function LostBar() {
    return connection.value === 'lost' && bufferOf(activeFile.value) ? (
        <div class="conflict lost" role="alert">
            <Unplug size={14} aria-hidden="true" />
            <span>The server does not answer. Your text is kept here until it does.</span>
            <button onClick={copyShownText}>Copy the text</button>
        </div>
    ) : null;
}
