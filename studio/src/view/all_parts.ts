/// The parts of the view: one import and one entry each.
import { makeBallDrag } from './ball_drag';
import { makeNudge } from './gizmos/nudge';
import { makeProblemMarks } from './gizmos/problem_marks';
import { makeOutlines } from './outlines';
import type { MakePart } from './parts';
import { makeTracedPicture } from './picture/traced_picture';
import { makeTrails } from './trails';

export const kAllParts: readonly MakePart[] = [
    makeTracedPicture,
    makeTrails,
    makeOutlines,
    makeBallDrag,
    makeNudge,
    makeProblemMarks,
];
