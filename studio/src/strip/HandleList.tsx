/// The strip's handles for the keyboard and screen readers: sliders that are not seen, in the order
/// of the canvas. One of them is reached by Tab; Page Up and Page Down go from one to the next.
import { signal } from '@preact/signals';
import { keyStep } from '../input/key_run';
import { selection } from '../state/state';
import { activeHandle, shownHandles } from './handles/all_handles';
import type { Handle } from './handles/handle';

const current = signal<string | null>(null); // the handle that Tab leads to

const kArrows: Record<string, readonly [number, number]> = {
    ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowDown: [0, -1], ArrowUp: [0, 1],
};

/// Moves a handle by steps of time and value.
function nudge(handle: Handle, [time, value]: readonly [number, number]): void {
    keyStep({
        id: `strip ${handle.id}`, label: `Move ${handle.label}`, isOfScene: true,
        start: [handle.time, handle.value ?? 0] as const,
        next: ([seconds, height]) =>
            [seconds + time * handle.step.time, height + value * handle.step.value] as const,
        changes: ([seconds, height]) => handle.change(seconds, height),
    });
}

function onKey(event: KeyboardEvent, handle: Handle): void {
    const arrow = kArrows[event.key];
    const page = { PageDown: 1, PageUp: -1 }[event.key];
    if (arrow && (arrow[0] !== 0 || handle.value !== null)) {
        const count = event.shiftKey ? 10 : 1;
        nudge(handle, [count * arrow[0], count * arrow[1]]);
    } else if (page) {
        const all = [...event.currentTarget instanceof Element
            ? event.currentTarget.parentElement?.querySelectorAll<HTMLElement>('[role=slider]') ?? [] : []];
        all[all.indexOf(event.currentTarget as HTMLElement) + page]?.focus();
    } else if ((event.key === 'Delete' || event.key === 'Backspace') && handle.remove) {
        handle.remove();
    } else {
        return;
    }
    event.preventDefault();
    event.stopPropagation();
}

export function HandleList() {
    const handles = shownHandles.value;
    const first = handles.find((handle) => handle.id === current.value) ?? handles[0];
    return (
        <div class="hidden" role="group" aria-label="Handles of the strip">
            {handles.map((handle) => (
                <div key={handle.id} role="slider" tabIndex={handle === first ? 0 : -1}
                    aria-label={handle.label} aria-valuetext={handle.text}
                    aria-valuenow={handle.value ?? handle.time} data-handle={handle.id}
                    onFocus={() => {
                        current.value = handle.id;
                        activeHandle.value = handle.id;
                        selection.value = handle.path;
                    }}
                    onBlur={() => { activeHandle.value = null; }}
                    onKeyDown={(event) => onKey(event, handle)} />
            ))}
        </div>
    );
}
