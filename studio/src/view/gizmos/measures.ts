/// The measures of an object's shape as handles: which number each handle changes, where it is, and
/// along which of the object's own axes it moves.
import type { Triple } from '../../protocol';

/// A value of the text with numbers in SI units: as parsed by shot_values.ts.
export type Parsed = number | string | Parsed[] | { [key: string]: Parsed };

export interface MeasureHandle {
    /// Below the object: ["box", "0"].
    key: string[];
    /// Its place in the object's coordinates.
    at: Triple;
    /// Of length 1, in the object's coordinates.
    along: Triple;
    value: number;
    /// By how much the value grows for each metre along the axis, if the object stays where it is.
    rate: number;
    about: string;
}

const kAxisNames = ['x', 'y', 'z'];

function unitOf(axis: number, sign = 1): Triple {
    return [0, 1, 2].map((i) => (i === axis ? sign : 0)) as Triple;
}

function number(value: Parsed | undefined, fallback = 0): number {
    return typeof value === 'number' ? value : fallback;
}

function member(value: Parsed | undefined, key: string): Parsed | undefined {
    return typeof value === 'object' && !Array.isArray(value) ? value[key] : undefined;
}

function edges(key: string[], value: Parsed | undefined, count: number): MeasureHandle[] {
    const sizes = Array.isArray(value) ? value.map((one) => number(one)) : [];
    return Array.from({ length: count }, (_, i) => ({
        key: [...key, String(i)], value: sizes[i] ?? 0, rate: 2, along: unitOf(i),
        at: unitOf(i, (sizes[i] ?? 0) / 2), about: `size along ${kAxisNames[i]}`,
    }));
}

function radial(key: string[], value: number, height: number, about = 'radius'): MeasureHandle {
    return { key, value, rate: 1, along: [1, 0, 0], at: [value, 0, height], about };
}

function axial(key: string[], value: number, top: number, about: string): MeasureHandle {
    return { key, value, rate: 2, along: [0, 0, 1], at: [0, 0, top], about };
}

/// The handles of a shape, whose value in the text is `value`. Empty for shapes without measures.
export function measureHandles(shape: string, value: Parsed | undefined): MeasureHandle[] {
    const of = (key: string) => number(member(value, key));
    switch (shape) {
    case 'box':
        return edges([shape], value, 3);
    case 'rectangle':
        return edges([shape], value, 2);
    case 'rounded_box':
        return edges([shape, 'size'], member(value, 'size'), 3);
    case 'sphere':
    case 'disk':
        return [radial([shape], number(value), 0)];
    case 'cylinder':
        return [
            radial([shape, 'radius'], of('radius'), 0),
            axial([shape, 'height'], of('height'), of('height') / 2, 'height'),
        ];
    case 'cone':
        return [
            radial([shape, 'radius'], of('radius'), -of('height') / 2),
            ...(member(value, 'top_radius') === undefined ? []
                : [radial([shape, 'top_radius'], of('top_radius'), of('height') / 2,
                    'top radius')]),
            axial([shape, 'height'], of('height'), of('height') / 2, 'height'),
        ];
    case 'capsule':
        return [
            radial([shape, 'radius'], of('radius'), 0),
            axial([shape, 'length'], of('length'), of('length') / 2 + of('radius'), 'length'),
        ];
    default:
        return [];
    }
}

/// The shapes that are lists of points.
export const kPointShapes: ReadonlySet<string> = new Set(['triangle', 'parallelogram', 'hull']);

/// The points of a triangle, parallelogram or hull.
export function pointsOf(value: Parsed | undefined): Triple[] {
    return (Array.isArray(value) ? value : []).map((point) =>
        [0, 1, 2].map((i) => number(Array.isArray(point) ? point[i] : undefined)) as Triple);
}

/// Pairs of points to join by lines: the edges of a triangle or parallelogram. A hull has none
/// here.
export function edgesOf(shape: string, points: readonly Triple[]): [Triple, Triple][] {
    const [a, b, c] = points;
    if (!a || !b || !c || shape === 'hull') {
        return [];
    }
    if (shape === 'triangle') {
        return [[a, b], [b, c], [c, a]];
    }
    const d: Triple = [b[0] + c[0] - a[0], b[1] + c[1] - a[1], b[2] + c[2] - a[2]];
    return [[a, b], [a, c], [b, d], [c, d]];
}
