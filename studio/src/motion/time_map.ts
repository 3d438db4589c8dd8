/// A camera's map from film time to scene time, and back (pipeline/camera/time_map.cpp, in floating
/// point: the server's fractions are exact).
import type { Camera } from '../protocol';

/// An instant of the film: s, and the index of the camera that shows it.
export interface FilmInstant {
    time: number;
    camera: number;
}

/// The part of a change of speed that has happened at the fraction x of its duration.
function changed(x: number, smooth: boolean): number {
    return smooth ? x * x * (3 - 2 * x) : x;
}

/// Its integral from 0 to x.
function integrated(x: number, smooth: boolean): number {
    return smooth ? x * x * x * (1 - 0.5 * x) : 0.5 * x * x;
}

/// Seconds of scene time from the first speed key to a film time.
function elapsedTo(camera: Camera, time: number): number {
    const keys = camera.speeds;
    const first = keys[0];
    if (!first) {
        return 0;
    }
    if (time <= first.video_time) {
        return first.speed * (time - first.video_time);
    }
    let sum = 0;
    let before = first;
    for (const next of keys.slice(1)) {
        const span = next.video_time - before.video_time;
        const change = next.speed - before.speed;
        if (time < next.video_time) {
            const x = (time - before.video_time) / span;
            return sum + span * (before.speed * x + change * integrated(x, camera.smooth));
        }
        sum += span * (before.speed + 0.5 * change);
        before = next;
    }
    return sum + before.speed * (time - before.video_time);
}

/// The scene time at a film time; beyond the camera's ends the map continues.
export function sceneTimeAt(camera: Camera, filmTime: number): number {
    if (camera.speeds.length === 0) {
        return camera.scene_start + (filmTime - camera.video_start) * speedAt(camera, filmTime);
    }
    return camera.scene_start + elapsedTo(camera, filmTime)
        - elapsedTo(camera, camera.video_start);
}

/// Seconds of the scene per second of film; negative in reverse.
export function speedAt(camera: Camera, filmTime: number): number {
    const keys = camera.speeds;
    const first = keys[0];
    if (!first) {
        const duration = camera.video_end - camera.video_start;
        return duration > 0 ? (camera.scene_end - camera.scene_start) / duration : 0;
    }
    if (filmTime <= first.video_time) {
        return first.speed;
    }
    let before = first;
    for (const next of keys.slice(1)) {
        if (filmTime < next.video_time) {
            const x = (filmTime - before.video_time) / (next.video_time - before.video_time);
            return before.speed + (next.speed - before.speed) * changed(x, camera.smooth);
        }
        before = next;
    }
    return before.speed;
}

/// Film times that cut the camera's interval into pieces in which scene time does not turn round.
function monotonePieces(camera: Camera): number[] {
    const cuts = [camera.video_start, camera.video_end];
    camera.speeds.forEach((key, i) => {
        cuts.push(key.video_time);
        const next = camera.speeds[i + 1];
        if (next && key.speed * next.speed < 0) {
            cuts.push(bisect(key.video_time, next.video_time, (t) => speedAt(camera, t)));
        }
    });
    return cuts
        .filter((time) => time >= camera.video_start && time <= camera.video_end)
        .sort((a, b) => a - b);
}

/// Where a function that has different signs at both ends is 0.
function bisect(from: number, to: number, value: (t: number) => number): number {
    let low = from;
    let high = to;
    const rises = value(to) > value(from);
    for (let i = 0; i < 60; ++i) {
        const middle = 0.5 * (low + high);
        if (value(middle) < 0 === rises) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return 0.5 * (low + high);
}

const kSame = 1e-9; // s

/// All film times at which the camera shows a scene time. Of an interval in which scene time stands
/// still, the one nearest to `near`.
export function filmTimesAt(camera: Camera, sceneTime: number, near: number): number[] {
    const cuts = monotonePieces(camera);
    const found: number[] = [];
    const add = (time: number) => {
        if (!found.some((other) => Math.abs(other - time) < kSame)) {
            found.push(time);
        }
    };
    for (let i = 0; i + 1 < cuts.length; ++i) {
        const from = cuts[i] ?? 0;
        const to = cuts[i + 1] ?? 0;
        const offset = (time: number) => sceneTimeAt(camera, time) - sceneTime;
        const a = offset(from);
        const b = offset(to);
        if (Math.abs(a) < kSame && Math.abs(b) < kSame) {
            add(Math.min(Math.max(near, from), to));
        } else if (Math.abs(a) < kSame) {
            add(from);
        } else if (Math.abs(b) < kSame) {
            add(to);
        } else if (a < 0 !== b < 0) {
            add(bisect(from, to, offset));
        }
    }
    return found;
}

/// The index of the camera that is seen most at a film time: during a cross-fade the one with the
/// larger weight. Before the first camera it is the first, after the last one the last; -1 if there
/// is none.
export function cameraAt(cameras: readonly Camera[], filmTime: number): number {
    let index = cameras.length > 0 ? 0 : -1;
    cameras.forEach((camera, i) => {
        if (filmTime >= camera.video_start + camera.fade / 2) {
            index = i;
        }
    });
    return index;
}

/// All instants of the film that show a scene time, in the order of the cameras.
export function instantsAt(
    cameras: readonly Camera[], sceneTime: number, near: number,
): FilmInstant[] {
    return cameras.flatMap((camera, index) =>
        filmTimesAt(camera, sceneTime, near).map((time) => ({ time, camera: index })));
}

/// The instant of the film that is nearest to `near` among those that show a scene time. If none
/// does, the one that shows the nearest scene time; null without cameras.
export function nearestInstant(
    cameras: readonly Camera[], sceneTime: number, near: number,
): FilmInstant | null {
    const shown = instantsAt(cameras, sceneTime, near);
    const candidates = shown.length > 0 ? shown : cameras.flatMap((camera, index) =>
        monotonePieces(camera).map((time) => ({ time, camera: index })));
    const cost = (instant: FilmInstant): number => {
        const camera = cameras[instant.camera];
        const away = camera ? Math.abs(sceneTimeAt(camera, instant.time) - sceneTime) : 0;
        return shown.length > 0 ? Math.abs(instant.time - near) : away;
    };
    return candidates.reduce<FilmInstant | null>(
        (best, instant) => (best === null || cost(instant) < cost(best) ? instant : best), null);
}
