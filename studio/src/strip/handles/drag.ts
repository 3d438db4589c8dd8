/// A handle that is dragged: the way of the pointer becomes a time and a value.
import type { Change } from '../../edit/edit';
import { secondsPerPixel } from '../axis';
import type { CurveRow } from '../curve_row';
import type { Handle } from './handle';

const kDead = 5; // px: a direction counts only from here on, so that a drag can change one number

interface Place {
    x: number;
    y: number;
}

export interface HandleDrag {
    changes(at: Place): Change[];
    /// Whether anything was changed.
    moved(): boolean;
    /// What it is at now.
    text(): string;
}

/// The part of a way beyond the dead zone; `isFree` once the way was long enough.
function beyond(way: number, isFree: boolean): number {
    return isFree ? way : 0;
}

/// A drag of a handle that was grabbed at a place.
export function dragOf(handle: Handle, from: Place, row: CurveRow): HandleDrag {
    let isFreeX = handle.value === null;
    let isFreeY = false;
    let isMoved = false;
    let text = handle.text;
    return {
        changes: (at) => {
            const way = { x: at.x - from.x, y: at.y - from.y };
            isFreeX ||= Math.abs(way.x) > kDead;
            isFreeY ||= handle.value !== null && Math.abs(way.y) > kDead;
            isMoved ||= way.x !== 0 || way.y !== 0;
            const time = handle.time + beyond(way.x, isFreeX) * secondsPerPixel(handle.axis);
            const value = (handle.value ?? 0) - beyond(way.y, isFreeY) * row.perPixel;
            const changes = handle.change(time, value);
            text = `${handle.label}: ${changes.map((change) => valueText(change.value)).join(', ')}`;
            return changes;
        },
        moved: () => isMoved,
        text: () => text,
    };
}

function valueText(value: Change['value']): string {
    return typeof value === 'number' ? String(Number(value.toFixed(4)))
        : typeof value === 'object' && 'yaml' in value ? value.yaml : String(value);
}
