/// Sets a key beside which others must not stand: `direction` goes to the place of `toward`.
import { isScalar, type Pair } from 'yaml';
import type { KeyPath } from '../protocol';
import { EditError } from './edit_error';
import type { SourceFile, Value } from './edit_types';
import { withEdits } from './file_edits';
import { locate, type Located } from './layers';
import { planRemove, planSet, type Decisions } from './plan';
import { itemEnd, itemStart, parseWhole, scalarText, walk } from './yaml_tree';
import { writeValue, type NumberStyle } from './write_value';

/// The keys that contradict the last one of a path.
export type RivalsOf = (path: KeyPath) => readonly string[];

/// Where the value of a key stands; null also if it is `null`, which only hides that of an include.
function given(files: readonly SourceFile[], path: KeyPath): Located | null {
    const located = locate(files, path);
    const node = located?.way.steps.at(-1)?.node;
    const isHidden = isScalar(node) && node.type === 'PLAIN' && /^(null|~|)$/.test(scalarText(node));
    return isHidden ? null : located;
}

/// The rivals of the last key of a path that the text has.
function rivalsIn(files: readonly SourceFile[], path: KeyPath, rivalsOf: RivalsOf): KeyPath[] {
    return rivalsOf(path).map((key) => [...path.slice(0, -1), key])
        .filter((rival) => given(files, rival) !== null);
}

/// Throws EditError if a map on the way to the value is missing and cannot be added, because another
/// one stands in its place: what is edited has become something else meanwhile.
function checkWay(files: readonly SourceFile[], path: KeyPath, rivalsOf: RivalsOf): void {
    for (let depth = 1; depth < path.length; ++depth) {
        const above = path.slice(0, depth);
        if (!locate(files, above)) {
            const rival = rivalsIn(files, above, rivalsOf)[0]?.at(-1);
            if (rival !== undefined) {
                throw new EditError(`'${path.join('.')}' cannot be set: the text has '${rival}' there`);
            }
            return;
        }
    }
}

/// The files with the value at `path` set and without the keys that contradict it. If there is one
/// and it stands in the shot's own text, the new one takes its place. Throws as planSet does.
export function setAlone(
    files: SourceFile[], path: KeyPath, rivalsOf: RivalsOf, value: Value, style: NumberStyle,
    decisions: Decisions = {},
): SourceFile[] {
    checkWay(files, path, rivalsOf);
    const rivals = rivalsIn(files, path, rivalsOf);
    const [rival = []] = rivals;
    const shot = files[0];
    const located = rivals.length === 1 && !locate(files, path) ? given(files, rival) : null;
    if (shot && located?.file === shot && located.way.steps.every((step) => step.alias === null)) {
        const tree = parseWhole(shot.text, shot.name);
        const pair = walk(tree, rival).steps.at(-1)?.pair as Pair;
        const insert = `${path[path.length - 1] ?? ''}: ${writeValue(value, style)}`;
        const edit = { from: itemStart(pair), to: itemEnd(shot.text, pair), insert };
        return withEdits(files, { file: shot, edits: [edit] });
    }
    const set = withEdits(files, planSet(files, path, value, style, decisions));
    return rivals.reduce((all, one) => withEdits(all, planRemove(all, one, decisions)), set);
}
