/// All that the strip shows, and how things are drawn on it.
import type { CameraFramesOf } from '../../motion/camera_frames';
import type { Film, SequenceState, ShotState, TimelineEvent } from '../../protocol';
import type { SoundData } from '../../sound/sound_data';
import type { BallSpeeds } from '../ball_speeds';
import type { Colours } from '../colours';
import type { CurvePoint, CurveScale } from '../curves';
import type { Handle } from '../handles/handle';
import type { Layout } from '../layout';
import type { CurveName } from '../strip_state';

export interface StripPicture {
    layout: Layout;
    colours: Colours;
    film: Film | null;
    isSequence: boolean; // also while it has errors
    sequence: SequenceState | null;
    shownPart: number; // index of the part of the sequence at the play head, or -1
    shot: ShotState | null;
    frames: readonly CameraFramesOf[];
    events: readonly TimelineEvent[];
    energy: readonly number[];
    balls: readonly BallSpeeds[];
    fastest: number; // m/s
    curve: CurveName;
    curves: readonly (readonly CurvePoint[])[]; // of each camera
    curveScale: CurveScale;
    curveCamera: number; // index of the camera whose curve can be dragged, or -1
    selected: number; // index of the selected camera, or -1
    selectedPath: string; // joined with "/"
    handles: readonly Handle[];
    activeHandle: string | null;
    thumbnails: ReadonlyMap<number, string>;
    sound: SoundData | null;
    isSoundStale: boolean; // of an older version than the motion
    isStale: boolean;
}

export type Pen = CanvasRenderingContext2D;
