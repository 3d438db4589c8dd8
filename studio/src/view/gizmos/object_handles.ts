/// The handles of a selected object, and what is drawn of them.
import type { Triple } from '../../protocol';
import { add, length, scale, subtract } from '../../motion/vectors';
import { kColours, type Figure, type Line } from './figure';
import {
    edgesOf, kPointShapes, measureHandles, pointsOf, type MeasureHandle, type Parsed,
} from './measures';
import { kAxes, toWorld, type ObjectFrame } from './object_frame';
import { planeAxes } from './rays';
import type { Tool } from './tool_state';

export const kArmPixels = 74;
const kRingPixels = 66;
const kRingPieces = 48;
const kAxisColours = [kColours.x, kColours.y, kColours.z];

export type ObjectHandle = { at: Triple } & (
    | { kind: 'vertex'; index: number }
    | { kind: 'measure'; measure: MeasureHandle }
    | { kind: 'axis'; axis: number }
    | { kind: 'scale' });

/// What the handles are made of.
export interface Selected {
    shape: string;
    value: Parsed | undefined; // of the shape in the text
    frame: ObjectFrame;
    tool: Tool;
    /// That one CSS pixel shows at the origin, m.
    metresPerPixel: number;
    isBall: boolean;
    /// Axes that point at the viewer: an arrow along them would hide the object.
    hiddenAxes: readonly number[];
}

/// The handles that are points.
export function objectHandles(selected: Selected): ObjectHandle[] {
    const { shape, value, frame, tool, metresPerPixel, isBall, hiddenAxes } = selected;
    const vertices = kPointShapes.has(shape)
        ? pointsOf(value).map((point, index): ObjectHandle =>
            ({ kind: 'vertex', index, at: toWorld(frame, point) })) : [];
    if (tool === 'move') {
        const reach = kArmPixels * metresPerPixel;
        const arrows = kAxes.map((axis, i): ObjectHandle =>
            ({ kind: 'axis', axis: i, at: add(frame.origin, scale(reach, axis)) }));
        return [...vertices, ...arrows.filter((_, i) => !hiddenAxes.includes(i))];
    }
    if (tool === 'turn' || isBall) {
        return vertices;
    }
    const measures = measureHandles(shape, value);
    if (measures.length === 0 && shape !== 'plane') {
        const arm = (kArmPixels * metresPerPixel) / Math.sqrt(2);
        return [...vertices, { kind: 'scale', at: add(frame.origin, [arm, 0, arm]) }];
    }
    return measures.map((measure) =>
        ({ kind: 'measure', measure, at: toWorld(frame, measure.at) }));
}

/// The points of the ring about a world axis, around the origin.
export function ringPoints(selected: Selected, axis: number): Triple[] {
    const radius = kRingPixels * selected.metresPerPixel;
    const [x, y] = planeAxes(kAxes[axis] ?? [0, 0, 1]);
    return Array.from({ length: kRingPieces + 1 }, (_, i) => {
        const angle = (2 * Math.PI * i) / kRingPieces;
        return add(selected.frame.origin,
            add(scale(radius * Math.cos(angle), x), scale(radius * Math.sin(angle), y)));
    });
}

/// The unit vector of a measure's axis in the world, and the length of the object's own unit there.
export function measureAxis(
    frame: ObjectFrame, { along }: MeasureHandle,
): { axis: Triple; unit: number } {
    const axis = subtract(toWorld(frame, along), frame.origin);
    const unit = length(axis);
    return { axis: scale(1 / (unit || 1), axis), unit };
}

/// `active`: the axis that is being turned about or moved along.
export function objectFigure(selected: Selected, active: number | null): Figure {
    const { frame, tool, shape, value } = selected;
    const lines: Line[] = edgesOf(shape, pointsOf(value)).map(([a, b]) => ({
        from: toWorld(frame, a), to: toWorld(frame, b), colour: kColours.accent, isFaint: true,
    }));
    const figure: Required<Figure> = { lines, dots: [], tips: [], balls: [], labels: [] };
    for (const handle of objectHandles(selected)) {
        drawHandle(handle, selected, active, figure);
    }
    if (tool === 'turn') {
        for (const axis of [0, 1, 2]) {
            const points = ringPoints(selected, axis);
            const colour = kAxisColours[axis] ?? kColours.accent;
            const isFaint = active !== null && active !== axis;
            lines.push(...points.slice(1).map((to, i) =>
                ({ from: points[i] ?? to, to, colour, isFaint })));
        }
    }
    return figure;
}

function drawHandle(
    handle: ObjectHandle, { frame }: Selected, active: number | null, figure: Required<Figure>,
): void {
    const { at } = handle;
    if (handle.kind === 'axis') {
        const colour = kAxisColours[handle.axis] ?? kColours.accent;
        const isFaint = active !== null && active !== handle.axis;
        figure.lines.push({ from: frame.origin, to: at, colour, isFaint });
        figure.tips.push({ at, along: subtract(at, frame.origin), colour, size: 16 });
    } else if (handle.kind === 'vertex') {
        figure.dots.push({ at, colour: kColours.handle, size: 11, shape: 'disc' });
    } else {
        const colour = handle.kind === 'scale' ? kColours.handle : kColours.strike;
        figure.lines.push({ from: frame.origin, to: at, colour, isFaint: true });
        figure.dots.push({ at, colour, size: 12, shape: 'square' });
    }
}
