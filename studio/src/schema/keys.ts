/// The keys of the shot's maps, and what the schema says at a key path.
import type { KeyPath } from '../protocol';
import { typesOf, type Schema, type SchemaNode, type ValueType } from './value_types';

export interface KeyInfo {
    name: string;
    about: string;
    /// As the schema writes it, or empty.
    usual: string;
    node: SchemaNode;
    isRequired: boolean;
}

const kDefault = /^(.*?) ?\(default: (.*)\)$/s;

function keyInfo(name: string, node: SchemaNode, isRequired: boolean): KeyInfo {
    const description = node.description ?? '';
    const parts = kDefault.exec(description);
    return { name, node, isRequired, about: parts?.[1] ?? description, usual: parts?.[2] ?? '' };
}

function keysOfMap(node: SchemaNode): KeyInfo[] {
    return Object.entries(node.properties ?? {}).map(([name, one]) =>
        keyInfo(name, one, node.required?.includes(name) ?? false));
}

/// The pairs of keys of a map of which only one may be given.
function exclusions(node: SchemaNode): string[][] {
    return (node.allOf ?? []).flatMap((rule) => rule.not?.required ? [rule.not.required] : []);
}

/// The keys without a meaning beside the one of `present` that decides the kind of the map.
function meaningless(node: SchemaNode, present: readonly string[]): string[] {
    const limited = Object.entries(node.properties ?? {}).flatMap(([name, one]) => {
        const kinds = one['x-goes-with'];
        return kinds ? [{ name, kinds }] : [];
    });
    const kind = present.find((key) => limited.some(({ kinds }) => kinds.includes(key)));
    const ofOthers = kind === undefined ? []
        : limited.filter(({ kinds }) => !kinds.includes(kind)).map(({ name }) => name);
    return [...ofOthers, ...needy(node, (partner) => !present.includes(partner))];
}

/// The keys that have a meaning beside one of some others only, all of which are missing.
function needy(node: SchemaNode, isMissing: (partner: string) => boolean): string[] {
    return Object.entries(node.properties ?? {}).flatMap(([name, one]) =>
        one['x-only-with']?.every(isMissing) ? [name] : []);
}

/// What two types have in common if they differ only in whether they may be merged.
function signature(type: ValueType): string {
    return type.kind === 'map'
        ? Object.keys(type.node.properties ?? {}).join()
        : JSON.stringify(type).replaceAll('-(merged)', '');
}

/// The types without those that say the same: a map may be given whole or beside an `include`.
function distinct(types: readonly ValueType[]): ValueType[] {
    const known = new Map(types.map((type) => [signature(type), type]).reverse() as
        [string, ValueType][]);
    return [...known.values()].reverse();
}

/// The maps among the types that can have the keys `present`; all if none can.
function mapsOf(types: readonly ValueType[], present: readonly string[]): SchemaNode[] {
    const maps = types.flatMap((type) => type.kind === 'map' ? [type.node] : []);
    const fitting = maps.filter((map) => present.every((key) => key in (map.properties ?? {})));
    return fitting.length > 0 ? fitting : maps;
}

/// Whether the items of a list have names by which a path may choose them.
function hasNames(schema: Schema, items: SchemaNode): boolean {
    return typesOf(schema, items).some((type) =>
        type.kind === 'map' && 'name' in (type.node.properties ?? {}));
}

/// What may stand at a path, by every form that the maps on the way may have. Empty if the path
/// leads nowhere.
export function typesAt(schema: Schema, path: KeyPath): ValueType[] {
    let nodes: SchemaNode[] = [schema];
    for (const key of path) {
        nodes = nodes.flatMap((node) => typesOf(schema, node)).flatMap((type) => {
            if (type.kind === 'map') {
                const next = type.node.properties?.[key];
                return next ? [next] : [];
            }
            return type.kind === 'named' ? [type.values]
                : type.kind === 'list' && (/^\d+$/.test(key) || hasNames(schema, type.items))
                    ? [type.items] : [];
        });
    }
    return distinct(nodes.flatMap((node) => typesOf(schema, node)));
}

/// The keys that may be added to the map at `path`, which has the keys `present` already.
export function keysAt(schema: Schema, path: KeyPath, present: readonly string[]): KeyInfo[] {
    const found = new Map<string, KeyInfo>();
    for (const map of mapsOf(typesAt(schema, path), present)) {
        const excluded = [...meaningless(map, present), ...exclusions(map)
            .filter((pair) => pair.some((key) => present.includes(key))).flat()];
        for (const key of keysOfMap(map)) {
            if (!present.includes(key.name) && !excluded.includes(key.name)) {
                found.set(key.name, found.get(key.name) ?? key);
            }
        }
    }
    return [...found.values()];
}

/// The keys that contradict the one that a path ends with: beside `direction`, there is no `pot`,
/// and so no `in`, which belongs to that.
export function rivalsOf(schema: Schema, path: KeyPath): string[] {
    const name = path[path.length - 1] ?? '';
    const maps = mapsOf(typesAt(schema, path.slice(0, -1)), [name]);
    const rivals = maps.flatMap(exclusions).filter((pair) => pair.includes(name)).flat()
        .filter((key) => key !== name);
    const theirs = maps.flatMap((map) => needy(map, (partner) => rivals.includes(partner)));
    return [...new Set([...rivals, ...theirs])];
}

/// What the schema says about the key that a path ends with; null for names and items of lists.
export function keyAt(schema: Schema, path: KeyPath): KeyInfo | null {
    const name = path[path.length - 1] ?? '';
    const maps = mapsOf(typesAt(schema, path.slice(0, -1)), [name]);
    return maps.flatMap(keysOfMap).find((key) => key.name === name) ?? null;
}
