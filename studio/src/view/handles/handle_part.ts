/// What all parts with handles share: which one the pointer is over, which one is dragged.
import { computed, signal, type ReadonlySignal } from '@preact/signals';
import { selection } from '../../state/state';
import { nearestHandle } from '../gizmos/dragging';
import type { Figure } from '../gizmos/figure';
import type { Drag, Pixel, ViewContext } from '../parts';
import { dragHandle } from './drag_handle';
import { handleDots, type Handle } from './handle';
import type { KeyPath, Triple } from '../../protocol';

export interface HandleSet {
    /// The handles with the dragged one at the pointer.
    readonly shown: ReadonlySignal<readonly Handle[]>;
    figure(): Figure;
    at(event: PointerEvent): Handle | null;
    grab(event: PointerEvent): Drag | null;
    hover(event: PointerEvent): string | null;
    pick(pixel: Pixel): KeyPath | null;
}

/// Handles that follow a signal.
export function handleSet(
    handles: ReadonlySignal<readonly Handle[]>, context: ViewContext,
): HandleSet {
    const hot = signal<string | null>(null);
    const dragged = signal<{ key: string; at: Triple } | null>(null);
    const shown = computed(() => {
        const moved = dragged.value;
        return moved === null ? handles.value
            : handles.value.map((one) => one.key === moved.key ? { ...one, at: moved.at } : one);
    });
    const at = (event: PointerEvent) => nearestHandle(context, shown.peek(), event);
    return {
        shown,
        at,
        figure: () => {
            const name = dragged.value?.key ?? hot.value;
            const named = shown.value.find((one) => one.key === name);
            return {
                dots: handleDots(shown.value, name, selection.value),
                labels: named ? [{ at: named.at, text: named.label }] : [],
            };
        },
        grab: (event) => {
            const handle = at(event);
            if (!handle) {
                return null;
            }
            selection.value = handle.path;
            hot.value = handle.key;
            return dragHandle(handle, event, context, (place) => {
                dragged.value = place && { key: handle.key, at: place };
            });
        },
        pick: (pixel) => nearestHandle(context, shown.peek(), pixel)?.path ?? null,
        hover: (event) => {
            const handle = at(event);
            hot.value = handle?.key ?? null;
            return handle ? 'grab' : null;
        },
    };
}
