/// Handles: places in the view that are dragged to change values of the text.
import type { Change } from '../../edit/edit';
import type { KeyPath, Triple } from '../../protocol';
import type { Dot, DotShape } from '../gizmos/figure';

/// Where a handle may be moved to: anywhere, along a line, or in a plane, both through its place.
export type HandleWay =
    | { kind: 'free' }
    | { kind: 'line'; along: Triple }
    | { kind: 'plane'; normal: Triple };

export interface Handle {
    /// Tells it from all others as long as the shot has it.
    key: string;
    at: Triple;
    /// What a press selects.
    path: KeyPath;
    /// "break: position 2", for the undo step and for the label beside it.
    label: string;
    shape: DotShape;
    colour: number;
    size: number;
    way: HandleWay;
    /// What to write for a place; lengths not finer than `precision`, m. `isFreed`: a place that belongs
    /// to an object becomes one of its own.
    changes(to: Triple, precision: number, isFreed: boolean): Change[];
}

const kSelected = 0xffffff;

/// How handles are drawn: larger under the pointer, white with a rim of their colour if selected.
export function handleDots(
    handles: readonly Handle[], hot: string | null, chosen: KeyPath | null,
): Dot[] {
    const name = chosen?.join('/');
    return handles.flatMap((handle) => {
        const { at, shape, colour } = handle;
        const size = handle.size + (handle.key === hot ? 4 : 0);
        const dot = { at, shape, colour, size };
        return handle.path.join('/') === name
            ? [{ ...dot, size: size + 6 }, { ...dot, colour: kSelected }] : [dot];
    });
}
