/// Where a ball that is dragged over the cloth comes to lie: against other balls, at the noses of
/// the cushions, on the table's lines and spots. Everything is seen from above, in metres.
import type { CushionNose, ShotState, TablePocket } from '../../protocol';

export type Place = [number, number];

/// The table seen from above.
export interface TablePlan {
    length: number;
    width: number;
    noses: readonly CushionNose[];
    pockets: readonly TablePocket[];
}

/// The plan of a shot's table; null without cushions.
export function tablePlan(shot: ShotState): TablePlan | null {
    const { table, noses, pockets } = shot;
    return table ? { length: table.length, width: table.width, noses, pockets } : null;
}

/// Another ball that lies on the cloth.
export interface OtherBall {
    name: string;
    place: Place;
    radius: number;
}

export interface Snap {
    place: Place;
    /// What it snapped to: "touches nine", "at a cushion", "foot spot"; empty if to nothing.
    to: string[];
    /// Of the lines that it lies on, from end to end.
    guides: [Place, Place][];
}

/// A circle or a line on which the centre of the ball may lie.
type Curve =
    | { kind: 'circle'; centre: Place; radius: number; to: string }
    | { kind: 'line'; from: Place; to: string; along: Place; length: number; isGuide: boolean };

const kFinest = 1e-6; // m, of places that touch something
const kAlong = 1e-4; // m, of the coordinate along a line on which the ball may lie anywhere

/// The distance of the centres of two balls that lie on the cloth and touch, seen from above.
export function contactDistance(a: number, b: number): number {
    return 2 * Math.sqrt(a * b);
}

/// The balls that a ball at `place` overlaps, the deepest first.
export function overlaps(
    place: Place, radius: number, others: readonly OtherBall[], tolerance = 1e-9,
): { name: string; depth: number }[] {
    return others
        .map((other) => ({
            name: other.name,
            depth: contactDistance(radius, other.radius) - distance(place, other.place),
        }))
        .filter(({ depth }) => depth > tolerance)
        .sort((a, b) => b.depth - a.depth);
}

function distance(a: Place, b: Place): number {
    return Math.hypot(a[0] - b[0], a[1] - b[1]);
}

/// The lines of a table on which players place balls, and its spots.
function tableMarks(table: TablePlan): { lines: Curve[]; spots: { place: Place; to: string }[] } {
    const x = table.length / 2;
    const y = table.width / 2;
    const across = (at: number, to: string): Curve =>
        ({ kind: 'line', from: [at, -y], along: [0, 1], length: 2 * y, to, isGuide: true });
    const lines: Curve[] = [
        {
            kind: 'line', from: [-x, 0], along: [1, 0], length: 2 * x, to: 'centre line',
            isGuide: true,
        },
        across(0, 'middle of the table'), across(-x / 2, 'head string'),
        across(x / 2, 'foot string'),
    ];
    const spots = [
        { place: [0, 0] as Place, to: 'centre spot' },
        { place: [-x / 2, 0] as Place, to: 'head spot' },
        { place: [x / 2, 0] as Place, to: 'foot spot' },
    ];
    return { lines, spots };
}

/// The lines on which a ball's centre lies when it touches the nose of a cushion.
function noseLines(table: TablePlan, radius: number): Curve[] {
    return table.noses.map(({ from, to }) => {
        const length = distance(from, to);
        const along: Place = [(to[0] - from[0]) / length, (to[1] - from[1]) / length];
        const start: Place = [from[0] - along[1] * radius, from[1] + along[0] * radius];
        return { kind: 'line', from: start, along, length, to: 'at a cushion', isGuide: false };
    });
}

/// The point of a curve that is nearest to `place`; null beyond the ends of a line.
function nearest(curve: Curve, place: Place): Place | null {
    if (curve.kind === 'circle') {
        const away = distance(place, curve.centre);
        const factor = away > 1e-12 ? curve.radius / away : 0;
        return factor === 0 ? null : [
            curve.centre[0] + factor * (place[0] - curve.centre[0]),
            curve.centre[1] + factor * (place[1] - curve.centre[1])];
    }
    const t = (place[0] - curve.from[0]) * curve.along[0]
        + (place[1] - curve.from[1]) * curve.along[1];
    return t < 0 || t > curve.length ? null
        : [curve.from[0] + t * curve.along[0], curve.from[1] + t * curve.along[1]];
}

/// Where two curves meet: up to two points.
function meetings(a: Curve, b: Curve): Place[] {
    if (a.kind === 'line' && b.kind === 'line') {
        const sine = a.along[0] * b.along[1] - a.along[1] * b.along[0];
        if (Math.abs(sine) < 1e-9) {
            return [];
        }
        const [dx, dy] = [b.from[0] - a.from[0], b.from[1] - a.from[1]];
        const t = (dx * b.along[1] - dy * b.along[0]) / sine;
        return [[a.from[0] + t * a.along[0], a.from[1] + t * a.along[1]]];
    }
    if (a.kind === 'circle' && b.kind === 'circle') {
        const d = distance(a.centre, b.centre);
        const along = (d * d + a.radius * a.radius - b.radius * b.radius) / (2 * d);
        const side = Math.sqrt(a.radius * a.radius - along * along);
        if (!(d > 1e-9) || !(side >= 0)) {
            return [];
        }
        const u: Place = [(b.centre[0] - a.centre[0]) / d, (b.centre[1] - a.centre[1]) / d];
        const foot: Place = [a.centre[0] + along * u[0], a.centre[1] + along * u[1]];
        return [[foot[0] - side * u[1], foot[1] + side * u[0]],
            [foot[0] + side * u[1], foot[1] - side * u[0]]];
    }
    const [line, circle] = a.kind === 'line' ? [a, b] : [b, a];
    if (line.kind !== 'line' || circle.kind !== 'circle') {
        return [];
    }
    const [dx, dy] = [circle.centre[0] - line.from[0], circle.centre[1] - line.from[1]];
    const along = dx * line.along[0] + dy * line.along[1];
    const off = dx * line.along[1] - dy * line.along[0];
    const side = Math.sqrt(circle.radius * circle.radius - off * off);
    return !(side >= 0) ? [] : [along - side, along + side].map((t) =>
        [line.from[0] + t * line.along[0], line.from[1] + t * line.along[1]] as Place);
}

/// Rounds a place to whole steps of `kFinest` so that it does not overlap the balls that it touches
/// and stays clear of the cushions by less than two steps.
function roundedOutwards(place: Place, radius: number, others: readonly OtherBall[]): Place {
    const steps = place.map((value) => value / kFinest);
    const near = others.filter((other) =>
        distance(place, other.place) < contactDistance(radius, other.radius) + 10 * kFinest);
    let best: Place | null = null;
    let smallest = Infinity;
    for (let i = -1; i <= 2; ++i) {
        for (let j = -1; j <= 2; ++j) {
            const one: Place = [
                (Math.floor(steps[0] ?? 0) + i) * kFinest,
                (Math.floor(steps[1] ?? 0) + j) * kFinest];
            const away = distance(one, place);
            if (away < smallest && overlaps(one, radius, near, 0).length === 0) {
                [best, smallest] = [one, away];
            }
        }
    }
    return best ?? place;
}

/// With the coordinate that the snap leaves free in whole steps.
function inSteps<T extends Snap & { line: Curve | null }>(snap: T): T {
    const along = snap.line?.kind === 'line' ? snap.line.along : [0, 0];
    const place = snap.place.map((value, i) =>
        Math.abs(along[i] ?? 0) === 1 ? Math.round(value / kAlong) * kAlong : value);
    return { ...snap, place: place as Place };
}

function guidesOf(curves: readonly Curve[]): [Place, Place][] {
    return curves.flatMap((curve): [Place, Place][] => curve.kind === 'line' && curve.isGuide
        ? [[curve.from, [curve.from[0] + curve.length * curve.along[0],
            curve.from[1] + curve.length * curve.along[1]]]]
        : []);
}

/// The place near `place` where the ball touches something or lies on a mark, at most `reach` (m)
/// away. Two marks at once come before one. Without any, `place` itself.
export function snapBall(
    place: Place, radius: number, others: readonly OtherBall[], table: TablePlan | null,
    reach: number,
): Snap {
    const marks = table ? tableMarks(table) : { lines: [], spots: [] };
    const curves: Curve[] = [
        ...others.map((other): Curve => ({
            kind: 'circle', centre: other.place, radius: contactDistance(radius, other.radius),
            to: `touches ${other.name}`,
        })),
        ...(table ? noseLines(table, radius) : []),
        ...marks.lines,
    ].filter((curve) => {
        const point = nearest(curve, place);
        return point !== null && distance(point, place) <= reach;
    });
    const isFree = (one: Place) => distance(one, place) <= reach
        && overlaps(one, radius, others, 1e-7).length === 0;
    const pick = (candidates: (Snap & { rank: number })[]): Snap | null => {
        const free = candidates.filter((one) => isFree(one.place));
        free.sort((a, b) => a.rank - b.rank || distance(a.place, place) - distance(b.place, place));
        return free[0] ?? null;
    };
    const twice = curves.flatMap((a, i) => curves.slice(i + 1).flatMap((b) =>
        meetings(a, b).map((one) =>
            ({ place: one, to: [a.to, b.to], guides: guidesOf([a, b]), rank: 0 }))));
    const spots = marks.spots.map((spot) =>
        ({ place: spot.place, to: [spot.to], guides: [], rank: -1 }));
    const once = curves.flatMap((curve) => {
        const one = nearest(curve, place);
        return one ? [{ place: one, to: [curve.to], guides: guidesOf([curve]),
            rank: curve.kind === 'circle' ? 1 : 2, line: curve }] : [];
    });
    const found = pick([...spots, ...twice]) ?? pick(once.map(inSteps));
    return found ? { to: found.to, guides: found.guides,
        place: roundedOutwards(found.place, radius, others) } : { place, to: [], guides: [] };
}
