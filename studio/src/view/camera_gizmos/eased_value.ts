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

/// The key of the end that a drag writes: that with the larger share, or the value itself.
export function easedPath(path: KeyPath, value: EasedValue): KeyPath {
    const kind = sourceOf(path)?.kind ?? 'scalar';
    const isEnd = shareOfEnd(value) >= 0.5;
    return kind === 'scalar' ? path
        : [...path, kind === 'list' ? (isEnd ? '1' : '0') : isEnd ? 'to' : 'from'];
}

/// The key to write, and its value, so that the value now becomes `wanted`: the end with the larger
/// share is changed.
export function easedChange(
    path: KeyPath, value: EasedValue, wanted: number,
): { path: KeyPath; value: number } {
    const key = easedPath(path, value);
    if (key.length === path.length) {
        return { path, value: wanted };
    }
    const share = shareOfEnd(value);
    const changed = share >= 0.5 ? (wanted - (1 - share) * value.start) / share
        : (wanted - share * value.end) / (1 - share);
    return { path: key, value: changed };
}
