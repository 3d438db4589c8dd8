/// The motion of the newest version as signals, and the play head: both clocks always agree.
import { batch, computed } from '@preact/signals';
import {
    cameraFrames, filmTime, kTheFilm, lookThrough, openFilm, sceneTime, sequence, shot, timeline,
} from '../state/state';
import { CameraFramesOf } from './camera_frames';
import { cameraAt, nearestInstant, sceneTimeAt } from './time_map';
import { Track } from './track';

/// The tracks of the timeline by the names of their objects.
export const tracks = computed<ReadonlyMap<string, Track>>(() => {
    const motion = timeline.value;
    const heads = motion?.head.tracks ?? [];
    const numbers = motion?.numbers ?? new Float64Array();
    return new Map(heads.filter((head) => head.keys > 0)
        .map((head) => [head.name, new Track(head, numbers)]));
});

/// The planned frames of each camera of the shot.
export const framesOfCameras = computed<readonly CameraFramesOf[]>(() => {
    const frames = cameraFrames.value;
    const cameras = shot.value?.cameras ?? [];
    return frames ? cameras.map((_, index) => new CameraFramesOf(frames.numbers, index)) : [];
});

/// The index of the camera that the film shows at the play head; -1 without cameras.
export const filmCamera = computed(() => cameraAt(shot.value?.cameras ?? [], filmTime.value));

/// The index of the camera that the view looks through; -1 in the free view.
export const cameraLookedThrough = computed(() => {
    const name = lookThrough.value;
    return name === kTheFilm ? filmCamera.value
        : shot.value?.cameras.findIndex((camera) => camera.name === name) ?? -1;
});

/// The film's duration, s; without cameras that of the motion.
export const filmDuration = computed(() => {
    if (sequence.value) {
        return sequence.value.film.duration;
    }
    const cameras = shot.value?.cameras ?? [];
    const head = timeline.value?.head;
    return cameras.length > 0 ? Math.max(...cameras.map((camera) => camera.video_end))
        : head ? head.end - head.start : 0;
});

/// Puts the play head to a time of the film, within its ends, and the scene's clock with it.
export function goToFilmTime(time: number): void {
    const cameras = shot.peek()?.cameras ?? [];
    const clamped = Math.min(Math.max(time, 0), filmDuration.peek());
    const camera = cameras[cameraAt(cameras, clamped)];
    batch(() => {
        filmTime.value = clamped;
        sceneTime.value = camera ? sceneTimeAt(camera, clamped)
            : (timeline.peek()?.head.start ?? 0) + clamped;
    });
}

/// Puts the play head to a time of the scene, and the film's clock to the nearest instant from the
/// present one that shows it. If no camera does, to the one that shows the nearest scene time.
export function goToSceneTime(time: number): void {
    if (sequence.peek()) {  // has no scene of its own: its clock is that of the film
        goToFilmTime(time);
        return;
    }
    const cameras = shot.peek()?.cameras ?? [];
    const start = timeline.peek()?.head.start ?? 0;
    const end = timeline.peek()?.head.end ?? time;
    const clamped = Math.min(Math.max(time, start), Math.max(start, end));
    const instant = nearestInstant(cameras, clamped, filmTime.peek());
    batch(() => {
        sceneTime.value = clamped;
        filmTime.value = instant ? instant.time : clamped - start;
    });
}

/// Puts the play head to a frame of the film.
export function goToFrame(frame: number): void {
    goToFilmTime(frame / (openFilm.peek()?.fps ?? 24));
}
