/// What the page knows, as signals. Nothing else holds state: the view, the strip, the outline and
/// the inspector read these and write through src/edit.
import { computed, signal } from '@preact/signals';
import type {
    AnnotationsHead, CamerasHead, Deferred, FanHead, Judged, KeyPath, OpenFile, PictureHead, Problems, SequenceState, ShotState, SolutionsHead, SoundState, Start, StrikeMap,
    TimelineHead, Triple, Welcome, Work,
} from '../protocol';

/// The motion of one version: `head` says where each track's numbers begin.
export interface Timeline {
    head: TimelineHead;
    numbers: Float64Array;
}

/// The cameras of all frames of the film: kCamerasNumbersPerFrame numbers for each entry.
export interface CameraFrames {
    head: CamerasHead;
    numbers: Float64Array;
}

/// The finished runs of a shot with small disturbances: kFanNumbersPerPoint numbers for each point.
export interface OutcomeFan {
    head: FanHead;
    numbers: Float64Array;
}

/// Strikes with the paths of what they move: kSolutionsNumbersPerPoint numbers for each point.
export interface Solutions {
    head: SolutionsHead;
    numbers: Float64Array;
}

/// The annotations in the scene at a time: kAnnotationsNumbersPerPoint numbers for each point.
export interface SceneAnnotations {
    head: AnnotationsHead;
    numbers: Float64Array;
}

/// A path-traced picture: red, green, blue and alpha of each pixel, from the upper left corner.
export interface Picture {
    head: PictureHead;
    pixels: Uint8ClampedArray<ArrayBuffer>;
}

/// 'refused': there is a server, but not the one that this page belongs to.
export type ConnectionState = 'connecting' | 'open' | 'lost' | 'refused';
export type Theme = 'dark' | 'light' | 'system';

export const connection = signal<ConnectionState>('connecting');
/// The file whose newest text is too long for the server; empty: none.
export const tooLongFile = signal('');
export const welcome = signal<Welcome | null>(null);
/// What the start page offers, as the server last told; null: it was not asked yet.
export const start = signal<Start | null>(null);
/// Whether no shot is open: the start page is shown.
export const isStarting = computed(() => welcome.value?.shot === '');
/// Where films and exports are written, as words of a sentence.
export const folderOfFiles = computed(() => welcome.value?.output || "the shot's folder");
/// The shot's file, first, and those that it includes, as the server last told.
export const files = signal<OpenFile[]>([]);
/// The newest version of the texts.
export const textVersion = signal(0);
/// Of the newest version without errors.
export const shot = signal<ShotState | null>(null);
/// The same of a film of several shots; then there is no shot.
export const sequence = signal<SequenceState | null>(null);
export const timeline = signal<Timeline | null>(null);
export const cameraFrames = signal<CameraFrames | null>(null);
/// Whether the open text is a film of several shots, also before the server has read it, and as long
/// as it has errors.
export const isSequence = computed(() => sequence.value !== null
    || (shot.value === null && /^film[ \t]*:/m.test(files.value[0]?.text ?? '')));

/// Size, rate and length of the film that is open.
export const openFilm = computed(() => sequence.value?.film ?? shot.value?.film ?? null);

/// The answer to the newest question how sure the outcome is; of an older version once the texts
/// changed.
export const fan = signal<OutcomeFan | null>(null);
/// Strikes that were found for what is sought.
export const solutions = signal<Solutions | null>(null);
/// What a strike pots as it is, and what comes of others like it.
export const judged = signal<Judged | null>(null);
export const strikeMap = signal<StrikeMap | null>(null);
/// The answer to the newest question what annotations in the scene look like.
export const sceneAnnotations = signal<SceneAnnotations | null>(null);
export const problems = signal<Problems | null>(null);
/// The newest round of the picture that was asked for.
export const picture = signal<Picture | null>(null);
/// The hash of /scene/HASH.glb, the meshes of the newest version.
export const meshes = signal<string | null>(null);
/// What of the film's sound can be got from the server, or why there is none.
export const soundState = signal<SoundState | null>(null);
export const work = signal<Work | null>(null);
/// The newest version that is not simulated, because it takes too long for every change.
export const deferred = signal<Deferred | null>(null);

/// Whether the newest texts wait to be simulated, by the end of a drag or by the user.
export const isDeferred = computed(() => {
    const v = deferred.value?.v ?? -1;
    return v >= textVersion.value && (timeline.value?.head.v ?? -1) < v;
});

/// Whether they wait for the user, because simulating them takes longer than happens by itself.
export const waitsForButton = computed(() =>
    isDeferred.value && deferred.value?.reason === 'limit');

/// Whether the newest texts have an error, as far as the server has answered.
export const hasErrors = computed(
    () => problems.value?.list.some((problem) => problem.severity === 'error') ?? false,
);

/// Whether the motion belongs to older texts: it is drawn greyed.
export const isStale = computed(() => hasErrors.value
    || (sequence.value?.v ?? timeline.value?.head.v ?? 0) < textVersion.value);

/// The key path of what is selected: ["balls", "cue"], ["cameras", "0", "position", "bezier", "1"].
export const selection = signal<KeyPath | null>(null);
export const hovered = signal<KeyPath | null>(null);

/// The play head, in seconds. Both clocks always agree: src/motion has the map between them.
export const filmTime = signal(0);
export const sceneTime = signal(0);
export const playing = signal(false);
/// The name of the camera that the view looks through, or kTheFilm; null: the free view.
export const lookThrough = signal<string | null>(null);
/// The value of `lookThrough` for the film: at each time the camera that the film shows.
export const kTheFilm = '(film)';

/// The view's own camera; null while the view looks through a camera of the shot.
export const freePose = signal<FreePose | null>(null);
/// Whether the pointer turns or moves the view's own camera.
export const viewMoving = signal(false);

export interface FreePose {
    position: Triple;
    target: Triple;
    up: Triple;
    fov: number; // rad, vertical; of an orthographic view 0
    height: number; // m, of what an orthographic view shows; else 0
    orthographic: boolean;
}

export const theme = signal<Theme>('system');
/// The open side panel.
export const panel = signal<string | null>(null);

/// Whether a text is under way to the server, or a newer one waits to be sent.
export const textUnderWay = signal(false);
/// Whether a picture was asked for and its last round has not come.
export const pictureAsked = signal(false);
/// Whether a drag is in progress that changes the texts: between beginGesture and its end.
export const dragging = signal(false);
/// A sentence about what just happened, for the status line; replaced by the next one.
export const notice = signal<Notice | null>(null);

export interface Notice {
    kind: 'info' | 'error';
    text: string;
}

/// Whether everything that was asked of the server is answered for the newest texts.
export const isIdle = computed(() => {
    if (isDeferred.value && !pictureAsked.value) {
        return true;
    }
    if (textUnderWay.value || pictureAsked.value || !problems.value?.complete) {
        return false;
    }
    const answered = problems.value.v >= textVersion.value;
    const shown = sequence.value?.v ?? timeline.value?.head.v ?? -1;
    return answered && (hasErrors.value || shown >= textVersion.value);
});
