/// Which of a shot's files a value comes from. As in pipeline/config/gather.cpp: a file is merged
/// over its quality preset and its includes, maps key by key, other values as a whole; an entry of
/// `cameras` is merged over the camera of the file that it includes.
import { isMap, isScalar, isSeq, type Node } from 'yaml';
import type { KeyPath } from '../protocol';
import type { SourceFile } from './edit_types';
import { keyText, parseTree, scalarText, walk, type Tree, type Walk } from './yaml_tree';

export interface Located {
    file: SourceFile;
    tree: Tree;
    /// The path of the value within that file.
    path: KeyPath;
    way: Walk;
}

const kDeepest = 16;

/// A path without "." and "..".
function normal(path: string): string {
    const parts: string[] = [];
    for (const part of path.split('/')) {
        if (part === '..') {
            parts.pop();
        } else if (part !== '.' && part !== '') {
            parts.push(part);
        }
    }
    return `/${parts.join('/')}`;
}

/// The file that `including` means by `name`, if it is one of the shot's.
export function includedFile(
    files: readonly SourceFile[], including: SourceFile, name: string,
): SourceFile | null {
    const folder = including.file.slice(0, including.file.lastIndexOf('/'));
    const beside = name.startsWith('/') ? normal(name) : normal(`${folder}/${name}`);
    const inConfigs = name.slice(name.lastIndexOf('configs/') + 1).replace(/^onfigs\//, '');
    return files.find((file) => file.file === beside)
        ?? files.find((file) => file.file.endsWith(`/configs/${inConfigs}`))
        ?? files.find((file) => file.file.endsWith(`/${name}`))
        ?? null;
}

/// The texts of a scalar or of the scalars of a list.
function words(node: Node | undefined): string[] {
    if (isScalar(node)) {
        return [scalarText(node)];
    }
    return isSeq(node)
        ? node.items.filter((item) => isScalar(item)).map((item) => scalarText(item))
        : [];
}

/// The value of a key of a map, if it is there.
function valueOf(node: Node | undefined, key: string): Node | undefined {
    const pair = isMap(node) ? node.items.find((item) => keyText(item) === key) : undefined;
    return (pair?.value as Node | null | undefined) ?? undefined;
}

/// The files that stand behind a file's own values, the one that counts most first.
function behind(files: readonly SourceFile[], file: SourceFile, tree: Tree): SourceFile[] {
    const top = (tree.document.contents as Node | null) ?? undefined;
    const includes = words(valueOf(top, 'include'));
    const quality = file === files[0] ? words(valueOf(top, 'quality')) : [];
    return [...includes, ...quality.map((name) => `quality/${name}.yaml`)]
        .reverse()
        .map((name) => includedFile(files, file, name))
        .filter((found) => found !== null);
}

/// Whether the path leads to the shot of a part of a film. The part may be only the name of its file.
export function isShotOfPart(path: KeyPath): boolean {
    return path.length === 4 && path[0] === 'film' && path[1] === 'shots' && path[3] === 'shot';
}

/// Whether the path leads to the key that decides what a part of a film is: it cannot go without it.
export function isKindOfPart(path: KeyPath): boolean {
    return isShotOfPart([...path.slice(0, -1), 'shot']) && ['shot', 'title'].includes(path[3] ?? '');
}

function locateIn(
    files: readonly SourceFile[], file: SourceFile, path: KeyPath, depth: number,
): Located | null {
    const tree = parseTree(file.text);
    const way = walk(tree, path);
    if (way.rest.length === 0) {
        return { file, tree, path, way };
    }
    if (isShotOfPart(path) && way.rest.length === 1 && isScalar(way.steps.at(-1)?.node)) {
        return locateIn(files, file, path.slice(0, 3), depth);
    }
    if (depth > kDeepest || way.steps.some((step) => isScalar(step.node))) {
        return null;  // something else stands in its place
    }
    const done = path.length - way.rest.length;
    const camera = path[0] === 'cameras' && done >= 2 ? way.steps[2]?.node : undefined;
    const [rig] = words(valueOf(camera, 'include'));
    if (rig !== undefined) {
        const found = includedFile(files, file, rig);
        const inRig = ['cameras', '0', ...path.slice(2)];
        return found ? locateIn(files, found, inRig, depth + 1) : null;
    }
    if (way.steps.some((step) => isSeq(step.node))) {
        return null;  // lists are not merged
    }
    for (const one of behind(files, file, tree)) {
        const found = locateIn(files, one, path, depth + 1);
        if (found) {
            return found;
        }
    }
    return null;
}

/// Where the value of a path stands, seen from the shot, which is the first of `files`; null if no
/// file has it.
export function locate(files: readonly SourceFile[], path: KeyPath): Located | null {
    const shot = files[0];
    return shot ? locateIn(files, shot, path, 0) : null;
}
