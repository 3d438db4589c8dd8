/// What is being written at an offset of a YAML text. The text before the offset is read and of the
/// text after it only the keys beside it, so that half-written values do no harm.
import type { KeyPath } from '../protocol';
import { followingKeys } from './following_keys';

export interface Spot {
    /// A key of the map `path`; the value at `path`; or either: what will be the first key, or the
    /// value.
    kind: 'key' | 'value' | 'either';
    path: KeyPath;
    /// Where the word or value that is being written starts.
    from: number;
    /// The keys that the map has before and after.
    present: string[];
    isFlow: boolean;
    /// The column of `from`, for lines that follow.
    column: number;
}

interface Frame {
    isMap: boolean;
    isFlow: boolean;
    /// Of its keys or dashes; of a flow map that of the block that it stands in.
    indent: number;
    keys: string[];
    key: string | null;
    index: number;
}

const kKey = /("(?:[^"\\\n]|\\.)*"|'(?:[^'\n]|'')*'|[^\s#'"|>&*!%@`[\]{},][^#\n]*?)[ \t]*:(?=[ \t\n]|$)/y;
const kQuoted = /"(?:[^"\\]|\\[^])*"|'(?:[^']|'')*'/y;
const kProperties = /(?:[&!][^\s,[\]{}]*[ \t]+)+/y;

function unquoted(key: string): string {
    return /^(["']).*\1$/.test(key) ? key.slice(1, -1) : key;
}

class Scanner {
    private at = 0;
    private frames: Frame[] = [];
    private spot: Omit<Spot, 'present'> | null = null;
    private isOver = false;

    constructor(private readonly text: string) {}

    scan(): { spot: Omit<Spot, 'present'>; before: string[] } | null {
        while (!this.isOver) {
            this.line();
        }
        const map = this.frames[this.frames.length - 1];
        return this.spot && { spot: this.spot, before: map?.isMap ? map.keys : [] };
    }

    private get atEnd(): boolean {
        return this.at >= this.text.length;
    }

    private match(pattern: RegExp): string | null {
        pattern.lastIndex = this.at;
        const found = pattern.exec(this.text);
        if (found) {
            this.at += found[0].length;
        }
        return found ? found[1] ?? found[0] : null;
    }

    private column(): number {
        return this.at - this.text.lastIndexOf('\n', this.at - 1) - 1;
    }

    private path(frames: readonly Frame[] = this.frames): KeyPath {
        return frames.flatMap((frame) =>
            frame.isMap ? frame.key === null ? [] : [frame.key] : [String(frame.index)]);
    }

    private end(kind: Spot['kind'] | null, from: number): void {
        this.isOver = true;
        const column = from - this.text.lastIndexOf('\n', from - 1) - 1;
        const top = this.frames[this.frames.length - 1];
        const path = kind === 'key' ? this.path(this.frames.slice(0, -1)) : this.path();
        this.spot = kind && { kind, path, from, column, isFlow: top?.isFlow ?? false };
    }

    /// Ends blocks that a line at this column does not belong to.
    private close(column: number, isDash: boolean): void {
        for (;;) {
            const top = this.frames[this.frames.length - 1];
            if (!top || top.indent < column
                || (top.indent === column && (top.isMap || isDash))) {
                return;
            }
            this.frames.pop();
        }
    }

    private line(): void {
        this.match(/[ ]*/y);
        if (this.match(/#[^\n]*\n|\n/y) !== null) {
            return;
        }
        if (this.match(/(?:---|\.\.\.)(?=\s)/y) !== null) {
            this.frames = [];
        }
        const isDash = /^-(\s|$)/.test(this.text.slice(this.at, this.at + 2)) && !this.atEnd;
        this.close(this.column(), isDash);
        if (this.text.startsWith('#', this.at)) {
            this.end(null, this.at);
        } else if (this.atEnd) {
            this.endOfKey(this.at);
        } else {
            this.content();
        }
    }

    /// The end within a key, or before one, of a block.
    private endOfKey(from: number): void {
        const column = from - this.text.lastIndexOf('\n', from - 1) - 1;
        const top = this.frames[this.frames.length - 1];
        if (!top) {
            this.frames.push(this.frame(true, false, column));
            this.end('key', from);
        } else if (top.isMap && top.indent === column) {
            this.end('key', from);
        } else {
            this.end('either', from);
        }
    }

    private frame(isMap: boolean, isFlow: boolean, indent: number): Frame {
        return { isMap, isFlow, indent, keys: [], key: null, index: 0 };
    }

    private content(): void {
        while (this.match(/-(?=\s|$)/y) !== null) {
            const column = this.column() - 1;
            const top = this.frames[this.frames.length - 1];
            if (top && !top.isMap && top.indent === column) {
                top.index += 1;
            } else {
                this.frames.push(this.frame(false, false, column));
            }
            this.match(/[ \t]*/y);
            if (this.atEnd) {
                return this.end('either', this.at);
            }
            if (this.match(/\n|#[^\n]*\n/y) !== null) {
                return undefined;
            }
        }
        const column = this.column();
        const start = this.at;
        this.match(kProperties);
        const key = this.match(kKey);
        if (key === null) {
            return this.value(start, true);
        }
        const top = this.frames[this.frames.length - 1];
        const map = top?.isMap && top.indent === column ? top : this.frame(true, false, column);
        if (map !== top) {
            this.frames.push(map);
        }
        map.key = unquoted(key);
        map.keys.push(map.key);
        return this.value(this.at, false);
    }

    /// A value of a block, up to the end of its line or lines.
    private value(start: number, isAlone: boolean): void {
        this.match(/[ \t]*/y);
        this.match(kProperties);
        const from = this.at;
        const next = this.text[this.at];
        if (next === '{' || next === '[') {
            this.flow(this.frames.length, this.frames[this.frames.length - 1]?.indent ?? -1);
            this.rest();
        } else if (next === '|' || next === '>') {
            this.blockScalar();
        } else if (next === '"' || next === "'") {
            if (this.match(kQuoted) === null || this.atEnd) {
                this.end('value', from);
            }
            this.rest();
        } else {
            this.match(/(?:[^#\n]|(?<=\S)#)*/y);
            if (this.atEnd) {
                return isAlone ? this.endOfKey(start) : this.end('value', from);
            }
            this.rest();
        }
        return undefined;
    }

    /// What is left of a line after its value.
    private rest(): void {
        if (this.isOver) {
            return;
        }
        this.match(/[^\n]*/y);
        if (this.atEnd) {
            this.end(null, this.at);
        }
        this.at += 1;
    }

    private blockScalar(): void {
        const indent = this.frames[this.frames.length - 1]?.indent ?? -1;
        this.match(/[^\n]*/y);
        while (!this.atEnd && this.match(/\n[ \t]*(?=\n|$)/y) !== null) {
            // an empty line
        }
        for (;;) {
            const line = /\n( *)[^\n]*/y;
            line.lastIndex = this.at;
            const found = line.exec(this.text);
            // A blank line belongs to the text, unless the next key may be written there.
            const isLast = found && this.at + found[0].length === this.text.length;
            const isBlank = found?.[0].trim() === ''
                && !(isLast && (found[1]?.length ?? 0) <= indent);
            if (!found || (!isBlank && (found[1]?.length ?? 0) <= indent)) {
                break;
            }
            this.at += found[0].length;
        }
        if (this.atEnd) {
            return this.end(null, this.at);
        }
        this.at += 1;
        return undefined;
    }

    /// Space and comments within {...} or [...]. Returns false where a less indented line shows
    /// that the closing bracket is missing.
    private skip(indent: number): boolean {
        for (;;) {
            this.match(/[ \t]+/y);
            if (this.match(/#[^\n]*/y) !== null && this.atEnd) {
                this.end(null, this.at);
                return true;
            }
            if (this.text[this.at] !== '\n') {
                return true;
            }
            const next = /\n( *)(?=[^\s#])/y;
            next.lastIndex = this.at;
            const found = next.exec(this.text);
            if (found && (found[1]?.length ?? 0) <= indent
                && !/[\]}]/.test(this.text[this.at + found[0].length] ?? '')) {
                return false;
            }
            this.at += 1;
        }
    }

    private flow(depth: number, indent: number): void {
        this.frames.push(this.frame(this.text[this.at] === '{', true, indent));
        this.at += 1;
        while (!this.isOver && this.frames.length > depth) {
            const frame = this.frames[this.frames.length - 1] as Frame;
            if (!this.skip(indent)) {
                this.frames.length = depth;
                return;
            }
            if (this.isOver) {
                return;
            }
            const needsKey = frame.isMap && frame.key === null;
            if (this.atEnd) {
                this.end(needsKey ? 'key' : 'value', this.at);
            } else if (this.match(/[\]}]/y) !== null) {
                this.frames.pop();
            } else if (this.match(/,/y) !== null) {
                frame.key = null;
                frame.index += 1;
            } else if (/[[{]/.test(this.text[this.at] ?? '') && !needsKey) {
                this.frames.push(this.frame(this.text[this.at] === '{', true, indent));
                this.at += 1;
            } else {
                this.flowScalar(frame, needsKey);
            }
        }
    }

    private flowScalar(frame: Frame, needsKey: boolean): void {
        const from = this.at;
        const word = this.match(kQuoted) ?? this.match(/(?:[^,[\]{}\n#:]|(?<=\S)#|:(?=[^\s,[\]{}]))+/y);
        if (word === null) {
            this.at += 1;  // a colon, or a quote that does not end
        } else if (this.atEnd) {
            this.end(needsKey ? 'key' : 'value', from);
        } else if (needsKey && this.match(/[ \t]*:/y) !== null) {
            frame.key = unquoted(word.trim());
            frame.keys.push(frame.key);
        }
    }
}

/// What is being written at `offset`; null within comments and long texts.
export function spotAt(text: string, offset: number): Spot | null {
    const found = new Scanner(text.slice(0, offset)).scan();
    if (!found) {
        return null;
    }
    const { spot, before } = found;
    const after = spot.kind === 'value' ? []
        : followingKeys(text, offset, spot.isFlow ? null : spot.column);
    const own = spot.kind === 'either' ? [] : before;
    return { ...spot, present: spot.kind === 'value' ? [] : [...own, ...after] };
}
