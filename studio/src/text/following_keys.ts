/// The keys of a map after an offset.

const kFlowKey = /([A-Za-z_][\w-]*)[ \t]*:(?=[\s[{"']|$)/y;
const kMost = 4000;  // characters that are looked at

function inFlow(text: string, offset: number): string[] {
    const keys: string[] = [];
    let depth = 0;
    // The word at the offset is the key that is being written.
    let at = offset + (/^[\w-]*[ \t]*:?/.exec(text.slice(offset, offset + 80))?.[0].length ?? 0);
    const end = Math.min(text.length, offset + kMost);
    let isStart = false;
    while (at < end && depth >= 0) {
        const sign = text[at] ?? '';
        if (sign === '"' || sign === "'") {
            const close = text.indexOf(sign, at + 1);
            at = close < 0 ? end : close;
        } else if (/[[{]/.test(sign)) {
            depth += 1;
        } else if (/[\]}]/.test(sign)) {
            depth -= 1;
        } else if (sign === ',') {
            isStart = true;
        } else if (isStart && depth === 0 && /\S/.test(sign)) {
            isStart = false;
            kFlowKey.lastIndex = at;
            const key = kFlowKey.exec(text)?.[1];
            if (key !== undefined) {
                keys.push(key);
            }
        }
        at += 1;
    }
    return keys;
}

function inBlock(text: string, offset: number, column: number): string[] {
    const keys: string[] = [];
    const lines = text.slice(offset).split('\n').slice(1);
    for (const line of lines) {
        const indent = line.length - line.trimStart().length;
        const isEmpty = line.trim() === '' || line.trim().startsWith('#');
        if (!isEmpty && indent < column) {
            break;
        }
        if (!isEmpty && indent === column) {
            const key = /^\s*(?:"([^"]*)"|'([^']*)'|([^\s#'"-][^#]*?))[ \t]*:(?:\s|$)/.exec(line);
            if (!key) {
                break;
            }
            keys.push(key[1] ?? key[2] ?? key[3] ?? '');
        }
    }
    return keys;
}

/// The keys after `offset` of the map that is being written there: of a block whose keys stand at
/// `column`, or of the flow map around it if that is null.
export function followingKeys(text: string, offset: number, column: number | null): string[] {
    return column === null ? inFlow(text, offset) : inBlock(text, offset, column);
}
