import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { neededUnit } from '../../src/edit/schema_facts';
import { keyAt, keysAt, typesAt } from '../../src/schema/keys';
import { numberType, typed } from '../../src/inspector/number_text';
import type { Schema } from '../../src/schema/value_types';

const schema = JSON.parse(
    readFileSync(join(__REPOSITORY__, 'configs/carom.schema.json'), 'utf8')) as Schema;

const at = (path: string) => typesAt(schema, path.split('.'));

test('TypesAt_Values_SayTheirUnitRangeAndNames', () => {
    const types = at('cameras.0.fov');
    const fov = types.find((type) => type.kind === 'number');
    assert.ok(fov);
    assert.deepEqual([fov.unit, fov.needsUnit, fov.range],
        ['deg', true, 'more than 0 deg and less than 180 deg']);
    assert.deepEqual(types.map(({ kind }) => kind), ['number', 'list', 'map', 'map']);
    assert.deepEqual(at('simulation.duration'), [{ kind: 'number', isInteger: false, unit: 's',
        units: ['s', 'ms', 'min'], needsUnit: false, zeroNeedsUnit: false, low: 0, high: 3600,
        range: 'more than 0 s and at most 3600 s' }]);
    assert.ok(at('events.0.strike.toward').some((type) =>
        type.kind === 'name' && type.of === 'a ball, object, spot or pocket'));
    assert.ok(at('balls.cue.at').some((type) =>
        type.kind === 'name' && type.of === 'a spot of the table'));
    assert.deepEqual(at('cameras.2.target.follow'), [{ kind: 'name', of: 'a ball or moving object' }]);
    assert.deepEqual(at('physics.cloth'),
        [{ kind: 'text', words: ['new', 'worn'], keysOf: 'conditions.cloth', pattern: '' }]);
    assert.deepEqual(at('cameras.0.easing.nothing'), []);
});

test('KeysAt_Maps_OfferWhatMayBeAdded', () => {
    const names = (path: string, present: string[]) =>
        keysAt(schema, path === '' ? [] : path.split('.'), present).map(({ name }) => name);
    assert.ok(names('', []).includes('cameras'));
    assert.ok(!names('', ['cameras']).includes('cameras'));
    assert.deepEqual(names('cameras.0.fov', ['keys']), ['easing']);
    assert.deepEqual(names('cameras.0.fov', ['from']), ['to', 'easing']);
    assert.deepEqual(names('events.0', []),
        ['strike', 'impulse', 'force', 'torque', 'velocity', 'place', 'remove']);
    assert.deepEqual(names('events.0', ['force']), []);
    assert.ok(names('balls.cue', ['at']).includes('spin'));
    const beside = (...present: string[]) => names('events.0.strike', present)
        .filter((name) => ['pot', 'in', 'of', 'hit', 'fullness', 'side'].includes(name));
    assert.deepEqual(beside(), ['pot', 'hit']);
    assert.deepEqual(beside('pot'), ['in']);
    assert.deepEqual(beside('cut'), ['of', 'side']);
    assert.deepEqual(beside('hit'), ['fullness', 'side']);
    const step = keyAt(schema, ['simulation', 'step']);
    assert.equal(step?.about, 'longest time step between two contacts');
    assert.equal(step?.usual, '1/240 s');
    assert.equal(keyAt(schema, ['balls', 'cue']), null);
});

test('NeededUnit_NewNumbers_AreOfTheSchema', () => {
    const unit = (path: string) => neededUnit(schema, path.split('.'));
    const cases: [string, string][] = [
        ['cameras.0.fov', 'deg'], ['cameras.0.fov.1', 'deg'], ['cameras.0.fov.from', 'deg'],
        ['cameras.0.aperture', 'mm'], ['cameras.0.position', ''], ['cameras.0.position.angles', 'deg'],
        ['balls.cue.spin', 'rad/s'], ['balls.cue.spin.2', 'rad/s'], ['balls.cue.at', ''],
        ['objects.x.physics.density', 'kg/m^3'], ['objects.x.rotate', 'deg'],
        ['objects.x.rotate.angle', 'deg'], ['events.0.strike.direction', 'deg'],
        ['events.0.strike.tip', ''], ['events.0.strike.speed', ''], ['render.shutter', 'deg'],
        ['lights.x.angle.0', 'deg'], ['cameras.0.scene.speeds.0', ''], ['nowhere', ''],
    ];
    for (const [path, expected] of cases) {
        assert.equal(unit(path), expected, path);
    }
});

test('Typed_Level_GetsItsUnitEvenIfItIsZero', () => {
    const level = numberType(at('sound.mix.balls'));
    assert.deepEqual([level?.unit, level?.needsUnit, level?.zeroNeedsUnit], ['dB', true, true]);
    assert.deepEqual([typed('0', '', level), typed('-6', '', level), typed('-6', '3 dB', level)],
        ['0 dB', '-6 dB', '-6 dB']);
    assert.equal(typed('0', '', numberType(at('cameras.0.fov'))), '0');
    assert.equal(typed('9', '', numberType(at('sound.materials.ball.modulus'))), '9 GPa');
});

test('KeysAt_SoundOfACamera_HasNoRoom', () => {
    const names = (path: string[]) => keysAt(schema, path, []).map(({ name }) => name);
    assert.ok(names(['sound']).includes('room'));
    assert.ok(names(['cameras', '0', 'sound']).includes('gain'));
    assert.ok(!names(['cameras', '0', 'sound']).includes('room'));
    assert.deepEqual(at('sound').map(({ kind }) => kind), ['choice', 'map']);
});
