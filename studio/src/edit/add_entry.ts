/// The smallest additions to a text: an entry of a map, an item of a list, a new section.
import { isMap, isSeq, type Node, type Pair, type YAMLMap, type YAMLSeq } from 'yaml';
import type { KeyPath } from '../protocol';
import { PlaceError } from './edit_error';
import { lineEnd, lineStart, type TextEdit } from './text_edit';
import {
    contentEnd, isEmpty, itemEnd, itemStart, keyText, rangeOf, type Step, type Tree, type Walk,
} from './yaml_tree';

/// The sections of a shot in the order in which shots have them.
const kSections = [
    'carom', 'include', 'quality', 'simulation', 'physics', 'conditions', 'ball_set', 'table',
    'rack', 'balls', 'objects', 'events', 'materials', 'lights', 'cameras', 'render', 'output',
    'sound', 'annotations',
];
/// Sections whose entries stand on lines of their own.
const kLists = new Set(['events', 'cameras', 'annotations']);
const kNamed = new Set(['balls', 'objects', 'materials', 'lights', 'conditions']);
const kIndent = '  ';

/// `yaml` (without indent) with all lines after the first indented.
export function indentRest(yaml: string, indent: string): string {
    return yaml.trim().replace(/\n(?=[^\n])/g, `\n${indent}`);
}

/// The spaces before a column.
function spaces(text: string, offset: number): string {
    return ' '.repeat(offset - lineStart(text, offset));
}

/// "a: {b: [v]}" for the keys a, b and 0.
function nestFlow(keys: KeyPath, value: string): string {
    const [key, ...rest] = keys;
    if (key === undefined) {
        return value;
    }
    if (/^\d+$/.test(key)) {
        if (key !== '0') {
            throw new PlaceError(`there is no list yet that could have an element ${key}`);
        }
        return `[${nestFlow(rest, value)}]`;
    }
    return `${key}: ${asFlowValue(rest, value)}`;
}

function asFlowValue(keys: KeyPath, value: string): string {
    const nested = nestFlow(keys, value);
    return keys.length > 0 && !/^\d+$/.test(keys[0] ?? '') ? `{${nested}}` : nested;
}

/// The same as lines of their own, with an indent of 0: "balls:\n  nine: {at: v}" for a section.
export function nestBlock(keys: KeyPath, value: string, isTop: boolean): string {
    const [section = '', key = '', ...rest] = keys;
    if (isTop && keys.length > 1 && kNamed.has(section)) {
        return `${section}:\n${kIndent}${indentRest(nestBlock([key, ...rest], value, false), kIndent)}`;
    }
    if (isTop && keys.length > 1 && kLists.has(section) && key === '0') {
        const item = rest.length > 0 ? nestFlow(rest, value) : value;
        return `${section}:\n${kIndent}- ${indentRest(item, `${kIndent}  `)}`;
    }
    if (keys.length === 1 && value.includes('\n')) {
        return `${section}:\n${kIndent}${indentRest(value, kIndent)}`;
    }
    return nestFlow(keys, value);
}

function needsOneLine(value: string): void {
    if (value.includes('\n')) {
        throw new PlaceError('a value of several lines does not fit into {...} or [...]');
    }
}

/// Adds `entry` ("key: value" or an item) to a flow map or list before the item `index`.
function addToFlow(tree: Tree, node: YAMLMap | YAMLSeq, index: number, entry: string): TextEdit {
    needsOneLine(entry);
    const items = node.items as (Node | Pair)[];
    const before = items[index];
    if (before !== undefined) {
        const at = itemStart(before as Node);
        return { from: at, to: at, insert: `${entry}, ` };
    }
    const last = items[items.length - 1];
    if (last === undefined) {
        const [start, end] = rangeOf(node);
        const inner = tree.text.slice(start + 1, end - 1);
        const to = inner.trim() === '' ? end - 1 : start + 1;
        return { from: start + 1, to, insert: entry };
    }
    const at = itemEnd(tree.text, last as Node);
    return { from: at, to: at, insert: `, ${entry}` };
}


/// The end of the line of `offset`, and of the indented comment lines below it.
function endWithComments(text: string, offset: number): number {
    let end = lineEnd(text, offset);
    for (;;) {
        const next = /^\n[ \t]+#[^\n]*/.exec(text.slice(end));
        if (!next) {
            return end;
        }
        end += next[0].length;
    }
}

/// Adds a section at the top of a shot, at its place in the order of sections.
function addSection(tree: Tree, top: YAMLMap | null, entry: string, key: string): TextEdit {
    const { text } = tree;
    const rank = kSections.indexOf(key);
    const pairs = top?.items ?? [];
    const earlier = pairs.filter((pair) => kSections.indexOf(keyText(pair)) < rank);
    const before = (rank < 0 ? pairs : earlier)[(rank < 0 ? pairs : earlier).length - 1];
    if (!before) {
        const at = pairs[0] ? itemStart(pairs[0]) : text.length;
        const needsBreak = at > 0 && text[at - 1] !== '\n';
        return { from: at, to: at, insert: `${needsBreak ? '\n' : ''}${entry}\n` };
    }
    const at = endWithComments(text, itemEnd(text, before));
    const rest = text.slice(at);
    const keepsLines = /[|>]\d?\+\s*\n/.test(text);  // empty lines may be part of a text
    const isSparse = !keepsLines
        && (/^\n[ \t]*\n/.test(rest) || (rest.trim() === '' && /\n\s*\n/.test(text)));
    return { from: at, to: at, insert: `${isSparse ? '\n' : ''}\n${entry}` };
}

/// Adds "key: value" to a block map.
function addToBlockMap(tree: Tree, node: YAMLMap, entry: string): TextEdit {
    const { text } = tree;
    const first = node.items[0];
    const last = node.items[node.items.length - 1];
    if (!first || !last) {
        throw new PlaceError('an empty map has no place for an entry');
    }
    const at = lineEnd(text, itemEnd(text, last));
    const indent = spaces(text, itemStart(first));
    return { from: at, to: at, insert: `\n${indent}${indentRest(entry, indent)}` };
}

/// Where the dash of a block list's item stands.
function dashOf(text: string, item: Node): number {
    const dash = text.lastIndexOf('-', itemStart(item) - 1);
    if (dash < 0 || !/^-\s*(&\S+\s*)?$/.test(text.slice(dash, itemStart(item)))) {
        throw new PlaceError('the list is written in a way that this page cannot add to');
    }
    return dash;
}

/// Adds an item to a block list before the item `index`.
function addToBlockList(tree: Tree, node: YAMLSeq, index: number, value: string): TextEdit {
    const { text } = tree;
    const items = node.items as Node[];
    const first = items[0];
    const last = items[items.length - 1];
    if (!first || !last) {
        throw new PlaceError('an empty list has no place for an item');
    }
    const indent = spaces(text, dashOf(text, first));
    const item = `- ${indentRest(value, `${indent}  `)}`;
    const before = items[index];
    if (before && index > 0) {
        const at = lineEnd(text, contentEnd(text, items[index - 1] as Node));
        return { from: at, to: at, insert: `\n${indent}${item}` };
    }
    if (before) {
        const at = dashOf(text, before);
        return { from: at, to: at, insert: `${item}\n${indent}` };
    }
    const at = lineEnd(text, contentEnd(text, last));
    return { from: at, to: at, insert: `\n${indent}${item}` };
}

/// Adds items, each on one line, after the last one of a list.
export function addItems(tree: Tree, list: YAMLSeq, values: readonly string[]): TextEdit {
    if (list.flow) {
        return addToFlow(tree, list, list.items.length, values.join(', '));
    }
    const first = addToBlockList(tree, list, list.items.length, values[0] ?? '');
    const indent = spaces(tree.text, dashOf(tree.text, list.items[0] as Node));
    const more = values.slice(1).map((value) => `\n${indent}- ${value}`).join('');
    return { ...first, insert: first.insert + more };
}

/// Gives `key:` without a value one.
function fillEmpty(tree: Tree, step: Step, keys: KeyPath, value: string, depth: number): TextEdit {
    const pair = step.pair;
    if (!pair) {
        throw new PlaceError('an empty item of a list has no place for a value');
    }
    const keyStart = itemStart(pair);
    const colon = tree.text.indexOf(':', rangeOf(pair.key as Node)[1]) + 1;
    const isBlock = !(step.holder?.flow ?? false);
    if (isBlock && depth === 1 && keys.length > 0) {
        const indent = spaces(tree.text, keyStart) + kIndent;
        const isItem = keys[0] === '0';
        const inner = isItem
            ? `- ${keys.length > 1 ? nestFlow(keys.slice(1), value) : value}`
            : nestBlock(keys, value, false);
        return { from: colon, to: colon, insert: `\n${indent}${indentRest(inner, indent)}` };
    }
    return { from: colon, to: colon, insert: ` ${asFlowValue(keys, value)}` };
}

/// Adds what is missing of the way, with `value` (YAML without an indent) at its end. `index` is
/// where a new item of a list is inserted; without it, only the index after the last is possible.
export function addAt(tree: Tree, way: Walk, value: string, index?: number): TextEdit {
    const step = way.steps[way.steps.length - 1];
    const [key = '', ...deeper] = way.rest;
    const isTop = way.steps.length <= 1;
    if (!step || (isTop && isMap(step.node) && !step.node.flow)) {
        const top = step && isMap(step.node) ? step.node : null;
        return addSection(tree, top, nestBlock(way.rest, value, true), key);
    }
    const { node } = step;
    if (isEmpty(node)) {
        return fillEmpty(tree, step, way.rest, value, way.steps.length - 1);
    }
    if (isMap(node)) {
        return node.flow
            ? addToFlow(tree, node, node.items.length, nestFlow(way.rest, value))
            : addToBlockMap(tree, node, nestBlock(way.rest, value, false));
    }
    if (isSeq(node)) {
        const at = index ?? node.items.length;
        if (index === undefined && key !== String(at)) {
            throw new PlaceError(`the list has no element ${key}; it has ${node.items.length}`);
        }
        const item = deeper.length > 0 ? asFlowValue(deeper, value) : value;
        return node.flow
            ? addToFlow(tree, node, at, item)
            : addToBlockList(tree, node, at, item);
    }
    const text = tree.text.slice(...rangeOf(node));
    throw new PlaceError(`'${text}' stands where '${key}' would have to be`);
}
