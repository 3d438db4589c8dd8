/// Where the parts of a film of several shots are on the strip.
import type { FilmPart } from '../protocol';
import { partAt } from '../sequence/parts';
import { openFilm, sequence } from '../state/state';
import { timeAt } from './axis';
import { isIn, laneOf, type Layout } from './layout';

/// The part whose box is at a place.
export function partUnder(layout: Layout, { x, y }: { x: number; y: number }): FilmPart | undefined {
    const parts = sequence.peek()?.parts ?? [];
    const frame = Math.floor(timeAt(layout.film, x) * (openFilm.peek()?.fps ?? 24) + 1e-6);
    return parts.find((part, i) => partAt([part], frame) === 0 && isIn(laneOf(layout.clips, i), y));
}
