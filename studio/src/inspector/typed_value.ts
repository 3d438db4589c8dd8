/// What a typed text means for a key: a plain text, or a list, a map or a quantity in YAML.
import { isMap, isScalar, isSeq, parseDocument } from 'yaml';
import type { Source, Value } from '../edit/edit';
import { parseQuantity } from '../edit/quantity';
import { scalarText } from '../edit/yaml_tree';
import type { ValueType } from '../schema/value_types';

/// A text without the quotes that YAML has around it.
function unquoted(text: string): string {
    if (!/^(["']).*\1$/s.test(text)) {
        return text;
    }
    const { contents, errors } = parseDocument(text, { schema: 'failsafe', logLevel: 'silent' });
    return errors.length === 0 && isScalar(contents) ? scalarText(contents) : text;
}

/// A value as its field shows it.
export function shownText(source: Source | null): string {
    return source === null ? '' : source.kind === 'scalar' ? unquoted(source.text) : source.text;
}

/// Whether a text is one list or map in flow style, and nothing else.
function isCollection(text: string): boolean {
    if (!/^[[{]/.test(text)) {
        return false;
    }
    const { contents, errors, comment } =
        parseDocument(text, { schema: 'failsafe', logLevel: 'silent' });
    const isWhole = errors.length === 0 && comment === null && !/[\]}]\s*#/.test(text);
    return isWhole && (isSeq(contents) || isMap(contents)) && /[\]}]$/.test(text);
}

function takes(types: readonly ValueType[], kinds: readonly ValueType['kind'][]): boolean {
    return types.length === 0 || types.some(({ kind }) => kinds.includes(kind));
}

/// The value that a typed text stands for. `problem` is a sentence if it is none.
export function typedValue(
    text: string, types: readonly ValueType[],
): { value: Value; problem: '' } | { value: null; problem: string } {
    if (/^[[{]/.test(text) && takes(types, ['list', 'map', 'named'])) {
        return isCollection(text) ? { value: { yaml: text }, problem: '' }
            : { value: null, problem: `'${text}' is not complete: a list is written as [1, 2], `
                + 'a map as {key: value}.' };
    }
    if (takes(types, ['number']) && parseQuantity(text)) {
        return { value: { yaml: text }, problem: '' };
    }
    return { value: unquoted(text), problem: '' };
}
