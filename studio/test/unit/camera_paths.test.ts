// Moving the paths of cameras, and where their points are written.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { bernstein, leadingPoint, movePath } from '../../src/view/camera_gizmos/move_path';
import { movePoint, onOrbit, writtenAt } from '../../src/view/camera_gizmos/path_handles';
import { boxOf } from '../../src/view/bounds';
import type { PathPoint, PathShape, Triple } from '../../src/protocol';

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
