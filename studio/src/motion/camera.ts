/// The camera as the renderer has it: its axes, its lens, and its pose between two frames.
import type { Triple } from '../protocol';
import { add, cross, dot, length, mix, scale, subtract, unit } from './vectors';

/// A camera at one instant (render/camera/camera_state.h).
export interface CameraPose {
    position: Triple;
    target: Triple;
    up: Triple;
    roll: number; // rad; positive turns the picture clockwise
    verticalFov: number; // rad
    focusDistance: number; // m, along the optical axis
    lensRadius: number; // m
}

/// Orthonormal axes in the world: to the right, upwards, and backwards from what is seen.
export interface CameraAxes {
    right: Triple;
    up: Triple;
    back: Triple;
}

const kSmallestSine = 1e-6; // between the axis and `up`; the renderer refuses less

/// The formula of pipeline/export (`camera_axes`) and of the renderer's lens. Where the renderer
/// refuses a view along `up`, the picture's upper edge is +y, or +z for a view along y: the page
/// still shows something, turned as a plan of the table is.
export function cameraAxes(pose: CameraPose): CameraAxes {
    const axis = subtract(pose.target, pose.position);
    const forward: Triple = length(axis) > 1e-9 ? unit(axis) : [0, 1, 0];
    const level = unit(cross(forward, uprightFor(forward, pose.up)));
    const upright = cross(level, forward);
    const c = Math.cos(pose.roll);
    const s = Math.sin(pose.roll);
    return {
        right: add(scale(c, level), scale(s, upright)),
        up: subtract(scale(c, upright), scale(s, level)),
        back: scale(-1, forward),
    };
}

function uprightFor(forward: Triple, up: Triple): Triple {
    if (length(cross(forward, unit(up))) > kSmallestSine) {
        return up;
    }
    return Math.abs(forward[1]) < 0.9 ? [0, 1, 0] : [0, 0, 1];
}

/// Where the picture shows a point: to the right and up from the picture's centre in units of half
/// its height, and its depth along the axis, m. Null behind the camera.
export function projectPoint(
    pose: CameraPose, point: Triple,
): { x: number; y: number; depth: number } | null {
    const axes = cameraAxes(pose);
    const from = subtract(point, pose.position);
    const depth = -dot(from, axes.back);
    if (depth <= 0) {
        return null;
    }
    const scaleAt = 1 / (depth * Math.tan(pose.verticalFov / 2));
    return { x: dot(from, axes.right) * scaleAt, y: dot(from, axes.up) * scaleAt, depth };
}

/// The field of view of a lens; both in m, the result in rad.
export function fovOfLens(focalLength: number, sensorHeight: number): number {
    return 2 * Math.atan(sensorHeight / 2 / focalLength);
}

/// The inverse, in m.
export function lensOfFov(verticalFov: number, sensorHeight: number): number {
    return sensorHeight / 2 / Math.tan(verticalFov / 2);
}

/// The field of view, rad, whose half has `scale` times the tangent of half of `fov`.
export function scaledFov(fov: number, scale: number): number {
    return scale === 1 ? fov : 2 * Math.atan(scale * Math.tan(fov / 2));
}

/// The pose between two others, as the renderer mixes them during an exposure: the axis, not the
/// target, changes linearly.
export function mixPoses(a: CameraPose, b: CameraPose, weight: number): CameraPose {
    const number = (x: number, y: number) => x + weight * (y - x);
    const position = mix(a.position, b.position, weight);
    const axis = mix(subtract(a.target, a.position), subtract(b.target, b.position), weight);
    return {
        position,
        target: add(position, axis),
        up: mix(a.up, b.up, weight),
        roll: number(a.roll, b.roll),
        verticalFov: number(a.verticalFov, b.verticalFov),
        focusDistance: number(a.focusDistance, b.focusDistance),
        lensRadius: number(a.lensRadius, b.lensRadius),
    };
}
