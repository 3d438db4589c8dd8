/// Edits of the shot by key path. Nothing but the text is changed, and of it only the bytes of the
/// value; what the page draws follows from the server's answer.
import type { KeyPath } from '../protocol';
import { indentRest, nestBlock } from './add_entry';
import { applyPlan, changed, checkOption } from './apply';
import type { Change, EditResult } from './edit_types';
import { withEdits } from './file_edits';
import { planEntry, planInsert, planRemove } from './plan';
import { checkScenePath } from './scene_paths';

export type { Change, Choice, EditResult, Gesture, Origin, Value } from './edit_types';
export { applyChanges } from './apply';
export { beginGesture, cancelGesture } from './gesture';
export { originOf, sourceOf, type Source } from './origin';

/// Takes a key with its value, or an item of a list, out of the text. `isOfScene` as for applyChanges.
export function removeValue(path: KeyPath, label: string, isOfScene = false): EditResult {
    return applyPlan((files, decisions) => {
        checkOption(path);
        if (isOfScene) {
            checkScenePath(path, files);
        }
        return withEdits(files, planRemove(files, path, decisions));
    }, label, { text: '', path });
}

/// Makes changes and takes values out, as one step of undo; all paths come from the scene that is shown.
export function changeAndRemove(
    changes: Change[], removed: readonly KeyPath[], label: string,
): EditResult {
    const path = changes[0]?.path ?? [];
    return applyPlan((files, decisions) => {
        [...changes.map((one) => one.path), ...removed].forEach((one) =>
            checkScenePath(one, files));
        return removed.reduce((all, one) => withEdits(all, planRemove(all, one, decisions)),
            changed(files, changes, decisions));
    }, label, { text: '', path });
}

/// Adds an item, written as YAML with an indent of 0, to a list before the item `index`. `isOfScene`
/// as for applyChanges.
export function insertItem(
    listPath: KeyPath, index: number, yaml: string, label: string, isOfScene = false,
): EditResult {
    return applyPlan((files, decisions) => {
        if (isOfScene) {
            checkScenePath([...listPath, String(index)], files);
        }
        return withEdits(files, planInsert(files, listPath, index, yaml, decisions));
    }, label, { text: `- ${indentRest(yaml, '  ')}`, path: listPath });
}

/// Adds an entry, its value written as YAML with an indent of 0, to a map.
export function insertEntry(
    mapPath: KeyPath, key: string, yaml: string, label: string,
): EditResult {
    return applyPlan((files, decisions) =>
        withEdits(files, planEntry(files, mapPath, key, yaml, decisions)), label,
    { text: nestBlock([...mapPath, key], yaml, true), path: mapPath });
}

/// Takes an item out of a list and puts it, written as YAML, before what is then the item `to`.
export function moveItem(
    listPath: KeyPath, from: number, to: number, yaml: string, label: string,
): EditResult {
    return applyPlan((files, decisions) => {
        const without = withEdits(files, planRemove(files, [...listPath, String(from)], decisions));
        return withEdits(without, planInsert(without, listPath, to, yaml, decisions));
    }, label, { text: '', path: listPath });
}

/// After the last item of any list.
const kLast = 1_000_000;

/// Adds parts of another shot, as one undo step.
export function insertParts(
    parts: readonly { section: string; name: string; yaml: string }[], label: string,
): EditResult {
    const manual = parts.map(({ section, name, yaml }) =>
        nestBlock(section === 'cameras' ? [section] : [section, name], yaml, true)).join('\n');
    return applyPlan((files, decisions) => parts.reduce((all, { section, name, yaml }) =>
        withEdits(all, section === 'cameras'
            ? planInsert(all, [section], kLast, yaml, decisions)
            : planEntry(all, [section], name, yaml, decisions)), files), label,
    { text: manual, path: [] });
}
