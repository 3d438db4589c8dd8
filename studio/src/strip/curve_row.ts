/// The row of curves: which values its upper and lower borders stand for.
import { computed, signal } from '@preact/signals';
import { framesOfCameras } from '../motion/clock';
import { shot } from '../state/state';
import { curveOf, scaleOf, type CurvePoint, type CurveScale } from './curves';
import type { Row } from './layout';
import { curveName } from './strip_state';

const kMargin = 5; // px above and below

/// The curve of each camera of the shot.
export const curvePoints = computed<readonly CurvePoint[][]>(() =>
    (shot.value?.cameras ?? []).map((camera, i) =>
        curveOf(curveName.value, camera, framesOfCameras.value[i])));

/// The scale during a drag, which must not change under the pointer; null: it follows the curves.
export const heldScale = signal<CurveScale | null>(null);

export const curveScale = computed(() =>
    heldScale.value ?? scaleOf(curveName.value, curvePoints.value.flat()));

export interface CurveRow {
    yOf(value: number): number;
    valueAt(y: number): number;
    perPixel: number;
}

/// Values and heights of a row with a scale.
export function curveRow(row: Row, { low, high }: CurveScale): CurveRow {
    const perPixel = (high - low) / Math.max(1, row.height - 2 * kMargin);
    const bottom = row.y + row.height - kMargin;
    return {
        yOf: (value) => bottom - (value - low) / perPixel,
        valueAt: (y) => low + (bottom - y) * perPixel,
        perPixel,
    };
}
