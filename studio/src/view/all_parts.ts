/// The parts of the view: one import and one entry each.
import { makeAnnotations } from './annotations';
import { makeBallDrag } from './ball_drag';
import { makeCameras } from './camera_gizmos/camera_part';
import { makeAimWindow } from './gizmos/aim_window';
import { makeArrows } from './gizmos/arrows';
import { makeEventPins } from './gizmos/event_pins';
import { makeFan } from './gizmos/fan';
import { makeMotionKeys } from './gizmos/motion_keys';
import { makeNudge } from './gizmos/nudge';
import { makeObjectBodies, makeObjectHandles } from './gizmos/objects';
import { makeProblemMarks } from './gizmos/problem_marks';
import { makeOutlines } from './outlines';
import { makeSolutions } from './gizmos/solutions';
import { makeStrike } from './gizmos/strike';
import { makeLights } from './light_gizmos/light_part';
import type { MakePart } from './parts';
import { makeTracedPicture } from './picture/traced_picture';
import { makeSceneAnnotations } from './scene_annotations/scene_annotations';
import { makeTrails } from './trails';

export const kAllParts: readonly MakePart[] = [
    makeTracedPicture,
    makeTrails,
    makeOutlines,
    makeAnnotations,
    makeSceneAnnotations,
    makeCameras,
    makeLights,
    makeBallDrag,
    makeNudge,
    makeProblemMarks,
    makeStrike,
    makeSolutions,
    makeAimWindow,
    makeArrows,
    makeEventPins,
    makeFan,
    makeMotionKeys,
    makeObjectHandles,
    makeObjectBodies,
];
