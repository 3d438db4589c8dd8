import assert from 'node:assert/strict';
import { test } from 'node:test';
import { rotate } from '../../src/motion/vectors';
import type { Triple } from '../../src/protocol';
import {
    contactDistance, overlaps, snapBall, type OtherBall, type Place, type TablePlan,
} from '../../src/view/gizmos/ball_snap';
import { measureHandles } from '../../src/view/gizmos/measures';
import {
    anglesLike, anglesOfTurn, frameOf, toLocal, toWorld, turnAbout, turned, turnOf, turnOfAngles,
    type RotationText,
} from '../../src/view/gizmos/object_frame';
import { alongAxis, angleAround, onPlane, planeAxes, stepOf } from '../../src/view/gizmos/rays';
import { afterContact, dashed, firstContact, polar } from '../../src/view/gizmos/strike_geometry';

const kRadius = 0.028575;
const degree = Math.PI / 180;

const table: TablePlan = {
    length: 2.54, width: 1.27,
    noses: [
        { from: [-1.2, -0.635], to: [1.19, -0.635] }, { from: [1.27, -0.55], to: [1.27, 0.55] },
        { from: [1.19, 0.635], to: [-1.2, 0.635] }, { from: [-1.27, 0.55], to: [-1.27, -0.55] },
    ],
    pockets: [{ name: 'corner_right_back', place: [1.29, 0.655], radius: 0.06 }],
};

function ball(name: string, place: Place, radius = kRadius): OtherBall {
    return { name, place, radius };
}

function near(actual: readonly number[], expected: readonly number[], tolerance = 1e-9): void {
    assert.equal(actual.length, expected.length);
    actual.forEach((value, i) => {
        assert.ok(Math.abs(value - (expected[i] ?? NaN)) <= tolerance, `${actual} is not ${expected}`);
    });
}

test('Snap_NearAnotherBall_TouchesItWithoutOverlap', () => {
    const one = ball('one', [0.1, 0.2]);
    for (let angle = 0; angle < 360; angle += 7) {
        const snap = snapBall(polar(one.place, angle * degree, 0.0605), kRadius, [one], null, 0.005);
        assert.deepEqual(snap.to, ['touches one']);
        const gap = Math.hypot(snap.place[0] - 0.1, snap.place[1] - 0.2) - 2 * kRadius;
        assert.ok(gap >= 0 && gap < 3e-6, `a gap of ${gap} m`);
    }
    assert.deepEqual(snapBall([0.3, 0.2], kRadius, [one], null, 0.005).to, []);
});

test('Snap_NearTwoThings_TouchesBoth', () => {
    const [one, two] = [ball('one', [0, 0.2]), ball('two', [0.07, 0.2])];
    const between = snapBall([0.036, 0.247], kRadius, [one, two], null, 0.005);
    assert.deepEqual([...between.to].sort(), ['touches one', 'touches two']);
    assert.equal(overlaps(between.place, kRadius, [one, two]).length, 0);
    const corner = snapBall([0.4, 0.604], kRadius, [], table, 0.005);
    assert.deepEqual(corner.to, ['at a cushion']);
    near([corner.place[1]], [0.635 - kRadius], 1e-6);
    const wall = ball('wall', [0.5, 0.635 - kRadius]);
    const both = snapBall([0.5 - 0.0572, 0.6055], kRadius, [wall], table, 0.005);
    assert.deepEqual([...both.to].sort(), ['at a cushion', 'touches wall']);
});

test('Snap_NearMarks_SpotBeforeLine', () => {
    assert.deepEqual(snapBall([0.633, 0.002], kRadius, [], table, 0.005).to, ['foot spot']);
    const line = snapBall([0.2, 0.003], kRadius, [], table, 0.005);
    assert.deepEqual(line.to, ['centre line']);
    near(line.place, [0.2, 0]);
    near(snapBall([0.2000321, 0.003], kRadius, [], table, 0.005).place, [0.2, 0]);
    // A spot that is taken is not offered.
    const taken = snapBall([0.633, 0.002], kRadius, [ball('nine', [0.635, 0])], table, 0.005);
    assert.deepEqual(taken.to, []);
});

test('Overlaps_OfDifferentRadii_CountFromAbove', () => {
    const small = ball('small', [0, 0], 0.02);
    const reach = contactDistance(kRadius, 0.02);
    assert.equal(overlaps([reach, 0], kRadius, [small]).length, 0);
    near(overlaps([reach - 0.001, 0], kRadius, [small]).map(({ depth }) => depth), [0.001]);
});

test('FirstContact_HalfBallHit_GivesGhostObjectAndTangentLines', () => {
    const object = ball('nine', [1, kRadius]);
    const contact = firstContact([0, 0], [1, 0], kRadius, [object, ball('ten', [1.2, 0])], table);
    assert.equal(contact.kind === 'ball' && contact.ball?.name, 'nine');
    const [x, y] = contact.ghost;
    near([Math.hypot(1 - x, kRadius - y), y], [2 * kRadius, 0]);
    const after = afterContact(contact, [1, 0]);
    near(after.object ?? [], [Math.cos(30 * degree), 0.5]);  // a half-ball hit: 30 degrees
    near(after.own ?? [], [Math.sin(30 * degree), -Math.cos(30 * degree)]);
    const full = firstContact([0, kRadius], [1, 0], kRadius, [object], table);
    assert.equal(afterContact(full, [1, 0]).own, null);
});

test('FirstContact_WithoutABall_IsTheCushionOrThePocket', () => {
    const at45: Place = [Math.SQRT1_2, Math.SQRT1_2];
    const rail = firstContact([0, 0], at45, kRadius, [], table);
    assert.equal(rail.kind, 'cushion');
    near(rail.ghost, [0.635 - kRadius, 0.635 - kRadius]);
    near(afterContact(rail, at45).own ?? [], [Math.SQRT1_2, -Math.SQRT1_2]);
    const angle = Math.atan2(0.655, 1.29);
    const potted = firstContact([0, 0], [Math.cos(angle), Math.sin(angle)], kRadius, [], table);
    assert.equal(potted.pocket, 'corner_right_back');
    assert.equal(firstContact([0, 0], [1, 0], kRadius, [], null).kind, 'none');
    // Through the mouth of a pocket that has none: not further than the rail.
    const lost = firstContact([1.25, 0.3], [0, 1], kRadius, [], { ...table, pockets: [] });
    near(lost.ghost, [1.25, 0.695]);
    // A ball that lies at the cushion and moves along it does not touch it.
    assert.equal(firstContact([0, 0.635 - kRadius], [-1, 0], kRadius, [], table).normal, undefined);
});

test('Dashes_OfALine_StayWithinIt', () => {
    const pieces = dashed([0, 0], [0.1, 0], 0.02, 0.015);
    assert.equal(pieces.length, 3);
    near(pieces[2]?.[1] ?? [], [0.09, 0]);
});

test('Rays_AgainstPlanesAndAxes', () => {
    const ray = { origin: [0, 0, 2] as Triple, direction: [0.6, 0, -0.8] as Triple };
    near(onPlane(ray, [0, 0, 0], [0, 0, 1]) ?? [], [1.5, 0, 0]);
    assert.equal(onPlane(ray, [0, 0, 5], [0, 0, 1]), null);
    near([alongAxis(ray, [1.5, 0.3, 0], [0, 0, 1]) ?? NaN], [0]);
    near([alongAxis(ray, [0, 0.1, 0], [1, 0, 0]) ?? NaN], [1.5]);
    assert.equal(alongAxis(ray, [0, 0, 0], [0.6, 0, -0.8]), null);
    const [x] = planeAxes([0, 0, 1]);
    const over = (p: Triple) => ({ origin: [p[0], p[1], 3] as Triple, direction: [0, 0, -1] as Triple });
    const start = angleAround(over(x), [0, 0, 0], [0, 0, 1]) ?? NaN;
    near([start], [0]);
    const turnedPoint = rotate(turnAbout([0, 0, 1], 0.7), x);
    near([angleAround(over(turnedPoint), [0, 0, 0], [0, 0, 1]) ?? NaN], [0.7]);
    near([0.00034, 2, 1e-9].map((one) => stepOf(one, 1e-6, 0.1)), [1e-4, 0.1, 1e-6]);
});

/// The rotation after `text` was changed.
function changed(text: RotationText, changes: ReturnType<typeof turned>): RotationText {
    let result = text;
    for (const { key, value } of changes) {
        if (key.length === 1 && key[0] === 'rotate') {
            result = { kind: 'angles', angles: value as Triple };
        } else if (result.kind === 'axis') {
            result = key[1] === 'axis' ? { ...result, axis: value as Triple }
                : { ...result, angle: value as number };
        }
    }
    return result;
}

test('Turned_InEveryWayOfWriting_IsTheRotationFollowedByTheOther', () => {
    const texts: RotationText[] = [
        { kind: 'angles', angles: [0.3, -0.8, 2.5] }, { kind: 'angles', angles: [0, 0, 0.5] },
        { kind: 'axis', axis: [1, 2, 0], angle: 0.8 }, { kind: 'axis', axis: [0, 0, -2], angle: 1 },
        { kind: 'none' },
    ];
    for (const text of texts) {
        for (const axis of [[1, 0, 0], [0, 1, 0], [0, 0, 1]] as Triple[]) {
            const after = changed(text, turned(text, axis, 0.4));
            for (const v of [[1, 0, 0], [0, 1, 0]] as Triple[]) {
                near(rotate(turnOf(after), v), rotate(turnAbout(axis, 0.4), rotate(turnOf(text), v)));
            }
        }
    }
    const level = turned({ kind: 'angles', angles: [0, 0, 0.5] }, [0, 0, 1], 0.25);
    near(level[0]?.value as Triple, [0, 0, 0.75]);
    const same = turned({ kind: 'axis', axis: [0, 0, -2], angle: 1 }, [0, 0, 1], 0.25);
    assert.deepEqual(same, [{ key: ['rotate', 'angle'], value: 0.75 }]);
});

test('Angles_OfARotation_AreTheNearestOnes', () => {
    for (const angles of [[0.1, 0.2, 0.3], [2, 1.2, -3], [0, Math.PI / 2, 0.4], [0, -Math.PI / 2, 1]]) {
        const turn = turnOfAngles(angles as Triple);
        const back = turnOfAngles(anglesOfTurn(turn));
        near(rotate(back, [1, 2, 3]), rotate(turn, [1, 2, 3]), 1e-8);
    }
    near(anglesLike(turnOfAngles([0.1, 2, 0.3]), [0.1, 1.9, 0.3]), [0.1, 2, 0.3]);
    near(anglesLike(turnOfAngles([0, 0, 7]), [0, 0, 6.9]), [0, 0, 7]);
});

test('Frame_ToWorldAndBack_IsTheSamePoint', () => {
    const frame = frameOf([1, 2, 3], { kind: 'angles', angles: [0.3, -0.8, 2.5] }, [1, 2, 0.5]);
    near(toLocal(frame, toWorld(frame, [0.1, -0.2, 0.3])) ?? [], [0.1, -0.2, 0.3]);
    const skew = frameOf([0, 0, 0],
        { kind: 'axes', axes: [[1, 0, 0], [1, 1, 0], [0, 1, 1]] }, [1, 1, 1]);
    near(toWorld(skew, [0, 1, 0]), [1, 1, 0]);
    near(toLocal(skew, toWorld(skew, [0.5, -2, 7])) ?? [], [0.5, -2, 7]);
});

test('Measures_OfShapes_NameTheirNumbers', () => {
    const keys = (shape: string, value: Parameters<typeof measureHandles>[1]) =>
        measureHandles(shape, value).map((one) => one.key.join('.'));
    assert.deepEqual(keys('box', [1, 2, 3]), ['box.0', 'box.1', 'box.2']);
    assert.deepEqual(keys('rounded_box', { size: [1, 2, 3], radius: 0.1 }),
        ['rounded_box.size.0', 'rounded_box.size.1', 'rounded_box.size.2']);
    assert.deepEqual(keys('cone', { radius: 1, height: 2 }), ['cone.radius', 'cone.height']);
    assert.deepEqual(keys('mesh', 'a.obj'), []);
    near(measureHandles('box', [1, 2, 3])[2]?.at ?? [], [0, 0, 1.5]);
});
