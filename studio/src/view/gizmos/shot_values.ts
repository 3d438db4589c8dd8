/// Values of the shot's text as numbers in SI units, wherever they come from.
import { isMap, isScalar, isSeq, parseDocument, type Node } from 'yaml';
import { sourceOf } from '../../edit/edit';
import { parseQuantity } from '../../edit/quantity';
import { keyText, scalarText } from '../../edit/yaml_tree';
import type { KeyPath, Triple } from '../../protocol';
import type { ObjectFrame, RotationText } from './object_frame';
import { frameOf } from './object_frame';
import type { Parsed } from './measures';

function parsed(node: Node | null): Parsed {
    if (isMap(node)) {
        return Object.fromEntries(node.items.map((pair) =>
            [keyText(pair), parsed(pair.value as Node | null)]));
    }
    if (isSeq(node)) {
        return node.items.map((item) => parsed(item as Node));
    }
    const text = isScalar(node) ? scalarText(node) : '';
    return parseQuantity(text)?.value ?? text;
}

/// Text in YAML with its numbers in SI units.
export function parseValue(text: string): Parsed {
    const document = parseDocument(text, { schema: 'failsafe', logLevel: 'silent' });
    return parsed(document.contents as Node | null);
}

/// The value of a key as it stands in the text now; undefined if no file has it.
export function valueAt(path: KeyPath): Parsed | undefined {
    const source = sourceOf(path);
    return source ? parseValue(source.text) : undefined;
}

/// A list of three numbers; null if it is something else.
export function tripleOf(value: Parsed | undefined): Triple | null {
    const isTriple = Array.isArray(value) && value.length === 3
        && value.every((one) => typeof one === 'number');
    return isTriple ? value as Triple : null;
}

/// What the text says about an object's rotation.
export function rotationText(object: KeyPath): RotationText {
    const axes = valueAt([...object, 'axes']);
    const columns = Array.isArray(axes) ? axes.map(tripleOf) : [];
    if (columns.length === 3 && columns.every((one) => one !== null)) {
        return { kind: 'axes', axes: columns as [Triple, Triple, Triple] };
    }
    return rotationAt([...object, 'rotate']);
}

/// What the text says about a rotation.
export function rotationAt(path: KeyPath): RotationText {
    const rotate = valueAt(path);
    const angles = tripleOf(rotate);
    if (angles) {
        return { kind: 'angles', angles };
    }
    if (typeof rotate === 'object' && !Array.isArray(rotate)) {
        const axis = tripleOf(rotate['axis']);
        const angle = rotate['angle'];
        return axis ? { kind: 'axis', axis, angle: typeof angle === 'number' ? angle : 0 }
            : { kind: 'none' };
    }
    return { kind: 'none' };
}

/// Where the text puts an object at the start, and its axes.
export function objectFrame(object: KeyPath): ObjectFrame {
    const scale = valueAt([...object, 'scale']);
    const factor = typeof scale === 'number' ? scale : 1;
    const scales: Triple = tripleOf(scale) ?? [factor, factor, factor];
    const at = tripleOf(valueAt([...object, 'at'])) ?? [0, 0, 0];
    return frameOf(at, rotationText(object), scales);
}
