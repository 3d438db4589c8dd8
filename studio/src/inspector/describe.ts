/// What is known of a key: what it means, what it may be, and where its value comes from.
import { signal } from '@preact/signals';
import type { KeyPath } from '../protocol';
import type { Field } from './field_model';
import { numberType } from './number_text';

export const kOrigins = {
    shot: 'this shot', include: 'an included file', config: "one of carom's files",
    set: 'an option of the command', absent: 'the default',
};

export interface Description {
    meaning: string;
    /// "Unit m/s · 0 m/s to 30 m/s · Default 1 m/s · From this shot".
    facts: string;
}

/// The file and line of a value of another file, or a word for where it comes from.
function placeOf({ source, origin }: Field): string {
    return source && origin !== 'shot' && origin !== 'set'
        ? `${source.file.split('/').at(-1)}, line ${source.line}` : kOrigins[origin];
}

/// "at least 0 s and at most 10 s" in few words.
function shortRange(range: string): string {
    return range.replace(/^at least (.+) and at most (.+)$/, '$1 to $2')
        .replaceAll('at least ', '≥ ').replaceAll('more than ', '> ')
        .replaceAll('at most ', '≤ ').replaceAll('less than ', '< ').replace(' and ', ', ');
}

function sentence(text: string): string {
    const plain = text.replaceAll('`', '').trim();
    const whole = plain.charAt(0).toUpperCase() + plain.slice(1);
    return whole === '' || /[.!?]$/.test(whole) ? whole : `${whole}.`;
}

export function describe(field: Field): Description {
    const type = numberType(field.types);
    const usual = field.info?.usual.replaceAll('`', '') ?? '';
    const parts = [
        type?.unit ? `Unit ${type.unit}` : '',
        type?.range ? shortRange(type.range) : '',
        usual ? `Default ${usual}` : field.info?.isRequired ? 'Required' : '',
        field.origin === 'absent' ? 'Not in the text' : `From ${placeOf(field)}`,
    ].filter((part) => part !== '');
    return { meaning: sentence(field.info?.about ?? ''), facts: parts.join(' · ') };
}

/// The id of the element that describes a key to screen readers.
export function describedBy(path: KeyPath): string {
    return `about-${path.map((key) => key.replaceAll(/\W/g, '-')).join('-')}`;
}

/// The paths, joined with "/", of the rows that the pointer is over and that were used last.
const hoveredRow = signal<string | null>(null);
const usedRow = signal<string | null>(null);

/// The row that the area below the list describes; the pointer comes first.
export function describedRow(): string | null {
    return hoveredRow.value ?? usedRow.value;
}

/// What makes a row the described one, also by touch, which gives no focus to a name.
export function rowEvents(field: Field) {
    const path = field.path.join('/');
    return {
        onPointerEnter: () => { hoveredRow.value = path; },
        onPointerLeave: () => { hoveredRow.value = null; },
        onPointerDown: () => { usedRow.value = path; },
        onFocusIn: () => { usedRow.value = path; },
    };
}

/// The field at a path, joined with "/", among fields and their parts.
export function fieldWith(fields: readonly Field[], path: string): Field | null {
    for (const field of fields) {
        const found = field.path.join('/') === path ? field : fieldWith(field.parts, path);
        if (found) {
            return found;
        }
    }
    return null;
}
