import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { join } from 'node:path';
import type { Triple, Turn } from '../../src/protocol';
import { cameraAxes, mixPoses, projectPoint } from '../../src/motion/camera';
import type { CameraAxes, CameraPose } from '../../src/motion/camera';
import { Track } from '../../src/motion/track';
import { polyline } from '../../src/view/trail_lines';
import { cross, dot, length, subtract } from '../../src/motion/vectors';

// Keys and samples of the same tracks, computed by carom (data/make_motion.mjs).
interface Sample {
    time: number;
    position: Triple;
    orientation: Turn;
    velocity: Triple;
    angular_velocity: Triple;
}
interface Key extends Sample {
    velocity_before?: Triple;
    angular_velocity_before?: Triple;
}
interface CameraKey {
    position: Triple;
    target: Triple;
    orientation: Turn;
    vertical_fov: number;
}
interface Data {
    cue: { keys: Key[]; samples: Sample[] };
    two: { keys: Key[]; samples: Sample[] };
    cameras: { name: string; keys: CameraKey[] }[];
}

const folder = join(__REPOSITORY__, 'studio/test/unit/data');
const data = JSON.parse(readFileSync(join(folder, 'motion.json'), 'utf8')) as Data;

/// A track from keys as the export writes them.
function trackOf(name: 'cue' | 'two'): Track {
    const numbers = data[name].keys.flatMap((key) => [
        key.time, ...key.position, ...key.orientation,
        ...(key.velocity_before ?? key.velocity), ...key.velocity,
        ...(key.angular_velocity_before ?? key.angular_velocity), ...key.angular_velocity,
    ]);
    // The first number is not the track's: `first` must be respected.
    const keys = data[name].keys.length;
    return new Track({ name, first: 1, keys }, Float64Array.from([NaN, ...numbers]));
}

function assertClose(actual: readonly number[], expected: readonly number[], what: string): void {
    expected.forEach((value, i) => {
        const error = Math.abs((actual[i] ?? NaN) - value);
        assert.ok(error < 1e-9 * Math.max(1, Math.abs(value)), `${what}: ${actual} != ${expected}`);
    });
}

/// The angle between two orientations, rad.
function angleBetween(a: Turn, b: Turn): number {
    const cosine = Math.abs(a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3]);
    const sign = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3] < 0 ? -1 : 1;
    const distance = Math.hypot(...a.map((x, i) => x - sign * (b[i] ?? 0)));
    return cosine < 0.9 ? 2 * Math.acos(cosine) : 2 * distance;
}

for (const name of ['cue', 'two'] as const) {
    test(`Track_AtTimesOfCarom_GivesItsStates: ${name}`, () => {
        const track = trackOf(name);
        assert.ok(data[name].samples.length > 20);
        for (const sample of data[name].samples) {
            const state = track.sample(sample.time);
            const at = `at ${sample.time} s`;
            assertClose(state.position, sample.position, `position ${at}`);
            assertClose(state.velocity, sample.velocity, `velocity ${at}`);
            assertClose(state.angularVelocity, sample.angular_velocity, `turning ${at}`);
            const angle = angleBetween(state.orientation, sample.orientation);
            assert.ok(angle < 1e-9, `orientation ${at}: ${angle} rad away`);
            assertClose(track.position(sample.time), sample.position, `position alone ${at}`);
            assert.deepEqual(track.orientation(sample.time), state.orientation);
        }
    });

    test(`Track_AtKeys_HasTheKeysValuesAndTheVelocitiesAfterIt: ${name}`, () => {
        const track = trackOf(name);
        assert.ok(data[name].keys.some((key) => key.velocity_before));
        data[name].keys.forEach((key, index) => {
            const state = track.sample(key.time);
            assert.deepEqual(state.position, key.position);
            assert.deepEqual(state.orientation, key.orientation);
            assert.deepEqual(state.velocity, key.velocity);
            assert.deepEqual(state.angularVelocity, key.angular_velocity);
            assert.equal(track.lastKeyAt(key.time), index);
        });
    });

    test(`Track_JustBeforeABreak_HasTheVelocitiesBeforeIt: ${name}`, () => {
        const track = trackOf(name);
        data[name].keys.filter((key) => key.velocity_before && key.time > 0.3).forEach((key) => {
            const state = track.sample(key.time - 1e-9);
            const change = length(subtract(state.velocity, key.velocity_before ?? [0, 0, 0]));
            assert.ok(change < 1e-6, `at ${key.time} s: ${change} m/s`);
            assert.ok(angleBetween(state.orientation, key.orientation) < 1e-6);
        });
    });

    test(`Track_OutsideOfItsKeys_Rests: ${name}`, () => {
        const track = trackOf(name);
        const keys = data[name].keys;
        for (const [time, key] of [[-5, keys[0]], [1e9, keys[keys.length - 1]]] as const) {
            const state = track.sample(time);
            assert.deepEqual(state.position, key?.position);
            assert.deepEqual(track.position(time), key?.position);
            assert.deepEqual(track.orientation(time), key?.orientation);
            assert.deepEqual(state.velocity, [0, 0, 0]);
            assert.deepEqual(state.angularVelocity, [0, 0, 0]);
        }
    });
}

test('Track_BezierPoints_DrawTheSameCurve', () => {
    const track = trackOf('cue');
    const key = 1;
    const [a, b, c, d] = track.bezierAfter(key);
    const s = 0.3;
    const weights = [(1 - s) ** 3, 3 * s * (1 - s) ** 2, 3 * s * s * (1 - s), s ** 3];
    const time = track.timeOf(key) + s * (track.timeOf(key + 1) - track.timeOf(key));
    const point = [0, 1, 2].map((i) =>
        [a, b, c, d].reduce((sum, p, n) => sum + (weights[n] ?? 0) * (p[i] ?? 0), 0));
    assertClose(point, track.position(time), 'Bezier');
});

function pose(position: Triple, target: Triple, up: Triple, roll: number): CameraPose {
    return { position, target, up, roll, verticalFov: 0.7, focusDistance: 1, lensRadius: 0 };
}

/// The columns of a rotation: what it makes of x, y and z.
function columns([w, x, y, z]: Turn): CameraAxes {
    return {
        right: [1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)],
        up: [2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)],
        back: [2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)],
    };
}

function assertSameAxes(actual: CameraAxes, expected: CameraAxes): void {
    assertClose(actual.right, expected.right, 'right');
    assertClose(actual.up, expected.up, 'up');
    assertClose(actual.back, expected.back, 'back');
}

test('CameraAxes_OfCaromsCameras_AreItsOrientations', () => {
    const degree = Math.PI / 180;
    const rolls = [25 * degree, -10 * degree];
    const ups: Triple[] = [[0, 0, 1], [0.4, 1, 0.1]];
    data.cameras.forEach((camera, i) => {
        for (const key of camera.keys) {
            const up = ups[i] ?? [0, 0, 1];
            const axes = cameraAxes(pose(key.position, key.target, up, rolls[i] ?? 0));
            assertSameAxes(axes, columns(key.orientation));
        }
    });
    assert.equal(data.cameras.length, 2);
});

test('CameraAxes_AlongUp_AreStillOrthonormal', () => {
    const views: [Triple, Triple, Triple][] = [
        [[0, 0, 2], [0, 0, 0], [0, 0, 1]], [[0, 0, -2], [0, 0, 0], [0, 0, 1]],
        [[0, 2, 0], [0, 0, 0], [0, 1, 0]], [[3, 0, 0], [0, 0, 0], [-2, 0, 0]],
        [[1, 1, 1], [1, 1, 1], [0, 0, 1]],
    ];
    for (const [position, target, up] of views) {
        const axes = cameraAxes(pose(position, target, up, 0.3));
        for (const axis of [axes.right, axes.up, axes.back]) {
            assert.ok(Math.abs(length(axis) - 1) < 1e-12);
        }
        assert.ok(Math.abs(dot(axes.right, axes.up)) < 1e-12);
        assertClose(cross(axes.right, axes.up), axes.back, 'handedness');
    }
    const plan = cameraAxes(pose([0, 0, 2], [0, 0, 0], [0, 0, 1], 0));
    assertSameAxes(plan, { right: [1, 0, 0], up: [0, 1, 0], back: [0, 0, 1] });
});

test('ProjectPoint_AtTheUpperEdgeOfTheFieldOfView_IsAtHeightOne', () => {
    const camera = pose([0, -2, 0], [0, 0, 0], [0, 0, 1], 0);
    const top = projectPoint(camera, [0.5, 0, 2 * Math.tan(0.35)]);
    assert.ok(top && Math.abs(top.y - 1) < 1e-12 && Math.abs(top.depth - 2) < 1e-12);
    assert.ok(top.x > 0);
    assert.equal(projectPoint(camera, [0, -3, 0]), null);
    const rolled = projectPoint({ ...camera, roll: Math.PI / 2 }, [0, 0, 1]);
    assert.ok(rolled && rolled.x > 0.5 && Math.abs(rolled.y) < 1e-12, 'turns clockwise');
});

test('MixPoses_Halfway_MixesTheAxisAndTheNumbers', () => {
    const a = pose([0, -2, 0], [0, 0, 0], [0, 0, 1], 0);
    const b = { ...pose([2, -2, 0], [2, 2, 0], [0, 0, 1], 1), verticalFov: 0.9 };
    const half = mixPoses(a, b, 0.5);
    assertClose(half.position, [1, -2, 0], 'position');
    assertClose(half.target, [1, 1, 0], 'target');
    assertClose([half.roll, half.verticalFov], [0.5, 0.8], 'roll and lens');
});

test('Track_ThatJumps_IsNeverBetweenThePlaces', () => {
    const landed = 1 + Number.EPSILON;
    const key = (time: number, position: Triple, vIn: Triple, vOut: Triple) =>
        [time, ...position, 1, 0, 0, 0, ...vIn, ...vOut, 0, 0, 0, 0, 0, 0];
    const rest: Triple = [0, 0, 0];
    const track = new Track({ name: 'black', first: 0, keys: 4 }, Float64Array.from([
        ...key(0, [0, 0, 0], [2, 0, 0], [2, 0, 0]), ...key(1, [2, 0, 0], [2, 0, 0], rest),
        ...key(landed, [0, 1, 0], rest, rest), ...key(3, [0, 1, 0], rest, rest),
    ]));
    assert.deepEqual([0, 1, 2, 3].map((one) => track.jumpsAfter(one)), [false, true, false, false]);
    assertClose(track.position(0.75), [1.5, 0, 0], 'before');
    for (const time of [1, landed, 1.5, 9]) {
        assert.deepEqual(track.position(time), [0, 1, 0], `at ${time} s`);
        assert.deepEqual(track.sample(time).position, [0, 1, 0], `at ${time} s`);
        assert.equal(track.speed(time), 0, `at ${time} s`);
    }
    assert.deepEqual([...polyline(track).jumps], [2]);
});
