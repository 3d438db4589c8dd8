// Values of the lens that are given by keys: what a drag writes, and their handles on the strip.
import assert from 'node:assert/strict';
import { beforeEach, test } from 'node:test';
import { scaledFov, type CameraPose } from '../../src/motion/camera';
import { keysOf } from '../../src/motion/lens_keys';
import { CameraFramesOf } from '../../src/motion/camera_frames';
import { kCamerasNumbersPerFrame, type Camera, type LensKey, type ShotState }
    from '../../src/protocol';
import { shot } from '../../src/state/state';
import type { CurveRow } from '../../src/strip/curve_row';
import { addLensKey, lensHandles } from '../../src/strip/handles/lens_handles';
import type { Layout } from '../../src/strip/layout';
import { buffers, textOf } from '../../src/text/buffers';
import { takeFiles } from '../../src/text/take_files';
import { easedChange, easedPath, type EasedValue } from '../../src/view/camera_gizmos/eased_value';
import { lensHandles as viewHandles } from '../../src/view/camera_gizmos/lens_handles';

const kDegree = Math.PI / 180;
const kShot = `cameras:
  - video: [0 s, 4 s]
    fov: {keys: [[1 s, 40 deg], [2 s, 20 deg], [3 s, 30 deg]]}
    focus: {keys: [[1 s, cue], [2 s, 1.5 m]]}
    f_number: [4, 8]
`;
const kFov = ['cameras', '0', 'fov'];

function keys(name: string, ...times: number[]): LensKey[] {
    return times.map((video_time, i) =>
        ({ path: ['cameras', '0', name, 'keys', String(i)], video_time }));
}

const camera = {
    name: 'a', path: ['cameras', '0'], video_start: 0, video_end: 4, speeds: [],
    sensor_height: 0.024, fov_scale: 1, lens_keys: [...keys('fov', 1, 2, 3), ...keys('focus', 1, 2)],
} as unknown as Camera;
const state = {
    objects: [], lights: [], events: [], annotations: [], cameras: [camera], places: [], film: { fps: 24 },
} as unknown as ShotState;

beforeEach(() => {
    buffers.value = [];
    takeFiles([{ file: '/a.yaml', name: 'a.yaml', text: kShot, hash: 'a', writable: true, changed: false }]);
    shot.value = state;
});

function fovAt(time: number, now: number): EasedValue {
    return { start: NaN, end: NaN, now: now * kDegree, progress: time / 4,
        keys: keysOf(camera.lens_keys, kFov), time };
}

test('KeysOf_AValue_AreThoseOfThisValueOnly', () => {
    assert.equal(keysOf(camera.lens_keys, kFov).length, 3);
    assert.equal(keysOf(camera.lens_keys, ['cameras', '0', 'focus']).length, 2);
    assert.equal(keysOf(camera.lens_keys, ['cameras', '0', 'aperture']).length, 0);
});

test('EasedChange_BetweenTwoKeys_ChangesTheNearerSoThatTheValueIsTheWantedOne', () => {
    const early = easedChange(kFov, fovAt(1.25, 35), 38 * kDegree);
    assert.deepEqual(early.path, [...kFov, 'keys', '0', '1']);
    assert.ok(Math.abs(0.75 * early.value + 0.25 * 20 * kDegree - 38 * kDegree) < 1e-12);
    const late = easedChange(kFov, fovAt(1.75, 25), 22 * kDegree);
    assert.deepEqual(late.path, [...kFov, 'keys', '1', '1']);
    assert.ok(Math.abs(0.25 * 40 * kDegree + 0.75 * late.value - 22 * kDegree) < 1e-12);
});

test('EasedChange_BeforeTheFirstAndAfterTheLastKey_ChangesIt', () => {
    assert.deepEqual(easedChange(kFov, fovAt(0.5, 40), 1), { path: [...kFov, 'keys', '0', '1'], value: 1 });
    assert.deepEqual(easedChange(kFov, fovAt(3.5, 30), 1), { path: [...kFov, 'keys', '2', '1'], value: 1 });
});

test('EasedPath_BetweenNames_IsTheKeyThatIsNearerInTime', () => {
    const focus = ['cameras', '0', 'focus'];
    const at = (time: number) => easedPath(focus, { ...fovAt(time, 1), keys: keys('focus', 1, 2) });
    assert.deepEqual(at(1.2), [...focus, 'keys', '0', '1']);
    assert.deepEqual(at(1.8), [...focus, 'keys', '1', '1']);
});

test('EasedPath_WithoutKeys_IsThatOfTheList', () => {
    const path = ['cameras', '0', 'f_number'];
    assert.deepEqual(easedPath(path, { start: 4, end: 8, now: 7, progress: 0.1, keys: [], time: 0 }),
        [...path, '1']);
});

test('ScaledFov_OfAWidth_IsItsHeight', () => {
    assert.ok(Math.abs(Math.tan(scaledFov(1, 9 / 16) / 2) - 9 / 16 * Math.tan(0.5)) < 1e-15);
    assert.ok(Math.abs(scaledFov(scaledFov(0.9, 0.5), 2) - 0.9) < 1e-14);
    assert.equal(scaledFov(0.9, 1), 0.9);
});

const row = { yOf: (value: number) => -value, perPixel: 0.001 } as unknown as CurveRow;
const layout = { film: {} } as unknown as Layout;

/// Frames of the camera, all with a field of view of 30 degrees.
function frames(): CameraFramesOf {
    const numbers = new Float64Array(97 * kCamerasNumbersPerFrame);
    for (let i = 0; i < 97; ++i) {
        const first = i * kCamerasNumbersPerFrame;
        numbers[first] = i;
        numbers[first + 3] = i / 24;
        numbers[first + 18] = 30 * kDegree;
    }
    return new CameraFramesOf(numbers, 0);
}

test('LensHandles_OfKeys_MoveInTimeAndValue', () => {
    const handles = lensHandles(layout, state, 0, 'fov', row, frames());
    assert.deepEqual(handles.map(({ time }) => time), [1, 2, 3]);
    assert.ok(Math.abs((handles[1]?.value ?? 0) - 20 * kDegree) < 1e-12);
    const [time, value] = handles[1]?.change(2.5, 0.5) ?? [];
    assert.deepEqual(time, { path: [...kFov, 'keys', '1', '0'], value: { yaml: '2.5 s' } });
    assert.deepEqual(value?.path, [...kFov, 'keys', '1', '1']);
    // A key stays a frame away from its neighbours.
    const [far] = handles[1]?.change(9, 0.5) ?? [];
    assert.deepEqual(far?.value, { yaml: '71 / 24 s' });
    assert.equal(handles[1]?.change(2, 0.5).length, 1, 'no new time where it is');
    handles[1]?.remove?.();
    assert.match(buffers.value.map(textOf).join(''), /fov: \{keys: \[\[1 s, 40 deg\], \[3 s, 30 deg\]\]\}/);
});

test('LensHandles_OfKeysThatAreNames_AreLeftOut', () => {
    const handles = lensHandles(layout, state, 0, 'focus', row, frames());
    assert.deepEqual(handles.map(({ time }) => time), [2]);
});

test('AddLensKey_BetweenTwo_HasTheValueOfTheOneBefore', () => {
    assert.ok(addLensKey(state, camera, 'fov', 1.5));
    assert.match(buffers.value.map(textOf).join(''),
        /fov: \{keys: \[\[1 s, 40 deg\], \[1\.5 s, 40 deg\], \[2 s, 20 deg\], \[3 s, 30 deg\]\]\}/);
    assert.ok(!addLensKey(state, camera, 'f_number', 1.5), 'it has no keys');
});

test('ViewHandles_OfAKeyedFieldOfViewAlongTheWidth_WriteItsKey', () => {
    const pose: CameraPose = { position: [0, 0, 0], target: [0, 2, 0], up: [0, 0, 1], roll: 0,
        verticalFov: scaledFov(30 * kDegree, 0.5), focusDistance: 1, lensRadius: 0 };
    const lens = { camera: { ...camera, fov_scale: 0.5 }, pose, first: pose, last: pose,
        progress: 0.9, aspect: 2, colour: 0 };
    const handle = viewHandles(lens)[0];
    assert.equal(handle?.label, 'a: field of view 30.0°');
    const wanted = scaledFov(50 * kDegree, 0.5);
    const [change] = handle?.changes([0, 1, Math.tan(wanted / 2)], 0.001, false) ?? [];
    assert.deepEqual(change?.path, [...kFov, 'keys', '2', '1']);
    assert.ok(Math.abs((change?.value as number) - 50 * kDegree) < 1e-12);
});
