/// Dragging a handle: one gesture of edits.
import { applyChanges, type Change, type EditResult } from '../../edit/edit';
import { add, scale, subtract } from '../../motion/vectors';
import type { Triple } from '../../protocol';
import { editDrag, follower, rayThrough } from '../gizmos/dragging';
import { alongAxis, onPlane, stepOf } from '../gizmos/rays';
import { openMenu } from '../menu/menu_state';
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
        return free(event, event.shiftKey ? 'level' : 'view');
    };
}

/// Asks what an edit that could mean several things shall do, and does it.
function askChoices(result: EditResult, changes: Change[], label: string, at: Pixel): void {
    openMenu({
        title: result.message, x: at.clientX, y: at.clientY,
        items: () => result.choices.map((choice) => ({
            label: choice.label,
            run: () => {
                choice.apply();
                applyChanges(changes, label);
            },
        })),
    });
}

/// `moved` is called with the handle's place for the pointer, and with null at the end.
export function dragHandle(
    handle: Handle, start: PointerEvent, context: ViewContext, moved: (at: Triple | null) => void,
): Drag {
    const place = placeFor(handle, start, context);
    const precision = precisionAt(context, handle.at);
    let last: Change[] = [];
    let pixel: Pixel = start;
    let result: EditResult | null = null;
    return editDrag(start, {
        label: `Move ${handle.label}`,
        changes: (event) => {
            const at = place(event);
            if (!at) {
                return null;
            }
            pixel = { clientX: event.clientX, clientY: event.clientY };
            moved(at);
            last = handle.changes(at, precision);
            return last;
        },
        after: (one) => { result = one; },
        ended: () => {
            moved(null);
            if (result && !result.ok && result.choices.length > 0) {
                askChoices(result, last, handle.label, pixel);
            }
        },
    });
}
