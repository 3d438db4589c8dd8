/// The ends of a camera's changing field of view, focus and aperture, the inner points of their
/// easing, and their keys, on their curve.
import { insertItem, removeValue, sourceOf, type Change } from '../../edit/edit';
import { parseQuantity } from '../../edit/quantity';
import { scaledFov } from '../../motion/camera';
import type { CameraFramesOf } from '../../motion/camera_frames';
import { keysOf } from '../../motion/lens_keys';
import type { Camera, KeyPath, LensKey as LensPoint, ShotState } from '../../protocol';
import { roundStep } from '../axis';
import { clipColourName } from '../colours';
import type { CurveRow } from '../curve_row';
import { curveText } from '../curves';
import { oldTexts, timeChange, timeOfFrame, timeText, type OldTexts } from '../film_time';
import type { Layout } from '../layout';
import type { CurveName } from '../strip_state';
import { frameNear, type Handle } from './handle';

/// A key that a curve shows, and how its values become those of the curve: radians and metres.
interface LensKey {
    key: string;
    unit: number; // SI
    toCurve(value: number, fov: number): number;
    fromCurve(value: number, fov: number): number;
}

function lensKeys(name: CurveName, sensor: number, fovScale: number): LensKey[] {
    const half = sensor / 2;
    const length = (fov: number) => half / Math.tan(fov / 2);
    const same = (value: number) => value;
    switch (name) {
        case 'speed':
            return [];
        case 'fov':
            return [
                { key: 'focal_length', unit: 0.001, toCurve: (f) => 2 * Math.atan(half / f),
                    fromCurve: length },
                { key: 'fov', unit: Math.PI / 180, toCurve: (fov) => scaledFov(fov, fovScale),
                    fromCurve: (fov) => scaledFov(fov, 1 / fovScale) },
            ];
        case 'focus':
            return [{ key: 'focus', unit: 0.01, toCurve: same, fromCurve: same }];
        case 'aperture':
            return [
                { key: 'f_number', unit: 1, toCurve: (n, fov) => length(fov) / (2 * n),
                    fromCurve: (radius, fov) => length(fov) / (2 * radius) },
                { key: 'aperture', unit: 0.001, toCurve: same, fromCurve: same },
            ];
    }
}

interface Ends {
    from: KeyPath;
    to: KeyPath | null; // null: one value for all times
    easing: KeyPath | null; // of four numbers
}

/// Where the values of a key stand: one, a list of two, or from and to.
function endsOf(path: KeyPath): Ends {
    const source = sourceOf(path);
    if (source?.kind === 'list') {
        return { from: [...path, '0'], to: [...path, '1'], easing: null };
    }
    if (source?.kind === 'map') {
        const easing = [...path, 'easing'];
        return { from: [...path, 'from'], to: [...path, 'to'],
            easing: sourceOf(easing)?.kind === 'list' ? easing : null };
    }
    return { from: path, to: null, easing: null };
}

function numberAt(path: KeyPath): number | null {
    const source = sourceOf(path);
    return source?.kind === 'scalar' ? parseQuantity(source.text)?.value ?? null : null;
}

interface Given {
    layout: Layout;
    shot: ShotState;
    index: number;
    camera: Camera;
    row: CurveRow;
    name: CurveName;
}

function endHandle(given: Given, key: LensKey, path: KeyPath, time: number, curve: number,
    fov: number, which: string): Handle {
    const { layout, camera, index, row, name, shot } = given;
    const change = (_: number, value: number): Change[] => {
        const positive = Math.max(value, row.perPixel / 4);
        const next = key.fromCurve(positive, fov);
        const beside = key.fromCurve(positive + row.perPixel / 2, fov);
        const step = roundStep(Math.max(Math.abs(beside - next) / key.unit, 1e-4)) * key.unit;
        return [{ path, value: Math.round(next / step) * step, precision: step }];
    };
    return {
        id: path.join('/'), path: camera.path, axis: layout.film, time, y: row.yOf(curve), value: curve,
        mark: 'point', colour: clipColourName(index), reach: { x: 7, y: 6 },
        step: { time: 1 / shot.film.fps, value: 2 * row.perPixel },
        label: `${key.key} of camera ${camera.name}${which}`, text: curveText(name, curve), change,
    };
}

/// A handle for each key whose value is a number: it has a time and a value.
function keyHandles(
    given: Given, key: LensKey, points: readonly LensPoint[], frames: CameraFramesOf,
): Handle[] {
    const { shot } = given;
    const { fps } = shot.film;
    const old = oldTexts();
    return points.flatMap((point, i): Handle[] => {
        const number = numberAt([...point.path, '1']);
        const fov = frames.poseAt(point.video_time)?.verticalFov;
        if (number === null || fov === undefined) {
            return [];
        }
        const handle = endHandle(given, key, [...point.path, '1'], point.video_time,
            key.toCurve(number, fov), fov, `, key ${i + 1}`);
        const least = (points[i - 1]?.video_time ?? -1 / fps) + 1 / fps;
        const most = (points[i + 1]?.video_time ?? 3600) - 1 / fps;
        return [{
            ...handle, path: point.path,
            change: (time, value) => [
                ...timeMoves(point, time, fps, least, most, old), ...handle.change(time, value)],
            ...points.length > 1
                ? { remove: () => { removeValue(point.path, `Delete key of ${key.key}`, true); } } : {},
        }];
    });
}

/// The edit that moves a key to the nearest frame; none where it is.
function timeMoves(point: LensPoint, time: number, fps: number, least: number, most: number,
    old: OldTexts): Change[] {
    const at = timeOfFrame(frameNear(time, fps, least, most), fps);
    return Math.abs(time - point.video_time) > 0.25 / fps
        ? [timeChange([...point.path, '0'], at, old)] : [];
}

/// Adds a key to a value that is given by keys, with the value of the key before it, at the frame
/// nearest to a film time. False if the value has no keys.
export function addLensKey(shot: ShotState, camera: Camera, key: string, time: number): boolean {
    const { fps } = shot.film;
    const path = [...camera.path, key];
    const points = keysOf(camera.lens_keys, path);
    const at = timeOfFrame(frameNear(time, fps, camera.video_start, camera.video_end), fps);
    const seconds = at.numerator / at.denominator;
    const isTaken = points.some((one) => Math.abs(one.video_time - seconds) < 0.5 / fps);
    const before = points.filter((one) => one.video_time < seconds).length;
    const near = points[Math.max(0, before - 1)];
    const text = near ? sourceOf([...near.path, '1'])?.text : undefined;
    if (text !== undefined && !isTaken) {
        insertItem([...path, 'keys'], before, `[${timeText(at, null)}, ${text}]`,
            `Add key to ${key}`, true);
    }
    return points.length > 0;
}

function easingHandles(given: Given, path: KeyPath, from: number, to: number): Handle[] {
    const { layout, camera, index, row } = given;
    const length = camera.video_end - camera.video_start;
    return [0, 2].flatMap((first): Handle[] => {
        const [x, y] = [numberAt([...path, String(first)]), numberAt([...path, String(first + 1)])];
        if (x === null || y === null || from === to) {
            return [];
        }
        const value = from + (to - from) * y;
        return [{
            id: `${path.join('/')} ${first}`, path: camera.path, axis: layout.film,
            time: camera.video_start + x * length, y: row.yOf(value), value, mark: 'tick',
            colour: clipColourName(index), reach: { x: 7, y: 7 },
            step: { time: 0.02 * length, value: 2 * row.perPixel },
            label: `easing point ${first / 2 + 1} of camera ${camera.name}`,
            text: `${x.toFixed(2)}, ${y.toFixed(2)}`,
            change: (time, next) => [
                { path: [...path, String(first)], precision: 0.01,
                    value: Math.min(1, Math.max(0, (time - camera.video_start) / length)) },
                { path: [...path, String(first + 1)], precision: 0.01,
                    value: Math.min(10, Math.max(-10, (next - from) / (to - from))) },
            ],
        }];
    });
}

/// The handles of a camera's curve. Values that are names, such as `auto`, have none.
export function lensHandles(
    layout: Layout, shot: ShotState, index: number, name: CurveName, row: CurveRow,
    frames: CameraFramesOf | undefined,
): Handle[] {
    const camera = shot.cameras[index];
    const keys = lensKeys(name, camera?.sensor_height ?? 0.024, camera?.fov_scale ?? 1);
    const key = keys.find((one) => camera && sourceOf([...camera.path, one.key])) ?? keys.at(-1);
    if (!camera || !key || !frames || frames.count === 0) {
        return [];
    }
    const given = { layout, shot, index, camera, row, name };
    const path = [...camera.path, key.key];
    const points = keysOf(camera.lens_keys, path);
    if (points.length > 0) {
        return keyHandles(given, key, points, frames);
    }
    const { from, to, easing } = endsOf(path);
    const fovAt = (entry: number) => frames.at(entry).pose.verticalFov;
    const curveAt = (at: KeyPath, entry: number): number | null => {
        const number = numberAt(at);
        return number === null ? null : key.toCurve(number, fovAt(entry));
    };
    const last = frames.count - 1;
    const [a, b] = [curveAt(from, 0), to ? curveAt(to, last) : null];
    const handles: Handle[] = [];
    if (a !== null) {
        handles.push(endHandle(given, key, from, camera.video_start, a, fovAt(0),
            to ? ' at its start' : ''));
    }
    if (to && b !== null) {
        handles.push(endHandle(given, key, to, camera.video_end, b, fovAt(last), ' at its end'));
    }
    if (easing && a !== null && b !== null) {
        handles.push(...easingHandles(given, easing, a, b));
    }
    return handles;
}
