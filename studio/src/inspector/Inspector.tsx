import { applyChanges, sourceOf } from '../edit/edit';
import type { KeyPath, ValuePlace } from '../protocol';
import { selection, shot } from '../state/state';
import { showRange } from '../text/show';
import './inspector.css';

/// The values below the selection that stand alone: not maps, nor lists of maps.
function valuesOf(chosen: KeyPath): ValuePlace[] {
    const places = shot.value?.places ?? [];
    const isBelow = (path: KeyPath, above: KeyPath) =>
        path.length > above.length && above.every((key, i) => path[i] === key);
    return places.filter(({ path }) => isBelow(path, chosen)
        && !places.some((other) => isBelow(other.path, path)));
}

/// Writes what was typed; numbers as numbers, so that they keep the unit of the text.
function write(path: KeyPath, text: string): void {
    const number = Number(text);
    const isNumber = text.trim() !== '' && Number.isFinite(number);
    applyChanges([{ path, value: isNumber ? number : text.trim() }], `Set ${path.join('.')}`);
}

function Field({ place, above }: { place: ValuePlace; above: number }) {
    const source = sourceOf(place.path);
    const name = place.path.slice(above).join('.');
    const canWrite = place.origin === 'shot' || place.origin === 'include';
    const text = source?.text ?? '';
    return (
        <label class="field">
            <button class="origin" type="button" title="Show in the text"
                onClick={() => showRange(place.value)}>{name}</button>
            {source?.kind === 'scalar' && canWrite
                ? (
                    <input value={text} aria-label={name} spellcheck={false}
                        onChange={(event) => {
                            const typed = event.currentTarget.value;
                            if (typed !== text) {
                                write(place.path, typed);
                            }
                        }} />
                )
                : <output aria-label={name}>{text}</output>}
        </label>
    );
}

/// The values of what is selected, as the text has them. Fills its parent.
export function Inspector() {
    const chosen = selection.value;
    const values = chosen ? valuesOf(chosen) : [];
    return (
        <div class="inspector" role="region" aria-label="Values of the selection">
            {chosen === null ? <p class="hint">Select a ball, an event or a camera to see its values.</p>
                : <h2>{chosen.join(' › ')}</h2>}
            {chosen !== null && values.length === 0
                ? <p class="hint">The text says nothing about it: all its values are defaults.</p> : null}
            {values.map((place) => (
                <Field key={place.path.join('/')} place={place} above={chosen?.length ?? 0} />
            ))}
        </div>
    );
}
