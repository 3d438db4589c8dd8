/// The axes of an object as the shot writes them (`at`, `rotate`, `scale`, `axes`), and rotations
/// written back in the shot's own way.
import type { Triple, Turn } from '../../protocol';
import { add, cross, dot, rotate, scale, times, unit, unitTurn } from '../../motion/vectors';
import { rotationFromVector, rotationVector } from '../../motion/rotation';

/// Where the object's origin is, and to which vectors its own axes are mapped.
export interface ObjectFrame {
    origin: Triple;
    axes: [Triple, Triple, Triple];
}

export const kAxes: readonly [Triple, Triple, Triple] = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];

/// A rotation by `angle` rad about an axis of any length.
export function turnAbout(axis: Triple, angle: number): Turn {
    return rotationFromVector(scale(angle, unit(axis)));
}

/// The rotation by three angles (rad) about the world's x, y and z axis in this order.
export function turnOfAngles([x, y, z]: Triple): Turn {
    return times(turnAbout([0, 0, 1], z), times(turnAbout([0, 1, 0], y), turnAbout([1, 0, 0], x)));
}

/// The inverse: angles (rad) whose second is within a quarter turn. Where x and z turn about the
/// same axis, x is 0.
export function anglesOfTurn(turn: Turn): Triple {
    const q = unitTurn(turn);
    const x = rotate(q, [1, 0, 0]);
    const y = rotate(q, [0, 1, 0]);
    const z = rotate(q, [0, 0, 1]);
    const sine = -x[2];
    if (Math.abs(sine) > 1 - 1e-9) {
        return [0, (Math.sign(sine) * Math.PI) / 2, Math.atan2(-y[0], y[1])];
    }
    return [Math.atan2(y[2], z[2]), Math.asin(sine), Math.atan2(x[1], x[0])];
}

/// The angles of the same rotation that are nearest to `old`, so that as few numbers as possible
/// change: three angles can be written in two ways, and with whole turns more.
export function anglesLike(turn: Turn, old: Triple): Triple {
    const first = anglesOfTurn(turn);
    const second: Triple = [first[0] + Math.PI, Math.PI - first[1], first[2] + Math.PI];
    const near = (angles: Triple): Triple => angles.map((angle, i) => {
        const from = old[i] ?? 0;
        return angle + 2 * Math.PI * Math.round((from - angle) / (2 * Math.PI));
    }) as Triple;
    const way = (angles: Triple) =>
        angles.reduce((sum, a, i) => sum + Math.abs(a - (old[i] ?? 0)), 0);
    const [a, b] = [near(first), near(second)];
    return way(b) < way(a) - 1e-9 ? b : a;
}

/// How a shot writes a rotation.
export type RotationText =
    | { kind: 'none' }
    | { kind: 'angles'; angles: Triple }
    | { kind: 'axis'; axis: Triple; angle: number }
    | { kind: 'axes'; axes: [Triple, Triple, Triple] };

/// What has to be written for the rotation `turn` followed after the present one: keys below the
/// object, and their new values.
export interface RotationChange {
    key: string[];
    value: number | Triple | Triple[];
}

/// The rotation that the text means; `axes` is no rotation and gives none.
export function turnOf(text: RotationText): Turn {
    if (text.kind === 'angles') {
        return turnOfAngles(text.angles);
    }
    return text.kind === 'axis' ? turnAbout(text.axis, text.angle) : [1, 0, 0, 0];
}

/// Turns what `text` says by `angle` rad about a world axis. `now` is the present rotation if the
/// text has none (a ball whose orientation the seed chooses).
export function turned(
    text: RotationText, axis: Triple, angle: number, now: Turn = [1, 0, 0, 0],
): RotationChange[] {
    const more = turnAbout(axis, angle);
    if (text.kind === 'axes') {
        return [{ key: ['axes'], value: text.axes.map((one) => rotate(more, one)) }];
    }
    if (text.kind === 'axis') {
        const along = dot(unit(text.axis), unit(axis));
        if (Math.abs(along) > 1 - 1e-9) {
            return [{ key: ['rotate', 'angle'], value: text.angle + Math.sign(along) * angle }];
        }
        const vector = rotationVector(times(more, turnOf(text)));
        const size = Math.hypot(...vector);
        // Without any rotation the old axis is as good as any.
        return size < 1e-9 ? [{ key: ['rotate', 'angle'], value: 0 }] : [
            { key: ['rotate', 'axis'], value: unit(vector) },
            { key: ['rotate', 'angle'], value: size },
        ];
    }
    const before = text.kind === 'angles' ? text.angles : anglesOfTurn(now);
    const after = anglesLike(times(more, turnOfAngles(before)), before);
    return [{ key: ['rotate'], value: after }];
}

/// The frame of an object. `scales` are the factors of its own axes.
export function frameOf(origin: Triple, text: RotationText, scales: Triple): ObjectFrame {
    if (text.kind === 'axes') {
        return { origin, axes: text.axes };
    }
    const turn = turnOf(text);
    const axes = kAxes.map((axis, i) => scale(scales[i] ?? 1, rotate(turn, axis)));
    return { origin, axes: axes as [Triple, Triple, Triple] };
}

/// From the object's coordinates to the world's.
export function toWorld(frame: ObjectFrame, local: Triple): Triple {
    const [x, y, z] = frame.axes;
    return add(frame.origin, add(scale(local[0], x), add(scale(local[1], y), scale(local[2], z))));
}

/// The inverse; null if the axes lie in a plane.
export function toLocal(frame: ObjectFrame, world: Triple): Triple | null {
    const [x, y, z] = frame.axes;
    const volume = dot(x, cross(y, z));
    if (Math.abs(volume) < 1e-15) {
        return null;
    }
    const from: Triple = [world[0] - frame.origin[0], world[1] - frame.origin[1],
        world[2] - frame.origin[2]];
    return [dot(from, cross(y, z)) / volume, dot(from, cross(z, x)) / volume,
        dot(from, cross(x, y)) / volume];
}
