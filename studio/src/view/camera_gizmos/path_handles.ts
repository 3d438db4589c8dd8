/// The handles of a camera's paths: control points, and the measures of orbits.
import type { Change } from '../../edit/edit';
import { add, rotate, scale, subtract, inverse } from '../../motion/vectors';
import type { Camera, KeyPath, Orbit, PathPoint, PathShape, Triple } from '../../protocol';
import { valueAt } from '../gizmos/shot_values';
import { shortAngle, stepOf } from '../gizmos/rays';
import type { Handle } from '../handles/handle';

const kDegree = Math.PI / 180;
const kSmallestRadius = 1e-3; // m

/// Where the place of a point is written: itself, or its offset from an object.
export function writtenAt(point: PathPoint): KeyPath {
    const isOffset = point.path[point.path.length - 1] === 'offset';
    return point.of === '' || isOffset ? point.path : [...point.path, 'offset'];
}

/// What moves a point of a path to a place.
export function movePoint(point: PathPoint, to: Triple, precision: number): Change[] {
    const value = add(point.offset, subtract(to, point.position));
    return [{ path: writtenAt(point), value, precision }];
}

/// A place on the ellipse of an orbit.
export function onOrbit(orbit: Orbit, centre: Triple, angle: number): Triple {
    return add(centre, rotate(orbit.turn,
        [orbit.radii[0] * Math.cos(angle), orbit.radii[1] * Math.sin(angle), 0]));
}

/// The path of one of a camera's two shapes with their colour.
export interface DrawnPath {
    camera: Camera;
    part: 'position' | 'target';
    shape: PathShape;
    colour: number;
}

export function drawnPaths(camera: Camera, colour: number, targetColour: number): DrawnPath[] {
    return [
        { camera, part: 'position', shape: camera.position, colour },
        { camera, part: 'target', shape: camera.target, colour: targetColour },
    ];
}

function orbitHandles({ camera, part, shape, colour }: DrawnPath, orbit: Orbit): Handle[] {
    const centre = shape.points[0]?.position ?? [0, 0, 0];
    const path = [...camera.path, part];
    const normal = rotate(orbit.turn, [0, 0, 1]);
    const own = (key: string) => [...path, key];
    const radius = (axis: 0 | 1): Handle => {
        const along = rotate(orbit.turn, axis === 0 ? [1, 0, 0] : [0, 1, 0]);
        const isOne = typeof valueAt(own('radius')) === 'number';
        return {
            key: [...own('radius'), axis].join('/'), path: own('radius'), colour,
            at: add(centre, scale(orbit.radii[axis], along)), shape: 'square', size: 9,
            label: `${camera.name}: ${isOne ? 'radius' : axis === 0 ? 'radius along x' : 'radius along y'}`,
            way: { kind: 'line', along },
            changes: (to, precision) => {
                const from = subtract(to, centre);
                const length = Math.max(kSmallestRadius,
                    from[0] * along[0] + from[1] * along[1] + from[2] * along[2]);
                const value = isOne ? length
                    : orbit.radii.map((old, i) => (i === axis ? length : old));
                return [{ path: own('radius'), value, precision }];
            },
        };
    };
    const angle = (end: 0 | 1): Handle => ({
        key: [...own('angles'), end].join('/'), path: own('angles'), colour,
        at: onOrbit(orbit, centre, orbit.angles[end]), shape: 'ring', size: 14,
        label: `${camera.name}: ${end === 0 ? 'start' : 'end'} angle`,
        way: { kind: 'plane', normal },
        changes: (to, precision) => {
            const local = rotate(inverse(orbit.turn), subtract(to, centre));
            const raw = Math.atan2(local[1] / orbit.radii[1], local[0] / orbit.radii[0]);
            const old = orbit.angles[end];
            const moved = old + shortAngle(raw - old);
            const step = stepOf(precision / Math.max(...orbit.radii) / kDegree, 1e-4, 0.1) * kDegree;
            return [{
                path: own('angles'), precision: step,
                value: orbit.angles.map((value, i) => (i === end ? moved : value)),
            }];
        },
    });
    return [radius(0), radius(1), angle(0), angle(1)];
}

/// All handles of a path.
export function pathHandles(path: DrawnPath): Handle[] {
    const { camera, part, shape, colour } = path;
    const isOrbit = shape.orbit !== undefined;
    const points = shape.points.map((point, i): Handle => ({
        key: `${[...camera.path, part, i].join('/')}`, at: point.position, path: point.path, colour,
        shape: part === 'target' || isOrbit ? 'diamond' : 'ring', size: 14,
        label: `${camera.name}: ${pointName(path, point, i)}`,
        way: { kind: 'free' },
        changes: (to, precision) => movePoint(point, to, precision),
    }));
    return shape.orbit ? [...points, ...orbitHandles(path, shape.orbit)] : points;
}

function pointName({ part, shape }: DrawnPath, point: PathPoint, index: number): string {
    const what = shape.orbit ? 'centre' : shape.points.length > 1 ? `${part} ${index + 1}` : part;
    return point.of === '' ? what : `${what}, from ${point.of}`;
}
