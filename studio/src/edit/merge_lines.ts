/// Two changed versions of a text, merged line by line, or word by word.
import { applyEdits, difference, type TextEdit } from './text_edit';

/// Lines [from, to) of the base that a version replaces by other lines.
interface Hunk {
    from: number;
    to: number;
    lines: string[];
}

const kMostCells = 4_000_000;  // of the table that compares the lines between

/// What turns `base` into `version`, by a longest common subsequence of lines.
function hunksOf(base: readonly string[], version: readonly string[]): Hunk[] {
    let start = 0;
    while (start < Math.min(base.length, version.length) && base[start] === version[start]) {
        start += 1;
    }
    let end = 0;
    while (end < Math.min(base.length, version.length) - start
        && base[base.length - 1 - end] === version[version.length - 1 - end]) {
        end += 1;
    }
    const rows = base.length - start - end;
    const columns = version.length - start - end;
    const width = columns + 1;
    if (rows * columns > kMostCells) {
        return [{ from: start, to: start + rows, lines: version.slice(start, start + columns) }];
    }
    const common = new Uint32Array((rows + 1) * width);
    for (let i = rows - 1; i >= 0; --i) {
        for (let j = columns - 1; j >= 0; --j) {
            common[i * width + j] = base[start + i] === version[start + j]
                ? (common[(i + 1) * width + j + 1] ?? 0) + 1
                : Math.max(common[(i + 1) * width + j] ?? 0, common[i * width + j + 1] ?? 0);
        }
    }
    const hunks: Hunk[] = [];
    let i = 0;
    let j = 0;
    while (i < rows || j < columns) {
        if (i < rows && j < columns && base[start + i] === version[start + j]) {
            i += 1;
            j += 1;
            continue;
        }
        const hunk: Hunk = { from: start + i, to: start + i, lines: [] };
        while ((i < rows || j < columns)
            && !(i < rows && j < columns && base[start + i] === version[start + j])) {
            const takesBase = j >= columns || (i < rows
                && (common[(i + 1) * width + j] ?? 0) >= (common[i * width + j + 1] ?? 0));
            if (takesBase) {
                i += 1;
            } else {
                hunk.lines.push(version[start + j] ?? '');
                j += 1;
            }
        }
        hunk.to = start + i;
        hunks.push(hunk);
    }
    return hunks;
}

/// Whether two hunks touch the same lines, or insert at the same place.
function meet(a: Hunk, b: Hunk): boolean {
    return a.from === b.from || (a.from < b.to && b.from < a.to);
}

function isEqual(a: Hunk, b: Hunk): boolean {
    return a.from === b.from && a.to === b.to && a.lines.join('\n') === b.lines.join('\n');
}

export interface Merged {
    text: string;
    /// How many changes of the other version could not be taken over, because the own version
    /// changes the same lines.
    conflicts: number;
}

/// Where each item of a list is in a later one, by index: unchanged items in their order, and changed
/// ones that have as many in their place; null: it is gone.
export function keptItems(
    before: readonly string[], after: readonly string[],
): (number | null)[] {
    const kept: (number | null)[] = [];
    let shift = 0;
    const unchangedUntil = (end: number) => {
        while (kept.length < end) {
            kept.push(kept.length + shift);
        }
    };
    for (const { from, to, lines } of hunksOf(before, after)) {
        unchangedUntil(from);
        const isInPlace = lines.length === to - from;
        for (let i = from; i < to; ++i) {
            kept.push(isInPlace ? i + shift : null);
        }
        shift += lines.length - (to - from);
    }
    unchangedUntil(before.length);
    return kept;
}

/// What turns `base` into `version`, of whole words and numbers; null if they are equal.
function wordsChanged(base: string, version: string): TextEdit | null {
    const edit = difference(base, version);
    if (!edit) {
        return null;
    }
    let { from, to } = edit;
    while (from > 0 && /[\w.+-]/.test(base[from - 1] ?? '')) {
        from -= 1;
    }
    while (to < base.length && /[\w.+-]/.test(base[to] ?? '')) {
        to += 1;
    }
    const insert = base.slice(from, edit.from) + edit.insert + base.slice(edit.to, to);
    return { from, to, insert };
}

/// As mergeLines, but two changes of one line are both kept if each is of one stretch of words and
/// these are apart.
export function mergeWords(base: string, own: string, other: string): Merged {
    const [mine, theirs] = [wordsChanged(base, own), wordsChanged(base, other)];
    if (!mine || !theirs || own === other) {
        return { text: mine ? own : other, conflicts: 0 };
    }
    if (mine.to < theirs.from || theirs.to < mine.from) {
        return { text: applyEdits(base, [mine, theirs]), conflicts: 0 };
    }
    const isOneLine = !/\n/.test(base + own + other);
    return isOneLine ? { text: own, conflicts: 1 } : mergeHunks(base, own, other, mergeWords);
}

/// Hunks that replace as many lines as they take, line by line.
function byLine(hunk: Hunk): Hunk[] {
    const { from, to, lines } = hunk;
    return lines.length !== to - from ? [hunk]
        : lines.map((line, i) => ({ from: from + i, to: from + i + 1, lines: [line] }));
}

/// `mergeLine` merges two versions of one line.
function mergeHunks(
    base: string, own: string, other: string, mergeLine: typeof mergeWords | null,
): Merged {
    const lines = base.split('\n');
    const mine = hunksOf(lines, own.split('\n')).flatMap(byLine);
    const theirs = hunksOf(lines, other.split('\n')).flatMap(byLine)
        .filter((hunk) => !mine.some((one) => isEqual(one, hunk)));
    const free: Hunk[] = [];
    let conflicts = 0;
    for (const hunk of theirs) {
        const met = mine.filter((one) => meet(one, hunk));
        const [one] = met;
        const isOneLine = met.length === 1 && one && one.lines.length === 1 && hunk.lines.length === 1
            && one.to === one.from + 1 && hunk.to === one.to && hunk.from === one.from;
        const merged = isOneLine && mergeLine ? mergeLine(lines[one.from] ?? '', one.lines[0] ?? '',
            hunk.lines[0] ?? '') : null;
        if (met.length === 0) {
            free.push(hunk);
        } else if (one && merged && merged.conflicts === 0) {
            one.lines = [merged.text];
        } else {
            conflicts += 1;
        }
    }
    for (const hunk of [...mine, ...free].sort((a, b) => b.from - a.from || b.to - a.to)) {
        lines.splice(hunk.from, hunk.to - hunk.from, ...hunk.lines);
    }
    return { text: lines.join('\n'), conflicts };
}

/// The own version with those changes of the other one that touch no line that the own one changes.
export function mergeLines(base: string, own: string, other: string): Merged {
    return mergeHunks(base, own, other, null);
}
