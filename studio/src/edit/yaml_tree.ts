/// A YAML text as nodes with places, and walks along key paths in it.
import {
    isAlias, isMap, isScalar, isSeq, parseDocument,
    type Alias, type Document, type Node, type Pair, type Scalar, type YAMLMap, type YAMLSeq,
} from 'yaml';
import type { KeyPath } from '../protocol';
import { EditError } from './edit_error';

export interface Tree {
    text: string;
    document: Document.Parsed;
    /// The first mistake of the syntax, or empty. Values before it can still be found.
    mistake: string;
}

/// A node that was reached, and how.
export interface Step {
    node: Node;
    /// The entry of a map whose value `node` is.
    pair: Pair | null;
    /// The map or list that holds it; null at the top.
    holder: YAMLMap | YAMLSeq | null;
    /// The alias that stands in the text in the node's stead.
    alias: Alias | null;
}

/// The way along a path as far as it exists.
export interface Walk {
    /// From the top of the text to the deepest node; at least one unless the text is empty.
    steps: Step[];
    /// The keys that do not exist.
    rest: KeyPath;
}

const kKept = 24;
const kept = new Map<string, Tree>();

/// The nodes of a text. Trees of the last texts are kept, as edits ask for them again and again.
export function parseTree(text: string): Tree {
    const known = kept.get(text);
    if (known) {
        return known;
    }
    const document = parseDocument(text, {
        schema: 'failsafe', uniqueKeys: false, strict: false, logLevel: 'silent',
    });
    const tree = { text, document, mistake: document.errors[0]?.message ?? '' };
    kept.set(text, tree);
    if (kept.size > kKept) {
        kept.delete(kept.keys().next().value ?? '');
    }
    return tree;
}

/// The tree, if its syntax has no mistake. Throws EditError otherwise.
export function parseWhole(text: string, name: string): Tree {
    const tree = parseTree(text);
    if (tree.mistake !== '') {
        const where = tree.mistake.split('\n')[0] ?? '';
        throw new EditError(`${name} has a mistake that must be fixed first: ${where}`);
    }
    return tree;
}

/// Start and end of a node's own text.
export function rangeOf(node: Node): [number, number] {
    const range = node.range;
    if (!range) {
        throw new EditError('a value has no place in the text');
    }
    return [range[0], range[1]];
}

/// The end of the last character of a node that is not space or a comment.
export function contentEnd(text: string, node: Node): number {
    if ((isMap(node) || isSeq(node)) && !node.flow) {
        const last = node.items[node.items.length - 1];
        if (last !== undefined) {
            return itemEnd(text, last as Node | Pair);
        }
    }
    let [start, end] = rangeOf(node);
    if (isScalar(node) && /^[|>]\d?\+/.test(text.slice(start, start + 3))) {
        return text[end - 1] === '\n' ? end - 1 : end;  // its empty lines are part of the text
    }
    while (end > start && /\s/.test(text[end - 1] ?? '')) {
        end -= 1;
    }
    return end;
}

/// The same for an item of a list or an entry of a map.
export function itemEnd(text: string, item: Node | Pair): number {
    if (!('key' in item)) {
        return contentEnd(text, item);
    }
    const key = item.key as Node;
    const value = item.value as Node | null;
    const afterKey = rangeOf(key)[1];
    const afterColon = text[afterKey] === ':' ? afterKey + 1 : afterKey;
    return Math.max(value ? contentEnd(text, value) : afterKey, afterColon);
}

/// Where an item of a list, or an entry of a map, starts.
export function itemStart(item: Node | Pair): number {
    return rangeOf('key' in item ? (item.key as Node) : item)[0];
}

/// Whether a node is the empty value of `key:`.
export function isEmpty(node: Node): boolean {
    return isScalar(node) && rangeOf(node)[0] === rangeOf(node)[1];
}

/// The keys of a map, as texts.
export function keyText(pair: Pair): string {
    return isScalar(pair.key) ? String(pair.key.value) : '';
}

/// The text of a scalar without quotes.
export function scalarText(node: Scalar): string {
    return node.value === null ? '' : String(node.value);
}

/// The place of a list's element by its index or its `name`; -1 if there is none.
function indexOf(list: YAMLSeq, key: string): number {
    if (/^\d+$/.test(key)) {
        return Number(key) < list.items.length ? Number(key) : -1;
    }
    return list.items.findIndex((item) => isMap(item) && item.items.some((pair) =>
        keyText(pair) === 'name' && isScalar(pair.value) && scalarText(pair.value) === key));
}

function stepInto(tree: Tree, node: Node, key: string): Step | null {
    let value: Node | null = null;
    let pair: Pair | null = null;
    if (isMap(node)) {
        pair = node.items.find((item) => keyText(item) === key) ?? null;
        value = (pair?.value as Node | null) ?? null;
    } else if (isSeq(node)) {
        value = (node.items[indexOf(node, key)] as Node | undefined) ?? null;
    }
    if (!value) {
        return null;
    }
    const holder = node as YAMLMap | YAMLSeq;
    return isAlias(value)
        ? { node: value.resolve(tree.document) ?? value, pair, holder, alias: value }
        : { node: value, pair, holder, alias: null };
}

/// Follows `path` from the top as far as it exists.
export function walk(tree: Tree, path: KeyPath): Walk {
    const top = tree.document.contents as Node | null;
    if (!top) {
        return { steps: [], rest: path };
    }
    const steps: Step[] = [{ node: top, pair: null, holder: null, alias: null }];
    for (const [depth, key] of path.entries()) {
        const last = steps[steps.length - 1];
        const next = last ? stepInto(tree, last.node, key) : null;
        if (!next) {
            return { steps, rest: path.slice(depth) };
        }
        steps.push(next);
    }
    return { steps, rest: [] };
}
