/// What the inspector shows: the keys of what is selected, those that the text gives and those that
/// it may give.
import type { Origin, Source } from '../edit/edit';
import { keyAt, keysAt, typesAt, type KeyInfo } from '../schema/keys';
import type { Schema, ValueType } from '../schema/value_types';
import type { KeyPath } from '../protocol';

export interface Field {
    path: KeyPath;
    name: string;
    info: KeyInfo | null;
    types: ValueType[];
    source: Source | null; // null: the text does not have it
    origin: Origin;
    /// Of a map or a list that is shown part by part.
    parts: Field[];
}

/// How the model asks about the texts.
export interface Texts {
    sourceOf(path: KeyPath): Source | null;
    originOf(path: KeyPath): Origin;
    /// The keys of the map at a path, or the indices of the list, in the order of the text.
    keysOf(path: KeyPath): string[];
}

const kDeepest = 10; // maps within maps, as of mixes of textures

/// Whether a list is shown in one line: two to four plain values.
export function isVector(field: Field): boolean {
    return field.source?.kind === 'list' && field.parts.length >= 1 && field.parts.length <= 4
        && field.parts.every((part) => part.source?.kind === 'scalar');
}

function fieldAt(schema: Schema, texts: Texts, path: KeyPath, depth: number): Field {
    const source = texts.sourceOf(path);
    const name = path[path.length - 1] ?? '';
    const isInside = source !== null && source.kind !== 'scalar' && depth < kDeepest;
    return {
        path, name: /^\d+$/.test(name) ? String(Number(name) + 1) : name,
        info: keyAt(schema, path), types: typesAt(schema, path), source, origin: texts.originOf(path),
        parts: isInside ? partsOf(schema, texts, path, depth + 1) : [],
    };
}

function partsOf(schema: Schema, texts: Texts, path: KeyPath, depth: number): Field[] {
    return texts.keysOf(path).map((key) => fieldAt(schema, texts, [...path, key], depth));
}

/// The keys that the texts give at a path, and those that they may give beside them.
export function fieldsOf(schema: Schema, texts: Texts, path: KeyPath): { given: Field[]; more: Field[] } {
    const present = texts.keysOf(path);
    const isList = texts.sourceOf(path)?.kind === 'list';
    const others = isList ? [] : keysAt(schema, path, present)
        .filter((info) => info.name !== 'include')
        .map((info) => fieldAt(schema, texts, [...path, info.name], 0));
    // What the text itself does not say may come from the rig that a camera includes.
    return {
        given: [...partsOf(schema, texts, path, 0), ...others.filter(({ source }) => source)],
        more: others.filter(({ source }) => !source),
    };
}

/// The same of an entry that has the values of its kind below a key, which come first, and others
/// beside it: "path: {of: cue}", "from: 1 s".
export function fieldsOfKind(
    schema: Schema, texts: Texts, path: KeyPath, kind: string,
): { given: Field[]; more: Field[] } {
    const outer = fieldsOf(schema, texts, path);
    if (texts.sourceOf([...path, kind])?.kind !== 'map') {
        return outer;
    }
    const inner = fieldsOf(schema, texts, [...path, kind]);
    return {
        given: [...inner.given, ...outer.given.filter(({ name }) => name !== kind)],
        more: [...inner.more, ...outer.more],
    };
}

/// The fields whose name, or the name of a part, contains a word.
export function matching(fields: readonly Field[], word: string): Field[] {
    const needle = word.trim().toLowerCase();
    return fields.flatMap((field) => {
        if (field.name.toLowerCase().includes(needle)
            || field.info?.about.toLowerCase().includes(needle)) {
            return [field];
        }
        const parts = matching(field.parts, word);
        return parts.length > 0 ? [{ ...field, parts }] : [];
    });
}

/// The path of a field as one word.
export function keyOf(field: Field): string {
    return field.path.join('/');
}

/// The fields with those that were among the defaults back in their places there. `held` are the
/// keys of the defaults as they were.
export function inPlace(
    fields: { given: Field[]; more: Field[] }, held: readonly string[],
): { given: Field[]; more: Field[] } {
    const rank = (field: Field) => {
        const at = held.indexOf(keyOf(field));
        return at < 0 ? held.length : at;
    };
    const isHeld = (field: Field) => held.includes(keyOf(field));
    const moved = fields.given.filter(isHeld);
    return {
        given: fields.given.filter((field) => !isHeld(field)),
        more: [...fields.more, ...moved].sort((a, b) => rank(a) - rank(b)),
    };
}
