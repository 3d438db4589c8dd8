/// Decides where a change is written, and what exactly.
import { isSeq, type Node } from 'yaml';
import type { KeyPath } from '../protocol';
import { addAt } from './add_entry';
import { checked } from './alias_check';
import { EditError } from './edit_error';
import type { FileEdits, SourceFile, Value } from './edit_types';
export type { FileEdits } from './edit_types';
import { locate, type Located } from './layers';
import { removeAt } from './remove_entry';
import { setNode } from './set_value';
import type { TextEdit } from './text_edit';
import { parseTree, parseWhole, rangeOf, walk, type Step, type Tree } from './yaml_tree';
import { flowText, writeValue, type NumberStyle } from './write_value';

/// What the user has decided about values that could be changed in two ways.
export interface Decisions {
    /// Values of includes are changed in the include, not laid over in the shot.
    intoInclude?: boolean;
    /// What to do with aliases, by their anchor.
    aliases?: ReadonlyMap<string, 'anchor' | 'copy'>;
    /// Lists of read-only files that are copied into the shot, by their path joined with "/".
    takenLists?: ReadonlySet<string>;
}

/// A question that has to be answered before the edit is possible.
export class Undecided extends Error {
    constructor(
        message: string,
        readonly kind: 'alias' | 'list',
        /// The anchor, or the path of the list joined with "/".
        readonly subject: string,
    ) {
        super(message);
    }
}

/// The outermost alias on the way, with its depth; null if there is none.
function firstAlias(steps: readonly Step[]): { step: Step; depth: number } | null {
    const depth = steps.findIndex((step) => step.alias !== null);
    const step = steps[depth];
    return step ? { step, depth } : null;
}

/// Follows the alias on the way if the user wants the anchor changed, or puts a copy of the value
/// in its place. Returns the edit that copies, or null if the way can be used as it is.
function resolveAlias(tree: Tree, steps: readonly Step[], decisions: Decisions): TextEdit | null {
    const found = firstAlias(steps);
    const alias = found?.step.alias;
    if (!found || !alias) {
        return null;
    }
    const decision = decisions.aliases?.get(alias.source);
    if (decision === undefined) {
        throw new Undecided(
            `'*${alias.source}' repeats a value that is written elsewhere with the name `
            + `'&${alias.source}'.`, 'alias', alias.source);
    }
    if (decision === 'anchor') {
        return null;
    }
    const [from, to] = rangeOf(alias);
    return { from, to, insert: flowText(tree, alias) };
}

/// The shot with `edit` made, for edits that build on it.
function after(file: SourceFile, edit: TextEdit): SourceFile {
    const text = file.text.slice(0, edit.from) + edit.insert + file.text.slice(edit.to);
    return { ...file, text };
}

/// Edits of the text before `first` was made that do both `first` and `then`.
function both(file: SourceFile, first: TextEdit, then: readonly TextEdit[]): TextEdit[] {
    // One edit over everything that either of them touches.
    const middle = after(file, first).text;
    const grown = first.insert.length - (first.to - first.from);
    const from = Math.min(first.from, ...then.map((edit) => edit.from));
    const to = Math.max(first.from + first.insert.length, ...then.map((edit) => edit.to));
    let insert = middle.slice(from, to);
    for (const edit of [...then].sort((a, b) => b.from - a.from)) {
        insert = insert.slice(0, edit.from - from) + edit.insert + insert.slice(edit.to - from);
    }
    return [{ from, to: to - grown, insert }];
}

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
    const copy = resolveAlias(tree, steps, decisions);
    if (copy && firstAlias(above)) {
        const copied = after(file, copy);
        const again = setThere({ ...located, file: copied }, value, style, decisions);
        return { file, edits: both(file, copy, again.edits) };
    }
    const target = copy ? last : { ...last, alias: null };
    return { file, edits: setNode(tree, [...above, target], value, style) };
}

/// How many keys of a path lead to the first list on the way, itself included; -1 without a list.
function listDepth(located: Located): number {
    const depth = located.way.steps.slice(0, -1).findIndex((step) => isSeq(step.node));
    // In a camera file that a camera includes, `cameras` is no list of the shot's.
    return depth;
}

/// The part of the shot's path that corresponds to `depth` keys within `located.file`.
function outerPath(path: KeyPath, located: Located, depth: number): KeyPath {
    return path.slice(0, depth + path.length - located.path.length);
}

/// Adds a value, or another text in YAML, to the shot where the path is missing.
export function addToShot(
    shot: SourceFile, path: KeyPath, yaml: string, decisions: Decisions, index?: number,
): FileEdits {
    const tree = parseWhole(shot.text, shot.name);
    const way = walk(tree, path);
    const copy = resolveAlias(tree, way.steps, decisions);
    if (copy) {
        const again = addToShot(after(shot, copy), path, yaml, decisions, index);
        return { file: shot, edits: both(shot, copy, again.edits) };
    }
    return { file: shot, edits: [addAt(tree, way, yaml, index)] };
}

/// Whether the camera that the path leads into is one that the shot's camera includes.
function isRig(path: KeyPath, shot: SourceFile): boolean {
    return path[0] === 'cameras' && path.length > 2
        && walk(parseTree(shot.text), path.slice(0, 2)).rest.length === 0;
}

function takenFrom(file: SourceFile, list: KeyPath): Undecided {
    return new Undecided(
        `'${list.join('.')}' is a list of ${file.name}, which cannot be changed here.`,
        'list', list.join('/'));
}

/// The edits that copy a list of a read-only file into the shot.
export function planTakeList(files: readonly SourceFile[], list: KeyPath): FileEdits {
    const shot = files[0];
    const located = locate(files, list);
    const node = located?.way.steps[located.way.steps.length - 1]?.node;
    if (!shot || !located || !node) {
        throw new EditError(`'${list.join('.')}' is not in the text`);
    }
    return addToShot(shot, list, flowText(located.tree, node), {});
}

/// Copies a list of an included file into the shot, then sets a value in it.
function takeOver(
    files: readonly SourceFile[], located: Located, list: KeyPath, path: KeyPath, value: Value,
    style: NumberStyle, decisions: Decisions,
): FileEdits {
    const shot = files[0] as SourceFile;
    if (!decisions.takenLists?.has(list.join('/'))) {
        throw takenFrom(located.file, list);
    }
    const depth = list.length + located.path.length - path.length;
    const node = located.way.steps[depth]?.node as Node;
    const [copy] = addToShot(shot, list, flowText(located.tree, node), decisions).edits;
    const taken = after(shot, copy as TextEdit);
    const tree = parseWhole(taken.text, taken.name);
    const edits = setNode(tree, walk(tree, path).steps, value, style);
    return { file: shot, edits: both(shot, copy as TextEdit, edits) };
}

function planSetUnchecked(
    files: readonly SourceFile[], path: KeyPath, value: Value, style: NumberStyle,
    decisions: Decisions,
): FileEdits {
    const shot = files[0];
    if (!shot) {
        throw new EditError('no shot is open');
    }
    const located = locate(files, path);
    if (!located) {
        return addToShot(shot, path, writeValue(value, style), decisions);
    }
    if (located.file === shot) {
        return setThere(located, value, style, decisions);
    }
    const isInRig = isRig(path, shot);
    const depth = isInRig
        ? located.way.steps.slice(2, -1).findIndex((step) => isSeq(step.node)) + 2
        : listDepth(located);
    const isInList = depth >= (isInRig ? 2 : 0);
    if (located.file.writable && (isInList || decisions.intoInclude)) {
        return setThere(located, value, style, decisions);
    }
    if (isInList) {
        const list = outerPath(path, located, depth);
        return takeOver(files, located, list, path, value, style, decisions);
    }
    return addToShot(shot, path, writeValue(value, style), decisions);
}

function planRemoveUnchecked(
    files: readonly SourceFile[], path: KeyPath, decisions: Decisions = {},
): FileEdits {
    const shot = files[0];
    const located = locate(files, path);
    if (!shot || !located) {
        throw new EditError(`'${path.join('.')}' is not in the text`);
    }
    const file = located.file;
    if (file === shot || (file.writable && decisions.intoInclude)) {
        const tree = parseWhole(file.text, file.name);
        const { steps } = walk(tree, located.path);
        const copy = resolveAlias(tree, steps.slice(0, -1), decisions);
        if (copy) {
            const again = planRemoveUnchecked([after(file, copy), ...files.slice(1)], path, decisions);
            return { file, edits: both(file, copy, again.edits) };
        }
        return { file, edits: [removeAt(tree, steps)] };
    }
    const depth = listDepth(located);
    if (depth >= 0 && file.writable) {
        const tree = parseWhole(file.text, file.name);
        return { file, edits: [removeAt(tree, walk(tree, located.path).steps)] };
    }
    if (depth >= 0) {
        throw takenFrom(file, outerPath(path, located, depth));
    }
    return addToShot(shot, path, 'null', decisions);
}

/// The edits that add an item, YAML without an indent, to a list before the item `index`.
export function planInsert(
    files: readonly SourceFile[], list: KeyPath, index: number, yaml: string,
    decisions: Decisions = {},
): FileEdits {
    const shot = files[0];
    if (!shot) {
        throw new EditError('no shot is open');
    }
    const located = locate(files, list);
    const node = located?.way.steps[located.way.steps.length - 1]?.node;
    const isOwn = located?.file === shot;
    if (located && !isOwn && isSeq(node) && node.items.length > 0) {
        if (!located.file.writable) {
            throw takenFrom(located.file, list);
        }
        const tree = parseWhole(located.file.text, located.file.name);
        const way = walk(tree, [...located.path, String(index)]);
        const edit = addAt(tree, { steps: walk(tree, located.path).steps, rest: way.rest.length > 0
            ? way.rest : [String(index)] }, yaml, index);
        return { file: located.file, edits: [edit] };
    }
    const tree = parseWhole(shot.text, shot.name);
    if (isOwn && isSeq(node)) {
        const { steps } = walk(tree, list);
        const copy = resolveAlias(tree, steps, decisions);
        if (copy) {
            const again = planInsert([after(shot, copy)], list, index, yaml, decisions);
            return { file: shot, edits: both(shot, copy, again.edits) };
        }
        return { file: shot, edits: [addAt(tree, { steps, rest: [String(index)] }, yaml, index)] };
    }
    return addToShot(shot, [...list, '0'], yaml, decisions);
}

/// The edits that add an entry, its value YAML without an indent, to a map.
export function planEntry(
    files: readonly SourceFile[], map: KeyPath, key: string, yaml: string,
    decisions: Decisions = {},
): FileEdits {
    const shot = files[0];
    if (!shot) {
        throw new EditError('no shot is open');
    }
    const way = walk(parseWhole(shot.text, shot.name), [...map, key]);
    if (way.rest.length === 0) {
        throw new EditError(`'${[...map, key].join('.')}' is in the text already`);
    }
    return addToShot(shot, [...map, key], yaml, decisions);
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
