import { buffers } from '../text/buffers';
import type { SourceFile } from './edit_types';

/// The shot's files as they stand in the page. Line breaks are "\n", as in the editor.
export function currentFiles(): SourceFile[] {
    return buffers.value.map(({ file, name, writable, state }) =>
        ({ file, name, writable, text: state.doc.toString() }));
}
