/// The edges and fades of the cameras' clips, in whole frames of the film.
import type { Change } from '../../edit/edit';
import { clipColourName } from '../colours';
import type { Camera, ShotState } from '../../protocol';
import { filmClock } from '../clock_text';
import type { Layout } from '../layout';
import { frameTime, type Handle } from './handle';

const kLongest = 3600; // s

/// The edits that let a camera begin at another film time: the one before ends when it has faded in.
export function startChanges(shot: ShotState, index: number, time: number): Change[] {
    const { fps } = shot.film;
    const camera = shot.cameras[index];
    const before = shot.cameras[index - 1];
    if (!camera) {
        return [];
    }
    const least = before ? before.video_start + before.fade + 1 / fps : 0;
    const at = frameTime(time, fps, least, camera.video_end - camera.fade - 1 / fps);
    const precision = 1 / fps;
    const own = { path: [...camera.path, 'video', '0'], value: at, precision };
    return before
        ? [own, { path: [...before.path, 'video', '1'], value: at + camera.fade, precision }] : [own];
}

/// The edits that let the last camera end at another film time.
export function endChanges(shot: ShotState, camera: Camera, time: number): Change[] {
    const { fps } = shot.film;
    const at = frameTime(time, fps, camera.video_start + camera.fade + 1 / fps, kLongest);
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
    const next = shot.cameras[index + 1];
    const most = next ? next.video_start : camera.video_end;
    const end = frameTime(time, fps, camera.video_start, most);
    const precision = 1 / fps;
    return [
        { path: [...camera.path, 'fade'], value: end - camera.video_start, precision },
        { path: [...before.path, 'video', '1'], value: end, precision },
    ];
}

/// The handles of all clips. `selected` is the index of the selected camera: only there a fade that
/// does not exist yet can be drawn out.
export function clipHandles(layout: Layout, shot: ShotState, selected: number): Handle[] {
    const { clips, film } = layout;
    const middle = clips.y + clips.height / 2;
    const frame = 1 / shot.film.fps;
    return shot.cameras.flatMap((camera, index): Handle[] => {
        const common = { path: camera.path, axis: film, value: null, colour: clipColourName(index),
            step: { time: frame, value: 0 } };
        const edge = (end: 'start' | 'end', time: number, change: (time: number) => Change[]) => ({
            ...common, id: `${camera.path.join('/')} ${end}`, time, y: middle,
            mark: 'none' as const, reach: { x: 5, y: clips.height / 2 },
            label: `${end} of camera ${camera.name}`, text: filmClock(time), change,
        });
        const handles: Handle[] = [
            edge('start', camera.video_start, (time) => startChanges(shot, index, time))];
        if (index === shot.cameras.length - 1) {
            handles.push(edge('end', camera.video_end, (time) => endChanges(shot, camera, time)));
        }
        if (index > 0 && (camera.fade > 0 || index === selected)) {
            handles.unshift({
                ...common, id: `${camera.path.join('/')} fade`, time: camera.video_start + camera.fade,
                y: clips.y + 5, mark: 'fade', reach: { x: 7, y: 6 },
                label: `fade of camera ${camera.name}`,
                text: camera.fade > 0 ? `${camera.fade.toFixed(2)} s` : 'none',
                change: (time) => fadeChanges(shot, index, time),
            });
        }
        return handles;
    });
}
