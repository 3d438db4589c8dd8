/// One key of what is selected: its name, which is dragged if it is a number, its value, where the
/// value comes from, and a button that takes it out of the text.
import { ChevronRight, RotateCcw } from 'lucide-preact';
import { useState } from 'preact/hooks';
import { removeValue } from '../edit/edit';
import { shot } from '../state/state';
import { showRange } from '../text/show';
import { dragNumber } from './drag_number';
import { isVector, type Field } from './field_model';
import { numberType, steppable } from './number_text';
import { ValueInput } from './ValueInput';

const kOrigins = {
    shot: 'the shot', include: 'an included file', config: "one of carom's files",
    set: 'an option of the command', absent: 'default',
};
const kBadges = { shot: '', include: 'incl', config: 'conf', set: 'set', absent: '' };

/// What is known of a key, for its tooltip.
function about(field: Field): string {
    const type = numberType(field.types);
    const file = field.source && field.origin !== 'shot'
        ? `${field.source.file.split('/').at(-1)}, line ${field.source.line}` : kOrigins[field.origin];
    return [
        field.info?.about.replaceAll('`', '') ?? '',
        type?.range ? `range: ${type.range}` : '',
        type?.unit ? `unit: ${type.unit}` : '',
        field.info?.usual ? `default: ${field.info.usual}` : '',
        `from ${file}`,
    ].filter((line) => line !== '').join('\n');
}

/// Shows the value in the text, if it stands there.
function show(field: Field): void {
    const path = field.path.join('/');
    const places = shot.peek()?.places ?? [];
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
        <button type="button" class={number ? 'name number' : 'name'} title={about(field)}
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
            {badge ? <button type="button" class="badge" title={`From ${kOrigins[field.origin]}: show it`}
                onClick={() => show(field)}>{badge}</button> : null}
            {field.origin === 'shot' && !field.info?.isRequired && !/^\d+$/.test(field.path.at(-1) ?? '')
                ? (
                    <button type="button" class="reset" title="Take it out of the text: the default holds"
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
            <div class="row head">
                <button type="button" class="fold" aria-expanded={isOpen}
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
    if (isVector(field)) {
        return (
            <div class={/^\d+$/.test(field.name) ? 'row indexed' : field.parts.length > 2 ? 'row wide' : 'row'} data-key={field.name}>
                <Name field={field} />
                <span class="parts">
                    {field.parts.map((part) => (
                        <ValueInput key={part.path.join('/')} field={part} label={`${label} ${part.name}`} />
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
        <div class={`row${field.source ? '' : ' absent'}${/^\d+$/.test(field.name) ? ' indexed' : ''}`} data-key={field.name}>
            <Name field={field} />
            <ValueInput field={field} label={label} />
            <Origin field={field} />
        </div>
    );
}
