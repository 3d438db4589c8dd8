/// Decides where something new is written, and how.
import { isSeq, type Node } from 'yaml';
import type { KeyPath } from '../protocol';
import { addAt } from './add_entry';
import { resolveAlias, type Decisions } from './decisions';
import { EditError } from './edit_error';
import type { FileEdits, SourceFile } from './edit_types';
import { after, both } from './file_edits';
import { locate } from './layers';
import { filesOfCamera, listAround, placeToAdd, takenFrom, type Place } from './place';
import { flowText } from './write_value';
import { parseWhole, walk } from './yaml_tree';

/// Adds a value, or another text in YAML, to a file where the path is missing.
export function addTo({ file, path }: Place, yaml: string, decisions: Decisions): FileEdits {
    const tree = parseWhole(file.text, file.name);
    const way = walk(tree, path);
    const copy = resolveAlias(file, tree, way.steps, decisions);
    if (copy) {
        const again = addTo({ file: after(file, copy), path }, yaml, decisions);
        return { file, edits: both(file, copy, again.edits) };
    }
    return { file, edits: [addAt(tree, way, yaml)] };
}

/// The same in the file where it belongs.
export function add(
    files: readonly SourceFile[], path: KeyPath, yaml: string, decisions: Decisions,
): FileEdits {
    const place = placeToAdd(files, path);
    if (!place) {
        throw new EditError('no shot is open');
    }
    return addTo(place, yaml, decisions);
}

/// The edits that copy a list of a read-only file into the shot.
export function planTakeList(files: readonly SourceFile[], list: KeyPath): FileEdits {
    const shot = files[0];
    const located = locate(files, list);
    const node = located?.way.steps[located.way.steps.length - 1]?.node;
    if (!shot || !located || !node) {
        throw new EditError(`'${list.join('.')}' is not in the text`);
    }
    return addTo({ file: shot, path: list }, flowText(located.tree, node), {});
}

/// Inserts an item into a list of a file.
function insertInto({ file, path }: Place, index: number, yaml: string, decisions: Decisions) {
    const tree = parseWhole(file.text, file.name);
    const { steps } = walk(tree, path);
    const copy = resolveAlias(file, tree, steps, decisions);
    if (copy) {
        const again: FileEdits =
            insertInto({ file: after(file, copy), path }, index, yaml, decisions);
        return { file, edits: both(file, copy, again.edits) };
    }
    return { file, edits: [addAt(tree, { steps, rest: [String(index)] }, yaml, index)] };
}

/// The edits that add an item, YAML without an indent, to a list before the item `index`.
export function planInsert(
    all: readonly SourceFile[], list: KeyPath, index: number, yaml: string,
    decisions: Decisions = {},
): FileEdits {
    const files = filesOfCamera(all, [...list, '0']);
    const located = locate(files, list);
    const node = located?.way.steps[located.way.steps.length - 1]?.node as Node | undefined;
    if (!located || !isSeq(node)) {
        return add(all, [...list, '0'], yaml, decisions);
    }
    const isOwn = located.file === all[0];
    const outer = isOwn ? null : listAround(files, list, located, true);
    if (!isOwn && node.items.length === 0 && outer?.length === list.length) {
        return addTo({ file: files[0] as SourceFile, path: [...list, '0'] }, yaml, decisions);
    }
    if (!isOwn && !located.file.writable) {
        throw takenFrom(located.file, outer ?? ['cameras']);
    }
    return insertInto(located, index, yaml, decisions);
}

/// The edits that add an entry, its value YAML without an indent, to a map.
export function planEntry(
    files: readonly SourceFile[], map: KeyPath, key: string, yaml: string,
    decisions: Decisions = {},
): FileEdits {
    const path = [...map, key];
    const place = placeToAdd(files, path);
    if (!place) {
        throw new EditError('no shot is open');
    }
    if (walk(parseWhole(place.file.text, place.file.name), place.path).rest.length === 0) {
        throw new EditError(`'${path.join('.')}' is in the text already`);
    }
    return addTo(place, yaml, decisions);
}
