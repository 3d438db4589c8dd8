/// The handles of a camera's paths: control points, and what an orbit has.
import type { Change } from '../../edit/edit';
import { add, subtract } from '../../motion/vectors';
import type { Camera, KeyPath, PathPoint, PathShape, Triple } from '../../protocol';
import type { Handle } from '../handles/handle';
import { freePoint, isDerived } from './free_point';
import { orbitHandles } from './orbit_handles';

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

/// All handles of a path.
export function pathHandles(path: DrawnPath): Handle[] {
    const { camera, part, shape, colour } = path;
    const isOrbit = shape.orbit !== undefined;
    const points = shape.points.map((point, i): Handle => ({
        key: `${[...camera.path, part, i].join('/')}`, at: point.position, path: point.path, colour,
        shape: part === 'target' || isOrbit ? 'diamond' : 'ring', size: 14,
        label: `${camera.name}: ${pointName(path, point, i)}`,
        way: { kind: 'free' },
        changes: (to, precision, isFreed) => isFreed && isDerived(point)
            ? freePoint(camera, part, point, to, precision) : movePoint(point, to, precision),
    }));
    return shape.orbit ? [...points, ...orbitHandles(path, shape.orbit)] : points;
}

function pointName({ part, shape }: DrawnPath, point: PathPoint, index: number): string {
    const what = shape.orbit ? 'centre' : shape.points.length > 1 ? `${part} ${index + 1}` : part;
    return point.of === '' ? what : `${what}, from ${point.of}; Alt frees it`;
}
