/// What carom's JSON schema says about values, in a form that completion, tooltips and fields can
/// use. Only the members that carom writes into its schema are read.

/// A part of the schema.
export interface SchemaNode {
    $ref?: string;
    description?: string;
    type?: string | string[];
    enum?: unknown[];
    const?: unknown;
    pattern?: string;
    minimum?: number;
    maximum?: number;
    exclusiveMinimum?: number;
    exclusiveMaximum?: number;
    minItems?: number;
    maxItems?: number;
    items?: SchemaNode;
    properties?: Record<string, SchemaNode>;
    additionalProperties?: SchemaNode | false;
    required?: string[];
    not?: { required?: string[] };
    anyOf?: SchemaNode[];
    allOf?: SchemaNode[];
    'x-unit'?: string;
    'x-units'?: string;
    'x-needs-unit'?: boolean;
    'x-zero-needs-unit'?: boolean;
    'x-range'?: string;
    'x-name-of'?: string;
    'x-keys-of'?: string;
    'x-file'?: boolean;
    'x-goes-with'?: string[];
    'x-only-with'?: string[];
}

export interface Schema extends SchemaNode {
    definitions: Record<string, SchemaNode>;
}

/// One of the forms that a value may have.
export type ValueType =
    | NumberType
    | { kind: 'boolean' }
    | { kind: 'choice'; words: string[] }
    /// Any word; `words` are suggestions, and so are the keys of the shot's map `keysOf` ("a.b").
    | { kind: 'text'; words: string[]; keysOf: string; pattern: string }
    /// A name of the shot: "a ball", "a material" ...
    | { kind: 'name'; of: string }
    | { kind: 'file' }
    | { kind: 'list'; items: SchemaNode; least: number; most: number }
    | { kind: 'map'; node: SchemaNode }
    /// A map from the user's names.
    | { kind: 'named'; values: SchemaNode };

export interface NumberType {
    kind: 'number';
    isInteger: boolean;
    /// The unit that numbers are shown with, and all usual ones; empty for plain numbers.
    unit: string;
    units: string[];
    needsUnit: boolean;
    /// Whether 0 needs its unit, too: 0 dB.
    zeroNeedsUnit: boolean;
    /// In SI units, as far as plain numbers are allowed.
    low: number | null;
    high: number | null;
    /// "more than 0 s and at most 10 s", or empty.
    range: string;
}

function follow(schema: Schema, node: SchemaNode): SchemaNode {
    return node.$ref === undefined
        ? node : schema.definitions[node.$ref.replace('#/definitions/', '')] ?? {};
}

function numberOf(node: SchemaNode, isInteger: boolean): NumberType {
    const low = node.minimum ?? node.exclusiveMinimum ?? null;
    const high = node.maximum ?? node.exclusiveMaximum ?? null;
    const words = [
        node.minimum !== undefined ? `at least ${node.minimum}` : '',
        node.exclusiveMinimum !== undefined ? `more than ${node.exclusiveMinimum}` : '',
        node.maximum !== undefined ? `at most ${node.maximum}` : '',
        node.exclusiveMaximum !== undefined ? `less than ${node.exclusiveMaximum}` : '',
    ].filter((word) => word !== '');
    return { kind: 'number', isInteger, unit: '', units: [], needsUnit: false,
        zeroNeedsUnit: false, low, high, range: words.join(' and ') };
}

/// The number that a text with a unit stands for.
function quantityOf(node: SchemaNode, range: string): NumberType {
    return { kind: 'number', isInteger: false, unit: node['x-unit'] ?? '',
        units: (node['x-units'] ?? '').split(', ').filter((unit) => unit !== ''),
        needsUnit: node['x-needs-unit'] ?? false, zeroNeedsUnit: node['x-zero-needs-unit'] ?? false,
        low: null, high: null, range };
}

/// Whether a pattern is that of a number, not of a word such as a colour.
function isNumberPattern(pattern: string): boolean {
    return pattern.includes('[0-9]+\\.?[0-9]*') || pattern === '^-?[0-9]+$';
}

function scalarTypes(node: SchemaNode, range: string): ValueType[] {
    const { type, pattern = '' } = node;
    if (node['x-name-of'] !== undefined) {
        return [{ kind: 'name', of: node['x-name-of'] }];
    }
    if (node['x-file']) {
        return [{ kind: 'file' }];
    }
    if (type === 'string' && (node['x-unit'] !== undefined || isNumberPattern(pattern))) {
        return [quantityOf(node, range)];
    }
    if (type === 'string' || (Array.isArray(type) && type.includes('string'))) {
        return [{ kind: 'text', words: [], keysOf: node['x-keys-of'] ?? '', pattern }];
    }
    if (type === 'number' || type === 'integer') {
        return [numberOf(node, type === 'integer')];
    }
    return type === 'boolean' ? [{ kind: 'boolean' }] : [];
}

function collect(schema: Schema, given: SchemaNode, range: string, found: ValueType[]): void {
    const node = follow(schema, given);
    if (node.properties) {
        found.push({ kind: 'map', node });
    } else if (node.type === 'object') {
        found.push({ kind: 'named', values: node.additionalProperties || {} });
    } else if (node.type === 'array') {
        found.push({ kind: 'list', items: node.items ?? {}, least: node.minItems ?? 0,
            most: node.maxItems ?? Infinity });
    } else if (node.enum) {
        const words = node.enum.filter((word) => typeof word === 'string');
        found.push({ kind: 'choice', words });
    } else {
        found.push(...scalarTypes(node, range));
        for (const part of [...node.anyOf ?? [], ...node.allOf ?? []]) {
            collect(schema, part, node['x-range'] ?? range, found);
        }
    }
}

/// One number type of those of a value: a plain number and a text with a unit say the same.
function merge(a: NumberType, b: NumberType): NumberType {
    return {
        kind: 'number', isInteger: a.isInteger || b.isInteger,
        unit: a.unit || b.unit, units: a.units.length > 0 ? a.units : b.units,
        needsUnit: a.needsUnit || b.needsUnit, zeroNeedsUnit: a.zeroNeedsUnit || b.zeroNeedsUnit,
        low: a.low ?? b.low, high: a.high ?? b.high,
        range: [a.range, b.range].sort((x, y) => y.length - x.length)[0] ?? '',
    };
}

/// All forms that a value of this part of the schema may have.
export function typesOf(schema: Schema, node: SchemaNode): ValueType[] {
    const found: ValueType[] = [];
    collect(schema, node, '', found);
    const numbers = found.filter((one) => one.kind === 'number');
    const choices = found.filter((one) => one.kind === 'choice').flatMap((one) => one.words);
    const texts = found.filter((one) => one.kind === 'text');
    const rest = found.filter(({ kind }) => kind !== 'number' && kind !== 'choice' && kind !== 'text');
    const words: ValueType[] = texts.map((text) => ({ ...text, words: choices }));
    if (texts.length === 0 && choices.length > 0) {
        words.push({ kind: 'choice', words: choices });
    }
    return [...words, ...numbers.length > 0 ? [numbers.reduce(merge)] : [], ...rest];
}
