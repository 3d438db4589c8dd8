/// Which thing of the text a path belongs to.
import type { KeyPath } from '../protocol';

/// The thing as a whole: of a point of a camera's path the camera, of a value of a part of a film the
/// part. A section is shorter.
export function thingOf(path: KeyPath): KeyPath {
    return path.slice(0, path[0] === 'film' && path[1] === 'shots' ? 3 : 2);
}

/// Whether it is an item of a list or an entry of a section, which can be deleted and duplicated.
export function isThing(path: KeyPath | null): boolean {
    return (path?.length ?? 0) >= (path?.[0] === 'film' ? 3 : 2);
}
