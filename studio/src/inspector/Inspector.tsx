import { signal } from '@preact/signals';
import { ChevronRight, Search } from 'lucide-preact';
import { schema } from '../schema/schema';
import { selection, shot } from '../state/state';
import { titleOf } from '../outline/outline_groups';
import type { KeyPath } from '../protocol';
import { FieldRow } from './FieldRow';
import { fieldsOf, matching } from './field_model';
import { StrikeTool } from './StrikeTool';
import { textsNow } from './texts';
import './inspector.css';

const word = signal('');
const showsMore = signal(true);

/// The selected thing as a whole: of a point of a path its camera.
function thingOf(chosen: KeyPath): KeyPath {
    return chosen.slice(0, 2);
}

function Values({ path }: { path: KeyPath }) {
    const all = schema.value;
    const texts = textsNow();
    const event = shot.value?.events.find((one) => one.path.join('/') === path.join('/'));
    // The keys of an event stand below its kind.
    const inner = path[0] === 'events' && event ? [...path, event.kind] : path;
    if (!all) {
        return null;
    }
    const { given, more } = fieldsOf(all, texts, inner);
    const isSearch = word.value.trim() !== '';
    const shown = isSearch ? matching(given, word.value) : given;
    const rest = isSearch ? matching(more, word.value) : more;
    return (
        <>
            {event?.kind === 'strike' && !isSearch ? <StrikeTool event={event} /> : null}
            {shown.map((field) => <FieldRow key={field.path.join('/')} field={field} />)}
            {rest.length > 0 ? (
                <button type="button" class="fold more" aria-expanded={showsMore.value}
                    onClick={() => { showsMore.value = !showsMore.value; }}>
                    <ChevronRight size={13} strokeWidth={2} aria-hidden="true" />Defaults
                    <span class="count">{rest.length}</span>
                </button>
            ) : null}
            {showsMore.value ? rest.map((field) => <FieldRow key={field.path.join('/')} field={field} />) : null}
            {isSearch && shown.length + rest.length === 0 ? <p class="hint">No key has this word.</p> : null}
        </>
    );
}

/// The values of what is selected: all keys that it has or may have. Fills its parent.
export function Inspector() {
    const chosen = selection.value;
    return (
        <div class="inspector" role="region" aria-label="Values of the selection">
            {chosen === null
                ? <p class="hint">Select a ball, an event, a camera or another thing of the shot to see its values.</p>
                : (
                    <>
                        <header>
                            <h2 title={chosen.join(' › ')}>{titleOf(thingOf(chosen), shot.value)}</h2>
                            <label class="seek">
                                <Search size={13} aria-hidden="true" />
                                <input type="search" placeholder="Find a key" aria-label="Find a key"
                                    value={word.value}
                                    onInput={(event) => { word.value = event.currentTarget.value; }} />
                            </label>
                        </header>
                        <Values path={thingOf(chosen)} />
                    </>
                )}
        </div>
    );
}
