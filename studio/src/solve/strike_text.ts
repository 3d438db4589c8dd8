/// What is written into the text for a strike that was found.
import type { Change } from '../edit/edit';
import { writeNumber } from '../edit/quantity';
import type { KeyPath, ShotSolution } from '../protocol';

const kDegree = Math.PI / 180;
// The numbers of solutions have these steps: none of them is lost.
const kDirectionStep = 1e-6; // degrees
const kSpeedStep = 1e-4;
const kTipStep = 1e-4;
const kElevationStep = 1e-6; // degrees

function isCentred({ tip }: ShotSolution): boolean {
    return tip[0] === 0 && tip[1] === 0;
}

/// `path`: of the strike's keys. `isGiven`: whether the text has such a key, whose value is changed as it
/// is written.
export function strikeChanges(
    path: KeyPath, one: ShotSolution, isGiven: (key: string) => boolean,
): Change[] {
    const speed = one.is_ball_speed ? 'ball_speed' : 'speed';
    return [
        { path: [...path, 'direction'], value: one.direction, precision: kDirectionStep * kDegree },
        { path: [...path, speed], precision: kSpeedStep, value: isGiven(speed) ? one.speed
            : { yaml: `${writeNumber(one.speed, kSpeedStep)} m/s` } },
        ...isGiven('tip') || !isCentred(one)
            ? [{ path: [...path, 'tip'], value: [...one.tip], precision: kTipStep }] : [],
        ...one.elevation > 0 || isGiven('elevation')
            ? [{ path: [...path, 'elevation'], value: one.elevation,
                precision: kElevationStep * kDegree }] : [],
    ];
}

/// A new strike as YAML.
export function newStrike(struck: string, time: number, one: ShotSolution): string {
    const tip = isCentred(one) ? ''
        : `, tip: [${one.tip.map((value) => writeNumber(value, kTipStep)).join(', ')}]`;
    const raised = one.elevation > 0
        ? `, elevation: ${writeNumber(one.elevation / kDegree, kElevationStep)} deg` : '';
    return `strike: {ball: ${struck}, at: ${writeNumber(time, 1e-3)} s, `
        + `direction: ${writeNumber(one.direction / kDegree, kDirectionStep)} deg, `
        + `speed: ${writeNumber(one.speed, kSpeedStep)} m/s${tip}${raised}}`;
}

/// Where `solve` finds the strike so far: it would find nothing any more. `count`: of its items; 0: the
/// shot has none. `item`: which of them; negative: it finds another strike.
export function solvePaths(item: number, count: number): KeyPath[] {
    return item < 0 || count === 0 ? [] : count > 1 ? [['solve', String(item)]] : [['solve']];
}
