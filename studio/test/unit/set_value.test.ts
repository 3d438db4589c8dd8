import assert from 'node:assert/strict';
import { test } from 'node:test';
import { isAlias, isMap, isScalar, isSeq, type Node } from 'yaml';
import { parseQuantity } from '../../src/edit/quantity';
import { setNode } from '../../src/edit/set_value';
import { applyEdits } from '../../src/edit/text_edit';
import { keyText, parseTree, scalarText, walk } from '../../src/edit/yaml_tree';
import { yamlFiles } from './yaml_files';

/// The paths and texts of all scalars that are numbers.
function numbersOf(node: Node | null, path: string[] = []): { path: string[]; text: string }[] {
    if (isMap(node)) {
        return node.items.flatMap((pair) =>
            numbersOf(pair.value as Node | null, [...path, keyText(pair)]));
    }
    if (isSeq(node)) {
        return node.items.flatMap((item, i) => numbersOf(item as Node, [...path, String(i)]));
    }
    if (isScalar(node) && !isAlias(node) && parseQuantity(scalarText(node))) {
        return [{ path, text: scalarText(node) }];
    }
    return [];
}

function set(text: string, path: string[], value: number, precision?: number): string {
    const tree = parseTree(text);
    const way = walk(tree, path);
    assert.equal(way.rest.length, 0, path.join('.'));
    return applyEdits(text, setNode(tree, way.steps, value, { unit: '', precision }));
}

test('SetNode_EachNumberOfEachFile_ChangesOnlyItsBytesAndReadsBack', () => {
    let count = 0;
    for (const { name, text } of yamlFiles('examples', 'configs', 'tests')) {
        const tree = parseTree(text);
        if (tree.mistake !== '') {
            continue;
        }
        for (const { path, text: written } of numbersOf(tree.document.contents as Node | null)) {
            const here = walk(tree, path).steps.at(-1)?.node;
            if (!isScalar(here) || scalarText(here) !== written) {
                continue;  // the second of two equal keys, which carom refuses
            }
            const old = parseQuantity(written);
            assert.ok(old);
            const value = (old.value === 0 ? 1 : old.value * 1.37) + 0.125 * old.scale;
            const after = set(text, path, value);
            const where = `${name}: ${path.join('.')}`;
            const [from, to] = walk(tree, path).steps.at(-1)?.node.range ?? [0, 0];
            assert.equal(after.slice(0, from), text.slice(0, from), where);
            assert.ok(after.endsWith(text.slice(to)), where);
            const found = walk(parseTree(after), path).steps.at(-1)?.node;
            assert.ok(isScalar(found), where);
            const read = parseQuantity(scalarText(found));
            assert.ok(read, where);
            assert.equal(read.unit, old.unit, where);
            assert.ok(Math.abs(read.value - value) <= 1e-11 * Math.abs(value), where);
            assert.equal(set(after, path, value), after, where);
            count += 1;
        }
    }
    assert.ok(count > 3000, `${count} numbers`);
});

test('SetNode_NumberWithUnit_KeepsTheWayOfWriting', () => {
    const degree = Math.PI / 180;
    const cases: [string, number, number | undefined, string][] = [
        ['30 deg', 31.5 * degree, 0.1 * degree, '31.5 deg'],
        ['30deg', 31.52 * degree, 0.1 * degree, '31.5deg'],
        ['57.15 mm', 0.0508, undefined, '50.8 mm'],
        ['-0.75', -0.552349, 1e-4, '-0.5523'],
        ['0.40', 0.5, undefined, '0.50'],
        ['3.0 s', 4, undefined, '4.0 s'],
        ['1/48 s', 1 / 24, undefined, '2/48 s'],
        ['1 / 22', 1 / 30, undefined, '1 / 30'],
        ['1/48 s', 0.0123, undefined, '0.0123 s'],
        ['1e-3', 2.5e-3, undefined, '2.5e-3'],
        ['0.4 s', 11 / 24, 1 / 24, '0.4583 s'],
        ['0.1234567', 0.1234, 1e-3, '0.1234567'],
        ['"2 m"', 3, undefined, '"3 m"'],
        ['20 km/h', 10, undefined, '36 km/h'],
        ['+1', 2, undefined, '+2'],
        ['0.2', -0.00001, 1e-3, '0'],
    ];
    for (const [written, value, precision, expected] of cases) {
        assert.equal(set(`a: {b: ${written}}  # c\n`, ['a', 'b'], value, precision),
            `a: {b: ${expected}}  # c\n`);
    }
});
