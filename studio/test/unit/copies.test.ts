// Copies of cameras and balls, and new cameras.
import assert from 'node:assert/strict';
import { beforeEach, test } from 'node:test';
import { duplicateSelected, templatesOf } from '../../src/outline/commands';
import { copyOfBall, copyOfCamera } from '../../src/outline/original_text';
import type { Camera, SceneObject, ShotState } from '../../src/protocol';
import { selection, shot } from '../../src/state/state';
import { buffers, textOf } from '../../src/text/buffers';
import { takeFiles } from '../../src/text/take_files';

const kShot = `balls:
  cue: {at: [0, 0]}
cameras:
  - {fade: 0.5 s, name: wide, video: [0 s, 31 / 24 s], scene: [0 s, 1 s]}
`;

function camera(more: Partial<Camera> = {}): Camera {
    return { name: 'wide', path: ['cameras', '0'], video_start: 0, video_end: 31 / 24, fade: 0,
        speeds: [], ...more } as unknown as Camera;
}

const state = {
    objects: [], lights: [], events: [], annotations: [], cameras: [camera()], places: [],
    names: { balls: ['cue'], objects: [], materials: [], lights: [], surfaces: [] },
} as unknown as ShotState;

beforeEach(() => {
    buffers.value = [];
    takeFiles([{ file: '/a.yaml', name: 'a.yaml', text: kShot, hash: 'a', writable: true, changed: false }]);
    shot.value = state;
    selection.value = ['cameras', '0'];
});

const lines = () => buffers.value.map(textOf).join('').split('\n').filter((line) => line !== '');

test('DuplicateSelected_ACameraTwice_HasTwoNamesAndFollowsExactly', () => {
    duplicateSelected();
    selection.value = ['cameras', '0'];
    duplicateSelected();
    assert.deepEqual(lines().slice(4), [
        '  - {name: wide_2, video: [31 / 24 s, 31 / 12 s], scene: [0 s, 1 s]}',
        '  - {name: wide_3, video: [31 / 12 s, 3.875 s], scene: [0 s, 1 s]}',
    ]);
    assert.deepEqual(selection.value, ['cameras', '2']);
});

test('TemplatesOf_ACameraTwice_HasTwoNamesAndFollowsExactly', () => {
    templatesOf('cameras')[0]?.run();
    templatesOf('cameras')[0]?.run();
    const text = lines().join('\n');
    assert.match(text, /- name: still\n {4}video: \[31 \/ 24 s, 103 \/ 24 s\]/);
    assert.match(text, /- name: still_2\n {4}video: \[103 \/ 24 s, 175 \/ 24 s\]/);
});

test('CopyOfCamera_WithARamp_TakesItAlong', () => {
    const speeds = [{ video_time: 0.5, speed: 1, path: [] }, { video_time: 1, speed: 0.5, path: [] }];
    const text = '{name: a, video: [0.5 s, 1 s], scene: {from: 0 s, speeds: [[0.5 s, 1], [1 s, 1/2]]}}';
    assert.equal(copyOfCamera(text, camera({ name: 'a', video_start: 0.5, video_end: 1, speeds }), state),
        '{name: a, video: [31 / 24 s, 43 / 24 s], '
        + 'scene: {from: 0 s, speeds: [[31 / 24 s, 1], [43 / 24 s, 1/2]]}}');
});

test('CopyOfBall_WithAHeight_KeepsItAndItsUnits', () => {
    const ball = { position: [0.1, 0.2, 0.05], radius: 0.02 } as unknown as SceneObject;
    assert.equal(copyOfBall('{spin: [1, 2, 3], at: [10 cm, 20 cm, 5 cm]}', ball),
        '{spin: [1, 2, 3], at: [15 cm, 20 cm, 5 cm]}');
    assert.equal(copyOfBall('{touching: one, number: 3}', ball), '{number: 3, at: [0.15, 0.2]}');
});
