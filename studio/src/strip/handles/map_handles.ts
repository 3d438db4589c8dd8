/// The lines between both clocks: their ends, and all of a camera's lines together.
import { sourceOf, type Change } from '../../edit/edit';
import { momentOf, parseMoment, writeMoment } from '../../motion/moments';
import { sceneTimeAt } from '../../motion/time_map';
import type { Camera, KeyPath, ShotState, TimelineEvent } from '../../protocol';
import { timeline } from '../../state/state';
import { resolved, secondsPerPixel, timeAt, xOf, type Axis } from '../axis';
import { sceneClock } from '../clock_text';
import { clipColourName } from '../colours';
import type { Layout } from '../layout';
import { linesOf } from '../map_lines';
import { shownEvents } from '../strip_state';
import type { Handle } from './handle';

const kSnap = 4; // px from the pin of an event
const kNear = 3.5; // px from a line
const kLeastShare = 0.3; // of the map's height: above this, lines move as if they were dragged here

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

/// The pin of an event to which a scene time snaps; undefined if none is near.
function pinNear(axis: Axis, time: number): TimelineEvent | undefined {
    const reach = kSnap * secondsPerPixel(axis);
    return shownEvents.peek().filter((event) => Math.abs(event.time - time) < reach)
        .sort((a, b) => Math.abs(a.time - time) - Math.abs(b.time - time))[0];
}

/// How a scene time is written: as the moment of an event whose pin is near; as the moment that
/// stands there now (`written`, which came to `old`), with another delay; else as a number.
export function timeChange(
    path: KeyPath, axis: Axis, next: number, written: string | undefined, old: number,
): Change {
    const { time: value, step: precision } = resolved(axis, Math.max(0, next));
    const pin = pinNear(axis, next);
    const named = pin && momentOf(pin, timeline.peek()?.head.events ?? []);
    if (named) {
        return { path, value: { yaml: named } };
    }
    const moment = written === undefined ? null : parseMoment(written);
    return moment ? { path, value: {
        yaml: writeMoment(moment, moment.delay + value - old, precision) } } : { path, value, precision };
}

/// The edits that let a camera show another part of the scene, as long as before.
export function shiftChanges(camera: Camera, seconds: number, precision: number): Change[] {
    const both = standsStill(camera) || camera.speeds.length > 0
        ? [camera.scene_start] : [camera.scene_start, camera.scene_end];
    const shift = Math.max(seconds, -Math.min(...both));
    return both.flatMap((time, end): Change[] => {
        const path = scenePath(camera, end === 0 ? 0 : 1);
        if (!path) {
            return [];
        }
        const moment = parseMoment(sourceOf(path)?.text ?? '');
        return moment
            ? [{ path, value: { yaml: writeMoment(moment, moment.delay + shift, precision) } }]
            : [{ path, value: time + shift, precision }];
    });
}

/// The lower ends of each camera's first and last line.
export function mapHandles(layout: Layout, shot: ShotState): Handle[] {
    const { map, scene } = layout;
    return shot.cameras.flatMap((camera, index) => ([0, 1] as const).flatMap((end): Handle[] => {
        const path = scenePath(camera, end);
        const time = end === 0 ? camera.scene_start : camera.scene_end;
        if (path === null || (end === 1 && standsStill(camera))) {
            return [];
        }
        const { step } = resolved(scene, time);
        const written = sourceOf(path)?.text;
        const name = written !== undefined && parseMoment(written) ? `${written} ` : '';
        return [{
            id: `${camera.path.join('/')} scene ${end}`, path: camera.path, axis: scene, time,
            y: map.y + map.height - 4, value: null, mark: 'tick', colour: clipColourName(index),
            reach: { x: 6, y: 8 }, step: { time: Math.max(step, 0.01), value: 0 },
            label: `scene time at the ${end === 0 ? 'start' : 'end'} of camera ${camera.name}`,
            text: name + sceneClock(time),
            change: (next) => [timeChange(path, scene, next, written, time)],
        }];
    }));
}

/// The line under the pointer, as a handle that moves all lines of its camera; `selected` is
/// preferred. Undefined if none is near.
export function lineAt(
    layout: Layout, shot: ShotState, selected: number, x: number, y: number,
): Handle | undefined {
    const { map, film, scene } = layout;
    const share = (y - map.y) / map.height;
    if (share < 0.04 || share > 1) {
        return undefined;
    }
    const near = shot.cameras.flatMap((camera, index) => linesOf(camera, film).map((time) => {
        const at = (1 - share) * xOf(film, time) + share * xOf(scene, sceneTimeAt(camera, time));
        return { camera, index, time, away: Math.abs(at - x) - (index === selected ? 3 : 0) };
    })).filter(({ away }) => away <= kNear).sort((a, b) => a.away - b.away)[0];
    if (!near) {
        return undefined;
    }
    const { camera, index, time } = near;
    const grabbed = sceneTimeAt(camera, time);
    const { step } = resolved(scene, grabbed);
    const gain = 1 / Math.max(share, kLeastShare);
    return {
        id: `${camera.path.join('/')} lines`, path: camera.path, axis: scene, value: null, y,
        time: timeAt(scene, x), mark: 'none', colour: clipColourName(index),
        reach: { x: kNear, y: 1 }, step: { time: step, value: 0 },
        label: `part of the scene that camera ${camera.name} shows`,
        text: `film ${time.toFixed(2)} s shows scene ${grabbed.toFixed(3)} s`,
        change: (next) => {
            const pixels = (next - timeAt(scene, x)) / secondsPerPixel(scene);
            const seconds = Math.round(pixels * gain * secondsPerPixel(scene) / step) * step;
            return shiftChanges(camera, seconds, step);
        },
    };
}
