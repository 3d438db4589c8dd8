/// In which file a change belongs. Maps of included files are merged with the shot's, so that the
/// shot can lay a key over; a list is replaced as a whole, so that it can only be changed where it
/// stands.
import { isSeq } from 'yaml';
import type { KeyPath } from '../protocol';
import { Undecided } from './decisions';
import type { SourceFile } from './edit_types';
import { locate, type Located } from './layers';
import { parseTree, walk } from './yaml_tree';

/// A key path of one file.
export interface Place {
    file: SourceFile;
    path: KeyPath;
}

/// The question whether a list of a read-only file is to be copied into the shot.
export function takenFrom(file: SourceFile, list: KeyPath): Undecided {
    return new Undecided(
        `'${list.join('.')}' is a list of ${file.name}, which cannot be changed here.`,
        'list', list.join('/'), list.join('.'));
}

/// The files as the one sees them that has the camera into which the path leads: a camera may
/// include a file of its own, over which only the camera's own text is laid.
export function filesOfCamera(files: readonly SourceFile[], path: KeyPath): readonly SourceFile[] {
    const isInCamera = path[0] === 'cameras' && path.length > 2;
    const holder = isInCamera ? locate(files, path.slice(0, 2))?.file : undefined;
    return !holder || holder === files[0] ? files
        : [holder, ...files.filter((file) => file !== holder)];
}

/// Whether the path leads into a camera of the file, which may include another file.
function isOwnCamera(path: KeyPath, file: SourceFile): boolean {
    return path[0] === 'cameras' && path.length > 2
        && walk(parseTree(file.text), path.slice(0, 2)).rest.length === 0;
}

/// The path of the outermost list that is not the shot's, `files[0]`, and holds what was located by
/// `path`; null: there is none. With `orIsOne` the located value itself counts, too.
export function listAround(
    files: readonly SourceFile[], path: KeyPath, located: Located, orIsOne: boolean,
): KeyPath | null {
    const { steps } = located.way;
    // In the file that a camera includes, `cameras` is no list of the shot's.
    const first = files[0] && isOwnCamera(path, files[0]) ? 2 : 0;
    const inside = steps.slice(first, orIsOne ? steps.length : -1);
    const depth = inside.findIndex((step) => isSeq(step.node));
    return depth < 0 ? null
        : path.slice(0, depth + first + path.length - located.path.length);
}

/// Where something that is not there yet is added. Throws Undecided if that is a list of a file that
/// cannot be written.
export function placeToAdd(all: readonly SourceFile[], path: KeyPath): Place | null {
    const files = filesOfCamera(all, path);
    const [shot] = files;
    if (!shot) {
        return null;
    }
    if (shot !== all[0] && !shot.writable) {
        throw takenFrom(shot, ['cameras']);
    }
    for (let depth = path.length - 1; depth > 0; depth -= 1) {
        const above = path.slice(0, depth);
        const located = locate(files, above);
        if (!located) {
            continue;
        }
        const list = located.file === shot ? null : listAround(files, above, located, true);
        if (!list) {
            break;
        }
        if (!located.file.writable) {
            throw takenFrom(located.file, list);
        }
        return { file: located.file, path: [...located.path, ...path.slice(depth)] };
    }
    return { file: shot, path };
}
