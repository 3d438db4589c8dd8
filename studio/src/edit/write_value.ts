/// Values as YAML.
import { isAlias, isMap, isScalar, isSeq, type Node, type Pair } from 'yaml';
import type { Value } from './edit_types';
import { writeNumber } from './quantity';
import { unitValue } from './units';
import { keyText, rangeOf, type Tree } from './yaml_tree';

/// How numbers of a new value are written.
export interface NumberStyle {
    /// The unit that numbers other than 0 need, or empty.
    unit: string;
    /// The finest step, in SI units.
    precision?: number | undefined;
}

const kPlainWord = /^[A-Za-z_./][A-Za-z0-9_./ -]*$/;
const kReserved = /^(null|true|false|yes|no|on|off|~)$/i;

/// A text as a YAML scalar, in quotes if it would be read as something else without them.
export function writeText(text: string): string {
    const isPlain = kPlainWord.test(text) && !kReserved.test(text) && !text.endsWith(' ');
    return isPlain ? text : JSON.stringify(text);
}

/// A value in flow style, on one line.
export function writeValue(value: Value, style: NumberStyle): string {
    if (Array.isArray(value)) {
        return `[${value.map((item) => writeValue(item, style)).join(', ')}]`;
    }
    if (typeof value === 'number') {
        const scale = unitValue(style.unit) ?? 1;
        const step = style.precision === undefined ? undefined : style.precision / scale;
        const number = writeNumber(value / scale, step);
        return style.unit === '' || number === '0' ? number : `${number} ${style.unit}`;
    }
    if (typeof value === 'object') {
        return value.yaml;
    }
    return typeof value === 'boolean' ? String(value) : writeText(value);
}

/// A node of a text in flow style, on one line, with the numbers as they are written there and
/// aliases replaced by what they stand for. Comments are lost.
export function flowText(tree: Tree, node: Node | null): string {
    if (node === null) {
        return '';
    }
    if (isAlias(node)) {
        return flowText(tree, node.resolve(tree.document) ?? null);
    }
    if (isMap(node)) {
        const entries = node.items.map((pair: Pair) =>
            `${keyText(pair)}: ${flowText(tree, pair.value as Node | null)}`);
        return `{${entries.join(', ')}}`;
    }
    if (isSeq(node)) {
        return `[${node.items.map((item) => flowText(tree, item as Node)).join(', ')}]`;
    }
    if (isScalar(node) && (node.type === 'PLAIN' || node.type === 'QUOTE_DOUBLE'
        || node.type === 'QUOTE_SINGLE')) {
        return tree.text.slice(...rangeOf(node)).replace(/\s*\n\s*/g, ' ');
    }
    return JSON.stringify(isScalar(node) ? String(node.value ?? '') : '');
}
