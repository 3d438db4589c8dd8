/// The motion of one object, as docs/timeline.md defines it: positions on cubic Hermite curves,
/// orientations by the integral of a linear angular velocity.
import type { TrackHead, Triple, Turn } from '../protocol';
import { kTimelineNumbersPerKey } from '../protocol';
import { RotationSegment, rotationFromVector, rotationVector } from './rotation';
import { inverse, scale, times, unitTurn } from './vectors';

/// The state of an object at an instant: m, unit quaternion, m/s, rad/s; world axes.
export interface MotionState {
    position: Triple;
    orientation: Turn;
    velocity: Triple;
    angularVelocity: Triple;
}

const kCheckpointSpacing = 16; // substeps
// Two keys that are less than this apart in time and more than that in place are a jump: the object
// was put elsewhere. carom writes them at neighbouring numbers.
const kJumpTime = 1e-12; // s
const kJumpWay = 1e-6; // m

// Where a key's numbers are: pipeline/studio/messages.h, TimelineHead.
const kPosition = 1;
const kOrientation = 4;
const kVelocityIn = 8;
const kVelocityOut = 11;
const kAngularIn = 14;
const kAngularOut = 17;

/// What the orientation between two keys needs, kept once it was asked for.
interface Interval {
    rotation: RotationSegment;
    checkpoints: Turn[]; // the orientation at every kCheckpointSpacing-th substep
    residual: Triple; // rotation vector that remains at the next key
}

/// A track over the numbers of a timeline message, which are not copied.
export class Track {
    readonly name: string;
    readonly keys: number;
    private readonly first: number;
    private readonly intervals: (Interval | undefined)[] = [];

    /// `head` has at least one key.
    constructor(head: TrackHead, private readonly numbers: Float64Array) {
        this.name = head.name;
        this.keys = head.keys;
        this.first = head.first;
    }

    /// The scene time of a key.
    timeOf(key: number): number {
        return this.number(key, 0);
    }

    get start(): number {
        return this.timeOf(0);
    }

    get end(): number {
        return this.timeOf(this.keys - 1);
    }

    /// Whether the position changes at all.
    get moves(): boolean {
        return this.keys > 1;
    }

    positionOf(key: number): Triple {
        return this.triple(key, kPosition);
    }

    /// Whether the object is put elsewhere between a key and the next one, and moves there at once.
    jumpsAfter(key: number): boolean {
        if (key < 0 || key + 1 >= this.keys || this.timeOf(key + 1) - this.timeOf(key) > kJumpTime) {
            return false;
        }
        const [a, b] = [this.positionOf(key), this.positionOf(key + 1)];
        return Math.hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]) > kJumpWay;
    }

    /// The index of the last key at or before the time, at a jump of that after it; -1 before the
    /// first one.
    lastKeyAt(time: number): number {
        let low = -1;
        let high = this.keys - 1;
        while (low < high) {
            const middle = (low + high + 1) >> 1;
            if (this.timeOf(middle) <= time) {
                low = middle;
            } else {
                high = middle - 1;
            }
        }
        while (this.jumpsAfter(low) && time === this.timeOf(low)) {
            ++low;
            time = this.timeOf(low);
        }
        return low;
    }

    /// Defined for every time: before the first and after the last key the object rests there.
    position(time: number): Triple {
        const key = this.keyBefore(time);
        return key === null ? this.restingAt(time, kPosition) : this.hermite(key, time);
    }

    /// Defined for every time, like `position`.
    orientation(time: number): Turn {
        const key = this.keyBefore(time);
        if (key !== null) {
            return this.orientationIn(key, time);
        }
        return this.turn(this.restingKey(time));
    }

    /// Metres per second; 0 outside of all keys.
    speed(time: number): number {
        const key = this.keyBefore(time);
        if (key !== null) {
            return Math.hypot(...this.hermiteVelocity(key, time));
        }
        const at = this.lastKeyAt(time);
        return at >= 0 && at < this.keys - 1 ? Math.hypot(...this.triple(at, kVelocityOut)) : 0;
    }

    /// Everything at an instant; at a break the velocities after it.
    sample(time: number): MotionState {
        const last = this.keys - 1;
        if (time < this.start || !(time <= this.end)) {
            const key = time < this.start ? 0 : last;
            return this.atKey(key, [0, 0, 0], [0, 0, 0]);
        }
        const key = this.lastKeyAt(time);
        if (time <= this.timeOf(key)) {
            return this.atKey(key, this.triple(key, kVelocityOut), this.triple(key, kAngularOut));
        }
        return {
            position: this.hermite(key, time),
            orientation: this.orientationIn(key, time),
            velocity: this.hermiteVelocity(key, time),
            angularVelocity: this.interval(key).rotation.angularVelocity(time - this.timeOf(key)),
        };
    }

    /// The four Bezier control points of the curve between a key and the next one, in metres.
    bezierAfter(key: number): [Triple, Triple, Triple, Triple] {
        const h = this.timeOf(key + 1) - this.timeOf(key);
        const p0 = this.triple(key, kPosition);
        const p1 = this.triple(key + 1, kPosition);
        const out = scale(h / 3, this.triple(key, kVelocityOut));
        const into = scale(-h / 3, this.triple(key + 1, kVelocityIn));
        return [
            p0,
            [p0[0] + out[0], p0[1] + out[1], p0[2] + out[2]],
            [p1[0] + into[0], p1[1] + into[1], p1[2] + into[2]],
            p1,
        ];
    }

    private number(key: number, offset: number): number {
        return this.numbers[this.first + key * kTimelineNumbersPerKey + offset] ?? 0;
    }

    private triple(key: number, offset: number): Triple {
        return [this.number(key, offset), this.number(key, offset + 1), this.number(key, offset + 2)];
    }

    private turn(key: number): Turn {
        return [
            this.number(key, kOrientation), this.number(key, kOrientation + 1),
            this.number(key, kOrientation + 2), this.number(key, kOrientation + 3),
        ];
    }

    private restingKey(time: number): number {
        return time < this.start ? 0 : Math.max(0, this.lastKeyAt(time));
    }

    private restingAt(time: number, offset: number): Triple {
        return this.triple(this.restingKey(time), offset);
    }

    /// The key whose interval contains the time; null at a key and outside of all keys.
    private keyBefore(time: number): number | null {
        const key = this.lastKeyAt(time);
        const isBetween = key >= 0 && key < this.keys - 1 && time > this.timeOf(key);
        return isBetween ? key : null;
    }

    private atKey(key: number, velocity: Triple, angularVelocity: Triple): MotionState {
        return {
            position: this.triple(key, kPosition), orientation: this.turn(key), velocity,
            angularVelocity,
        };
    }

    /// p0 + s (c1 + s (c2 + s c3)) with s in [0, 1].
    private hermite(key: number, time: number): Triple {
        const h = this.timeOf(key + 1) - this.timeOf(key);
        const s = (time - this.timeOf(key)) / h;
        const along = (i: number) => {
            const [p0, c1, c2, c3] = this.coefficients(key, i, h);
            return p0 + s * (c1 + s * (c2 + s * c3));
        };
        return [along(0), along(1), along(2)];
    }

    private hermiteVelocity(key: number, time: number): Triple {
        const h = this.timeOf(key + 1) - this.timeOf(key);
        const s = (time - this.timeOf(key)) / h;
        const along = (i: number) => {
            const [, c1, c2, c3] = this.coefficients(key, i, h);
            return (c1 + s * (2 * c2 + 3 * s * c3)) / h;
        };
        return [along(0), along(1), along(2)];
    }

    private coefficients(key: number, i: number, h: number): [number, number, number, number] {
        const p0 = this.number(key, kPosition + i);
        const d = this.number(key + 1, kPosition + i) - p0;
        const m0 = h * this.number(key, kVelocityOut + i);
        const m1 = h * this.number(key + 1, kVelocityIn + i);
        return [p0, m0, 3 * d - 2 * m0 - m1, m0 + m1 - 2 * d];
    }

    private interval(key: number): Interval {
        const known = this.intervals[key];
        if (known) {
            return known;
        }
        const rotation = new RotationSegment(
            this.triple(key, kAngularOut), this.triple(key + 1, kAngularIn),
            this.timeOf(key + 1) - this.timeOf(key),
        );
        const checkpoints: Turn[] = [];
        let orientation = this.turn(key);
        for (let substep = 0; substep < rotation.substeps;) {
            checkpoints.push(orientation);
            const next = Math.min(substep + kCheckpointSpacing, rotation.substeps);
            orientation = rotation.advance(orientation, substep, next);
            substep = next;
        }
        const residual = rotationVector(times(this.turn(key + 1), inverse(orientation)));
        const made = { rotation, checkpoints, residual };
        this.intervals[key] = made;
        return made;
    }

    private orientationIn(key: number, time: number): Turn {
        const { rotation, checkpoints, residual } = this.interval(key);
        const elapsed = time - this.timeOf(key);
        const substep = rotation.substepAt(elapsed);
        const checkpoint = Math.floor(substep / kCheckpointSpacing);
        const from = checkpoints[checkpoint] ?? this.turn(key);
        const start = rotation.advance(from, checkpoint * kCheckpointSpacing, substep);
        const turned = rotation.finish(start, substep, elapsed);
        const fraction = elapsed / (this.timeOf(key + 1) - this.timeOf(key));
        return unitTurn(times(rotationFromVector(scale(fraction, residual)), turned));
    }
}
