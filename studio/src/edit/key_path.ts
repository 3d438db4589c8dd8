import type { KeyPath } from '../protocol';

/// Whether `prefix` is `path` or leads to something above it.
export function isPrefix(prefix: KeyPath, path: KeyPath): boolean {
    return prefix.length <= path.length && prefix.every((key, i) => key === path[i]);
}
