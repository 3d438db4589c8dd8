/// What the server's schema demands of a new value: the unit that a number needs, as angles and some
/// others are refused without one, and the keys that must not stand beside it.
import type { KeyPath } from '../protocol';
import { rivalsOf, typesAt } from '../schema/keys';
import { schema } from '../schema/schema';
import { typesOf, type Schema, type ValueType } from '../schema/value_types';

/// The unit of the numbers among the types, or of those in their lists.
function unitOf(all: Schema, types: readonly ValueType[]): string {
    const number = types.find((type) => type.kind === 'number');
    if (number) {
        return number.needsUnit ? number.unit : '';
    }
    for (const type of types) {
        const unit = type.kind === 'list' ? unitOf(all, typesOf(all, type.items)) : '';
        if (unit !== '') {
            return unit;
        }
    }
    return '';
}

/// The unit for numbers at a path, and for those in a list there; empty if plain numbers will do.
export function neededUnit(all: Schema, path: KeyPath): string {
    return unitOf(all, typesAt(all, path));
}

/// The same by the schema of the server.
export function unitFor(path: KeyPath): string {
    return schema.value ? neededUnit(schema.value, path) : '';
}

/// The keys that contradict the one at a path.
export function rivalsFor(path: KeyPath): string[] {
    return schema.value ? rivalsOf(schema.value, path) : [];
}
