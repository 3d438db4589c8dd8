/// The handles of a camera's orbit: its two radii, its two angles, and the tilt of its plane.
import type { Change } from '../../edit/edit';
import { add, cross, dot, inverse, length, rotate, scale, subtract, unit } from '../../motion/vectors';
import type { KeyPath, Orbit, Triple } from '../../protocol';
import { turned } from '../gizmos/object_frame';
import { shortAngle, stepOf } from '../gizmos/rays';
import { rotationAt, valueAt } from '../gizmos/shot_values';
import type { Handle } from '../handles/handle';
import type { DrawnPath } from './path_handles';

const kDegree = Math.PI / 180;
const kTurnPrecision = 0.1 * kDegree;
const kSmallestRadius = 1e-3; // m
const kAxisShare = 0.5; // of the larger radius, from the centre to the handle of the tilt

/// A place on the ellipse of an orbit.
export function onOrbit(orbit: Orbit, centre: Triple, angle: number): Triple {
    return add(centre, rotate(orbit.turn,
        [orbit.radii[0] * Math.cos(angle), orbit.radii[1] * Math.sin(angle), 0]));
}

export function centreOf({ shape }: DrawnPath): Triple {
    return shape.points[0]?.position ?? [0, 0, 0];
}

/// The end of the orbit's axis, which tilts its plane.
export function axisEnd(orbit: Orbit, centre: Triple): Triple {
    return add(centre, scale(kAxisShare * Math.max(...orbit.radii), rotate(orbit.turn, [0, 0, 1])));
}

/// What turns the plane of an orbit so that its axis points to a place; `path` is that of `turn`.
export function tiltChanges(orbit: Orbit, centre: Triple, to: Triple, path: KeyPath): Change[] {
    const before = rotate(orbit.turn, [0, 0, 1]);
    const way = subtract(to, centre);
    const about = length(way) > 1e-9 ? cross(before, unit(way)) : [0, 0, 0] as Triple;
    if (length(about) < 1e-9) {
        return [];
    }
    const angle = Math.atan2(length(about), dot(before, unit(way)));
    return turned(rotationAt(path), unit(about), angle, orbit.turn).map(({ key, value }): Change => ({
        path: [...path, ...key.slice(1)], value,
        precision: key.includes('axis') ? 1e-5 : kTurnPrecision,
    }));
}

export function orbitHandles(drawn: DrawnPath, orbit: Orbit): Handle[] {
    return [
        radiusHandle(drawn, orbit, 0), radiusHandle(drawn, orbit, 1),
        angleHandle(drawn, orbit, 0), angleHandle(drawn, orbit, 1),
        tiltHandle(drawn, orbit),
    ];
}

function radiusHandle(drawn: DrawnPath, orbit: Orbit, axis: 0 | 1): Handle {
    const { camera, part, colour } = drawn;
    const centre = centreOf(drawn);
    const path = [...camera.path, part, 'radius'];
    const along = rotate(orbit.turn, axis === 0 ? [1, 0, 0] : [0, 1, 0]);
    const isOne = typeof valueAt(path) === 'number';
    return {
        key: [...path, axis].join('/'), path, colour,
        at: add(centre, scale(orbit.radii[axis], along)), shape: 'square', size: 9,
        label: `${camera.name}: ${isOne ? 'radius' : axis === 0 ? 'radius along x' : 'radius along y'}`,
        way: { kind: 'line', along },
        changes: (to, precision) => {
            const reach = Math.max(kSmallestRadius, dot(subtract(to, centre), along));
            const value = isOne ? reach
                : orbit.radii.map((old, i) => (i === axis ? reach : old));
            return [{ path, value, precision }];
        },
    };
}

function angleHandle(drawn: DrawnPath, orbit: Orbit, end: 0 | 1): Handle {
    const { camera, part, colour } = drawn;
    const centre = centreOf(drawn);
    const path = [...camera.path, part, 'angles'];
    return {
        key: [...path, end].join('/'), path, colour,
        at: onOrbit(orbit, centre, orbit.angles[end]), shape: 'ring', size: 14,
        label: `${camera.name}: ${end === 0 ? 'start' : 'end'} angle`,
        way: { kind: 'plane', normal: rotate(orbit.turn, [0, 0, 1]) },
        changes: (to, precision) => {
            const local = rotate(inverse(orbit.turn), subtract(to, centre));
            const raw = Math.atan2(local[1] / orbit.radii[1], local[0] / orbit.radii[0]);
            const old = orbit.angles[end];
            const moved = old + shortAngle(raw - old);
            const step = stepOf(precision / Math.max(...orbit.radii) / kDegree, 1e-4, 0.1) * kDegree;
            return [{
                path, precision: step,
                value: orbit.angles.map((value, i) => (i === end ? moved : value)),
            }];
        },
    };
}

function tiltHandle(drawn: DrawnPath, orbit: Orbit): Handle {
    const { camera, part, colour } = drawn;
    const centre = centreOf(drawn);
    const path = [...camera.path, part, 'turn'];
    return {
        key: path.join('/'), path, colour, at: axisEnd(orbit, centre), shape: 'disc', size: 10,
        label: `${camera.name}: tilt of the orbit`, way: { kind: 'free' },
        changes: (to) => tiltChanges(orbit, centre, to, path),
    };
}
