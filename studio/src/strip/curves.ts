/// The curves of a camera over film time: its speed, and its lens.
import type { CameraFramesOf } from '../motion/camera_frames';
import { speedAt } from '../motion/time_map';
import type { Camera } from '../protocol';
import { speedText } from './clock_text';
import type { CurveName } from './strip_state';

export interface CurvePoint {
    time: number; // of the film, s
    value: number;
}

/// Values and the two ends of the row that shows them.
export interface CurveScale {
    low: number;
    high: number;
}

export const kCurves: readonly { name: CurveName; label: string }[] = [
    { name: 'speed', label: 'Speed' },
    { name: 'fov', label: 'Field of view' },
    { name: 'focus', label: 'Focus' },
    { name: 'aperture', label: 'Aperture' },
];

const kSamples = 96;

/// The curve of one camera, at its frames, or finely for the speed.
export function curveOf(name: CurveName, camera: Camera, frames?: CameraFramesOf): CurvePoint[] {
    if (name === 'speed') {
        const length = camera.video_end - camera.video_start;
        return Array.from({ length: kSamples + 1 }, (_, i) => {
            const time = camera.video_start + length * (i / kSamples) * (1 - 1e-9);
            return { time, value: speedAt(camera, time) };
        });
    }
    return Array.from({ length: frames?.count ?? 0 }, (_, i) => {
        const entry = frames?.at(i);
        const pose = entry?.pose;
        const value = name === 'fov' ? pose?.verticalFov
            : name === 'focus' ? pose?.focusDistance : pose?.lensRadius;
        return { time: entry?.filmTime ?? 0, value: value ?? 0 };
    });
}

/// A scale that holds all values, with a margin; 0 belongs to speeds and apertures.
export function scaleOf(name: CurveName, points: readonly CurvePoint[]): CurveScale {
    const values = points.map((point) => point.value).filter(Number.isFinite);
    if (name === 'speed' || name === 'aperture') {
        values.push(0);
    }
    if (name === 'speed') {
        values.push(1);
    }
    const low = Math.min(...values);
    const high = Math.max(...values);
    const margin = Math.max(0.12 * (high - low), 0.02 * Math.abs(high), 1e-6);
    return values.length > 0 ? { low: low - margin, high: high + margin } : { low: 0, high: 1 };
}

/// A value of a curve with its unit.
export function curveText(name: CurveName, value: number): string {
    switch (name) {
        case 'speed':
            return speedText(value);
        case 'fov':
            return `${(value * 180 / Math.PI).toFixed(1)}°`;
        case 'focus':
            return value < 1 ? `${(100 * value).toFixed(1)} cm` : `${value.toFixed(2)} m`;
        case 'aperture':
            return `${(1000 * value).toFixed(1)} mm`;
    }
}
