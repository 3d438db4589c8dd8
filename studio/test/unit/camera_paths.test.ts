// Moving the paths of cameras, and where their points are written.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { bernstein, leadingPoint, movePath } from '../../src/view/camera_gizmos/move_path';
import { freePoint } from '../../src/view/camera_gizmos/free_point';
import { distanceOfReach, focusReach } from '../../src/view/camera_gizmos/lens_handles';
import { axisEnd, onOrbit, tiltChanges } from '../../src/view/camera_gizmos/orbit_handles';
import { lookFigure } from '../../src/view/camera_gizmos/path_figure';
import { movePoint, writtenAt } from '../../src/view/camera_gizmos/path_handles';
import { turnOfAngles } from '../../src/view/gizmos/object_frame';
import { rotate } from '../../src/motion/vectors';
import { CameraFramesOf } from '../../src/motion/camera_frames';
import { boxOf } from '../../src/view/bounds';
import type { Camera, Orbit, PathPoint, PathShape, Triple } from '../../src/protocol';

function point(position: Triple, more: Partial<PathPoint> = {}): PathPoint {
    return { path: ['cameras', '0', 'position', 'bezier', '0'], position, of: '', at: 0,
        offset: position, ...more };
}

const kCurve: PathShape = {
    kind: 'bezier', curve: [],
    points: [point([0, 0, 0]), point([1, 2, 0]), point([2, 0, 0])],
};

test('Bernstein_AtAnyParameter_SumsToOne', () => {
    for (const u of [0, 0.2, 0.5, 1]) {
        const weights = bernstein(5, u);
        assert.equal(weights.length, 5);
        assert.ok(Math.abs(weights.reduce((sum, one) => sum + one, 0) - 1) < 1e-12);
    }
    assert.deepEqual(bernstein(3, 0.5), [0.25, 0.5, 0.25]);
});

test('LeadingPoint_InTheMiddleOfACurve_IsTheMiddlePointWithItsWeight', () => {
    const { index, weight } = leadingPoint(kCurve, [1, 1, 0]);
    assert.equal(index, 1);
    assert.ok(Math.abs(weight - 0.5) < 1e-6);
});

test('LeadingPoint_AtAnEnd_IsTheEnd', () => {
    assert.deepEqual(leadingPoint(kCurve, [0, 0, 0]), { index: 0, weight: 1 });
});

test('MovePath_MiddleOfACurve_MovesThePointByMoreThanTheWay', () => {
    const [change] = movePath(kCurve, [1, 1, 0], [0, 0, 0.1], 1e-4);
    const value = change?.value as Triple;
    [1, 2, 0.2].forEach((wanted, i) => assert.ok(Math.abs((value[i] ?? 0) - wanted) < 1e-6));
});

test('MovePath_WithoutAWay_ChangesNothing', () => {
    assert.deepEqual(movePath(kCurve, [1, 1, 0], [0, 0, 0], 1e-4), []);
});

test('MovePoint_OfAnObject_WritesItsOffset', () => {
    const own = point([1, 1, 1], { of: 'cue', offset: [0, 0, 0.5] });
    assert.deepEqual(movePoint(own, [1, 1, 2], 1e-3), [{
        path: ['cameras', '0', 'position', 'bezier', '0', 'offset'], value: [0, 0, 1.5],
        precision: 1e-3,
    }]);
});

test('WrittenAt_OffsetOfAnOrbit_IsThatOffset', () => {
    const path = ['cameras', '0', 'position', 'offset'];
    assert.deepEqual(writtenAt(point([0, 0, 0], { of: 'eight', path })), path);
});

test('OnOrbit_TurnedByAQuarter_LiesOnTheTurnedAxis', () => {
    const half = Math.SQRT1_2; // a quarter turn about z
    const orbit = { radii: [2, 1] as [number, number], angles: [0, 1] as [number, number],
        turn: [half, 0, 0, half] as [number, number, number, number] };
    onOrbit(orbit, [0, 0, 1], 0).forEach((value, i) =>
        assert.ok(Math.abs(value - ([0, 2, 1][i] ?? 0)) < 1e-12));
});

test('BoxOf_NoPoints_IsNull', () => {
    assert.equal(boxOf([]), null);
    assert.deepEqual(boxOf([[0, 1, 2], [3, -1, 2]], 1), { low: [-1, -2, 1], high: [4, 2, 3] });
});

function cameraWith(position: PathShape): Camera {
    return { name: 'slow', path: ['cameras', '0'], position } as Camera;
}

test('FreePoint_OfACurve_IsAPlaceInItsList', () => {
    const own = point([1, 1, 1], { of: 'cue', offset: [0, 0, 0.5] });
    const camera = cameraWith({ ...kCurve, points: [own] });
    assert.deepEqual(freePoint(camera, 'position', own, [1, 2, 3], 1e-3),
        [{ path: ['cameras', '0', 'position', 'bezier', '0'], value: [1, 2, 3], precision: 1e-3 }]);
});

test('FreePoint_OfACameraThatFollows_ReplacesThePath', () => {
    const own = point([1, 1, 1], { of: 'cue', path: ['cameras', '0', 'position', 'offset'] });
    const camera = cameraWith({ kind: 'follow', curve: [], points: [own] });
    assert.deepEqual(freePoint(camera, 'position', own, [1, 2, 3], 1e-3),
        [{ path: ['cameras', '0', 'position'], value: [1, 2, 3], precision: 1e-3 }]);
});

test('FreePoint_CentreOfAnOrbit_KeepsItsOffset', () => {
    const own = point([1, 1, 1], {
        of: 'cue', path: ['cameras', '0', 'position', 'offset'], offset: [0, 0, 0.5],
    });
    const camera = cameraWith({ kind: 'orbit', curve: [], points: [own] });
    assert.deepEqual(freePoint(camera, 'position', own, [1, 2, 3], 1e-3),
        [{ path: ['cameras', '0', 'position', 'orbit'], value: [1, 2, 2.5], precision: 1e-3 }]);
});

test('FocusReach_OfAnyDistance_IsInvertedAndGrowsSlowly', () => {
    for (const distance of [0.1, 3, 6, 7, 50, 1000]) {
        assert.ok(Math.abs(distanceOfReach(focusReach(distance)) - distance) < 1e-9 * distance);
    }
    assert.equal(focusReach(3), 3);
    assert.ok(focusReach(20) > focusReach(10) && focusReach(1000) < 40);
});

test('TiltChanges_OfAnOrbit_PutTheAxisThroughThePlace', () => {
    const orbit: Orbit = { radii: [2, 1], angles: [0, 1], turn: turnOfAngles([0.2, -0.1, 0.4]) };
    const centre: Triple = [1, 2, 3];
    const to: Triple = [1.5, 2.2, 4];
    const [change] = tiltChanges(orbit, centre, to, ['cameras', '0', 'position', 'turn']);
    assert.deepEqual(change?.path, ['cameras', '0', 'position', 'turn']);
    const turn = turnOfAngles(change?.value as Triple);
    const end = axisEnd({ ...orbit, turn }, centre);
    const way = [0.5, 0.2, 1].map((value) => value / Math.hypot(0.5, 0.2, 1));
    const axis = rotate(turn, [0, 0, 1]);
    axis.forEach((value, i) => assert.ok(Math.abs(value - (way[i] ?? 0)) < 1e-9));
    assert.ok(Math.abs(Math.hypot(...end.map((value, i) => value - (centre[i] ?? 0))) - 1) < 1e-9);
});

test('LookFigure_OfManyFrames_IsAFewShortLinesTowardsTheTarget', () => {
    const frames = 240;
    const numbers = new Float64Array(21 * frames);
    for (let i = 0; i < frames; ++i) {
        numbers.set([i, 0, 1, i / 24, i / 24, 0, 0, 1, i / 100, -2, 1, 0, 0, 1], 21 * i);
    }
    const lines = lookFigure(new CameraFramesOf(numbers, 0), 0xffffff).lines ?? [];
    assert.ok(lines.length > 10 && lines.length <= 24);
    for (const { from, to } of lines) {
        const way = to.map((value, i) => value - (from[i] ?? 0));
        assert.ok(Math.abs(Math.hypot(...way) - 0.12) < 1e-9);
        assert.ok((way[1] ?? 0) > 0);
    }
});
