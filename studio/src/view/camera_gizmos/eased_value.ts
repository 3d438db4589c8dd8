/// Values of the lens that change during a camera: which of the written values a drag changes.
import { parseQuantity } from '../../edit/quantity';
import { sourceOf } from '../../edit/edit';
import type { KeyPath, LensKey } from '../../protocol';

/// A value at the start and end of a camera's interval, and now.
export interface EasedValue {
    start: number;
    end: number;
    now: number;
    /// Of the interval that has passed, 0 to 1.
    progress: number;
    /// The keys of the value, if it is given by keys, and the time of the film now.
    keys: readonly LensKey[];
    time: number;
}

/// The two written values between which the value is now; the second is null if there is only one.
interface Ends extends Pick<EasedValue, 'start' | 'end' | 'now' | 'progress'> {
    from: KeyPath;
    to: KeyPath | null;
}

/// The value of a key, if it is a number.
function numberOf(path: KeyPath): number {
    const source = sourceOf(path);
    return source?.kind === 'scalar' ? parseQuantity(source.text)?.value ?? NaN : NaN;
}

function endsAtKeys(value: EasedValue): Ends {
    const { keys, time, now } = value;
    const next = keys.findIndex((key) => time < key.video_time);
    const [a, b] = [keys[next - 1], keys[next]];
    const path = (key: LensKey | undefined) => [...(key?.path ?? []), '1'];
    if (!a || !b) {
        return { from: path(next === 0 ? b : keys[keys.length - 1]), to: null, start: now, end: now,
            now, progress: 0 };
    }
    const progress = (time - a.video_time) / (b.video_time - a.video_time);
    const [start, end] = [numberOf(path(a)), numberOf(path(b))];
    const known = Number.isFinite(start) && Number.isFinite(end);
    return { from: path(a), to: path(b), start: known ? start : now, end: known ? end : now, now,
        progress };
}

function endsOf(path: KeyPath, value: EasedValue): Ends {
    if (value.keys.length > 0) {
        return endsAtKeys(value);
    }
    const kind = sourceOf(path)?.kind ?? 'scalar';
    return kind === 'scalar' ? { ...value, from: path, to: null }
        : { ...value, from: [...path, kind === 'list' ? '0' : 'from'],
            to: [...path, kind === 'list' ? '1' : 'to'] };
}

/// The share that the second value has in the present one.
function shareOfEnd({ start, end, now, progress }: Ends): number {
    const difference = end - start;
    return Math.abs(difference) > 1e-9 ? Math.min(1, Math.max(0, (now - start) / difference))
        : progress;
}

/// The key of the value that a drag writes: of two, that with the larger share.
export function easedPath(path: KeyPath, value: EasedValue): KeyPath {
    const ends = endsOf(path, value);
    return ends.to && shareOfEnd(ends) >= 0.5 ? ends.to : ends.from;
}

/// The key to write, and its value, so that the value now becomes `wanted`: of two, the one with the
/// larger share is changed.
export function easedChange(
    path: KeyPath, value: EasedValue, wanted: number,
): { path: KeyPath; value: number } {
    const ends = endsOf(path, value);
    if (!ends.to) {
        return { path: ends.from, value: wanted };
    }
    const share = shareOfEnd(ends);
    return share >= 0.5 ? { path: ends.to, value: (wanted - (1 - share) * ends.start) / share }
        : { path: ends.from, value: (wanted - share * ends.end) / (1 - share) };
}
