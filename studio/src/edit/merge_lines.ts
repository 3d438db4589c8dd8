/// Two changed versions of a text, merged line by line.

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

/// The own version with those changes of the other one that touch no line that the own one changes.
export function mergeLines(base: string, own: string, other: string): Merged {
    const lines = base.split('\n');
    const mine = hunksOf(lines, own.split('\n'));
    const theirs = hunksOf(lines, other.split('\n'))
        .filter((hunk) => !mine.some((one) => isEqual(one, hunk)));
    const free = theirs.filter((hunk) => !mine.some((one) => meet(one, hunk)));
    for (const hunk of [...mine, ...free].sort((a, b) => b.from - a.from || b.to - a.to)) {
        lines.splice(hunk.from, hunk.to - hunk.from, ...hunk.lines);
    }
    return { text: lines.join('\n'), conflicts: theirs.length - free.length };
}
