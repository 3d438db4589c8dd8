/// The shot's texts as the inspector asks them.
import { isMap, isScalar, isSeq } from 'yaml';
import { originOf, sourceOf } from '../edit/edit';
import { isShotOfPart, locate } from '../edit/layers';
import type { SourceFile } from '../edit/edit_types';
import { keyText } from '../edit/yaml_tree';
import type { KeyPath } from '../protocol';
import { buffers } from '../text/buffers';
import type { Texts } from './field_model';

function filesNow(): SourceFile[] {
    return buffers.value.map(({ file, name, writable, state }) =>
        ({ file, name, writable, text: state.doc.toString() }));
}

/// Keys of a map in the file that counts, and those of the files below it.
function keysIn(files: readonly SourceFile[], path: KeyPath): string[] {
    const keys: string[] = [];
    if (isShotOfPart([...path, 'shot']) && isScalar(locate(files, path)?.way.steps.at(-1)?.node)) {
        return ['shot'];
    }
    for (let first = 0; first < files.length; first += 1) {
        const located = locate(files.slice(first), path);
        if (!located) {
            break;
        }
        const node = located.way.steps.at(-1)?.node;
        if (isSeq(node)) {
            return keys.length > 0 ? keys : node.items.map((_, i) => String(i));
        }
        if (isMap(node)) {
            keys.push(...node.items.map(keyText).filter((key) => !keys.includes(key)));
        }
        const at = files.indexOf(located.file);
        if (at < first) {
            break;
        }
        first = at;
    }
    return keys;
}

/// The texts as they stand now; read inside a component, it follows every change.
export function textsNow(): Texts {
    const files = filesNow();
    return { sourceOf, originOf, keysOf: (path) => keysIn(files, path) };
}
