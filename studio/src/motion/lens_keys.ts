/// The keys of the values of a camera's lens.
import type { KeyPath, LensKey } from '../protocol';

/// Those of the value at `path`, in their order.
export function keysOf(keys: readonly LensKey[], path: KeyPath): LensKey[] {
    return keys.filter((key) => path.every((step, i) => key.path[i] === step));
}
