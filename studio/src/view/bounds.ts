/// The boxes around parts of the shot.
import type { ShotState, Triple } from '../protocol';
import type { Bounds } from './cameras';

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
