/// A click on the canvas selects what is there, a double click traces the picture.
import type { KeyPath } from '../protocol';
import { runCommand } from '../state/keys';
import { selection } from '../state/state';
import type { Pixel, ViewPart } from './parts';
import { isHandleAt } from './pointer';

const kClickDistance = 4; // CSS pixels; a longer way is a drag

/// Selects what `at` returns for a click that no part of the view took. Returns a function that ends
/// this.
export function selectByClick(
    canvas: HTMLCanvasElement, at: (pixel: Pixel) => KeyPath | null,
): () => void {
    let start: Pixel | null = null;
    const down = (event: PointerEvent) => {
        start = event.button === 0 ? { clientX: event.clientX, clientY: event.clientY } : null;
    };
    const up = (event: PointerEvent) => {
        const way = start
            ? Math.hypot(event.clientX - start.clientX, event.clientY - start.clientY) : Infinity;
        if (way < kClickDistance) {
            selection.value = at(event);
        }
        start = null;
    };
    canvas.addEventListener('pointerdown', down);
    canvas.addEventListener('pointerup', up);
    return () => {
        canvas.removeEventListener('pointerdown', down);
        canvas.removeEventListener('pointerup', up);
    };
}

/// What the first part that has something at a pixel would select.
export function pickedBy(parts: readonly ViewPart[], pixel: Pixel): KeyPath | null {
    for (const part of [...parts].sort((a, b) => b.priority - a.priority)) {
        const path = part.pick?.(pixel) ?? null;
        if (path) {
            return path;
        }
    }
    return null;
}

/// A double click shows the traced picture as R does, unless it meets a handle.
export function traceByDoubleClick(canvas: HTMLCanvasElement, parts: readonly ViewPart[]): () => void {
    const listener = (event: MouseEvent) => {
        if (!isHandleAt(parts, event)) {
            runCommand('refine');
        }
    };
    canvas.addEventListener('dblclick', listener);
    return () => canvas.removeEventListener('dblclick', listener);
}
