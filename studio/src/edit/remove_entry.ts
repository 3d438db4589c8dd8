/// Takes an entry of a map or an item of a list out of a text.
import { isMap, type Node, type Pair } from 'yaml';
import { EditError, PlaceError } from './edit_error';
import { lineEnd, lineStart, type TextEdit } from './text_edit';
import { itemEnd, itemStart, type Step, type Tree } from './yaml_tree';

/// The edit that takes items[index] out of [...] or {...}, with one comma.
function removeFromFlow(text: string, items: (Node | Pair)[], index: number): TextEdit {
    const item = items[index] as Node;
    const next = items[index + 1];
    if (next !== undefined) {
        return { from: itemStart(item), to: itemStart(next as Node), insert: '' };
    }
    const before = items[index - 1];
    const end = itemEnd(text, item);
    if (before !== undefined) {
        return { from: itemEnd(text, before as Node), to: end, insert: '' };
    }
    const comma = /^\s*,/.exec(text.slice(end))?.[0].length ?? 0;
    return { from: itemStart(item), to: end + comma, insert: '' };
}

/// The edit that takes the lines of items[index] out, with comments on them.
function removeLines(text: string, items: (Node | Pair)[], index: number): TextEdit {
    const item = items[index] as Node;
    const from = lineStart(text, itemStart(item));
    const lead = text.slice(from, itemStart(item));
    const to = Math.min(text.length, lineEnd(text, itemEnd(text, item)) + 1);
    if (/^\s*(-\s+)?$/.test(lead) && (!lead.includes('-') || !('key' in item))) {
        return { from, to, insert: '' };
    }
    const next = items[index + 1];
    if (next === undefined || !('key' in item)) {
        throw new PlaceError('the value is written in a way that this page cannot take out');
    }
    return { from: itemStart(item), to: itemStart(next as Node), insert: '' };
}

/// Takes the last of `steps` out. What would then be empty, and stands on lines of its own, goes
/// with it.
export function removeAt(tree: Tree, steps: readonly Step[]): TextEdit {
    const step = steps[steps.length - 1];
    const holder = step?.holder;
    if (!step || !holder) {
        throw new EditError('the whole text cannot be taken out');
    }
    const items = holder.items as (Node | Pair)[];
    const index = isMap(holder)
        ? items.indexOf(step.pair as Pair)
        : items.indexOf((step.alias ?? step.node) as Node);
    if (holder.flow) {
        return removeFromFlow(tree.text, items, index);
    }
    if (items.length === 1 && steps.length > 2) {
        return removeAt(tree, steps.slice(0, -1));
    }
    return removeLines(tree.text, items, index);
}
