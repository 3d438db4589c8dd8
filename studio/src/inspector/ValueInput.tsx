/// The control of one value: a switch, a choice, a colour, or a text with suggestions.
import type { TargetedKeyboardEvent } from 'preact';
import { useEffect, useRef, useState } from 'preact/hooks';
import { applyChanges, beginGesture, type Gesture, removeValue, type Value } from '../edit/edit';
import { keyStep } from '../input/key_run';
import { kNoNames } from '../text/complete/candidates';
import { notice, shot } from '../state/state';
import type { ValueType } from '../schema/value_types';
import { fineness } from './drag_number';
import type { Field } from './field_model';
import { numberType, shareOf, stepped, type Steppable, steppable, typed } from './number_text';
import { shownText, typedValue } from './typed_value';

interface Properties {
    field: Field;
    label: string;
    /// The id of the element that describes the value.
    about: string;
}

const kColour = /^#[0-9a-f]{6}$/i;

function titleOf(field: Field): string {
    return `Set ${field.path[field.path.length - 1]}`;
}

function write(field: Field, value: Value): void {
    applyChanges([{ path: field.path, value }], titleOf(field));
}

/// Moves a number by one press of an arrow key.
function step(field: Field, from: Steppable, direction: number, fine: number): void {
    const moved = (value: number, steps: number) =>
        stepped(field.path, { ...from, value }, steps, fine);
    keyStep({
        id: `value ${field.path.join('/')}`, label: titleOf(field), start: from.value,
        next: (value) => moved(value, direction).value as number,
        changes: (value) => [moved(value, 0)],
    });
}

function Switch({ field, label, about }: Properties) {
    const isOn = (field.source?.text ?? field.info?.usual) === 'true';
    return (
        <input type="checkbox" role="switch" aria-label={label} checked={isOn}
            aria-describedby={about} onChange={() => write(field, !isOn)} />
    );
}

function Choice({ field, label, about, words }: Properties & { words: string[] }) {
    const value = shownText(field.source);
    const usual = field.info?.usual ?? '';
    const all = value === '' || words.includes(value) ? words : [value, ...words];
    return (
        <select aria-label={label} aria-describedby={about} value={value}
            class={field.source ? '' : 'absent'}
            onChange={(event) => {
                const next = event.currentTarget.value;
                if (next !== '') {
                    write(field, next);
                } else if (field.origin === 'shot') {
                    removeValue(field.path, `Reset ${field.name}`);
                }
            }}>
            {field.info?.isRequired && field.source ? null
                : <option value="">{usual || 'default'}</option>}
            {all.map((word) => <option key={word} value={word}>{word}</option>)}
        </select>
    );
}

/// The picker of a colour; one choice is one step of undo.
function Swatch({ field, label, about }: Properties) {
    const text = shownText(field.source);
    const gesture = useRef<Gesture | null>(null);
    const title = titleOf(field);
    const commit = () => {
        gesture.current?.commit(title);
        gesture.current = null;
    };
    useEffect(() => commit, []);
    return (
        <input type="color" aria-label={`${label}, picker`} aria-describedby={about}
            value={kColour.test(text) ? text : '#808080'}
            onInput={(event) => {
                gesture.current ??= beginGesture();
                gesture.current.update([{ path: field.path, value: event.currentTarget.value }]);
            }}
            onChange={commit} onBlur={commit} />
    );
}

/// The words and names that a value may be.
function suggestions(types: readonly ValueType[]): string[] {
    const names = shot.value?.names ?? kNoNames;
    return types.flatMap((type) => type.kind === 'choice' || type.kind === 'text' ? type.words
        : type.kind !== 'name' ? []
            : type.of === 'a material' ? names.materials
                : type.of === 'a ball' ? names.balls
                    : [...type.of.endsWith(' of the table') ? [] : [...names.balls, ...names.objects],
                        ...type.of.includes('surface') ? names.surfaces : [],
                        ...type.of.includes('spot') ? names.spots : [],
                        ...type.of.includes('pocket') ? names.pockets : []]);
}

/// A text that is typed, and kept while messages of the server draw the page again.
function Text({ field, label, about }: Properties) {
    const [draft, setDraft] = useState<string | null>(null);
    const [isRefused, setRefused] = useState(false);
    const type = numberType(field.types);
    const text = shownText(field.source);
    const usual = field.info?.usual ?? '';
    const words = suggestions(field.types);
    const list = words.length > 0 ? `words-${field.path.join('-')}` : undefined;
    const share = shareOf(field.source ? steppable(text, type) : null);
    const forget = () => {
        setDraft(null);
        setRefused(false);
    };
    const commit = (typedText: string) => {
        const next = typed(typedText, text || usual, type);
        if (next === '' && field.origin === 'shot' && !field.info?.isRequired) {
            removeValue(field.path, `Reset ${field.name}`);
        } else if (next !== '' && next !== text) {
            const { value, problem } = typedValue(next, field.types);
            if (value === null) {
                notice.value = { kind: 'error', text: problem };
                setRefused(true);
                return;
            }
            write(field, value);
        }
        forget();
    };
    const onKey = (event: TargetedKeyboardEvent<HTMLInputElement>) => {
        const direction = { ArrowUp: 1, ArrowDown: -1 }[event.key];
        const from = steppable(typed(draft ?? '', text || usual, type) || text || usual, type);
        if (direction && from && !list) {
            event.preventDefault();
            step(field, from, direction, fineness(event));
            forget();
        } else if (event.key === 'Escape') {
            event.currentTarget.value = text;
            forget();
            event.currentTarget.blur();
            event.stopPropagation();
        }
    };
    return (
        <span class="text">
            <input value={draft ?? text} placeholder={usual || '—'} aria-label={label}
                aria-describedby={about} aria-invalid={isRefused || undefined}
                list={list} spellcheck={false} autocomplete="off"
                style={share === null ? undefined
                    : { '--share': `${Math.round(100 * Math.min(1, Math.max(0, share)))}%` }}
                class={share === null ? '' : 'level'} onKeyDown={onKey}
                onInput={(event) => setDraft(event.currentTarget.value)}
                onChange={(event) => commit(event.currentTarget.value)}
                onBlur={() => { if (!isRefused) { setDraft(null); } }} />
            {list ? <datalist id={list}>{words.map((word) => <option key={word} value={word} />)}</datalist>
                : null}
        </span>
    );
}

/// The control of a value that is no map, or a grey text if it cannot be written here.
export function ValueInput({ field, label, about }: Properties) {
    const { types, origin } = field;
    const choice = types.find((type) => type.kind === 'choice');
    const isScalar = types.some((type) => type.kind !== 'map' && type.kind !== 'list'
        && type.kind !== 'named');
    if (origin === 'set' || (!isScalar && types.length > 0 && !field.source)) {
        return <output aria-label={label}>{field.source?.text || field.info?.usual || 'none'}</output>;
    }
    if (types.some((type) => type.kind === 'boolean')) {
        return <Switch field={field} label={label} about={about} />;
    }
    if (choice?.kind === 'choice' && !types.some((type) => type.kind === 'number'
        || type.kind === 'name')) {
        return <Choice field={field} label={label} about={about} words={choice.words} />;
    }
    const isColour = types.some((type) => type.kind === 'text' && type.pattern.startsWith('^#'));
    return (
        <span class="value">
            {isColour ? <Swatch field={field} label={label} about={about} /> : null}
            <Text field={field} label={label} about={about} />
        </span>
    );
}
