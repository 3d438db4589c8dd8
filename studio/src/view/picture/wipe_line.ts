/// The line between the kept and the newest picture, which is dragged in the view.
import type { Rectangle } from '../letterbox';
import type { Drag, ViewContext } from '../parts';
import { keptPicture, shownPicture, wipe } from './picture_state';

const kReach = 6; // CSS pixels

/// The place of a pixel as a fraction of the picture's width.
function fractionAt(event: MouseEvent, { canvas }: ViewContext, box: Rectangle): number {
    return (event.clientX - canvas.getBoundingClientRect().left - box.left) / box.width;
}

export function isOnLine(event: MouseEvent, context: ViewContext, box: Rectangle): boolean {
    return keptPicture.peek() !== null && shownPicture.peek() !== null
        && Math.abs(fractionAt(event, context, box) - wipe.peek()) * box.width <= kReach;
}

/// A drag of the line; Escape puts it back.
export function dragLine(context: ViewContext, box: Rectangle): Drag {
    const before = wipe.peek();
    const move = (event: PointerEvent) => {
        wipe.value = Math.min(1, Math.max(0, fractionAt(event, context, box)));
    };
    return { move, end: () => {}, cancel: () => { wipe.value = before; } };
}
