/// The messages between the studio and its page. Lengths are in metres, times in seconds, angles in
/// radians; world axes have Z up. pipeline/studio/messages.h says what the fields mean. Generated
/// from pipeline/studio/message_fields.h by write_protocol.

export const kProtocol = 'carom-studio/1';
/// Bytes of the longest message that the page may send.
export const kLongestMessage = 4194304;

export type Triple = [number, number, number];
/// A unit quaternion, w first.
export type Turn = [number, number, number, number];
/// Keys from the top of the shot to a value; elements of lists by their index.
export type KeyPath = string[];

export interface Hello {
    protocol: string;
}

export interface TextChange {
    v: number;
    file: string;
    text: string;
    base: number;
}

export interface Save {
    file: string;
    text: string;
    base_hash: string;
    force: boolean;
}

export interface Revert {
    v: number;
    file: string;
}

export interface Open {
    file: string;
    from: string;
    text: string;
    overwrite: boolean;
}

export interface SaveAs {
    file: string;
    overwrite: boolean;
}

export interface ListFolder {
    folder: string;
}

export interface Offer {
}

export interface Forget {
    file: string;
}

export interface Import {
    name: string;
    text: string;
}

export interface ReadParts {
    file: string;
    text: string;
}

export interface PartName {
    section: string;
    name: string;
}

export interface AddParts {
    file: string;
    text: string;
    parts: PartName[];
}

export interface Fan {
    v: number;
    runs: number;
    distance: number;
    angle: number;
}

export interface Unfan {
}

export interface SolveShot {
    q: number;
    v: number;
    event: number;
    struck: string;
    ball: string;
    pocket: string;
    rest?: [number, number];
    within: number;
    seconds: number;
}

export interface Judge {
    q: number;
    v: number;
    event: number;
    wants_map: boolean;
    directions?: [number, number];
}

export interface Unsolve {
}

export interface Dragging {
    on: boolean;
}

export interface Recover {
    use: boolean;
}

export interface Simulate {
    v: number;
}

export interface FreeView {
    scene_time: number;
    position: Triple;
    target: Triple;
    up: Triple;
    fov: number;
    focus: number;
    lens_radius: number;
}

export interface See {
    q: number;
    v: number;
    frame?: number;
    view?: FreeView;
    width: number;
    height: number;
    samples: number;
    channel: string;
}

export interface Unsee {
}

export interface SeeAnnotations {
    q: number;
    v: number;
    view: FreeView;
    frame: number;
    video_time: number;
    playback_speed: number;
}

export interface StartFilm {
    output: string;
    quality: string;
    frames: string;
    size: number[];
    overwrite: boolean;
}

export interface StopFilm {
}

export interface Make {
    q: number;
    what: string;
    output: string;
    frame: number;
    rate: number;
    overwrite: boolean;
}

export interface StopMaking {
    q: number;
}

/// What the page sends, by the member "t".
export interface ToServer {
    hello: Hello;
    text: TextChange;
    save: Save;
    revert: Revert;
    open: Open;
    save_as: SaveAs;
    list: ListFolder;
    offer: Offer;
    forget: Forget;
    import: Import;
    read_parts: ReadParts;
    add_parts: AddParts;
    fan: Fan;
    unfan: Unfan;
    solve: SolveShot;
    judge: Judge;
    unsolve: Unsolve;
    dragging: Dragging;
    recover: Recover;
    simulate: Simulate;
    see: See;
    unsee: Unsee;
    see_annotations: SeeAnnotations;
    film: StartFilm;
    stop_film: StopFilm;
    make: Make;
    stop_making: StopMaking;
}

export interface Welcome {
    protocol: string;
    version: string;
    v: number;
    shot: string;
    root: string;
    output: string;
}

export interface StartFile {
    file: string;
    name: string;
    about: string;
    still: string;
}

export interface Start {
    templates: StartFile[];
    examples: StartFile[];
    recent: StartFile[];
}

export interface Exists {
    what: string;
    file: string;
    name: string;
}

export interface FolderEntry {
    name: string;
    file: string;
    is_folder: boolean;
}

export interface Folder {
    folder: string;
    name: string;
    parent: string;
    entries: FolderEntry[];
}

export interface Imported {
    name: string;
    yaml: string;
    problems: string[];
    notes: string[];
}

export interface Part {
    section: string;
    name: string;
    about: string;
    exists: boolean;
}

export interface Parts {
    file: string;
    parts: Part[];
}

export interface Addition {
    section: string;
    name: string;
    yaml: string;
    of: string;
}

export interface Additions {
    list: Addition[];
}

export interface OpenFile {
    file: string;
    name: string;
    text: string;
    hash: string;
    writable: boolean;
    changed: boolean;
}

export interface Files {
    v: number;
    files: OpenFile[];
}

export interface TextChanged {
    v: number;
    file: string;
    text: string;
    base: number;
}

export interface Saved {
    file: string;
    hash: string;
}

export interface DiskChanged {
    file: string;
    text: string;
    hash: string;
    gone: string;
    refused: boolean;
}

export interface RecoveredText {
    file: string;
    text: string;
    base_hash: string;
    hash: string;
}

export interface Recovered {
    files: RecoveredText[];
}

export interface Failed {
    what: string;
    v: number;
    message: string;
}

export interface TextRange {
    file: string;
    line: number;
    column: number;
    length: number;
}

export interface Problem {
    severity: string;
    place: TextRange;
    key_path: string;
    message: string;
    suggestion: string;
    included_by: TextRange[];
}

export interface Problems {
    v: number;
    complete: boolean;
    list: Problem[];
}

export interface Film {
    width: number;
    height: number;
    fps: number;
    frames: number;
    duration: number;
    samples: number;
}

export interface Table {
    length: number;
    width: number;
    cushion_height: number;
    ball_radius: number;
}

export interface CushionNose {
    from: [number, number];
    to: [number, number];
}

export interface TablePocket {
    name: string;
    place: [number, number];
    radius: number;
}

export interface SceneObject {
    name: string;
    kind: string;
    path: KeyPath;
    shape: string;
    moves: boolean;
    track?: string;
    position: Triple;
    orientation: Turn;
    radius: number;
    number?: number;
    colour: Triple;
    material: string;
}

export interface SceneLight {
    name: string;
    kind: string;
    path: KeyPath;
    position: Triple;
    facing: Triple;
    orientation: Turn;
    colour: Triple;
    size: number[];
}

export interface SpeedPoint {
    path: KeyPath;
    video_time: number;
    speed: number;
}

export interface Orbit {
    radii: [number, number];
    angles: [number, number];
    turn: Turn;
}

export interface PathPoint {
    path: KeyPath;
    position: Triple;
    of: string;
    at: number;
    offset: Triple;
}

export interface PathShape {
    kind: string;
    orbit?: Orbit;
    points: PathPoint[];
    curve: number[];
}

export interface LensKey {
    path: KeyPath;
    video_time: number;
}

export interface Camera {
    name: string;
    path: KeyPath;
    video_start: number;
    video_end: number;
    fade: number;
    scene_start: number;
    scene_end: number;
    speeds: SpeedPoint[];
    smooth: boolean;
    position: PathShape;
    target: PathShape;
    sensor_height: number;
    fov_scale: number;
    lens_keys: LensKey[];
}

export interface ShotEvent {
    path: KeyPath;
    kind: string;
    object: string;
    time: number;
    triggered: boolean;
    duration?: number;
    vector: Triple;
    speed: number;
    ball_speed: boolean;
    elevation: number;
    tip: [number, number];
    direction: number;
    toward: string;
}

export interface AnnotationEnd {
    time: number;
    is_scene_time: boolean;
    moment?: number;
}

export interface AnnotationBox {
    centre: [number, number];
    size: [number, number];
}

export interface ShotAnnotation {
    path: KeyPath;
    kind: string;
    subject: string;
    text: string;
    from?: AnnotationEnd;
    to?: AnnotationEnd;
    box?: AnnotationBox;
}

export interface Names {
    balls: string[];
    objects: string[];
    materials: string[];
    lights: string[];
    cameras: string[];
    surfaces: string[];
    spots: string[];
    pockets: string[];
}

export interface ValuePlace {
    path: KeyPath;
    key: TextRange;
    value: TextRange;
    origin: string;
}

export interface ShotState {
    v: number;
    moves: boolean;
    name: string;
    film: Film;
    table?: Table;
    noses: CushionNose[];
    pockets: TablePocket[];
    objects: SceneObject[];
    lights: SceneLight[];
    cameras: Camera[];
    events: ShotEvent[];
    annotations: ShotAnnotation[];
    names: Names;
    places: ValuePlace[];
}

export interface FilmPart {
    path: KeyPath;
    kind: string;
    file: string;
    name: string;
    start: number;
    frames: number;
    fade: number;
    first: number;
    of_frames: number;
}

export interface SequenceState {
    v: number;
    name: string;
    film: Film;
    parts: FilmPart[];
    places: ValuePlace[];
}

export interface SoundState {
    v: number;
    reason: string;
    address: string;
    rate: number;
    samples: number;
    piece: number;
    ready: number;
}

export interface SceneMeshes {
    v: number;
    hash: string;
}

export interface Work {
    what: string;
    v: number;
    fraction: number;
}

export interface Deferred {
    v: number;
    reason: string;
    message: string;
}

export interface FilmState {
    state: string;
    shot: string;
    output: string;
    width: number;
    height: number;
    fps: number;
    stage: string;
    fraction: number;
    frames: number;
    finished: number;
    reused: number;
    seconds: number;
    left: number;
    message: string;
    warnings: string[];
    address: string;
}

export interface FilmFrame {
    frame: number;
    reused: boolean;
    seconds: number;
    address: string;
}

export interface Making {
    q: number;
    stage: string;
    fraction: number;
}

export interface Made {
    q: number;
    v: number;
    what: string;
    address: string;
    file: string;
}

export interface Pot {
    ball: string;
    pocket: string;
}

export interface Judged {
    q: number;
    v: number;
    event: number;
    pots: Pot[];
    window: [number, number];
    direction: number;
    chance: number;
    chance_error: number;
}

export interface StrikeMap {
    q: number;
    v: number;
    event: number;
    pots: Pot[];
    directions: [number, number];
    speeds: [number, number];
    columns: number;
    rows: number;
    cells: string;
}

/// The texts that the server sends, by the member "t".
export interface ToPage {
    welcome: Welcome;
    start: Start;
    exists: Exists;
    folder: Folder;
    imported: Imported;
    parts: Parts;
    additions: Additions;
    files: Files;
    text_changed: TextChanged;
    saved: Saved;
    disk_changed: DiskChanged;
    recovered: Recovered;
    failed: Failed;
    problems: Problems;
    shot: ShotState;
    sequence: SequenceState;
    sound: SoundState;
    scene: SceneMeshes;
    work: Work;
    deferred: Deferred;
    film_state: FilmState;
    film_frame: FilmFrame;
    making: Making;
    made: Made;
    judged: Judged;
    strike_map: StrikeMap;
}

export interface TrackHead {
    name: string;
    first: number;
    keys: number;
}

export interface TimelineEvent {
    kind: string;
    time: number;
    end_time: number;
    a: string;
    b: string;
    place: Triple;
    impulse: number;
    text: string;
}

export interface TimelineHead {
    v: number;
    kept: boolean;
    start: number;
    end: number;
    tracks: TrackHead[];
    events: TimelineEvent[];
    energy: number[];
    milliseconds: number;
}
export const kTimelineType = 1;
export const kTimelineNumbersPerKey = 20;

export interface CamerasHead {
    v: number;
    entries: number;
}
export const kCamerasType = 2;
export const kCamerasNumbersPerFrame = 21;

export interface PictureHead {
    q: number;
    v: number;
    width: number;
    height: number;
    samples: number;
    of_samples: number;
    complete: boolean;
    stored: boolean;
    channel: string;
    legend: string;
}
export const kPictureType = 3;

export interface FanTrack {
    name: string;
    run: number;
    first: number;
    points: number;
}

export interface FanOutcome {
    kind: string;
    a: string;
    b: string;
    text: string;
    runs: number;
    first: number;
    last: number;
}

export interface FanHead {
    v: number;
    runs: number;
    finished: number;
    tracks: FanTrack[];
    outcomes: FanOutcome[];
}
export const kFanType = 4;
export const kFanNumbersPerPoint = 4;

export interface AnnotationLabel {
    text: string;
    font: string;
    line_height: number;
    letters: [number, number];
    margin: [number, number];
    offset: [number, number];
    is_above: boolean;
    nearer: number;
    box_colour: Triple;
    box_opacity: number;
}

export interface AnnotationShape {
    annotation: number;
    kind: string;
    first: number;
    points: number;
    colour: Triple;
    opacity: number;
    width: number;
    is_closed: boolean;
    has_round_ends: boolean;
    has_head: boolean;
    label?: AnnotationLabel;
}

export interface AnnotationsHead {
    q: number;
    v: number;
    shapes: AnnotationShape[];
}
export const kAnnotationsType = 5;
export const kAnnotationsNumbersPerPoint = 4;

export interface ShotSolution {
    route: string;
    pocket: string;
    is_solved: boolean;
    miss: number;
    chance: number;
    chance_error: number;
    window: number;
    direction: number;
    speed: number;
    is_ball_speed: boolean;
    elevation: number;
    tip: [number, number];
    rest?: [number, number];
}

export interface SolutionsHead {
    q: number;
    v: number;
    complete: boolean;
    message: string;
    time: number;
    solve_item: number;
    trials: number;
    milliseconds: number;
    solutions: ShotSolution[];
    tracks: FanTrack[];
}
export const kSolutionsType = 6;
export const kSolutionsNumbersPerPoint = 4;

/// The heads of the binary messages.
export interface BinaryToPage {
    timeline: TimelineHead;
    cameras: CamerasHead;
    picture: PictureHead;
    fan: FanHead;
    annotations: AnnotationsHead;
    solutions: SolutionsHead;
}

/// The names of the binary messages by their type.
export const kBinaryTypes: Record<number, keyof BinaryToPage> = {
    [kTimelineType]: 'timeline',
    [kCamerasType]: 'cameras',
    [kPictureType]: 'picture',
    [kFanType]: 'fan',
    [kAnnotationsType]: 'annotations',
    [kSolutionsType]: 'solutions',
};
