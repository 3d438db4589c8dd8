/// The parts of the view: one import and one entry each.
import { makeBallDrag } from './ball_drag';
import type { MakePart } from './parts';
import { makeTrails } from './trails';

export const kAllParts: readonly MakePart[] = [
    makeTrails,
    makeBallDrag,
];
