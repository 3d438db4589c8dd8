/// What may be written at a place, from the schema and the names of the shot.
import type { KeyPath, Names } from '../../protocol';
import { keyAt, keysAt, typesAt, type KeyInfo } from '../../schema/keys';
import { typesText } from '../../schema/type_text';
import { typesOf, type Schema, type ValueType } from '../../schema/value_types';
import { snippetsFor } from './snippets';

export interface Candidate {
    label: string;
    kind: 'key' | 'word' | 'name' | 'value' | 'snippet' | 'file';
    /// A few words beside it.
    detail: string;
    /// A sentence about it, or empty.
    about: string;
    /// What is written, with ${...} at the places to fill in; otherwise the label.
    insert?: string;
    key?: KeyInfo;
}

/// The shot as far as completion needs it.
export interface Known {
    schema: Schema;
    names: Names;
    /// Files that may be included: "tables/pool_9ft.yaml".
    includes: readonly { name: string; about: string }[];
    presets: readonly string[];
    /// The length of the film in seconds.
    filmEnd: number;
}

export const kNoNames: Names = {
    balls: [], objects: [], materials: [], lights: [], cameras: [], surfaces: [], spots: [], pockets: [],
};

function name(label: string, detail: string): Candidate {
    return { label, kind: 'name', detail, about: '' };
}

/// The names of the shot that a value may be.
function namesOf(names: Names, of: string): Candidate[] {
    if (of === 'a material') {
        return names.materials.map((one) => name(one, 'material'));
    }
    const places = [...of.includes('spot') ? names.spots.map((one) => name(one, 'spot')) : [],
        ...of.includes('pocket') ? names.pockets.map((one) => name(one, 'pocket')) : []];
    if (of.endsWith(' of the table')) {
        return places;
    }
    const balls = names.balls.map((one) => name(one, 'ball'));
    const objects = names.objects.map((one) => name(one, 'object'));
    return of === 'a ball' ? balls
        : of === 'an object or surface'
            ? [...balls, ...objects, ...names.surfaces.map((one) => name(one, 'surface'))]
            : [...balls, ...objects, ...places];
}

/// The keys of the shot's map "conditions.cloth" as words.
function keysOf(known: Known, path: string): Candidate[] {
    return path === '' ? [] : keysAt(known.schema, path.split('.'), [])
        .map((key) => ({ label: key.name, kind: 'word', detail: path, about: key.about }));
}

/// The names that entries of a section may change: those of included files and of the rack.
function entriesOf(known: Known, path: KeyPath, present: readonly string[]): Candidate[] {
    const section = path[0] as keyof Names;
    const isNamed = path.length === 1 && section in known.names
        && typesAt(known.schema, path).some(({ kind }) => kind === 'named');
    const all = isNamed ? known.names[section] : [];
    return all.filter((one) => !present.includes(one))
        .map((one) => ({ label: one, kind: 'name', detail: section.slice(0, -1), about: '' }));
}

function valuesOf(known: Known, type: ValueType): Candidate[] {
    switch (type.kind) {
        case 'boolean':
            return ['true', 'false'].map((label) => ({ label, kind: 'word', detail: '', about: '' }));
        case 'choice':
            return type.words.map((label) => ({ label, kind: 'word', detail: '', about: '' }));
        case 'text':
            return [...type.words.map((label): Candidate =>
                ({ label, kind: 'word', detail: '', about: '' })), ...keysOf(known, type.keysOf)];
        case 'name':
            return namesOf(known.names, type.of);
        default:
            return [];
    }
}

/// "[${x}, ${y}, ${z}]" for a list of some length, with units where plain numbers are refused.
function listTemplate(known: Known, type: ValueType): string {
    if (type.kind !== 'list' || !Number.isFinite(type.least) || type.least < 2 || type.least > 4) {
        return '[${}]';
    }
    const number = typesOf(known.schema, type.items).find((one) => one.kind === 'number');
    const unit = number?.needsUnit ? ` ${number.unit}` : '';
    return `[${'xyzw'.slice(0, type.least).split('').map((one) => `\${${one}}${unit}`).join(', ')}]`;
}

/// The forms that are written with brackets.
function bracketsOf(known: Known, types: readonly ValueType[]): Candidate[] {
    return types.flatMap((type): Candidate[] => {
        const detail = typesText(known.schema, [type]);
        if (type.kind === 'list') {
            const insert = listTemplate(known, type);
            return [{ label: insert.replace(/\$\{(\w*)\}/g, '$1'), kind: 'value', detail: 'list',
                about: '', insert }];
        }
        // Several maps, of which the first key decides, are one pair of braces.
        return type.kind === 'map' && type === types.find(({ kind }) => kind === 'map')
            ? [{ label: '{ }', kind: 'value', detail: detail === '{…}' ? 'keys' : detail, about: '',
                insert: '{${}}' }]
            : [];
    });
}

function filesOf(known: Known, path: KeyPath): Candidate[] {
    const isInclude = path[0] === 'include' && path.length <= 2;
    const isRig = path[0] === 'cameras' && path.length === 3 && path[2] === 'include';
    if (path.join() === 'quality') {
        return known.presets.map((label) => ({ label, kind: 'word', detail: 'preset', about: '' }));
    }
    return known.includes
        .filter((file) => isInclude ? !/^(rigs|templates|quality)\//.test(file.name)
            : isRig && file.name.startsWith('rigs/'))
        .map((file) => ({ label: file.name, kind: 'file', detail: '', about: file.about }));
}

/// The values that may stand at a path, the commonest first.
export function valueCandidates(known: Known, path: KeyPath): Candidate[] {
    const types = typesAt(known.schema, path);
    const usual = keyAt(known.schema, path)?.usual ?? '';
    const words = types.flatMap((type) => valuesOf(known, type));
    const unknown = usual !== '' && !words.some(({ label }) => label === usual)
        && /^[-#\w[(.]/.test(usual) && !usual.includes('"')
        ? [{ label: usual, kind: 'value' as const, detail: 'default', about: '' }] : [];
    const shown = words.map((word) => word.label === usual ? { ...word, detail: 'default' } : word);
    return [...filesOf(known, path), ...shown, ...unknown, ...bracketsOf(known, types)];
}

/// The keys that may be added to the map at a path.
export function keyCandidates(
    known: Known, path: KeyPath, present: readonly string[],
): Candidate[] {
    const keys = keysAt(known.schema, path, present).map((key): Candidate => ({
        label: key.name, kind: 'key', about: key.about, key,
        detail: key.isRequired ? 'required' : typesText(known.schema,
            typesOf(known.schema, key.node)),
    }));
    return [...keys, ...entriesOf(known, path, present)];
}

/// Whole entries for the list or map at a path.
export function snippetCandidates(known: Known, path: KeyPath): Candidate[] {
    return snippetsFor(path, known.names, known.filmEnd).map((one) => ({
        label: one.label, kind: 'snippet', detail: 'new', about: one.about, insert: one.yaml,
    }));
}

/// The units that a number at a path may have.
export function unitsAt(known: Known, path: KeyPath): string[] {
    const units = typesAt(known.schema, path)
        .flatMap((type) => type.kind === 'number' ? type.units : []);
    return [...new Set(units)];
}
