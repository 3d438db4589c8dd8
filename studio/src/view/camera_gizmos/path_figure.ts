/// The paths of a camera as lines, with a mark for each frame of the film.
import type { CameraFramesOf } from '../../motion/camera_frames';
import type { Triple } from '../../protocol';
import type { Dot, Figure, Line } from '../gizmos/figure';
import { add, length, scale, subtract } from '../../motion/vectors';
import { axisEnd, centreOf } from './orbit_handles';
import type { DrawnPath } from './path_handles';

const kMostTicks = 1500;
const kFirstTick = 0xff3b3b; // the first frame
const kTick = 3.5; // CSS pixels
const kFirst = 8;
const kLooks = 24; // directions of view along a path, at most
const kLook = 0.12; // m; shorter where what is looked at is near

function polyline(curve: readonly number[], colour: number, isFaint: boolean): Line[] {
    const lines: Line[] = [];
    for (let i = 0; i + 5 < curve.length; i += 3) {
        lines.push({
            from: curve.slice(i, i + 3) as Triple, to: curve.slice(i + 3, i + 6) as Triple,
            colour, isFaint,
        });
    }
    return lines;
}

/// The lines between the control points of a Bezier curve.
function polygon({ shape, colour }: DrawnPath): Line[] {
    return shape.kind !== 'bezier' ? [] : shape.points.slice(1).map((point, i) =>
        ({ from: shape.points[i]?.position ?? point.position, to: point.position, colour,
            isFaint: true }));
}

/// The axis of an orbit, with whose end its plane is tilted.
function orbitAxis(path: DrawnPath): Line[] {
    const { orbit } = path.shape;
    return orbit ? [{ from: centreOf(path), to: axisEnd(orbit, centreOf(path)), colour: path.colour,
        isFaint: true }] : [];
}

/// Short lines along the path of a camera towards what it looks at.
export function lookFigure(frames: CameraFramesOf, colour: number): Figure {
    const step = Math.max(1, Math.ceil(frames.count / kLooks));
    const lines: Line[] = [];
    for (let i = 0; i < frames.count; i += step) {
        const { position, target } = frames.at(i).pose;
        const way = subtract(target, position);
        const share = Math.min(0.5, kLook / Math.max(length(way), 1e-9));
        lines.push({ from: position, to: add(position, scale(share, way)), colour, isFaint: true });
    }
    return { lines };
}

export function pathFigure(path: DrawnPath, isSelected: boolean): Figure {
    const isStrong = isSelected && path.part === 'position';
    return {
        lines: [
            ...polyline(path.shape.curve, path.colour, !isStrong),
            ...(isSelected ? [...polygon(path), ...orbitAxis(path)] : []),
        ],
    };
}

/// A dot where the camera is in each frame of the film; the first one is red. Of a camera that is not
/// active only the first.
export function tickFigure(frames: CameraFramesOf, colour: number, isActive: boolean): Figure {
    if (frames.count === 0) {
        return {};
    }
    const step = Math.max(1, Math.ceil(frames.count / kMostTicks));
    const dots: Dot[] = [];
    for (let i = isActive ? step : frames.count; i < frames.count; i += step) {
        dots.push({ at: frames.at(i).pose.position, colour, size: kTick, shape: 'disc' });
    }
    dots.push({
        at: frames.at(0).pose.position, colour: kFirstTick, size: kFirst, shape: 'disc',
    });
    return { dots };
}
