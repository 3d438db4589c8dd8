/// What can be dragged on the strip: a point at a time, some also at a value, and the edits that
/// bring it elsewhere.
import type { Change } from '../../edit/edit';
import type { KeyPath } from '../../protocol';
import type { Axis } from '../axis';

export type Mark = 'none' | 'point' | 'fade' | 'start' | 'action' | 'tick';

export interface Handle {
    /// Tells it apart from all others of the strip, also after an edit.
    id: string;
    label: string;
    /// What a press selects.
    path: KeyPath;
    axis: Axis;
    time: number; // s, of the axis
    y: number; // px, where it is drawn
    value: number | null; // of the curve that it belongs to; null if it has only a time
    mark: Mark;
    colour: string; // a custom property of the page without its dashes: "accent", "clip-2"
    /// How far from it a pointer may be, px.
    reach: { x: number; y: number };
    /// What an arrow key adds.
    step: { time: number; value: number };
    /// What it says of itself, for tooltips and screen readers.
    text: string;
    change(time: number, value: number): Change[];
    /// Takes it away, if that is possible.
    remove?: () => void;
}

/// The frame nearest to a film time, between two other times.
export function frameNear(time: number, fps: number, least: number, most: number): number {
    const first = Math.ceil(least * fps - 1e-6);
    const last = Math.max(first, Math.floor(most * fps + 1e-6));
    return Math.min(Math.max(Math.round(time * fps), first), last);
}
