/// Lines of annotations as straight pieces for the graphics card, with the arrowheads at their ends.
import type { Triple } from '../../protocol';
import { mix } from '../../motion/vectors';

/// Of a line with one point: a dot.
export interface ShownLine {
    points: readonly Triple[];
    strengths: readonly number[]; // opacity at each point
    colour: Triple; // sRGB, as the next
    edge: Triple; // colour of the dark edge
    width: number; // picture heights, without the edges
    isClosed: boolean;
    hasRoundEnds: boolean;
    hasHead: boolean;
}

/// What a piece is: a sum of these.
export const kJoinsBefore = 1; // another one continues it at its start
export const kJoinsAfter = 2;
export const kRound = 4;
export const kHead = 8; // it is an arrowhead from its base to its tip
export const kEdgeOnly = 16;
export const kCoreOnly = 32;

/// Numbers of a piece: from, to, the points before and after, colour, colour of the edge; opacity at
/// both ends, width, kind.
export const kNumbersPerPiece = 22;

const kHeadLength = 4.2; // widths of its line (pipeline/picture/placed_shapes.cpp)
const kMostHead = 0.5; // of the line's length
const kIntoHead = 0.25; // of the head's length, that its line reaches into it

type Place = [number, number];

const distance = (a: Place, b: Place) => Math.hypot(a[0] - b[0], a[1] - b[1]);

function lengthOf(places: readonly Place[]): number {
    return places.reduce((sum, place, i) => sum + distance(place, places[i - 1] ?? place), 0);
}

/// The line without its arrowhead, and the head's base. `places`: of the points on the screen; `width`
/// of the line there. Null if the line has no length.
export function withoutHead(
    points: readonly Triple[], places: readonly Place[], width: number,
): { points: Triple[]; base: Triple } | null {
    const head = Math.min(kHeadLength * width, kMostHead * lengthOf(places));
    const tip = places.at(-1);
    const end = points.at(-1);
    if (!tip || !end || head <= 0) {
        return null;
    }
    let last = points.length - 1;
    while (last > 1 && distance(places[last - 1] ?? tip, tip) < head) {
        last -= 1;
    }
    const [from, to] = [places[last - 1] ?? tip, places[last] ?? tip];
    const [fromTip, here] = [distance(from, tip), distance(to, tip)];
    const share = Math.min(Math.max(0, (fromTip - head) / Math.max(fromTip - here, 1e-9)), 1);
    // The point of the line near the base gives the direction.
    const behind = mix(points[last - 1] ?? end, points[last] ?? end, share);
    const away = distance([from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1])], tip);
    const base = mix(end, behind, away > 0 ? head / away : 1);
    return { points: [...points.slice(0, last), mix(base, end, kIntoHead)], base };
}

/// Neighbours that are one place are one point.
function distinct(line: ShownLine): { points: Triple[]; strengths: number[] } {
    const kept = line.points.map((_, i) => i).filter((i) => {
        const [point, before] = [line.points[i], line.points[i - 1]];
        return !point || !before || point.some((value, axis) => value !== before[axis]);
    });
    return {
        points: kept.map((i) => line.points[i] as Triple),
        strengths: kept.map((i) => line.strengths[i] ?? 1),
    };
}

/// Appends the pieces of a line; `kind` is added to that of each.
function addPieces(numbers: number[], line: ShownLine, kind: number): void {
    const { points, strengths } = distinct(line);
    const count = points.length;
    const at = (i: number) => points[(i + count) % count] as Triple;
    const pieces = count === 1 ? 1 : line.isClosed ? count : count - 1;
    for (let i = 0; i < pieces; ++i) {
        const joinsBefore = line.isClosed ? count > 1 : i > 0;
        const joinsAfter = line.isClosed ? count > 1 : i + 1 < pieces;
        const to = count === 1 ? at(0) : at(i + 1);
        numbers.push(...at(i), ...to, ...(joinsBefore ? at(i - 1) : at(i)),
            ...(joinsAfter ? at(i + 2) : to), ...line.colour, ...line.edge,
            strengths[i] ?? 1, strengths[(i + 1) % count] ?? 1, line.width,
            kind + (joinsBefore ? kJoinsBefore : 0) + (joinsAfter ? kJoinsAfter : 0)
                + (line.hasRoundEnds ? kRound : 0));
    }
}

/// The edges of a line and of its head lie below both.
function addHeaded(numbers: number[], line: ShownLine, shaft: ShownLine, base: Triple): void {
    const strength = line.strengths.at(-1) ?? 1;
    const tip = line.points.at(-1) as Triple;
    for (const layer of [kEdgeOnly, kCoreOnly]) {
        addPieces(numbers, shaft, layer);
        numbers.push(...base, ...tip, ...base, ...tip, ...line.colour, ...line.edge,
            strength, strength, line.width, layer + kHead);
    }
}

/// The pieces of some lines, each over those before it. `toScreen` gives places in the unit of
/// `height`, the picture's; null behind the camera.
export function linePieces(
    lines: readonly ShownLine[], toScreen: (point: Triple) => Place | null, height: number,
): number[] {
    const numbers: number[] = [];
    for (const line of lines) {
        const places = line.hasHead ? line.points.map(toScreen) : [];
        const seen = places.filter((place) => place !== null);
        const shaft = seen.length > 1 && seen.length === places.length
            ? withoutHead(line.points, seen, line.width * height) : null;
        if (shaft) {
            const strengths = line.strengths.slice(0, shaft.points.length);
            addHeaded(numbers, line, { ...line, points: shaft.points, strengths }, shaft.base);
        } else {
            addPieces(numbers, line, 0);
        }
    }
    return numbers;
}
