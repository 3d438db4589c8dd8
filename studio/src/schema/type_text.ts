/// Types in words, for lists and tooltips.
import { typesOf, type Schema, type ValueType } from './value_types';

/// A few words: "length, m", "true or false", "name of a ball", "list of 3".
export function typeText(schema: Schema, type: ValueType): string {
    switch (type.kind) {
        case 'number':
            return type.unit !== '' ? type.unit : type.isInteger ? 'whole number' : 'number';
        case 'boolean':
            return 'true or false';
        case 'choice':
            return type.words.length > 3
                ? 'word' : type.words.join(' | ');
        case 'text':
            return type.pattern.startsWith('^#') ? '#rrggbb' : 'word';
        case 'name':
            return `name of ${type.of}`;
        case 'file':
            return 'file';
        case 'list': {
            const [item] = typesOf(schema, type.items);
            const what = item && item.kind !== 'map' && item.kind !== 'list'
                ? ` ${typeText(schema, item)}` : '';
            return type.least === type.most ? `[${type.least}${what && ` ×${what}`}]`
                : `[${what.trim() || '…'}]`;
        }
        case 'map':
            return '{…}';
        case 'named':
            return 'names';
    }
}

/// All forms of a value: "m | [2 × m]".
export function typesText(schema: Schema, types: readonly ValueType[]): string {
    return [...new Set(types.map((type) => typeText(schema, type)))].join(' | ');
}
