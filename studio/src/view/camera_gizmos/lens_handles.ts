/// The lens of a camera at the play head: frustum, plane in focus, and their handles.
import { sourceOf } from '../../edit/edit';
import { cameraAxes, lensOfFov, scaledFov, type CameraPose } from '../../motion/camera';
import { keysOf } from '../../motion/lens_keys';
import { add, dot, scale, subtract } from '../../motion/vectors';
import type { Camera, KeyPath, Triple } from '../../protocol';
import type { Figure, Line } from '../gizmos/figure';
import type { Handle } from '../handles/handle';
import { easedChange, type EasedValue } from './eased_value';

const kDegree = Math.PI / 180;
const kBody = 0.12; // m, the depth of the frustum that stands for the camera
const kFarthest = 6; // m; a plane in focus further away is not drawn, its handle is nearer than it
const kFovs: [number, number] = [0.5 * kDegree, 175 * kDegree];
const kNearest = 0.01; // m, of a plane in focus
const kFovPrecision = 0.1 * kDegree;
const kLensPrecision = 1e-4; // m

/// A camera at the play head, with its poses at the ends of its interval.
export interface LensNow {
    camera: Camera;
    pose: CameraPose;
    first: CameraPose;
    last: CameraPose;
    progress: number;
    aspect: number; // of the film
    colour: number;
}

/// The corners of the picture at a depth, from the upper left one clockwise.
export function cornersAt({ pose, aspect }: LensNow, depth: number): Triple[] {
    const { right, up, back } = cameraAxes(pose);
    const high = depth * Math.tan(pose.verticalFov / 2);
    const middle = add(pose.position, scale(-depth, back));
    return ([[-1, 1], [1, 1], [1, -1], [-1, -1]] as const).map(([x, y]) =>
        add(middle, add(scale(x * high * aspect, right), scale(y * high, up))));
}

function outline(corners: readonly Triple[], colour: number, isFaint: boolean): Line[] {
    return corners.map((from, i) =>
        ({ from, to: corners[(i + 1) % corners.length] ?? from, colour, isFaint }));
}

/// The camera at the play head; of a selected one also its axis and the plane in focus.
export function lensFigure(lens: LensNow, isSelected: boolean): Figure {
    const { pose, colour } = lens;
    const body = Math.min(kBody, 0.5 * pose.focusDistance);
    const near = cornersAt(lens, body);
    const axes = cameraAxes(pose);
    const roof = add(pose.position, add(scale(-body, axes.back),
        scale(1.35 * body * Math.tan(pose.verticalFov / 2), axes.up)));
    const rays = near.map((to): Line => ({ from: pose.position, to, colour, isFaint: !isSelected }));
    const lines = [
        ...rays, ...outline(near, colour, !isSelected),
        // The triangle above the picture's upper edge shows what is up.
        { from: near[0] as Triple, to: roof, colour, isFaint: !isSelected },
        { from: roof, to: near[1] as Triple, colour, isFaint: !isSelected },
    ];
    if (!isSelected) {
        return { lines };
    }
    lines.push({ from: pose.position, to: pose.target, colour, isFaint: true });
    if (pose.focusDistance > kFarthest) {
        const to = add(pose.position, scale(-focusReach(pose.focusDistance), axes.back));
        return { lines: [...lines, { from: pose.position, to, colour, isFaint: true }] };
    }
    const focus = cornersAt(lens, pose.focusDistance);
    return {
        lines: [...lines, ...outline(focus, colour, true),
            ...focus.map((to, i): Line => ({ from: near[i] as Triple, to, colour, isFaint: true }))],
    };
}

/// A value of the lens at the ends of its camera's interval and now, which `of` takes from a pose.
export function lensValue(
    lens: LensNow, path: KeyPath, of: (pose: CameraPose) => number,
): EasedValue {
    const { camera, pose, first, last, progress } = lens;
    return {
        start: of(first), end: of(last), now: of(pose), progress,
        keys: keysOf(camera.lens_keys, path),
        time: camera.video_start + progress * (camera.video_end - camera.video_start),
    };
}

function fovHandle(lens: LensNow): Handle {
    const { camera, pose, colour } = lens;
    const { up, back } = cameraAxes(pose);
    const depth = Math.min(pose.focusDistance, 1);
    const middle = add(pose.position, scale(-depth, back));
    const isLens = sourceOf([...camera.path, 'focal_length']) !== null;
    const key = isLens ? 'focal_length' : 'fov';
    const path = [...camera.path, key];
    const written = (fov: number) => isLens ? lensOfFov(fov, camera.sensor_height)
        : scaledFov(fov, 1 / camera.fov_scale);
    const values = lensValue(lens, path, (one) => written(one.verticalFov));
    return {
        key: [...camera.path, 'fov'].join('/'), path, colour,
        at: add(middle, scale(depth * Math.tan(pose.verticalFov / 2), up)), shape: 'square', size: 9,
        label: `${camera.name}: ${isLens
            ? `focal length ${(1000 * values.now).toFixed(0)} mm`
            : `field of view ${(values.now / kDegree).toFixed(1)}°`}`,
        way: { kind: 'line', along: up },
        changes: (to) => {
            const high = dot(subtract(to, middle), up);
            const wanted = Math.min(kFovs[1], Math.max(kFovs[0], 2 * Math.atan(high / depth)));
            const change = easedChange(path, values, written(wanted));
            const limited = isLens
                ? Math.max(change.value, lensOfFov(kFovs[1], camera.sensor_height))
                : Math.min(kFovs[1], Math.max(kFovs[0], change.value));
            return [{ ...change, value: limited, precision: isLens ? kLensPrecision : kFovPrecision }];
        },
    };
}

/// What sets the distance of the plane in focus at the play head.
export function focusChange(lens: LensNow, distance: number, precision: number) {
    const path = [...lens.camera.path, 'focus'];
    const values = lensValue(lens, path, (pose) => pose.focusDistance);
    const change = easedChange(path, values, Math.max(kNearest, distance));
    return { ...change, value: Math.max(kNearest, change.value), precision };
}

/// How far from the camera the handle of a plane in focus is: up to some metres there, then by the
/// logarithm of the distance, so that it stays within reach.
export function focusReach(distance: number): number {
    return distance <= kFarthest ? distance : kFarthest * (1 + Math.log(distance / kFarthest));
}

/// The inverse.
export function distanceOfReach(reach: number): number {
    return reach <= kFarthest ? reach : kFarthest * Math.exp(reach / kFarthest - 1);
}

function focusHandle(lens: LensNow): Handle {
    const { camera, pose, colour } = lens;
    const { back } = cameraAxes(pose);
    return {
        key: [...camera.path, 'focus'].join('/'), path: [...camera.path, 'focus'], colour,
        at: add(pose.position, scale(-focusReach(pose.focusDistance), back)), shape: 'ring', size: 12,
        label: `${camera.name}: focus at ${pose.focusDistance.toFixed(2)} m`,
        way: { kind: 'line', along: scale(-1, back) },
        changes: (to, precision) => [focusChange(lens,
            distanceOfReach(-dot(subtract(to, pose.position), back)), precision)],
    };
}

export function lensHandles(lens: LensNow): Handle[] {
    return [fovHandle(lens), focusHandle(lens)];
}
