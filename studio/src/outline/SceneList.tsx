/// What the view shows, for screen readers and the keyboard: a list that is not seen. Page Up and Page
/// Down go from one thing to the next, Enter selects it; the arrow keys then move it.
import { signal } from '@preact/signals';
import { tracks } from '../motion/clock';
import type { SceneObject } from '../protocol';
import { hovered, playing, sceneTime, selection, shot } from '../state/state';

const current = signal('');

/// "ball cue at -0.75, 0.12, 0.03 m": where it is at the play head, or at the start while it plays.
function describe(object: SceneObject): string {
    const time = playing.value ? null : sceneTime.value;
    const [x, y, z] = time === null ? object.position
        : tracks.value.get(object.name)?.position(time) ?? object.position;
    const places = [x, y, z].map((one) => one.toFixed(2)).join(', ');
    return `${object.kind === 'ball' ? 'ball' : object.shape} ${object.name} at ${places} m`;
}

function onKey(event: KeyboardEvent): void {
    const page = { PageDown: 1, PageUp: -1 }[event.key];
    const list = (event.currentTarget as HTMLElement).closest('ul');
    if (page && list) {
        const all = [...list.querySelectorAll<HTMLElement>('button')];
        all[all.indexOf(event.target as HTMLElement) + page]?.focus();
        event.preventDefault();
        event.stopPropagation();
    }
}

export function SceneList() {
    const objects = shot.value?.objects ?? [];
    const reached = objects.find((one) => one.name === current.value) ?? objects[0];
    return (
        <ul class="hidden scene-list" aria-label="What the view shows">
            {objects.map((object) => (
                <li key={object.path.join('/')}>
                    <button type="button" data-scene-item={object.name} onKeyDown={onKey}
                        aria-pressed={selection.value?.join('/') === object.path.join('/')}
                        tabIndex={object === reached ? 0 : -1}
                        onFocus={() => { current.value = object.name; hovered.value = object.path; }}
                        onBlur={() => { hovered.value = null; }}
                        onClick={() => { selection.value = object.path; }}>
                        {describe(object)}
                    </button>
                </li>
            ))}
        </ul>
    );
}
