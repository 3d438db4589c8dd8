/// The control of one value: a switch, a choice, a colour, or a text with suggestions.
import { applyChanges, beginGesture, type Gesture, removeValue } from '../edit/edit';
import { kNoNames } from '../text/complete/candidates';
import { shot } from '../state/state';
import type { ValueType } from '../schema/value_types';
import { fineness } from './drag_number';
import type { Field } from './field_model';
import { numberType, shareOf, stepped, steppable, typed } from './number_text';

const kColour = /^#[0-9a-f]{6}$/i;

function titleOf(field: Field): string {
    return `Set ${field.path[field.path.length - 1]}`;
}

function write(field: Field, text: string): void {
    applyChanges([{ path: field.path, value: { yaml: text } }], titleOf(field));
}

function Switch({ field, label }: { field: Field; label: string }) {
    const isOn = (field.source?.text ?? field.info?.usual) === 'true';
    return (
        <input type="checkbox" role="switch" aria-label={label} checked={isOn}
            onChange={() => write(field, String(!isOn))} />
    );
}

function Choice({ field, label, words }: { field: Field; label: string; words: string[] }) {
    const value = field.source?.text ?? '';
    const usual = field.info?.usual ?? '';
    const all = value === '' || words.includes(value) ? words : [value, ...words];
    return (
        <select aria-label={label} value={value} class={field.source ? '' : 'absent'}
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
function Swatch({ field, label }: { field: Field; label: string }) {
    const text = field.source?.text.replace(/["']/g, '') ?? '';
    let gesture: Gesture | null = null;
    return (
        <input type="color" aria-label={`${label}, picker`} value={kColour.test(text) ? text : '#808080'}
            onInput={(event) => {
                gesture ??= beginGesture();
                gesture.update([{ path: field.path, value: event.currentTarget.value }]);
            }}
            onChange={() => {
                gesture?.commit(titleOf(field));
                gesture = null;
            }} />
    );
}

/// The words and names that a value may be.
function suggestions(types: readonly ValueType[]): string[] {
    const names = shot.value?.names ?? kNoNames;
    return types.flatMap((type) => type.kind === 'choice' || type.kind === 'text' ? type.words
        : type.kind !== 'name' ? []
            : type.of === 'a material' ? names.materials
                : type.of === 'a ball' ? names.balls
                    : [...names.balls, ...names.objects,
                        ...type.of.includes('surface') ? names.surfaces : []]);
}

function Text({ field, label }: { field: Field; label: string }) {
    const type = numberType(field.types);
    const text = field.source?.text ?? '';
    const number = steppable(text || (field.info?.usual ?? ''), type);
    const words = suggestions(field.types);
    const list = words.length > 0 ? `words-${field.path.join('-')}` : undefined;
    const share = shareOf(field.source ? number : null);
    const onKey = (event: KeyboardEvent) => {
        const direction = { ArrowUp: 1, ArrowDown: -1 }[event.key];
        if (direction && number && !list) {
            event.preventDefault();
            applyChanges([stepped(field.path, number, direction, fineness(event))], titleOf(field));
        } else if (event.key === 'Escape') {
            (event.currentTarget as HTMLInputElement).value = text;
            (event.currentTarget as HTMLInputElement).blur();
            event.stopPropagation();
        }
    };
    return (
        <span class="text">
            <input value={text} placeholder={field.info?.usual || '—'} aria-label={label}
                list={list} spellcheck={false} autocomplete="off"
                style={share === null ? undefined
                    : { '--share': `${Math.round(100 * Math.min(1, Math.max(0, share)))}%` }}
                class={share === null ? '' : 'level'} onKeyDown={onKey}
                onChange={(event) => {
                    const next = typed(event.currentTarget.value, text || (field.info?.usual ?? ''), type);
                    if (next === '' && field.origin === 'shot' && !field.info?.isRequired) {
                        removeValue(field.path, `Reset ${field.name}`);
                    } else if (next === '') {
                        event.currentTarget.value = text;
                    } else if (next !== text) {
                        write(field, next);
                    }
                }} />
            {list ? <datalist id={list}>{words.map((word) => <option key={word} value={word} />)}</datalist>
                : null}
        </span>
    );
}

/// The control of a value that is no map, or a grey text if it cannot be written here.
export function ValueInput({ field, label }: { field: Field; label: string }) {
    const { types, origin } = field;
    const choice = types.find((type) => type.kind === 'choice');
    const isScalar = types.some((type) => type.kind !== 'map' && type.kind !== 'list'
        && type.kind !== 'named');
    if (origin === 'set' || (!isScalar && types.length > 0 && !field.source)) {
        return <output aria-label={label}>{field.source?.text || field.info?.usual || 'none'}</output>;
    }
    if (types.some((type) => type.kind === 'boolean')) {
        return <Switch field={field} label={label} />;
    }
    if (choice?.kind === 'choice' && !types.some((type) => type.kind === 'number'
        || type.kind === 'name')) {
        return <Choice field={field} label={label} words={choice.words} />;
    }
    const isColour = types.some((type) => type.kind === 'text' && type.pattern.startsWith('^#'));
    return (
        <span class="value">
            {isColour ? <Swatch field={field} label={label} /> : null}
            <Text field={field} label={label} />
        </span>
    );
}
