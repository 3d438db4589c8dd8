/// Dragging a handle: one gesture of edits.
import { add, scale, subtract } from '../../motion/vectors';
import type { Triple } from '../../protocol';
import { editDrag, follower, hasShift, rayThrough } from '../gizmos/dragging';
import { alongAxis, onPlane, stepOf } from '../gizmos/rays';
import type { Drag, Pixel, ViewContext } from '../parts';
import type { Handle } from './handle';

const kFinest = 1e-5; // m
const kCoarsest = 1e-3;

/// The step of lengths that the view resolves at a place: at most half a pixel, a power of ten.
export function precisionAt(context: ViewContext, at: Triple): number {
    return stepOf(0.5 * context.metresPerPixel(at), kFinest, kCoarsest);
}

/// Returns where a handle is for a place of the pointer, so that it keeps its distance from it.
function placeFor(handle: Handle, start: Pixel, context: ViewContext) {
    const from = rayThrough(context, start);
    const free = follower(context, handle.at, start);
    return (event: PointerEvent): Triple | null => {
        const { way, at } = handle;
        const to = rayThrough(context, event);
        if (way.kind === 'line') {
            const [a, b] = [alongAxis(from, at, way.along), alongAxis(to, at, way.along)];
            return a === null || b === null ? null : add(at, scale(b - a, way.along));
        }
        if (way.kind === 'plane') {
            const [a, b] = [onPlane(from, at, way.normal), onPlane(to, at, way.normal)];
            return a && b && add(at, subtract(b, a));
        }
        return free(event, hasShift(event) ? 'level' : 'view');
    };
}

/// `moved` is called with the handle's place for the pointer, and with null at the end.
export function dragHandle(
    handle: Handle, start: PointerEvent, context: ViewContext, moved: (at: Triple | null) => void,
): Drag {
    const place = placeFor(handle, start, context);
    const precision = precisionAt(context, handle.at);
    return editDrag(start, {
        label: `Move ${handle.label}`,
        changes: (event) => {
            const at = place(event);
            moved(at ?? handle.at);
            return at && handle.changes(at, precision, event.altKey);
        },
        ended: () => moved(null),
    });
}
