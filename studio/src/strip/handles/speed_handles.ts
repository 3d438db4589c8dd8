/// The points of a camera's speed ramp, and how points come and go.
import {
    applyChanges, insertItem, removeValue, sourceOf, type Change,
} from '../../edit/edit';
import { speedAt } from '../../motion/time_map';
import type { Camera, ShotState } from '../../protocol';
import { filmClock, speedText } from '../clock_text';
import { clipColourName } from '../colours';
import { roundSpeed, speedAsText } from '../curve_values';
import type { CurveRow } from '../curve_row';
import {
    fractionOf, oldTexts, secondsOf, timeChange, timeOfFrame, timeText, type OldTexts,
} from '../film_time';
import type { Layout } from '../layout';
import { frameNear, type Handle } from './handle';

/// The edits that move a point of a ramp; its order among the others does not change.
export function speedChanges(
    shot: ShotState, camera: Camera, index: number, time: number, speed: number,
    old: OldTexts = oldTexts(),
): Change[] {
    const { fps } = shot.film;
    const point = camera.speeds[index];
    if (!point) {
        return [];
    }
    const least = (camera.speeds[index - 1]?.video_time ?? -1 / fps) + 1 / fps;
    const most = (camera.speeds[index + 1]?.video_time ?? 3600) - 1 / fps;
    const isMoved = Math.abs(time - point.video_time) > 0.25 / fps;
    const own: Change = { path: [...point.path, '1'], value: speed };
    const at = timeOfFrame(frameNear(time, fps, least, most), fps);
    return isMoved ? [timeChange([...point.path, '0'], at, old), own] : [own];
}

/// The handles of the ramp of one camera, in the row of curves.
export function speedHandles(
    layout: Layout, shot: ShotState, index: number, row: CurveRow,
): Handle[] {
    const camera = shot.cameras[index];
    const old = oldTexts();
    return (camera?.speeds ?? []).map((point, i): Handle => ({
        id: point.path.join('/'), path: point.path, axis: layout.film, time: point.video_time,
        y: row.yOf(point.speed), value: point.speed, mark: 'point', colour: clipColourName(index),
        reach: { x: 6, y: 6 }, step: { time: 1 / shot.film.fps, value: 1 / 16 },
        label: `point ${i + 1} of the speed ramp of camera ${camera?.name}`,
        text: `${speedText(point.speed)} at ${filmClock(point.video_time)}`,
        change: (time, value) =>
            speedChanges(shot, camera as Camera, i, time, roundSpeed(value, row.perPixel), old),
        remove: () => {
            removeValue(point.path, 'Delete point of the speed ramp', true);
        },
    }));
}

/// Adds a point to the ramp of a camera at a film time; a camera without a ramp gets one.
export function addSpeedPoint(shot: ShotState, camera: Camera, time: number): void {
    const { fps } = shot.film;
    const at = timeOfFrame(frameNear(time, fps, camera.video_start, camera.video_end), fps);
    const seconds = secondsOf(at);
    const speed = speedAt(camera, seconds);
    if (camera.speeds.some((one) => Math.abs(one.video_time - seconds) < 0.5 / fps)) {
        return;
    }
    const point = (text: string) => `[${text}, ${speedAsText(speed)}]`;
    const here = point(timeText(at, null));
    if (camera.speeds.length > 0) {
        const before = camera.speeds.filter((one) => one.video_time < seconds).length;
        insertItem([...camera.path, 'scene', 'speeds'], before, here, 'Add point to the speed ramp',
            true);
        return;
    }
    const text = (value: number) => timeText(fractionOf(value), null);
    const from = sourceOf([...camera.path, 'scene', '0'])?.text
        ?? sourceOf([...camera.path, 'scene'])?.text ?? text(camera.scene_start);
    const points = [...new Set([point(text(camera.video_start)), here, point(text(camera.video_end))])];
    applyChanges([{ path: [...camera.path, 'scene'],
        value: { yaml: `{from: ${from}, speeds: [${points.join(', ')}]}` } }], 'Add speed ramp', true);
}
