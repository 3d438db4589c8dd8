/// What `carom farm list --json` and `carom farm frames --json` print, which the server of `carom
/// farm watch` passes on. Times are in seconds, sizes in bytes; docs/farm.md says what they mean.

export interface Job {
    id: string;
    folder: string;
    owner: string;
    film: string;
    state: 'waiting' | 'running' | 'complete' | 'stopped' | 'failed' | 'unreadable';
    message: string;
    frames: number;
    finished: number;
    seconds_left?: number;
}

export type FrameState = 'done' | 'rendering' | 'failed' | 'missing' | 'skipped';

export interface FrameRow {
    frame: number;
    state: FrameState;
    fraction?: number;
    node?: string;
    worker?: string;
    seconds?: number;
    slow?: 0 | 1; // 1: it took more than twice the median
    memory_bytes?: number;
    tries: number;
    failures: number;
    ended?: number;
    log?: string;
    problem?: string;
}

export interface NodeRow {
    node: string;
    workers: number;
    rendered: number;
    failures: number;
    frames_per_hour?: number;
}

export interface JobList {
    store: string;
    jobs: Job[];
}

/// A job with its frames.
export interface JobFrames extends Omit<Job, 'owner'> {
    median_seconds: number; // of a frame; 0: none has been timed
    rows: FrameRow[];
    nodes: NodeRow[];
}

/// What the server sends, by the member "t".
export type Message =
    | { t: 'list'; data: JobList } | { t: 'list'; problem: string }
    | { t: 'frames'; job: string; sheet: number; data: JobFrames } | { t: 'frames'; job: string; problem: string }
    | { t: 'sheet'; job: string; number: number }; // the newest contact sheet of the job; 0: none yet
