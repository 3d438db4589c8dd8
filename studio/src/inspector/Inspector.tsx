import { signal } from '@preact/signals';
import { ChevronRight, Search } from 'lucide-preact';
import { useLayoutEffect, useRef } from 'preact/hooks';
import { schema } from '../schema/schema';
import { groupsNow } from '../outline/groups_now';
import { titleOf } from '../outline/outline_groups';
import { thingOf } from '../outline/thing';
import { indexOfPart } from '../sequence/parts';
import { PartTools } from '../sequence/PartTools';
import { dragging, isSequence, selection, sequence, shot } from '../state/state';
import type { KeyPath } from '../protocol';
import { About } from './About';
import { FieldRow } from './FieldRow';
import { fieldsOf, fieldsOfKind, inPlace, keyOf, matching, type Field } from './field_model';
import { StrikeTool } from './StrikeTool';
import { textsNow } from './texts';
import './inspector.css';

const word = signal('');
const showsMore = signal(true);

/// The fields to show. While something is dragged, or a key is held, a default that gets a value
/// keeps its place among the defaults: the row stays under the pointer.
function useFields(path: KeyPath, kind: string | null): { given: Field[]; more: Field[] } | null {
    const held = useRef<readonly string[]>([]);
    const all = schema.value;
    const texts = textsNow();
    if (!all) {
        return null;
    }
    const fields = kind === null ? fieldsOf(all, texts, path)
        : fieldsOfKind(all, texts, path, kind);
    if (path.join('/') === 'film') {  // its parts are things of their own
        fields.given = fields.given.filter(({ name }) => name !== 'shots');
    }
    if (dragging.value) {
        return inPlace(fields, held.current);
    }
    held.current = fields.more.map(keyOf);
    return fields;
}

/// Puts the focus back that an element lost because its row went elsewhere in the list.
function useKeptFocus(list: { current: HTMLElement | null }): void {
    const had = document.activeElement;
    const label = list.current?.contains(had) ? had?.getAttribute('aria-label') : null;
    useLayoutEffect(() => {
        if (label && document.activeElement === document.body) {
            list.current?.querySelector<HTMLElement>(`[aria-label="${CSS.escape(label)}"]`)?.focus();
        }
    });
}

function isMaterial(path: KeyPath): boolean {
    return path.length === 2 && path[0] === 'materials';
}

/// The model of reflection that the text gives a material; null if none.
function modelOfMaterial(path: KeyPath): string | null {
    return textsNow().keysOf(path).find((key) => key === 'standard' || key === 'phong') ?? null;
}

function Values({ path }: { path: KeyPath }) {
    const list = useRef<HTMLDivElement>(null);
    const isThis = (one: { path: KeyPath }) => one.path.join('/') === path.join('/');
    const event = shot.value?.events.find(isThis);
    const annotation = shot.value?.annotations.find(isThis);
    const part = sequence.value?.parts[indexOfPart(path)];
    // The keys of an event stand below its kind, as those of a material do; those of an annotation
    // also beside it.
    const kind = annotation?.kind ?? (isMaterial(path) ? modelOfMaterial(path) : null);
    const fields = useFields(event ? [...path, event.kind] : path, kind);
    useKeptFocus(list);
    if (!fields) {
        return null;
    }
    const isSearch = word.value.trim() !== '';
    const shown = isSearch ? matching(fields.given, word.value) : fields.given;
    const rest = isSearch ? matching(fields.more, word.value) : fields.more;
    const row = (field: Field) => <FieldRow key={keyOf(field)} field={field} />;
    // One list, in which a row keeps its element when it goes from the defaults to the others.
    const rows = [
        ...shown.map(row),
        rest.length === 0 ? null : (
            <button key=" defaults" type="button" class="fold more" aria-expanded={showsMore.value}
                onClick={() => { showsMore.value = !showsMore.value; }}>
                <ChevronRight size={13} strokeWidth={2} aria-hidden="true" />Defaults
                <span class="count">{rest.length}</span>
            </button>
        ),
        ...showsMore.value ? rest.map(row) : [],
    ];
    return (
        <>
            <div class="list" ref={list}>
                {event?.kind === 'strike' && !isSearch ? <StrikeTool event={event} /> : null}
                {part && !isSearch ? <PartTools part={part} /> : null}
                {rows}
                {isSearch && shown.length + rest.length === 0 ? <p class="hint">No matches.</p> : null}
            </div>
            <About fields={[...shown, ...rest]} />
        </>
    );
}

/// The values of what is selected: all keys that it has or may have. Fills its parent.
export function Inspector() {
    const chosen = selection.value;
    return (
        <div class="inspector" role="region" aria-label="Values of the selection">
            {chosen === null
                ? <p class="hint">
                    {isSequence.value ? 'Select a part of the film to see its values.'
                        : 'Select a ball, an event, a camera or anything else in the shot to see its values.'}
                </p>
                : (
                    <>
                        <header>
                            <h2 title={chosen.join(' › ')}>{titleOf(thingOf(chosen), groupsNow.value)}</h2>
                            <label class="seek">
                                <Search size={13} aria-hidden="true" />
                                <input type="search" placeholder="Find a key" aria-label="Find a key"
                                    value={word.value}
                                    onInput={(event) => { word.value = event.currentTarget.value; }} />
                            </label>
                        </header>
                        <Values key={thingOf(chosen).join('/')} path={thingOf(chosen)} />
                    </>
                )}
        </div>
    );
}
