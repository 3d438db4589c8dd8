/// Decides where a change is written, and what exactly.
import { isScalar, isSeq } from 'yaml';
import type { KeyPath } from '../protocol';
import { checked } from './alias_check';
import { decisionOf, resolveAlias, type Decisions } from './decisions';
import { EditError } from './edit_error';
import type { FileEdits, SourceFile, Value } from './edit_types';
import { after, both, withEdits } from './file_edits';
import { isShotOfPart, locate, type Located } from './layers';
import { filesOfCamera, listAround, takenFrom } from './place';
import { add, addTo } from './plan_add';
import { removeAt } from './remove_entry';
import { setNode } from './set_value';
import type { TextEdit } from './text_edit';
import { parseWhole, walk, type Step, type Tree } from './yaml_tree';
import { flowText, writeValue, type NumberStyle } from './write_value';

export type { FileEdits } from './edit_types';
export { Undecided, type Decisions } from './decisions';
export { planEntry, planInsert, planTakeList } from './plan_add';

/// Sets a value that stands in `located.file`, in this file.
function setThere(
    located: Located, value: Value, style: NumberStyle, decisions: Decisions,
): FileEdits {
    const { file } = located;
    const tree = parseWhole(file.text, file.name);
    const { steps } = walk(tree, located.path);
    const last = steps[steps.length - 1] as Step;
    const above = steps.slice(0, -1);
    // A scalar or a list that is only repeated is replaced by its value without a question if the
    // user wants copies; an alias further up has to be copied first.
    const copy = resolveAlias(file, tree, steps, decisions);
    if (copy && above.some((step) => step.alias !== null)) {
        const copied = after(file, copy);
        const again = setThere({ ...located, file: copied }, value, style, decisions);
        return { file, edits: both(file, copy, again.edits) };
    }
    const target = copy ? last : { ...last, alias: null };
    return { file, edits: setNode(tree, [...above, target], value, style,
        (alias) => decisionOf(file, alias, decisions)) };
}

/// Sets a value that a file has: there, or over it in the shot.
function setLocated(
    all: readonly SourceFile[], files: readonly SourceFile[], located: Located, path: KeyPath,
    value: Value, style: NumberStyle, decisions: Decisions,
): FileEdits {
    const shot = files[0] as SourceFile;
    const list = located.file === shot ? null : listAround(files, path, located, false);
    if (located.file === shot && (shot === all[0] || shot.writable)) {
        return setThere(located, value, style, decisions);
    }
    if (located.file.writable && (list || decisions.intoInclude)) {
        return setThere(located, value, style, decisions);
    }
    if (shot !== all[0] && !shot.writable) {
        throw takenFrom(shot, ['cameras']);
    }
    if (list) {
        throw takenFrom(located.file, list);
    }
    return addTo({ file: shot, path }, writeValue(value, style), decisions);
}

/// The name of the shot's file, as it is written, if the path leads into a part of a film that is
/// only that name; else null. Such a part becomes a map when it gets another key.
function shotOfPart(files: readonly SourceFile[], path: KeyPath): string | null {
    const part = path.length === 4 ? path.slice(0, 3) : [];
    const node = isShotOfPart([...part, 'shot']) ? locate(files, part)?.way.steps.at(-1)?.node : null;
    const located = isScalar(node) ? locate(files, part) : null;
    return located && isScalar(node) ? flowText(located.tree, node) : null;
}

function planSetUnchecked(
    all: readonly SourceFile[], path: KeyPath, value: Value, style: NumberStyle,
    decisions: Decisions,
): FileEdits {
    const files = filesOfCamera(all, path);
    const located = locate(files, path);
    const shot = located ? null : shotOfPart(files, path);
    if (shot !== null) {
        const yaml = `{shot: ${shot}, ${path[3] ?? ''}: ${writeValue(value, style)}}`;
        return planSetUnchecked(all, path.slice(0, 3), { yaml }, { unit: '' }, decisions);
    }
    if (!located) {
        return add(all, path, writeValue(value, style), decisions);
    }
    return setLocated(all, files, located, path, value, style, decisions);
}

/// The same as `[]` instead, if the list would not be empty without the item but that of an included
/// file.
function removeItem(
    files: readonly SourceFile[], file: SourceFile, path: KeyPath, tree: Tree, steps: Step[],
): TextEdit[] {
    const removal = removeAt(tree, steps);
    const list = steps[steps.length - 1]?.holder;
    if (file !== files[0] || !isSeq(list) || list.flow || list.items.length > 1) {
        return [removal];
    }
    const without = withEdits(files, { file, edits: [removal] });
    return locate(without, path.slice(0, -1))
        ? setNode(tree, steps.slice(0, -1), { yaml: '[]' }, { unit: '' }) : [removal];
}

function removeThere(
    files: readonly SourceFile[], located: Located, path: KeyPath, decisions: Decisions,
): FileEdits {
    const { file } = located;
    const tree = parseWhole(file.text, file.name);
    const { steps } = walk(tree, located.path);
    const copy = resolveAlias(file, tree, steps.slice(0, -1), decisions);
    if (copy) {
        const copied = after(file, copy);
        const again = removeThere(files.map((one) => one === file ? copied : one),
            { ...located, file: copied }, path, decisions);
        return { file, edits: both(file, copy, again.edits) };
    }
    return { file, edits: removeItem(files, file, path, tree, steps) };
}

function planRemoveUnchecked(
    all: readonly SourceFile[], path: KeyPath, decisions: Decisions,
): FileEdits {
    const files = filesOfCamera(all, path);
    const shot = files[0];
    const located = locate(files, path);
    if (!shot || !located) {
        throw new EditError(`'${path.join('.')}' is not in the text`);
    }
    const { file } = located;
    if (shot !== all[0] && !shot.writable) {
        throw takenFrom(shot, ['cameras']);
    }
    const list = file === shot ? null : listAround(files, path, located, false);
    if (file === shot || (file.writable && (list || decisions.intoInclude))) {
        return removeThere(files, located, path, decisions);
    }
    if (list) {
        throw takenFrom(file, list);
    }
    return addTo({ file: shot, path }, 'null', decisions);
}

/// The edits that give the value at `path` another one. `files` are the shot's, itself first.
/// Throws EditError if it is not possible and Undecided if a question has to be answered first.
export function planSet(
    files: readonly SourceFile[], path: KeyPath, value: Value, style: NumberStyle,
    decisions: Decisions = {},
): FileEdits {
    return checked(planSetUnchecked(files, path, value, style, decisions));
}

/// The edits that take the value at `path` out of the shot. A value of an include is hidden by
/// `null`.
export function planRemove(
    files: readonly SourceFile[], path: KeyPath, decisions: Decisions = {},
): FileEdits {
    return checked(planRemoveUnchecked(files, path, decisions));
}
