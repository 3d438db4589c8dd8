/// Values of the lens that change during a camera: which end a drag writes.
import { sourceOf } from '../../edit/edit';
import type { KeyPath } from '../../protocol';

/// A value at the start and end of a camera's interval, and now.
export interface EasedValue {
    start: number;
    end: number;
    now: number;
    /// Of the interval that has passed, 0 to 1.
    progress: number;
}

/// The share that the value at the end has in the present one.
function shareOfEnd({ start, end, now, progress }: EasedValue): number {
    const difference = end - start;
    return Math.abs(difference) > 1e-9 ? Math.min(1, Math.max(0, (now - start) / difference))
        : progress;
}

/// The key to write, and its value, so that the value now becomes `wanted`: the end with the larger
/// share is changed.
export function easedChange(
    path: KeyPath, value: EasedValue, wanted: number,
): { path: KeyPath; value: number } {
    const kind = sourceOf(path)?.kind ?? 'scalar';
    if (kind === 'scalar') {
        return { path, value: wanted };
    }
    const share = shareOfEnd(value);
    const isEnd = share >= 0.5;
    const key = kind === 'list' ? (isEnd ? '1' : '0') : isEnd ? 'to' : 'from';
    const changed = isEnd ? (wanted - (1 - share) * value.start) / share
        : (wanted - share * value.end) / (1 - share);
    return { path: [...path, key], value: changed };
}
