/// Points of camera paths that belong to an object become plain places.
import type { Change } from '../../edit/edit';
import { subtract } from '../../motion/vectors';
import type { Camera, PathPoint, PathShape, Triple } from '../../protocol';

/// Whether a point moves with the object that it belongs to, or is where that is at some time.
export function isDerived(point: PathPoint): boolean {
    return point.of !== '';
}

/// What puts a plain place where a point of an object is written. A camera that moves with an object
/// then stays at the place; an offset of the centre of an orbit is kept.
export function freePoint(
    camera: Camera, part: 'position' | 'target', point: PathPoint, to: Triple, precision: number,
): Change[] {
    const shape: PathShape = camera[part];
    const whole = [...camera.path, part];
    if (shape.kind === 'follow' || shape.kind === 'along') {
        return [{ path: whole, value: to, precision }];
    }
    if (shape.kind === 'orbit') {
        const isOffset = point.path[point.path.length - 1] === 'offset';
        return [{ path: [...whole, 'orbit'], value: isOffset ? subtract(to, point.offset) : to,
            precision }];
    }
    return [{ path: point.path, value: to, precision }];
}
