/// Numbers that are changed by dragging their name to the left and right: one step of undo a drag.
import { beginGesture, type Gesture } from '../edit/edit';
import { dragFrom } from '../input/element_drag';
import type { KeyPath } from '../protocol';
import { stepped, type Steppable } from './number_text';

const kPixels = 3; // of a step
const kStart = 3; // px before a press becomes a drag

/// What a modifier makes of a step: shift for larger ones, alt for finer ones.
export function fineness(event: { shiftKey: boolean; altKey: boolean }): number {
    return event.shiftKey ? 10 : event.altKey ? 0.1 : 1;
}

/// Starts to drag a number from a press on its name; `onClick` is called if it was no drag.
export function dragNumber(
    event: PointerEvent, path: KeyPath, from: Steppable | null, onClick: () => void,
): void {
    const start = event.clientX;
    let gesture: Gesture | null = null;
    dragFrom(event, {
        move: (move) => {
            const way = move.clientX - start;
            if (from && (gesture || Math.abs(way) > kStart)) {
                gesture ??= beginGesture();
                gesture.update([stepped(path, from, Math.round(way / kPixels), fineness(move))]);
            }
        },
        end: (isDone) => {
            if (!isDone) {
                gesture?.cancel();
            } else if (gesture) {
                gesture.commit(`Change ${path[path.length - 1]}`);
            } else {
                onClick();
            }
        },
    });
}
