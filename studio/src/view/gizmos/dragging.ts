/// What all drags of gizmos share: the first pixels that do not count, one gesture, rays as tuples.
import { Vector3 } from 'three';
import { beginGesture, type Change, type EditResult, type Gesture } from '../../edit/edit';
import type { Triple } from '../../protocol';
import { add, scale, subtract } from '../../motion/vectors';
import { files, notice } from '../../state/state';
import type { Drag, Pixel, ViewContext } from '../parts';
import { heldAxis } from './held_axis';
import { kAxes } from './object_frame';
import { alongAxis, onPlane, type Ray } from './rays';

const kDragDistance = 3; // CSS pixels; a shorter way is a click

/// The ray through a pixel.
export function rayThrough(context: ViewContext, pixel: Pixel): Ray {
    const { origin, direction } = context.rayAt(pixel);
    return { origin: origin.toArray(), direction: direction.toArray() };
}

/// The direction in which the camera looks.
export function viewDirection(context: ViewContext): Triple {
    return context.camera().getWorldDirection(new Vector3()).toArray();
}

export interface EditDrag {
    label: string;
    /// The changes of the shot for the pointer's place; null: none.
    changes(event: PointerEvent): Change[] | null;
    /// After each move that changed something.
    after?(result: EditResult): void;
    /// At the end, whatever it is. `moved`: whether it was more than a click.
    ended?(moved: boolean): void;
}

type Keys = Pick<MouseEvent, 'shiftKey' | 'ctrlKey' | 'metaKey'>;

/// Whether a value of a file that the shot includes is changed there: with Ctrl and Shift.
export function isIntoInclude(event: Keys): boolean {
    return event.shiftKey && (event.ctrlKey || event.metaKey);
}

/// Shift alone: finer, or level.
export function hasShift(event: Keys): boolean {
    return event.shiftKey && !isIntoInclude(event);
}

/// Tells that an edit went to another file than the shot.
function tellFile({ ok, file }: EditResult): void {
    const [own, ...others] = files.peek();
    const name = others.find((one) => one.file === file && file !== own?.file)?.name;
    if (ok && name !== undefined) {
        notice.value = { kind: 'info', text: `This changes ${name}, which the shot includes.` };
    }
}

/// A drag that edits the shot.
export function editDrag(start: Pixel, drag: EditDrag): Drag {
    let gesture: Gesture | null = null;
    let toldFile = '';
    return {
        move: (event) => {
            const way = Math.hypot(event.clientX - start.clientX, event.clientY - start.clientY);
            const changes = gesture || way >= kDragDistance ? drag.changes(event) : null;
            if (changes) {
                gesture ??= beginGesture(true);
                const intoInclude = isIntoInclude(event);
                const result = gesture.update(changes.map((one) => ({ ...one, intoInclude })));
                if (result.file !== toldFile) {
                    toldFile = result.file;
                    tellFile(result);
                }
                drag.after?.(result);
            }
        },
        end: () => {
            gesture?.commit(drag.label);
            drag.ended?.(gesture !== null);
        },
        cancel: () => {
            gesture?.cancel();
            drag.ended?.(gesture !== null);
        },
    };
}

/// How a point follows the pointer.
export type Follow = 'level' | 'view';

/// A point that was taken at `start` follows the pointer: in the plane that the view shows, or in
/// its level plane; along an axis while x, y or z is held. `fine` moves a tenth. Null where it
/// cannot.
export function follower(context: ViewContext, point: Triple, start: Pixel) {
    const from = rayThrough(context, start);
    const normal = viewDirection(context);
    return (event: PointerEvent, way: Follow, isFine = false): Triple | null => {
        const to = rayThrough(context, event);
        const axis = heldAxis();
        let moved: Triple | null = null;
        if (axis !== null) {
            const direction = kAxes[axis] as Triple;
            const [a, b] = [alongAxis(from, point, direction), alongAxis(to, point, direction)];
            moved = a === null || b === null ? null : scale(b - a, direction);
        } else {
            const plane: Triple = way === 'level' ? [0, 0, 1] : normal;
            const [a, b] = [onPlane(from, point, plane), onPlane(to, point, plane)];
            moved = a && b ? subtract(b, a) : null;
        }
        return moved && add(point, scale(isFine ? 0.1 : 1, moved));
    };
}

/// Whether a place is within `pixels` of a pixel on the canvas.
export function isNear(context: ViewContext, place: Triple, pixel: Pixel, pixels: number): boolean {
    return pixelDistance(context, place, pixel) <= pixels;
}

/// The distance of a place from a pixel, CSS pixels; infinite behind the camera.
export function pixelDistance(context: ViewContext, place: Triple, pixel: Pixel): number {
    const seen = context.toScreen(place);
    const box = context.canvas.getBoundingClientRect();
    return seen ? Math.hypot(seen[0] + box.left - pixel.clientX, seen[1] + box.top - pixel.clientY)
        : Infinity;
}

/// How near a handle has to be: fingers are less exact than mice.
export function reachOf(event: Pixel & { pointerType?: string }): number {
    return event.pointerType === 'touch' ? 22 : 10;
}

/// The nearest of the handles within reach of the pointer; null without any.
export function nearestHandle<T extends { at: Triple }>(
    context: ViewContext, handles: readonly T[], event: Pixel & { pointerType?: string },
): T | null {
    let best: T | null = null;
    let least = reachOf(event);
    for (const handle of handles) {
        const distance = pixelDistance(context, handle.at, event);
        if (distance <= least) {
            [best, least] = [handle, distance];
        }
    }
    return best;
}
