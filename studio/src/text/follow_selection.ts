/// The cursor in the text and the selection of the page follow each other.
import { EditorView } from '@codemirror/view';
import { isMap, isSeq, type Node, type Pair } from 'yaml';
import { untracked } from '@preact/signals';
import { currentFiles } from '../edit/current_files';
import { itemEnd, itemStart, keyText, parseTree } from '../edit/yaml_tree';
import { locate } from '../edit/layers';
import type { KeyPath } from '../protocol';
import { isThing, thingOf } from '../outline/thing';
import { selection } from '../state/state';
import { activeFile, buffers } from './buffers';

/// The path of the deepest value, at most `depth` keys, that contains an offset.
export function pathAt(text: string, offset: number, depth: number): KeyPath {
    const path: KeyPath = [];
    let node = parseTree(text).document.contents as Node | null;
    while (path.length < depth && (isMap(node) || isSeq(node))) {
        const items = node.items as (Node | Pair)[];
        const index = items.findIndex((item) =>
            itemStart(item) <= offset && offset <= itemEnd(text, item));
        const item = items[index];
        if (item === undefined) {
            break;
        }
        path.push('key' in item ? keyText(item) : String(index));
        node = ('key' in item ? item.value : item) as Node | null;
    }
    return path;
}

/// The sections whose entries can be selected.
const kSelectable = new Set([
    'balls', 'objects', 'lights', 'materials', 'events', 'cameras', 'annotations', 'film',
]);

let told: KeyPath | null = null;  // what the cursor selected

/// Selects what stands at the cursor, if the user moved it in the shot's own text.
export const selectAtCursor = EditorView.updateListener.of((update) => {
    const shot = buffers.peek()[0];
    const isUser = update.transactions.some((one) => one.isUserEvent('select'));
    if (!isUser || !shot || activeFile.peek() !== shot.file) {
        return;
    }
    const path = thingOf(pathAt(update.state.doc.toString(), update.state.selection.main.head, 3));
    if (isThing(path) && kSelectable.has(path[0] ?? '')) {
        told = path;
        selection.value = path;
    }
});

/// Shows the selected value in `view` from now on, without taking the focus. Returns what ends it.
export function showSelection(view: EditorView): () => void {
    return selection.subscribe((path) => {
        const found = path && path !== told ? locate(untracked(currentFiles), path) : null;
        const steps = found?.way.steps ?? [];
        const step = steps[steps.length - 1];
        if (found && step && found.file.file === activeFile.peek()) {
            const at = step.pair ? itemStart(step.pair) : itemStart(step.node);
            view.dispatch({
                selection: { anchor: at },
                effects: EditorView.scrollIntoView(at, { y: 'nearest', yMargin: 60 }),
            });
        }
    });
}
