import assert from 'node:assert/strict';
import { beforeEach, test } from 'node:test';
import type { Camera, ShotState, SpeedPoint } from '../../src/protocol';
import { CameraFramesOf } from '../../src/motion/camera_frames';
import { filmDuration, goToFilmTime, goToFrame, goToSceneTime } from '../../src/motion/clock';
import {
    cameraAt, filmTimesAt, instantsAt, nearestInstant, sceneTimeAt, speedAt,
} from '../../src/motion/time_map';
import { cameraFrames, filmTime, sceneTime, shot, timeline } from '../../src/state/state';

function camera(video: [number, number], scene: [number, number], more = {}): Camera {
    const still = { kind: 'bezier', points: [], curve: [] };
    return {
        name: '', path: [], video_start: video[0], video_end: video[1], fade: 0,
        scene_start: scene[0], scene_end: scene[1], speeds: [], smooth: false, position: still,
        target: still, sensor_height: 0.024, fov_scale: 1, lens_keys: [], ...more,
    };
}

function speeds(...points: [number, number][]): SpeedPoint[] {
    return points.map(([video_time, speed]) => ({ path: [], video_time, speed }));
}

function close(actual: number | undefined, expected: number, what = ''): void {
    assert.ok(Math.abs((actual ?? NaN) - expected) < 1e-9, `${what} ${actual} != ${expected}`);
}

// examples/nine_ball_break.yaml
const film = [
    camera([0, 2.75], [0.25, 3]), camera([2.75, 6.5], [0.59, 1.05875]), camera([6.5, 10], [3.9, 0.4]),
];
// the camera 'burst' of examples/park.yaml
const burst = camera([2.5, 5.5], [0.5, 0], {
    speeds: speeds([2.5, 1], [2.6, 1 / 16], [5, 1 / 16], [5.5, 1 / 4]), smooth: true,
});

test('SceneTime_OfALinearCamera_RunsFromStartToEnd', () => {
    close(sceneTimeAt(film[1]!, 2.75), 0.59);
    close(sceneTimeAt(film[1]!, 6.5), 1.05875);
    close(sceneTimeAt(film[2]!, 8.25), 2.15);
    close(speedAt(film[2]!, 7), -1);
    close(speedAt(film[1]!, 3), 0.125);
});

test('SceneTime_OfARamp_IsTheIntegralOfItsSpeed', () => {
    for (const smooth of [false, true]) {
        const ramp = { ...burst, smooth };
        let sum = ramp.scene_start;
        const steps = 30000;
        for (let i = 0; i < steps; ++i) {
            sum += (speedAt(ramp, 2.5 + (3 * (i + 0.5)) / steps) * 3) / steps;
        }
        assert.ok(Math.abs(sceneTimeAt(ramp, 5.5) - sum) < 1e-7, `${sceneTimeAt(ramp, 5.5)}`);
        close(sceneTimeAt(ramp, 2.5), 0.5);
        // Both kinds of change have a mean speed of half the sum: 0.1 s (1 + 1/16)/2 + 2.4 s/16.
        close(sceneTimeAt(ramp, 5), 0.5 + 0.053125 + 0.15);
    }
    close(speedAt({ ...burst, smooth: true }, 2.525), 1 - (15 / 16) * (3 / 16 - 2 / 64));
    close(speedAt({ ...burst, smooth: false }, 2.525), 1 - 15 / 64);
    close(speedAt(burst, 9), 0.25, 'after the last speed');
    close(sceneTimeAt(burst, 2), 0, 'before the first speed');
});

test('FilmTimes_OfASceneTime_AreAllThatShowIt', () => {
    close(filmTimesAt(film[2]!, 2.15, 0)[0], 8.25);
    assert.deepEqual(filmTimesAt(film[1]!, 2, 0), []);
    const there = camera([0, 4], [0, 0], { speeds: speeds([0, 1], [1, 1], [3, -1], [4, -1]) });
    close(sceneTimeAt(there, 2), 1.5);
    const twice = filmTimesAt(there, 1.25, 0);
    assert.equal(twice.length, 2);
    close(sceneTimeAt(there, twice[0]!), 1.25);
    close(twice[0]! + twice[1]!, 4);
    assert.equal(filmTimesAt(there, 1.6, 0).length, 0);
    for (const time of [2.51, 2.57, 3, 4.9, 5.2]) {
        close(filmTimesAt(burst, sceneTimeAt(burst, time), 0)[0], time, 'and back');
    }
});

test('FilmTimes_OfFrozenTime_IsTheNearest', () => {
    const frozen = camera([1, 3], [0.7, 0.7]);
    assert.deepEqual(filmTimesAt(frozen, 0.7, 2.2), [2.2]);
    assert.deepEqual(filmTimesAt(frozen, 0.7, 9), [3]);
    assert.deepEqual(filmTimesAt(frozen, 0.8, 2), []);
});

test('CameraAt_InACrossFade_IsTheHeavierOne', () => {
    const faded = [camera([0, 3], [0, 3]), camera([2, 5], [0, 3], { fade: 1 })];
    assert.equal(cameraAt(faded, 2.4), 0);
    assert.equal(cameraAt(faded, 2.6), 1);
    assert.equal(cameraAt(faded, -1), 0);
    assert.equal(cameraAt(faded, 99), 1);
    assert.equal(cameraAt([], 0), -1);
});

test('NearestInstant_OfTimesThatSeveralCamerasShow_IsNearestToThePresent', () => {
    assert.equal(instantsAt(film, 0.8, 0).length, 3);
    assert.equal(nearestInstant(film, 0.8, 1)?.camera, 0);
    assert.equal(nearestInstant(film, 0.8, 5)?.camera, 1);
    assert.equal(nearestInstant(film, 0.8, 9.9)?.camera, 2);
    const none = nearestInstant(film, 7, 0);
    assert.deepEqual(none, { time: 6.5, camera: 2 });
    assert.equal(nearestInstant([], 7, 0), null);
});

beforeEach(() => {
    shot.value = {
        cameras: film, film: { width: 64, height: 36, fps: 24, frames: 240, duration: 10, samples: 1 },
    } as unknown as ShotState;
    timeline.value = {
        head: {
            v: 1, kept: false, start: 0, end: 9, tracks: [], events: [], energy: [], milliseconds: 0,
        },
        numbers: new Float64Array(),
    };
});

test('GoToFilmTime_AnyTime_SetsBothClocksWithinTheFilm', () => {
    goToFilmTime(8.25);
    close(sceneTime.value, 2.15);
    goToFilmTime(99);
    close(filmTime.value, 10);
    close(sceneTime.value, 0.4);
    goToFrame(66);
    close(filmTime.value, 2.75);
    close(sceneTime.value, 0.59);
    close(filmDuration.value, 10);
});

test('GoToSceneTime_ShownThrice_StaysWithTheNearestCamera', () => {
    goToFilmTime(4);
    goToSceneTime(0.7);
    close(filmTime.value, 2.75 + 0.11 * 8);
    close(sceneTime.value, 0.7);
    goToSceneTime(8.5);
    close(sceneTime.value, 8.5, 'not in the film');
    close(filmTime.value, 6.5);
    goToSceneTime(100);
    close(sceneTime.value, 9, 'after the motion');
});

test('GoToFilmTime_WithoutCameras_IsTheTimeSinceTheMotionsStart', () => {
    shot.value = { ...shot.value!, cameras: [] };
    goToFilmTime(3);
    close(sceneTime.value, 3);
    close(filmDuration.value, 9);
    goToSceneTime(4);
    close(filmTime.value, 4);
});

test('CameraFrames_BetweenTwoFrames_AreMixed', () => {
    const entry = (frame: number, index: number, time: number, x: number) => [
        frame, index, 1, time, 0, 0, 0, 1, x, 0, 0, x, 1, 0, 0, 0, 1, 0, 0.7, 1, 0,
    ];
    const numbers = Float64Array.from([
        ...entry(0, 0, 0, 0), ...entry(1, 1, 0.5, 100), ...entry(1, 0, 0.5, 2), ...entry(2, 0, 1, 4),
    ]);
    cameraFrames.value = { head: { v: 1, entries: 4 }, numbers };
    const frames = new CameraFramesOf(numbers, 0);
    assert.equal(frames.count, 3);
    close(frames.poseAt(0.5)?.position[0], 2);
    close(frames.poseAt(0.625)?.position[0], 2.5);
    close(frames.poseAt(-3)?.position[0], 0);
    close(frames.poseAt(9)?.position[0], 4);
    assert.equal(frames.at(1).frame, 1);
    assert.equal(new CameraFramesOf(numbers, 2).poseAt(0), null);
});
