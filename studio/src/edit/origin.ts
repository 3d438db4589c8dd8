/// Where values come from, and how they are written.
import { isMap, isSeq } from 'yaml';
import type { KeyPath } from '../protocol';
import { shot } from '../state/state';
import { currentFiles } from './current_files';
import type { Origin } from './edit_types';
import { isPrefix } from './key_path';
import { locate } from './layers';
import { lineStart } from './text_edit';
import { flowText } from './write_value';

/// Where the value of a key path comes from.
export function originOf(path: KeyPath): Origin {
    const places = shot.value?.places ?? [];
    if (places.some((place) => place.origin === 'set' && isPrefix(place.path, path))) {
        return 'set';
    }
    const files = currentFiles();
    const located = locate(files, path);
    if (!located) {
        return 'absent';
    }
    return located.file === files[0] ? 'shot' : located.file.writable ? 'include' : 'config';
}

/// The text of a value as it is written now.
export interface Source {
    text: string;
    kind: 'scalar' | 'map' | 'list';
    file: string;
    /// From 1.
    line: number;
    origin: Origin;
}

/// The text of a key's value wherever it stands: of a scalar as it is written, of a map or list on
/// one line; null if no file has it.
export function sourceOf(path: KeyPath): Source | null {
    const located = locate(currentFiles(), path);
    const node = located?.way.steps[located.way.steps.length - 1]?.node;
    if (!located || !node) {
        return null;
    }
    const kind = isMap(node) ? 'map' : isSeq(node) ? 'list' : 'scalar';
    const before = located.tree.text.slice(0, lineStart(located.tree.text, node.range?.[0] ?? 0));
    const line = before.split('\n').length;
    const text = flowText(located.tree, node);
    return { text, kind, file: located.file.file, line, origin: originOf(path) };
}
