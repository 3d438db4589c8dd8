/// Vectors and quaternions as plain tuples in double precision: the timeline's accuracy (1e-9 m) is
/// beyond the 32-bit floats of the drawing library.
import type { Triple, Turn } from '../protocol';

export function add(a: Triple, b: Triple): Triple {
    return [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
}

export function subtract(a: Triple, b: Triple): Triple {
    return [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
}

export function scale(factor: number, a: Triple): Triple {
    return [factor * a[0], factor * a[1], factor * a[2]];
}

export function mix(a: Triple, b: Triple, weight: number): Triple {
    return add(a, scale(weight, subtract(b, a)));
}

export function dot(a: Triple, b: Triple): number {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

export function cross(a: Triple, b: Triple): Triple {
    return [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ];
}

export function length(a: Triple): number {
    return Math.hypot(a[0], a[1], a[2]);
}

/// The vector of length 1 in the direction of `a`; zero for zero.
export function unit(a: Triple): Triple {
    const size = length(a);
    return size > 0 ? scale(1 / size, a) : [0, 0, 0];
}

/// The product of two quaternions: the rotation `b` followed by the rotation `a`.
export function times(a: Turn, b: Turn): Turn {
    return [
        a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
        a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
        a[0] * b[2] + a[2] * b[0] + a[3] * b[1] - a[1] * b[3],
        a[0] * b[3] + a[3] * b[0] + a[1] * b[2] - a[2] * b[1],
    ];
}

/// The inverse of a unit quaternion.
export function inverse(q: Turn): Turn {
    return [q[0], -q[1], -q[2], -q[3]];
}

export function unitTurn(q: Turn): Turn {
    const size = Math.hypot(q[0], q[1], q[2], q[3]);
    return [q[0] / size, q[1] / size, q[2] / size, q[3] / size];
}

/// The vector after the rotation `q`.
export function rotate(q: Turn, v: Triple): Triple {
    const axis: Triple = [q[1], q[2], q[3]];
    const twice = scale(2, cross(axis, v));
    return add(add(v, scale(q[0], twice)), cross(axis, twice));
}
