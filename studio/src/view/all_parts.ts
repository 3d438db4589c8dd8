/// The parts of the view: one import and one entry each.
import { makeBallDrag } from './ball_drag';
import type { MakePart } from './parts';
import { makeTracedPicture } from './picture/traced_picture';
import { makeTrails } from './trails';

export const kAllParts: readonly MakePart[] = [
    makeTracedPicture,
    makeTrails,
    makeBallDrag,
];
