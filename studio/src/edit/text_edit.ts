/// Changes of one text.

/// Replaces what is between two offsets (UTF-16 units).
export interface TextEdit {
    from: number;
    to: number;
    insert: string;
}

/// The text after all edits, which do not overlap and are all given in offsets of `text`.
export function applyEdits(text: string, edits: readonly TextEdit[]): string {
    let result = text;
    for (const edit of [...edits].sort((a, b) => b.from - a.from || b.to - a.to)) {
        result = result.slice(0, edit.from) + edit.insert + result.slice(edit.to);
    }
    return result;
}

/// Where the line of an offset starts.
export function lineStart(text: string, offset: number): number {
    return text.lastIndexOf('\n', offset - 1) + 1;
}

/// Where the line of an offset ends, before its line break.
export function lineEnd(text: string, offset: number): number {
    const end = text.indexOf('\n', offset);
    return end < 0 ? text.length : end;
}

/// The smallest single edit that turns one text into another; null if they are equal.
export function difference(before: string, after: string): TextEdit | null {
    if (before === after) {
        return null;
    }
    const shorter = Math.min(before.length, after.length);
    let start = 0;
    while (start < shorter && before[start] === after[start]) {
        start += 1;
    }
    let end = 0;
    while (
        end < shorter - start
        && before[before.length - 1 - end] === after[after.length - 1 - end]
    ) {
        end += 1;
    }
    return {
        from: start,
        to: before.length - end,
        insert: after.slice(start, after.length - end),
    };
}
