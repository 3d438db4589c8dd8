/// Puts a key and its value in the place of another key that excludes it: `direction` for `toward`.
import type { Pair } from 'yaml';
import type { KeyPath } from '../protocol';
import type { SourceFile, Value } from './edit_types';
import { withEdits } from './file_edits';
import { locate } from './layers';
import { planRemove, planSet, type Decisions } from './plan';
import { itemEnd, itemStart, parseWhole, walk } from './yaml_tree';
import { writeValue, type NumberStyle } from './write_value';

/// The files with the value at `path` set and without the sibling key `old`, in whose place it is
/// written if the sibling stands in the shot's own text. Throws as planSet does.
export function replaceKey(
    files: SourceFile[], path: KeyPath, old: string, value: Value, style: NumberStyle,
    decisions: Decisions = {},
): SourceFile[] {
    const sibling = [...path.slice(0, -1), old];
    const located = locate(files, sibling);
    const shot = files[0];
    if (!located || !shot || locate(files, path)) {
        return withEdits(files, planSet(files, path, value, style, decisions));
    }
    const isOwn = located.file === shot && located.way.steps.every((step) => step.alias === null);
    if (isOwn) {
        const tree = parseWhole(shot.text, shot.name);
        const { steps } = walk(tree, sibling);
        const pair = steps[steps.length - 1]?.pair as Pair;
        const insert = `${path[path.length - 1] ?? ''}: ${writeValue(value, style)}`;
        const edit = { from: itemStart(pair), to: itemEnd(shot.text, pair), insert };
        return withEdits(files, { file: shot, edits: [edit] });
    }
    const set = withEdits(files, planSet(files, path, value, style, decisions));
    return withEdits(set, planRemove(set, sibling, decisions));
}
