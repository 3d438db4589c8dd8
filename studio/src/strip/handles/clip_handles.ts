/// The edges and fades of the cameras' clips, in whole frames of the film.
import type { Change } from '../../edit/edit';
import { clipColourName } from '../colours';
import type { Camera, ShotState } from '../../protocol';
import { filmClock } from '../clock_text';
import {
    fractionOf, minus, oldTexts, sum, timeChange, timeOfFrame, type OldTexts,
} from '../film_time';
import type { Layout } from '../layout';
import { frameNear, type Handle } from './handle';

const kLongest = 3600; // s

/// The cameras before and after one in the film, whatever their order in the text.
function neighbours(shot: ShotState, camera: Camera): { before?: Camera; next?: Camera } {
    const order = [...shot.cameras].sort((a, b) => a.video_start - b.video_start);
    const at = order.indexOf(camera);
    const [before, next] = [order[at - 1], order[at + 1]];
    return { ...before && { before }, ...next && { next } };
}

/// The edits that let a camera begin at another film time: the one before ends when it has faded in.
/// The film begins with its first camera, which stays where it is.
export function startChanges(
    shot: ShotState, index: number, time: number, old: OldTexts = oldTexts(),
): Change[] {
    const { fps } = shot.film;
    const camera = shot.cameras[index];
    const before = camera && neighbours(shot, camera).before;
    if (!camera || !before) {
        return [];
    }
    const least = before.video_start + before.fade + 1 / fps;
    const start = timeOfFrame(
        frameNear(time, fps, least, camera.video_end - camera.fade - 1 / fps), fps);
    return [
        timeChange([...camera.path, 'video', '0'], start, old),
        timeChange([...before.path, 'video', '1'], sum(start, fractionOf(camera.fade)), old),
    ];
}

/// The edits that let the last camera end at another film time.
export function endChanges(
    shot: ShotState, camera: Camera, time: number, old: OldTexts = oldTexts(),
): Change[] {
    const { fps } = shot.film;
    const frame = frameNear(time, fps, camera.video_start + camera.fade + 1 / fps, kLongest);
    return [timeChange([...camera.path, 'video', '1'], timeOfFrame(frame, fps), old)];
}

/// The edits that let a camera fade in until another film time.
export function fadeChanges(
    shot: ShotState, index: number, time: number, old: OldTexts = oldTexts(),
): Change[] {
    const { fps } = shot.film;
    const camera = shot.cameras[index];
    const { before, next } = camera ? neighbours(shot, camera) : {};
    if (!camera || !before) {
        return [];
    }
    const most = next ? next.video_start : camera.video_end;
    const end = timeOfFrame(frameNear(time, fps, camera.video_start, most), fps);
    return [
        timeChange([...camera.path, 'fade'], minus(end, fractionOf(camera.video_start)), old),
        timeChange([...before.path, 'video', '1'], end, old),
    ];
}

/// The handles of all clips. `selected` is the index of the selected camera: only there a fade that
/// does not exist yet can be drawn out.
export function clipHandles(layout: Layout, shot: ShotState, selected: number): Handle[] {
    const { clips, film } = layout;
    const middle = clips.y + clips.height / 2;
    const frame = 1 / shot.film.fps;
    return shot.cameras.flatMap((camera, index): Handle[] => {
        const { before, next } = neighbours(shot, camera);
        const old = oldTexts();
        const common = { path: camera.path, axis: film, value: null, colour: clipColourName(index),
            step: { time: frame, value: 0 } };
        const edge = (end: 'start' | 'end', time: number, change: (time: number) => Change[]) => ({
            ...common, id: `${camera.path.join('/')} ${end}`, time, y: middle,
            mark: 'none' as const, reach: { x: 5, y: clips.height / 2 },
            label: `${end} of camera ${camera.name}`, text: filmClock(time), change,
        });
        const handles: Handle[] = [];
        if (before && (camera.fade > 0 || index === selected)) {
            handles.push({
                ...common, id: `${camera.path.join('/')} fade`, time: camera.video_start + camera.fade,
                y: clips.y + 5, mark: 'fade', reach: { x: 7, y: 6 },
                label: `fade of camera ${camera.name}`,
                text: camera.fade > 0 ? `${camera.fade.toFixed(2)} s` : 'none',
                change: (time) => fadeChanges(shot, index, time, old),
            });
        }
        if (before) {
            handles.push(edge('start', camera.video_start,
                (time) => startChanges(shot, index, time, old)));
        }
        if (!next) {
            handles.push(edge('end', camera.video_end, (time) => endChanges(shot, camera, time, old)));
        }
        return handles;
    });
}
