import assert from 'node:assert/strict';
import { test } from 'node:test';
import { isMap, isScalar, isSeq, type Node } from 'yaml';
import { itemStart, keyText, parseTree, rangeOf } from '../../src/edit/yaml_tree';
import { spotAt } from '../../src/text/spot';
import { yamlFiles } from './yaml_files';

/// The spot at the sign "|" of a text, in one line.
function spot(marked: string): string {
    const offset = marked.indexOf('|');
    const found = spotAt(marked.replace('|', ''), offset);
    return found
        ? `${found.kind} ${found.path.join('.')} +${offset - found.from} [${found.present.join(' ')}]`
        : 'none';
}

test('SpotAt_HalfWrittenTexts_KnowTheirPath', () => {
    const cases: [string, string][] = [
        ['|', 'key  +0 []'],
        ['ba|\nrack: {}\n', 'key  +2 [rack]'],
        ['balls:\n  |', 'either balls +0 []'],
        ['balls:\n  cue: {at: [0, 1]}\n  |\n', 'key balls +0 [cue]'],
        ['balls:\n  cue: {at: [0, 1], sp|}\nrack: {}\n', 'key balls.cue +2 [at]'],
        ['balls:\n  cue: {sp|, at: [0, 1]}\n', 'key balls.cue +2 [at]'],
        ['balls:\n  cue: {at: [0, |\nrack: {set: x}\n', 'value balls.cue.at.1 +0 []'],
        ['balls:\n  cue: {at: [0, 1], spin: |}\n', 'value balls.cue.spin +0 []'],
        ['balls:\n  cue: {at: [0, 1]\nrack: {se|}\n', 'key rack +2 []'],
        ['cameras:\n  - name: a\n    fo|\n    video: [0, 1]\n', 'key cameras.0 +2 [name video]'],
        ['cameras:\n  - name: a\n  - |', 'either cameras.1 +0 []'],
        ['cameras:\n- name: a\n- na|\n  fov: 3\n', 'either cameras.1 +2 [fov]'],
        ['cameras:\n  - name: a\n    fov: 30 d|', 'value cameras.0.fov +4 []'],
        ['cameras:\n  - name: a\n  |', 'either cameras +0 []'],
        ['cameras:\n  - a: 1\nre|', 'key  +2 [cameras]'],
        ['events:\n  - strike: {ball: cue, toward: o|}', 'value events.0.strike.toward +1 []'],
        ['a: 1  # b|', 'none'],
        ['# a|', 'none'],
        ['a: >\n  text b|\n', 'none'],
        ['a: >\n  text\nb|\n', 'key  +1 [a]'],
        ['include: [a.yaml, ta|]', 'value include.1 +2 []'],
        ['include:\n  - ../configs/ta|', 'either include.0 +13 []'],
        ['a: &x {b: 1}\nc: {b: |', 'value c.b +0 []'],
        ['x: "a: {b"\nc|', 'key  +1 [x]'],
        ['a:\n  b: 1\n\n  |\n\nc: 2\n', 'key a +0 [b]'],
        ['to|ward: 3\nb: 2', 'key  +2 [b]'],
    ];
    for (const [text, expected] of cases) {
        assert.equal(spot(text), expected, text);
    }
});

/// Each key with the path of its map, and each scalar with its path.
function places(node: Node | null, path: string[] = []): { path: string[]; at: number; kind: string }[] {
    if (isMap(node)) {
        return node.items.flatMap((pair) => [
            { path, at: itemStart(pair), kind: 'key' },
            ...places(pair.value as Node | null, [...path, keyText(pair)])]);
    }
    if (isSeq(node)) {
        return node.items.flatMap((item, i) => places(item as Node, [...path, String(i)]));
    }
    return isScalar(node) && node.type === 'PLAIN' && rangeOf(node)[1] > rangeOf(node)[0]
        ? [{ path, at: rangeOf(node)[0], kind: 'value' }] : [];
}

test('SpotAt_EachKeyAndValueOfEachFile_IsWhereTheParserSeesIt', () => {
    let count = 0;
    for (const { name, text } of yamlFiles('examples', 'configs', 'tests')) {
        const tree = parseTree(text);
        if (tree.mistake !== '' || text.includes('\r') || /key_is_a_list|no_break_space/.test(name)) {
            continue;
        }
        for (const { path, at, kind } of places(tree.document.contents as Node | null)) {
            const found = spotAt(text, at);
            assert.ok(found, `${name} ${path.join('.')} at ${at}`);
            assert.deepEqual(found.path, path, `${name} at ${at}: ${text.slice(at, at + 30)}`);
            assert.ok(found.kind === kind || found.kind === 'either', `${name} ${found.kind} at ${at}`);
            count += 1;
        }
    }
    assert.ok(count > 5000, `${count} places`);
});
