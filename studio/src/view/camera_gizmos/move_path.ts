/// Moves a path so that the camera's place at the play head moves by a given way.
import type { Change } from '../../edit/edit';
import { add, length, mix, scale, subtract } from '../../motion/vectors';
import type { PathShape, Triple } from '../../protocol';
import { movePoint } from './path_handles';

const kSamples = 128;
const kRefinements = 40;

function onBezier(points: readonly Triple[], u: number): Triple {
    let level = [...points];
    while (level.length > 1) {
        level = level.slice(1).map((point, i) => mix(level[i] ?? point, point, u));
    }
    return level[0] ?? [0, 0, 0];
}

/// The parameter at which a Bezier curve is nearest to a place.
function parameterAt(points: readonly Triple[], place: Triple): number {
    const off = (u: number) => length(subtract(onBezier(points, u), place));
    let best = 0;
    for (let i = 1; i <= kSamples; ++i) {
        best = off(i / kSamples) < off(best) ? i / kSamples : best;
    }
    for (let i = 0, step = 0.5 / kSamples; i < kRefinements; ++i, step *= 0.7) {
        for (const other of [Math.max(0, best - step), Math.min(1, best + step)]) {
            best = off(other) < off(best) ? other : best;
        }
    }
    return best;
}

/// The weights of a Bezier curve's points at a parameter: Bernstein's polynomials.
export function bernstein(count: number, u: number): number[] {
    let weights = [1];
    for (let degree = 1; degree < count; ++degree) {
        weights = Array.from({ length: degree + 1 }, (_, i) =>
            (1 - u) * (weights[i] ?? 0) + u * (weights[i - 1] ?? 0));
    }
    return weights;
}

/// The point that has the largest part in a path's place, and this part.
export function leadingPoint(shape: PathShape, place: Triple): { index: number; weight: number } {
    const points = shape.points.map((point) => point.position);
    if (shape.kind === 'bezier' && points.length > 1) {
        const weights = bernstein(points.length, parameterAt(points, place));
        const weight = Math.max(...weights);
        return { index: weights.indexOf(weight), weight };
    }
    const distances = points.map((point) => length(subtract(point, place)));
    return { index: distances.indexOf(Math.min(...distances)), weight: 1 };
}

/// What moves the path's place `from` by `way`.
export function movePath(
    shape: PathShape, from: Triple, way: Triple, precision: number,
): Change[] {
    const { index, weight } = leadingPoint(shape, from);
    const point = shape.points[index];
    return point && length(way) > 0
        ? movePoint(point, add(point.position, scale(1 / weight, way)), precision) : [];
}
