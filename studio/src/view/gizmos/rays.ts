/// Rays against planes and axes, for handles that are dragged.
import type { Triple } from '../../protocol';
import { add, cross, dot, scale, subtract, unit } from '../../motion/vectors';

/// A half line in the world; `direction` has length 1.
export interface Ray {
    origin: Triple;
    direction: Triple;
}

const kGrazing = 0.02; // sine of the angle below which a ray and a plane count as parallel

/// Where the ray meets the plane through `point` perpendicular to `normal`; null if it does not.
export function onPlane(ray: Ray, point: Triple, normal: Triple): Triple | null {
    const n = unit(normal);
    const slope = dot(ray.direction, n);
    if (Math.abs(slope) < 1e-9) {
        return null;
    }
    const distance = dot(subtract(point, ray.origin), n) / slope;
    return distance > 0 ? add(ray.origin, scale(distance, ray.direction)) : null;
}

/// The place on the axis through `origin` along `axis` (of any length) that is nearest to the ray,
/// in metres from `origin`; null if both are nearly parallel.
export function alongAxis(ray: Ray, origin: Triple, axis: Triple): number | null {
    const a = unit(axis);
    const between = subtract(ray.origin, origin);
    const b = dot(a, ray.direction);
    const sine = 1 - b * b;
    if (sine < kGrazing * kGrazing) {
        return null;
    }
    return (dot(between, a) - b * dot(between, ray.direction)) / sine;
}

/// Two unit vectors that make a right-handed system with `axis`: x, y, axis.
export function planeAxes(axis: Triple): [Triple, Triple] {
    const z = unit(axis);
    const other: Triple = Math.abs(z[2]) < 0.9 ? [0, 0, 1] : [1, 0, 0];
    const x = unit(cross(other, z));
    return [x, cross(z, x)];
}

/// The angle (rad) of the ray's place around an axis, counter-clockwise when the axis points
/// towards the viewer, from the first of planeAxes; null if the ray runs along the plane.
export function angleAround(ray: Ray, origin: Triple, axis: Triple): number | null {
    if (Math.abs(dot(ray.direction, unit(axis))) < kGrazing) {
        return null;
    }
    const point = onPlane(ray, origin, axis);
    if (!point) {
        return null;
    }
    const [x, y] = planeAxes(axis);
    const from = subtract(point, origin);
    return Math.atan2(dot(from, y), dot(from, x));
}

/// The angle between -pi and pi that is equal to `angle` but for whole turns.
export function shortAngle(angle: number): number {
    const turns = angle / (2 * Math.PI);
    return 2 * Math.PI * (turns - Math.round(turns));
}

/// The step, a power of ten times 1, that is at most `size` and within [finest, coarsest].
export function stepOf(size: number, finest: number, coarsest: number): number {
    const power = 10 ** Math.floor(Math.log10(Math.max(size, 1e-12)) + 1e-9);
    return Math.min(Math.max(power, finest), coarsest);
}
