/// Gives a node of a text another value, with the fewest bytes changed.
import { isAlias, isMap, isScalar, isSeq, type Alias, type Node, type YAMLSeq } from 'yaml';
import type { Value } from './edit_types';
import { addItems } from './add_entry';
import { parseQuantity, writeLike } from './quantity';
import { lineEnd, type TextEdit } from './text_edit';
import {
    contentEnd, isEmpty, rangeOf, scalarText, type Step, type Tree,
} from './yaml_tree';
import { writeValue, type NumberStyle } from './write_value';

/// The text of a scalar between its quotes, if it has any, and where it stands.
function inner(tree: Tree, node: Node): { from: number; to: number; text: string } {
    const [from, to] = rangeOf(node);
    const text = tree.text.slice(from, to);
    const isQuoted = /^(["']).*\1$/s.test(text) && text.length > 1;
    return isQuoted
        ? { from: from + 1, to: to - 1, text: text.slice(1, -1) }
        : { from, to, text };
}

function setNumber(tree: Tree, node: Node, value: number, style: NumberStyle): TextEdit[] | null {
    const place = inner(tree, node);
    const old = parseQuantity(place.text);
    if (!old) {
        return null;
    }
    // A plain 0 has no unit that could be kept.
    const written = old.unit === '' && old.value === 0 && style.unit !== ''
        ? writeValue(value, style)
        : writeLike(old, value, style.precision);
    return written === place.text ? [] : [{ from: place.from, to: place.to, insert: written }];
}

function setText(tree: Tree, node: Node, value: string): TextEdit[] {
    const place = inner(tree, node);
    if (isScalar(node) && scalarText(node) === value) {
        return [];
    }
    const isSafe = !/["'\\\n]/.test(value);
    if (place.text.length < rangeOf(node)[1] - rangeOf(node)[0] && isSafe) {
        return [{ from: place.from, to: place.to, insert: value }];
    }
    const to = contentEnd(tree.text, node);
    return [{ from: rangeOf(node)[0], to, insert: writeValue(value, { unit: '' }) }];
}

/// Takes the items from `count` on, which is at least 1, out of a list.
function removeRest(text: string, list: YAMLSeq, count: number): TextEdit {
    const kept = contentEnd(text, list.items[count - 1] as Node);
    const last = contentEnd(text, list.items[list.items.length - 1] as Node);
    return list.flow ? { from: kept, to: last, insert: '' }
        : { from: lineEnd(text, kept), to: lineEnd(text, last), insert: '' };
}

/// What is done with an alias among the items of a list that gets another value: the anchor gets it,
/// or it stands in the alias's place.
export type Decide = (alias: Alias) => 'anchor' | 'copy';

/// Sets an item of a list. One that repeats a value and keeps it stays as it is.
function setItem(
    tree: Tree, steps: Step[], holder: YAMLSeq, node: Node, value: Value, style: NumberStyle,
    decide: Decide,
): TextEdit[] {
    const repeated = isAlias(node) ? node.resolve(tree.document) : undefined;
    const own: Step = { node: repeated ?? node, pair: null, holder, alias: null };
    const edits = setNode(tree, [...steps, own], value, style, decide);
    if (!isAlias(node) || !repeated || edits.length === 0 || decide(node) === 'anchor') {
        return edits;
    }
    return setNode(tree, [...steps, { ...own, alias: node }], value, style, decide);
}

/// Sets a list item by item; items that are too many are taken out.
function setList(
    tree: Tree, steps: Step[], list: YAMLSeq, value: Value[], style: NumberStyle, decide: Decide,
) {
    const edits: TextEdit[] = [];
    for (const [i, item] of value.entries()) {
        const node = list.items[i] as Node | undefined;
        if (node) {
            edits.push(...setItem(tree, steps, list, node, item, style, decide).filter((edit) =>
                !edits.some(({ from, to }) => from < edit.to && edit.from < to)));
        }
    }
    if (value.length > list.items.length) {
        const missing = value.slice(list.items.length).map((item) => writeValue(item, style));
        edits.push(addItems(tree, list, missing));
    }
    if (value.length < list.items.length) {
        edits.push(removeRest(tree.text, list, value.length));
    }
    return edits;
}

/// Writes the value in flow style over whatever the node is.
function replaceWhole(tree: Tree, step: Step, value: Value, style: NumberStyle): TextEdit[] {
    const { node, pair } = step;
    const written = writeValue(value, style);
    const isBlock = (isMap(node) || isSeq(node)) && !node.flow;
    if (!pair || !(isBlock || isEmpty(node))) {
        const whole = step.alias ?? node;
        const to = contentEnd(tree.text, whole);
        return [{ from: rangeOf(whole)[0], to, insert: written }];
    }
    const from = tree.text.indexOf(':', rangeOf(pair.key as Node)[1]) + 1;
    const to = isBlock ? contentEnd(tree.text, node) : from;
    return [{ from, to, insert: ` ${written}` }];
}

/// The edits that give the last of `steps` a value. Numbers keep their unit and way of writing,
/// texts their quotes, lists the place of their items. Empty if the value is there already.
export function setNode(
    tree: Tree, steps: Step[], value: Value, style: NumberStyle, decide: Decide = () => 'copy',
): TextEdit[] {
    const step = steps[steps.length - 1] as Step;
    const { node } = step;
    if (step.alias === null && isScalar(node) && !isEmpty(node)) {
        const edits = typeof value === 'number' ? setNumber(tree, node, value, style)
            : typeof value === 'string' ? setText(tree, node, value) : null;
        if (edits) {
            return edits;
        }
    }
    if (step.alias === null && isSeq(node) && Array.isArray(value) && node.items.length > 0
        && value.length > 0) {
        return setList(tree, steps, node, value, style, decide);
    }
    const edits = replaceWhole(tree, step, value, style);
    const isSame = edits.every((edit) => tree.text.slice(edit.from, edit.to) === edit.insert);
    return isSame ? [] : edits;
}
