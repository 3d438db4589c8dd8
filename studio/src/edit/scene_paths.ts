/// Whether a key path of the scene that is shown means the same in the text as it stands now. The view
/// shows the last text without errors: in a later one, an item of a list may be another one, and what
/// followed from a rack or a `repeat` may not exist any more.
import { isMap, isSeq, type Node } from 'yaml';
import type { KeyPath } from '../protocol';
import { hasErrors } from '../state/state';
import { shownTexts } from '../text/shown_texts';
import { EditError } from './edit_error';
import type { SourceFile } from './edit_types';
import { locate, type Located } from './layers';
import { keptItems } from './merge_lines';
import { flowText } from './write_value';
import { keyText, parseTree, walk } from './yaml_tree';

type Files = readonly SourceFile[];

/// The texts that decide which balls or objects there are beside those that are written one by one.
function implying(files: Files, section: string): string[] {
    return files.map(({ text }) => parseTree(text)).flatMap((tree) => {
        const textAt = (path: KeyPath) => {
            const { steps, rest } = walk(tree, path);
            return rest.length === 0 ? flowText(tree, steps.at(-1)?.node ?? null) : '';
        };
        const all = walk(tree, [section]).steps[1]?.node;
        const names = section === 'objects' && isMap(all) ? all.items.map(keyText) : [];
        return section === 'balls' ? [textAt(['table']), textAt(['rack'])]
            : names.map((name) => [name, textAt([section, name, 'repeat'])])
                .filter(([, repeat]) => repeat !== '').map((words) => words.join(' '));
    });
}

function itemTexts({ tree, way }: Located): string[] {
    const node = way.steps.at(-1)?.node;
    return isSeq(node) ? node.items.map((item) => flowText(tree, item as Node)) : [];
}

function isList({ way }: Located): boolean {
    return isSeq(way.steps.at(-1)?.node);
}

/// Whether a ball or an object that is not in the texts follows from them as before.
function isImplied([section = '']: KeyPath, before: Files, after: Files): boolean {
    return (section !== 'balls' && section !== 'objects')
        || implying(before, section).join('\n') === implying(after, section).join('\n');
}

/// Whether a path that leads somewhere in `before`, or to something that these texts imply, means the
/// same in `after`.
export function meansTheSame(path: KeyPath, before: Files, after: Files): boolean {
    if (before.every(({ text }, i) => text === after[i]?.text)) {
        return true;
    }
    for (let depth = 1; depth <= path.length; ++depth) {
        const [old, now] = [before, after].map((files) => locate(files, path.slice(0, depth)));
        if (!old) {
            // A value is new in the map that has it; a ball or an object must still be implied.
            return now !== null || depth > 2 || isImplied(path, before, after);
        }
        if (!now || isList(old) !== isList(now)) {
            return false;
        }
        const index = Number(path[depth]);
        if (isList(old) && Number.isInteger(index)) {
            const items = keptItems(itemTexts(old), itemTexts(now));
            if (index < items.length && items[index] !== index) {
                return false;
            }
        }
    }
    return true;
}

/// Throws EditError if a path of the scene that is shown means something else in these texts.
export function checkScenePath(path: KeyPath, files: Files): void {
    const before = shownTexts();
    if (before && !meansTheSame(path, before, files)) {
        const subject = `'${path.slice(0, 2).join('.')}' is not where it was in the text that is shown`;
        throw new EditError(hasErrors.peek()
            ? `${subject}: the newest one has mistakes that must be mended first`
            : `${subject}: it changed just now; try again`);
    }
}
