/// What can be dragged on the strip, and which values of the shot a drag writes.
import type { Change } from '../edit/edit';
import type { Camera, KeyPath, ShotState } from '../protocol';
import { resolved, timeAt, xOf } from './axis';
import type { Layout } from './layout';

/// A place to drag: `changes` are the edits that bring it to a pointer's place.
export interface Handle {
    x: number;
    y: number;
    /// How far from it a pointer may be, px.
    width: number;
    height: number;
    label: string;
    path: KeyPath;
    changes(x: number, y: number): Change[];
}

/// A film time as a whole frame between two others, s.
function frameTime(time: number, fps: number, least: number, most: number): number {
    return Math.round(Math.min(Math.max(time, least), most) * fps) / fps;
}

/// The edits that let a camera begin at another film time: the one before ends when it has faded in.
export function startChanges(shot: ShotState, index: number, time: number): Change[] {
    const { fps } = shot.film;
    const camera = shot.cameras[index];
    const before = shot.cameras[index - 1];
    if (!camera) {
        return [];
    }
    const least = before ? before.video_start + 1 / fps : 0;
    const at = frameTime(time, fps, least, camera.video_end - camera.fade - 1 / fps);
    const precision = 1 / fps;
    const own = { path: [...camera.path, 'video', '0'], value: at, precision };
    return before
        ? [own, { path: [...before.path, 'video', '1'], value: at + camera.fade, precision }] : [own];
}

/// The edits that let the last camera end at another film time.
export function endChanges(shot: ShotState, camera: Camera, time: number): Change[] {
    const { fps } = shot.film;
    const at = frameTime(time, fps, camera.video_start + 1 / fps, 3600);
    return [{ path: [...camera.path, 'video', '1'], value: at, precision: 1 / fps }];
}

/// The edits that let a camera fade in until another film time.
export function fadeChanges(shot: ShotState, index: number, time: number): Change[] {
    const { fps } = shot.film;
    const camera = shot.cameras[index];
    const before = shot.cameras[index - 1];
    if (!camera || !before) {
        return [];
    }
    const end = frameTime(time, fps, camera.video_start, camera.video_end);
    const precision = 1 / fps;
    return [
        { path: [...camera.path, 'fade'], value: end - camera.video_start, precision },
        { path: [...before.path, 'video', '1'], value: end, precision },
    ];
}

/// Whether time stands still for a camera, so that `scene` is one time.
function standsStill(camera: Camera): boolean {
    return camera.speeds.length === 0 && camera.scene_start === camera.scene_end;
}

/// The key path of a camera's first (0) or last (1) scene time; null if a ramp decides it.
export function scenePath(camera: Camera, end: 0 | 1): KeyPath | null {
    if (camera.speeds.length > 0) {
        return end === 0 ? [...camera.path, 'scene', 'from'] : null;
    }
    return standsStill(camera) ? [...camera.path, 'scene'] : [...camera.path, 'scene', String(end)];
}

function clipHandles(layout: Layout, shot: ShotState): Handle[] {
    const { clips, film } = layout;
    const y = clips.y + clips.height / 2;
    return shot.cameras.flatMap((camera, index): Handle[] => {
        const at = (time: number, label: string, key: string, change: (x: number) => Change[],
            offset = 0): Handle => ({
            x: xOf(film, time), y: y + offset, width: 5, height: clips.height / 2 - Math.abs(offset),
            label, path: [...camera.path, key], changes: change,
        });
        const handles = [at(camera.video_start, `start of camera ${camera.name}`, 'video',
            (x) => startChanges(shot, index, timeAt(film, x)))];
        if (index === shot.cameras.length - 1) {
            handles.push(at(camera.video_end, `end of camera ${camera.name}`, 'video',
                (x) => endChanges(shot, camera, timeAt(film, x))));
        }
        if (camera.fade > 0) {
            handles.unshift(at(camera.video_start + camera.fade, `fade of camera ${camera.name}`,
                'fade', (x) => fadeChanges(shot, index, timeAt(film, x)), -clips.height / 4));
        }
        return handles;
    });
}

function mapHandles(layout: Layout, shot: ShotState): Handle[] {
    const { map, scene } = layout;
    return shot.cameras.flatMap((camera) => ([0, 1] as const).flatMap((end): Handle[] => {
        const path = scenePath(camera, end);
        const time = end === 0 ? camera.scene_start : camera.scene_end;
        return path === null ? [] : [{
            x: xOf(scene, time), y: map.y + map.height - 4, width: 6, height: 9, path,
            label: `scene time at the ${end === 0 ? 'start' : 'end'} of camera ${camera.name}`,
            changes: (x) => {
                const { time: value, step } = resolved(scene, Math.max(0, timeAt(scene, x)));
                return [{ path, value, precision: step }];
            },
        }];
    }));
}

function eventHandles(layout: Layout, shot: ShotState): Handle[] {
    const { events, scene } = layout;
    return shot.events.filter((event) => !event.triggered).map((event) => ({
        x: xOf(scene, event.time), y: events.y + 4, width: 6, height: 6,
        label: `time of the ${event.kind} of ${event.object}`, path: event.path,
        changes: (x) => {
            const { time: value, step } = resolved(scene, Math.max(0, timeAt(scene, x)));
            return [{ path: [...event.path, event.kind, 'at'], value, precision: step }];
        },
    }));
}

/// All handles of the strip; where several overlap the first one counts.
export function handlesOf(layout: Layout, shot: ShotState): Handle[] {
    return [
        ...eventHandles(layout, shot), ...mapHandles(layout, shot), ...clipHandles(layout, shot),
    ];
}

/// The handle under the pointer.
export function handleAt(handles: readonly Handle[], x: number, y: number): Handle | undefined {
    return handles.find((handle) =>
        Math.abs(x - handle.x) <= handle.width && Math.abs(y - handle.y) <= handle.height);
}
