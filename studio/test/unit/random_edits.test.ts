/// Random edits of all YAML files and of some that are hard to edit: each changes what it says and
/// nothing else.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { isAlias, isMap, isScalar, isSeq, type Document, type Node } from 'yaml';
import { aliasKey } from '../../src/edit/decisions';
import { EditError } from '../../src/edit/edit_error';
import type { SourceFile, Value } from '../../src/edit/edit_types';
import {
    planEntry, planInsert, planRemove, planSet, type Decisions, type FileEdits,
} from '../../src/edit/plan';
import { parseQuantity } from '../../src/edit/quantity';
import { applyEdits, difference } from '../../src/edit/text_edit';
import { keyText, parseTree, scalarText } from '../../src/edit/yaml_tree';
import { yamlFiles } from './yaml_files';

type Plain = string | null | Plain[] | Map<string, Plain>;

const kOddities: [string, string][] = [
    ['comments', 'a: 1 # one\n# two\nb:   2   # three\nc: # four\n  d: 3\n  # five\n  e: 4\n# six\n'],
    ['no last line break', 'a: 1\nb: {c: 2, d: [1, 2, 3]}'],
    ['flow over lines', 'a: {\n  b: 1, # one\n  c: [1,\n    2, 3],\n  d: {e: f}\n}\ng: 1\n'],
    ['trailing comma', 'a: [1, 2, ]\nb: {c: 1, }\nd: 3\n'],
    ['compact list', 'a:\n- b: 1\n  c: 2\n- b: 3\n-   - 1\n    - 2\nd: e\n'],
    ['block scalars', 'a: |\n  text: 1\n\n  more # no comment\nb: >-\n  folded\n  text\nc: 1\n'],
    ['last block scalar', 'a:\n  b: 1\n  c: |+\n    text\n\n\nd: 2\n'],
    ['quotes', 'a: "1 m" # c\n\'b c\': \'it\'\'s\'\n"d": "x\\ty"\ne: [\'a\', "b, c"]\n'],
    ['anchors', 'a: &x {b: 1, c: [1, 2]}\nd: *x\ne: &y 3\nf: [*y, *y, 4]\ng: &z\n  h: 1\ni: *z\n'],
    ['unicode', 'ä: "ö"  # ü 🎱\nball 🎱: {at: [0, 1]} # 😀😀\nz: 1\n'],
    ['documents', '---\na: 1\nb:\n  - 1\n  - 2\n...\n'],
    ['carriage returns', 'a: 1\r\nb: {c: 2} # c\nd:\r\n  - 1\r\n  - 2\n'],
    ['empty values', 'a:\nb: {}\nc: []\nd:\n  e:\n  f: ~\ng: [ ]\n'],
    ['long plain text', 'a: one two\n  three\nb: x\nc:\n  - four\n    five\n  - six\n'],
    ['wide indent', 'a:\n      b: 1\n      c:\n            - d: 1\n              e: 2\n            - 3\nf: 1\n'],
    ['only comments', '# nothing\n\n# here\n'],
    ['blank lines', '\n\na: 1\n\n\nb:\n\n  c: 1\n\n  d: 2\n\n\ne: 3\n\n'],
    ['tags', 'a: !!str 1\nb: !x {c: 1}\nd: [!!int 3, 4]\ne: 1\n'],
    ['tabs before comments', 'a: 1\t# one\nb:\t{c: 1}\t# two\n'],
];

function plainOf(node: Node | null, document: Document): Plain {
    if (isAlias(node)) {
        return plainOf(node.resolve(document) ?? null, document);
    }
    if (isMap(node)) {
        return new Map(node.items.map((pair) =>
            [keyText(pair), plainOf(pair.value as Node | null, document)]));
    }
    if (isSeq(node)) {
        return node.items.map((item) => plainOf(item as Node, document));
    }
    return isScalar(node) && node.range && node.range[0] !== node.range[1]
        ? scalarText(node) : null;
}

function plain(text: string): Plain {
    const { document, mistake } = parseTree(text);
    assert.equal(mistake, '', text);
    return plainOf(document.contents as Node | null, document);
}

/// A generator of whole numbers below a limit, always the same.
function makeRandom(seed: number): (below: number) => number {
    let state = seed;
    return (below) => {
        state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
        return Math.floor(state / 65536) % below;
    };
}

interface Place {
    path: string[];
    value: Plain;
}

function placesOf(value: Plain, path: string[] = []): Place[] {
    const below = value instanceof Map
        ? [...value].flatMap(([key, one]) => placesOf(one, [...path, key]))
        : Array.isArray(value) ? value.flatMap((one, i) => placesOf(one, [...path, String(i)])) : [];
    return [{ path, value }, ...below];
}

/// A copy of the value with `change` done to what holds the last key of the path.
function changedAt(
    value: Plain, path: readonly string[],
    change: (holder: Map<string, Plain> | Plain[], key: string) => void,
): Plain {
    const copy: Plain = value instanceof Map ? new Map(value) : Array.isArray(value) ? [...value] : value;
    const [key = '', ...rest] = path;
    if (!(copy instanceof Map) && !Array.isArray(copy)) {
        throw new Error('the path leads through a scalar');
    }
    if (rest.length === 0) {
        change(copy, key);
    } else if (copy instanceof Map) {
        copy.set(key, changedAt(copy.get(key) ?? null, rest, change));
    } else {
        copy[Number(key)] = changedAt(copy[Number(key)] ?? null, rest, change);
    }
    return copy;
}

function write(value: Value): Plain {
    return Array.isArray(value) ? value.map(write) : String(value);
}

/// Whether both are the same, numbers by their values.
function isSame(a: Plain, b: Plain): boolean {
    if (a instanceof Map && b instanceof Map) {
        return a.size === b.size && [...a].every(([key, one]) => isSame(one, b.get(key) ?? null));
    }
    if (Array.isArray(a) && Array.isArray(b)) {
        return a.length === b.length && a.every((one, i) => isSame(one, b[i] ?? null));
    }
    if (typeof a !== 'string' || typeof b !== 'string' || a === b) {
        return a === b;
    }
    const [x, y] = [parseQuantity(a), parseQuantity(b)];
    return x !== null && y !== null
        && Math.abs(x.value - y.value) <= 1e-9 * Math.max(1, Math.abs(x.value));
}

/// All comments of a text, in their order.
function comments(text: string): string[] {
    const isPart = /"(?:[^"\\]|\\.)*"|'(?:[^']|'')*'|(?:^|[ \t])#[^\n]*/gm;
    return (text.match(isPart) ?? []).map((one) => one.trim()).filter((one) => one.startsWith('#'));
}

interface Edit {
    what: string;
    plan: (files: SourceFile[], decisions: Decisions) => FileEdits;
    expect: (before: Plain) => Plain;
    keepsComments: boolean;
}

const kValues: Value[] = [0.5, -3, 0, 'word', 'a b', 'x: y', 'true', '', true, '# no', [1, 2], [0.1, 'x'],
    [1, 2, 3, 4, 5]];

/// An edit that can be done at a place.
function editAt(place: Place, random: (below: number) => number): Edit | null {
    const { path, value } = place;
    const kind = random(4);
    if (kind === 0 && path.length > 0) {
        return {
            what: `remove ${path.join('.')}`, keepsComments: false,
            plan: (files, decisions) => planRemove(files, path, decisions),
            expect: (before) => changedAt(before, path, (holder, key) => {
                if (holder instanceof Map) {
                    holder.delete(key);
                } else {
                    holder.splice(Number(key), 1);
                }
            }),
        };
    }
    if (kind === 1 && value instanceof Map) {
        const key = `new${random(1000)}`;
        return value.has(key) ? null : {
            what: `add ${[...path, key].join('.')}`, keepsComments: true,
            plan: (files, decisions) => planEntry(files, path, key, '{at: [0, 1]}', decisions),
            expect: (before) => changedAt(before, [...path, key], (holder, name) =>
                (holder as Map<string, Plain>).set(name, new Map([['at', ['0', '1']]]))),
        };
    }
    if (kind === 2 && Array.isArray(value)) {
        const index = random(value.length + 1);
        return {
            what: `insert ${index} into ${path.join('.')}`, keepsComments: true,
            plan: (files, decisions) => planInsert(files, path, index, 'item', decisions),
            expect: (before) => changedAt(before, [...path, ''], (holder) =>
                (holder as Plain[]).splice(index, 0, 'item')),
        };
    }
    if (path.length === 0 || value instanceof Map) {
        return null;
    }
    const wanted = kValues[random(kValues.length)] as Value;
    return {
        what: `set ${path.join('.')} to ${JSON.stringify(wanted)}`,
        keepsComments: !Array.isArray(value),
        plan: (files, decisions) => planSet(files, path, wanted, { unit: '' }, decisions),
        expect: (before) => changedAt(before, path, (holder, key) => {
            if (holder instanceof Map) {
                holder.set(key, write(wanted));
            } else {
                holder[Number(key)] = write(wanted);
            }
        }),
    };
}

/// What would also go when the place is removed: maps and lists that are empty afterwards.
function withoutEmpty(value: Plain): Plain {
    if (value instanceof Map) {
        return new Map([...value].map(([key, one]) => [key, withoutEmpty(one)] as [string, Plain])
            .filter(([, one]) => !isEmpty(one)));
    }
    return Array.isArray(value)
        ? value.map(withoutEmpty).filter((one) => !isEmpty(one)) : value;
}

function isEmpty(value: Plain): boolean {
    return value === null || (value instanceof Map && value.size === 0)
        || (Array.isArray(value) && value.length === 0);
}

const counts = { done: 0, refused: 0 };

function tryEdit(name: string, text: string, edit: Edit): string {
    const where = `${name}: ${edit.what}`;
    const anchors = [...text.matchAll(/&([\w-]+)/g)].map((found) => found[1] ?? '');
    const decisions: Decisions = { aliases: new Map(anchors.map((one) =>
        [aliasKey('/a.yaml', one), 'copy' as const])) };
    const file: SourceFile = { file: '/a.yaml', name, text, writable: true };
    let edits;
    try {
        edits = edit.plan([file], decisions).edits;
    } catch (error) {
        assert.ok(error instanceof EditError, `${where}: ${String(error)}`);
        counts.refused += 1;
        return text;
    }
    const after = applyEdits(text, edits);
    const shown = `${where}\n${JSON.stringify(text)}\n${JSON.stringify(after)}`;
    assert.equal(parseTree(after).mistake, '', shown);
    // Values that repeat an anchor follow it, which the expectation does not know.
    if (anchors.length === 0) {
        const expected = edit.expect(plain(text));
        const isRemoval = edit.what.startsWith('remove');
        const [a, b] = isRemoval ? [withoutEmpty(plain(after)), withoutEmpty(expected)]
            : [plain(after), expected];
        assert.ok(isSame(a, b) || (isEmpty(a) && isEmpty(b)), shown);
    }
    if (edit.keepsComments && !/[|>][-+]?\n/.test(text)) {
        assert.deepEqual(comments(after), comments(text), shown);
    }
    const back = difference(after, text);
    assert.equal(back ? applyEdits(after, [back]) : after, text, where);
    counts.done += 1;
    return after;
}

/// Does a row of random edits, each on the result of the one before.
function run(name: string, text: string, seed: number, rows: number, inRow: number): void {
    const random = makeRandom(seed);
    for (let row = 0; row < rows; ++row) {
        let now = text;
        for (let i = 0; i < inRow; ++i) {
            const all = placesOf(plain(now));
            const place = all[random(all.length)] as Place;
            const edit = editAt(place, random);
            now = edit ? tryEdit(name, now, edit) : now;
        }
    }
}

test('RandomEdits_OfOddTexts_ChangeOnlyWhatTheySay', () => {
    for (const [i, [name, text]] of kOddities.entries()) {
        run(name, text, i + 1, 150, 4);
    }
});

test('RandomEdits_OfAllFiles_ChangeOnlyWhatTheySay', () => {
    for (const [i, { name, text }] of yamlFiles('examples', 'configs', 'tests').entries()) {
        const { mistake, document } = parseTree(text);
        const isFit = mistake === '' && !/duplicate|key_is_a_list|merge_key|alias_bomb|two_documents/.test(name)
            && isMap(document.contents);
        if (isFit) {
            run(name, text, i + 1, 12, 3);
        }
    }
    assert.ok(counts.done > 2000, `${counts.done} edits`);
    assert.ok(counts.refused < 0.2 * counts.done, `${counts.refused} of ${counts.done} refused`);
});
