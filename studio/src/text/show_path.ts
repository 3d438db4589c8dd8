/// Shows where the text says something about a value of the shot.
import { currentFiles } from '../edit/current_files';
import { locate } from '../edit/layers';
import { itemStart, rangeOf } from '../edit/yaml_tree';
import type { KeyPath, TextRange } from '../protocol';
import { notice } from '../state/state';
import { showRange } from './show';

/// Where the value, or its key, stands in the text as it is now; null if no file has it.
export function placeOf(path: KeyPath): TextRange | null {
    const found = locate(currentFiles(), path);
    const step = found?.way.steps.at(-1);
    if (!found || !step || found.way.steps.length === 1) {
        return null;
    }
    const key = step.pair ? rangeOf(step.pair.key as Parameters<typeof rangeOf>[0]) : null;
    const at = step.pair ? itemStart(step.pair) : itemStart(step.node);
    const before = found.tree.text.slice(0, at).split('\n');
    const column = [...before.at(-1) ?? ''].length + 1;
    return { file: found.file.file, line: before.length, column, length: key ? key[1] - key[0] : 0 };
}

/// What a ball or an object that no text names may follow from.
function sourcesOf([section, name = '']: KeyPath): KeyPath[] {
    return section === 'balls' ? [['rack']]
        : section === 'objects' ? [[section, name.replace(/_\d+$/, '')]] : [];
}

/// Shows the value, or the nearest one above it that stands in a text, and gives the text the focus.
/// Returns false if none does.
export function showPath(path: KeyPath): boolean {
    const above = path.map((_, i) => path.slice(0, path.length - i));
    const paths = [...above.slice(0, -1), ...sourcesOf(path), ...above.slice(-1)];
    const place = paths.map(placeOf).find((one) => one !== null);
    if (place) {
        showRange({ ...place, length: 0 });  // what is typed next must not replace it
        return true;
    }
    notice.value = { kind: 'info', text: `No text says anything about ${path.join('.')}.` };
    return false;
}
