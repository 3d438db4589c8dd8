/// What the discs and the map of a strike share.
import { beginGesture, type Change } from '../edit/edit';
import { beginsDrag, dragFrom } from '../input/element_drag';

/// The ways of the arrow keys, to the right and up.
export const kArrows: Readonly<Record<string, readonly [number, number]>> = {
    ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1],
};

/// A drag on an element, from the press on: one step of undo.
export function dragOn(
    event: PointerEvent, label: string, changes: (element: Element, at: PointerEvent) => Change[],
): void {
    if (!beginsDrag(event)) {
        return;
    }
    const element = event.currentTarget as Element;
    const gesture = beginGesture(true);
    const follow = (at: PointerEvent) => { gesture.update(changes(element, at)); };
    follow(event);
    dragFrom(event, {
        move: follow,
        end: (isDone) => {
            if (isDone) {
                gesture.commit(label);
            } else {
                gesture.cancel();
            }
        },
    });
}
