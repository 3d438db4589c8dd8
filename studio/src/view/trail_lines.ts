/// The paths of objects as pieces of lines, with colours and opacities, and as dots of equal times.
import { Color } from 'three';
import type { Track } from '../motion/track';
import type { SceneObject, TimelineEvent, Triple } from '../protocol';

const kMostPieces = 24; // straight pieces between two keys
const kDeviation = 0.0005; // m, of the drawn line from the curve
const kDotTime = 0.1; // s
const kNearest = 0.03; // m between two dots: slower balls have none
const kContacts = 2; // of a ball, after which its path is faded during a drag
/// Surfaces whose contacts change no ball's path that an eye would notice.
const kLevel = new Set(['cloth', 'floor']);

/// Lines and dots for the graphics card: three numbers for each place, four for each colour.
export interface TrailShapes {
    lines: number[];
    lineColours: number[];
    dots: number[];
    dotColours: number[];
}

export interface TrailStyle {
    opacity: number;
    /// Of what follows a ball's second contact.
    fadedOpacity: number;
}

/// Into how many straight pieces a curve between two keys is cut: a piece deviates by at most an
/// eighth of the square of its share of the curve times the second derivative.
function countPieces([a, b, c, d]: [Triple, Triple, Triple, Triple]): number {
    const bend = (p: Triple, q: Triple, r: Triple) =>
        6 * Math.hypot(p[0] - 2 * q[0] + r[0], p[1] - 2 * q[1] + r[1], p[2] - 2 * q[2] + r[2]);
    const pieces = Math.sqrt(Math.max(bend(a, b, c), bend(b, c, d)) / (8 * kDeviation));
    return Math.min(Math.max(1, Math.ceil(pieces)), kMostPieces);
}

/// Points along a track with their times. `jumps` has the points to which no line leads, because
/// the object was put there.
export function polyline(track: Track): { points: Triple[]; times: number[]; jumps: Set<number> } {
    const points = [track.positionOf(0)];
    const times = [track.timeOf(0)];
    const jumps = new Set<number>();
    for (let key = 0; key + 1 < track.keys; ++key) {
        if (track.jumpsAfter(key)) {
            jumps.add(points.length);
            points.push(track.positionOf(key + 1));
            times.push(track.timeOf(key + 1));
            continue;
        }
        const pieces = countPieces(track.bezierAfter(key));
        const from = track.timeOf(key);
        const span = track.timeOf(key + 1) - from;
        for (let piece = 1; piece < pieces; ++piece) {
            const time = from + (span * piece) / pieces;
            points.push(track.position(time));
            times.push(time);
        }
        points.push(track.positionOf(key + 1));
        times.push(from + span);
    }
    return { points, times, jumps };
}

/// The scene time of each object's second contact with another one or a cushion.
export function secondContacts(events: readonly TimelineEvent[]): Map<string, number> {
    const counts = new Map<string, number>();
    const found = new Map<string, number>();
    for (const event of events) {
        if (event.kind !== 'impact' || kLevel.has(event.b)) {
            continue;
        }
        for (const name of [event.a, event.b]) {
            const count = (counts.get(name) ?? 0) + 1;
            counts.set(name, count);
            if (count === kContacts) {
                found.set(name, event.time);
            }
        }
    }
    return found;
}

/// A ball's colour, light enough to be seen on the cloth.
export function trailColour(object: SceneObject): Color {
    return new Color(...object.colour).lerp(new Color(1, 1, 1), 0.25);
}

/// The shapes of all paths but that of the cue stick, which is of the table's kind. `fadedAfter` has the times from which paths are faded, by object.
export function trailShapes(
    objects: readonly SceneObject[], tracks: ReadonlyMap<string, Track>, style: TrailStyle,
    fadedAfter: ReadonlyMap<string, number>,
): TrailShapes {
    const shapes: TrailShapes = { lines: [], lineColours: [], dots: [], dotColours: [] };
    for (const object of objects) {
        const track = object.moves && object.kind !== 'table' ? tracks.get(object.name) : undefined;
        if (track?.moves) {
            const fadeTime = fadedAfter.get(object.name) ?? Infinity;
            const opacityAt = (time: number) =>
                (time > fadeTime ? style.fadedOpacity : style.opacity);
            addTrail(shapes, track, trailColour(object).toArray(), opacityAt);
        }
    }
    return shapes;
}

function addTrail(
    shapes: TrailShapes, track: Track, colour: number[], opacityAt: (time: number) => number,
): void {
    const { points, times, jumps } = polyline(track);
    for (let i = 0; i + 1 < points.length; ++i) {
        const [from, to] = [points[i] as Triple, points[i + 1] as Triple];
        const rests = from[0] === to[0] && from[1] === to[1] && from[2] === to[2];
        if (rests || jumps.has(i + 1)) {
            continue;
        }
        shapes.lines.push(...from, ...to);
        // Both ends have the opacity of the piece, so that it changes at once.
        const opacity = opacityAt(((times[i] ?? 0) + (times[i + 1] ?? 0)) / 2);
        shapes.lineColours.push(...colour, opacity, ...colour, opacity);
    }
    let last: Triple | null = null;
    const first = Math.ceil(track.start / kDotTime - 1e-9);
    for (let step = first; step * kDotTime <= track.end; ++step) {
        const place = track.position(step * kDotTime);
        const way = last
            ? Math.hypot(place[0] - last[0], place[1] - last[1], place[2] - last[2]) : 0;
        if (way > kNearest) {
            shapes.dots.push(...place);
            shapes.dotColours.push(...colour, Math.min(1, opacityAt(step * kDotTime) + 0.2));
        }
        last = place;
    }
}
