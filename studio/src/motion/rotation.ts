/// The rotation between two keys of a track, whose angular velocity changes linearly: equal substeps
/// by the series of Magnus (docs/timeline.md, "Orientation").
import type { Triple, Turn } from '../protocol';
import { add, cross, length, mix, scale, times } from './vectors';

const kLargestSubstep = 0.5; // rad
/// Below this angle about the perpendicular part, one step for nearly parallel angular velocities
/// has an error of less than rounding.
const kParallelError = 1e-13; // rad
const kMostSubsteps = 1e9;

/// The rotation by |vector| radians, right-handed, about the direction of `vector`.
export function rotationFromVector(vector: Triple): Turn {
    const half = length(vector) / 2;
    const factor = half < 1e-8 ? 0.5 : Math.sin(half) / (2 * half);
    return [Math.cos(half), factor * vector[0], factor * vector[1], factor * vector[2]];
}

/// The inverse: a vector of length at most pi. The rotations q and -q give the same.
export function rotationVector(q: Turn): Triple {
    const sign = q[0] < 0 ? -1 : 1;
    const sine = Math.hypot(q[1], q[2], q[3]);
    const cosine = sign * q[0];
    const factor = sine < 1e-8 ? 2 : (2 * Math.atan2(sine, cosine)) / sine;
    return scale(sign * factor, [q[1], q[2], q[3]]);
}

/// The rotation during `duration` by an angular velocity (world axes, rad/s) that changes linearly
/// from `before` to `after`; the first two terms of the series. It is applied from the left.
export function magnusStep(before: Triple, after: Triple, duration: number): Turn {
    return rotationFromVector(add(
        scale(0.5 * duration, add(before, after)),
        scale((duration * duration) / 12, cross(after, before)),
    ));
}

/// The number of equal substeps between two keys; 1 if both angular velocities are parallel.
export function countSubsteps(before: Triple, after: Triple, duration: number): number {
    const largest = Math.max(length(before), length(after));
    if (largest === 0) {
        return 1;
    }
    const perpendicular = length(cross(before, after)) / largest;
    if (perpendicular * duration <= kParallelError) {
        return 1;
    }
    const count = Math.ceil((largest * duration) / kLargestSubstep);
    return Math.min(Math.max(1, count), kMostSubsteps);
}

/// The rotation from one key to the next.
export class RotationSegment {
    readonly substeps: number;

    /// Angular velocities in world axes, rad/s; the duration in s, above 0.
    constructor(
        private readonly before: Triple,
        private readonly after: Triple,
        private readonly duration: number,
    ) {
        this.substeps = countSubsteps(before, after, duration);
    }

    angularVelocity(elapsed: number): Triple {
        const s = Math.min(Math.max(elapsed / this.duration, 0), 1);
        return mix(this.before, this.after, s);
    }

    /// The substep that contains `elapsed`, in s since the beginning.
    substepAt(elapsed: number): number {
        const place = Math.floor((elapsed / this.duration) * this.substeps);
        return Math.min(Math.max(place, 0), this.substeps - 1);
    }

    /// The orientation at the beginning of substep `last`, from that at the beginning of `first`.
    advance(orientation: Turn, first: number, last: number): Turn {
        let turned = orientation;
        for (let substep = first; substep < last; ++substep) {
            turned = this.step(turned, this.beginningOf(substep), this.beginningOf(substep + 1));
        }
        return turned;
    }

    /// The orientation at `elapsed`, from that at the beginning of its substep.
    finish(orientation: Turn, substep: number, elapsed: number): Turn {
        return this.step(orientation, this.beginningOf(substep), elapsed);
    }

    private step(orientation: Turn, from: number, to: number): Turn {
        const turn = magnusStep(this.angularVelocity(from), this.angularVelocity(to), to - from);
        return times(turn, orientation);
    }

    private beginningOf(substep: number): number {
        return (this.duration * substep) / this.substeps;
    }
}
