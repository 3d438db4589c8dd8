/// The boxes around parts of the shot.
import { Box3 } from 'three';
import type { Camera, KeyPath, ShotState, Triple } from '../protocol';
import type { Bounds } from './cameras';
import type { ViewContext } from './parts';

const kSpare = 0.15; // m around the places of the bodies: the table's frame

/// A box around all points, larger by `margin` on each side; null without points.
export function boxOf(points: readonly Triple[], margin = 0): Bounds | null {
    if (points.length === 0) {
        return null;
    }
    const along = (pick: (...values: number[]) => number, axis: 0 | 1 | 2, more: number) =>
        pick(...points.map((point) => point[axis])) + more;
    return {
        low: [along(Math.min, 0, -margin), along(Math.min, 1, -margin), along(Math.min, 2, -margin)],
        high: [along(Math.max, 0, margin), along(Math.max, 1, margin), along(Math.max, 2, margin)],
    };
}

/// Around the table, or around all bodies if the shot has none; a box of 3 m without a shot.
export function wholeScene(shot: ShotState | null): Bounds {
    const table = shot?.table;
    const corners: Triple[] = table
        ? [[-table.length / 2, -table.width / 2, 0], [table.length / 2, table.width / 2, 0]]
        : (shot?.objects ?? []).filter((one) => one.kind !== 'table').map((one) => one.position);
    return boxOf(corners, kSpare) ?? { low: [-1.5, -1.5, 0], high: [1.5, 1.5, 0] };
}

function triples(numbers: readonly number[]): Triple[] {
    return Array.from({ length: Math.floor(numbers.length / 3) }, (_, i) =>
        numbers.slice(3 * i, 3 * i + 3) as Triple);
}

/// The points of a camera's paths.
function pointsOfCamera({ position, target }: Camera): Triple[] {
    return [position, target].flatMap((path) =>
        [...triples(path.curve), ...path.points.map((point) => point.position)]);
}

function isBelow(path: KeyPath, above: KeyPath): boolean {
    return above.length <= path.length && above.every((key, i) => path[i] === key);
}

/// Around what a key path means: an object, a camera's paths or one point of them, a light, or the
/// object of an event; null if that is nowhere in space.
export function boundsOf(path: KeyPath, shot: ShotState, context: ViewContext): Bounds | null {
    const object = shot.objects.find((one) => isBelow(path, one.path))
        ?? shot.objects.find(({ name }) =>
            shot.events.some((event) => isBelow(path, event.path) && event.object === name));
    if (object) {
        const node = context.meshNode(object.name);
        const box = node && new Box3().setFromObject(node);
        return box && !box.isEmpty() ? { low: box.min.toArray(), high: box.max.toArray() }
            : boxOf([object.position], object.radius || kSpare);
    }
    const camera = shot.cameras.find((one) => isBelow(path, one.path));
    if (camera) {
        const own = [...camera.position.points, ...camera.target.points]
            .filter((point) => path.length > 2 && isBelow(point.path, path));
        return own.length > 0 ? boxOf(own.map((point) => point.position), kSpare)
            : boxOf(pointsOfCamera(camera), kSpare);
    }
    const light = shot.lights.find((one) => isBelow(path, one.path));
    return light && light.kind !== 'environment' && light.kind !== 'directional'
        ? boxOf([light.position], Math.max(kSpare, ...light.size) / 2 + kSpare) : null;
}
