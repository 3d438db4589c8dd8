/// The lines below the list of keys: what the row at hand means, what it may be, where it comes from.
import { describe, describedBy, describedRow, fieldWith } from './describe';
import type { Field } from './field_model';

/// The same for screen readers, beside the row.
export function HiddenAbout({ field }: { field: Field }) {
    const { meaning, facts } = describe(field);
    return <span hidden id={describedBy(field.path)}>{meaning} {facts}</span>;
}

export function About({ fields }: { fields: readonly Field[] }) {
    const path = describedRow();
    const field = path === null ? null : fieldWith(fields, path);
    const { meaning, facts } = field ? describe(field)
        : { meaning: '', facts: 'Point at a key to see what it means.' };
    return (
        <div class="about" aria-hidden="true">
            <p class="meaning">{field ? <b>{field.name}</b> : null} {meaning}</p>
            <p class="facts">{facts}</p>
        </div>
    );
}
