/// One key of what is selected: its name, which is dragged if it is a number, its value, where the
/// value comes from, and a button that takes it out of the text.
import { ChevronRight, RotateCcw } from 'lucide-preact';
import { useState } from 'preact/hooks';
import { removeValue } from '../edit/edit';
import { isKindOfPart } from '../edit/layers';
import { sequence, shot } from '../state/state';
import { showRange } from '../text/show';
import { HiddenAbout } from './About';
import { describedBy, kOrigins, rowEvents } from './describe';
import { dragNumber } from './drag_number';
import { isVector, type Field } from './field_model';
import { numberType, steppable } from './number_text';
import { ValueInput } from './ValueInput';

const kBadges = { shot: '', include: 'incl', config: 'conf', set: 'set', absent: '' };

/// Shows the value in the text, if it stands there.
function show(field: Field): void {
    const path = field.path.join('/');
    const places = (sequence.peek() ?? shot.peek())?.places ?? [];
    const place = places.find((one) => one.path.join('/') === path)
        ?? places.find((one) => one.path.join('/') === field.path.slice(0, -1).join('/'));
    if (place && field.source) {
        showRange(place.value);
    }
}

function Name({ field }: { field: Field }) {
    const text = field.source?.text ?? field.info?.usual ?? '';
    const number = field.source?.kind === 'list' ? null : steppable(text, numberType(field.types));
    return (
        <button type="button" class={number ? 'name number' : 'name'} title={field.name}
            aria-describedby={describedBy(field.path)}
            onPointerDown={(event) => dragNumber(event, field.path, number, () => show(field))}
            onKeyDown={(event) => {
                if (event.key === 'Enter') {
                    show(field);
                }
            }}>
            {field.name}
        </button>
    );
}

function Origin({ field }: { field: Field }) {
    const badge = kBadges[field.origin];
    return (
        <span class="tail">
            {badge ? <button type="button" class="badge"
                title={`From ${kOrigins[field.origin]}: show it in the text`}
                onClick={() => show(field)}>{badge}</button> : null}
            {field.origin === 'shot' && !field.info?.isRequired && !isKindOfPart(field.path)
                && !/^\d+$/.test(field.path.at(-1) ?? '')
                ? (
                    <button type="button" class="reset" title="Reset to default"
                        aria-label={`Reset ${field.name}`}
                        onClick={() => { removeValue(field.path, `Reset ${field.name}`); }}>
                        <RotateCcw size={13} strokeWidth={1.75} aria-hidden="true" />
                    </button>
                ) : null}
        </span>
    );
}

function Section({ field, above }: { field: Field; above: string }) {
    const [isOpen, setOpen] = useState(true);
    return (
        <div class="section" role="group" aria-label={field.name}>
            <div class="row head" {...rowEvents(field)}>
                <HiddenAbout field={field} />
                <button type="button" class="fold" aria-expanded={isOpen}
                    aria-describedby={describedBy(field.path)}
                    aria-label={`${field.name}, ${isOpen ? 'fold' : 'unfold'}`}
                    onClick={() => setOpen(!isOpen)}>
                    <ChevronRight size={13} strokeWidth={2} aria-hidden="true" />{field.name}
                </button>
                <Origin field={field} />
            </div>
            {isOpen ? <div class="inner">
                {field.parts.map((part) => <FieldRow key={part.path.join('/')} field={part} above={above} />)}
            </div> : null}
        </div>
    );
}

/// A row, or a section with rows. `above` are the words before its name for screen readers.
export function FieldRow({ field, above = '' }: { field: Field; above?: string }) {
    const label = `${above}${field.name}`;
    const isIndexed = /^\d+$/.test(field.name);
    const rowClass = isIndexed ? 'row indexed' : 'row';
    if (isVector(field)) {
        return (
            <div class={field.parts.length > 2 && !isIndexed ? `${rowClass} wide` : rowClass}
                data-key={field.name} {...rowEvents(field)}>
                <HiddenAbout field={field} />
                <Name field={field} />
                <span class="parts">
                    {field.parts.map((part) => (
                        <ValueInput key={part.path.join('/')} field={part} label={`${label} ${part.name}`}
                            about={describedBy(field.path)} />
                    ))}
                </span>
                <Origin field={field} />
            </div>
        );
    }
    if (field.parts.length > 0) {
        return <Section field={field} above={`${label} `} />;
    }
    return (
        <div class={field.source ? rowClass : `${rowClass} absent`} data-key={field.name}
            {...rowEvents(field)}>
            <HiddenAbout field={field} />
            <Name field={field} />
            <ValueInput field={field} label={label} about={describedBy(field.path)} />
            <Origin field={field} />
        </div>
    );
}
