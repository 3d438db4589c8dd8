/// What players draw before a strike, seen from above: the line of the aim, the ghost ball at the
/// first contact, where both balls leave it, and the rebound at a cushion. No throw, swerve or
/// squirt: the simulated paths show these.
import type { OtherBall, Place, TablePlan } from './ball_snap';
import { contactDistance } from './ball_snap';

/// Beyond this offset (in ball radii) a chalked tip slips off: sim/stick/strike.h (Alciatore, TP
/// 2.1).
export const kMiscueOffset = 0.5;

/// How far lines are drawn that meet nothing, m.
const kFar = 6;
/// How far outside of the playing field a ball in the mouth of a pocket can be, m.
const kBeyond = 0.06;

/// A ball that rolls along a line until it touches something: `ghost` is its centre then.
export interface Contact {
    kind: 'ball' | 'cushion' | 'pocket' | 'none';
    ghost: Place;
    /// From where it started, m.
    distance: number;
    /// Of the ball that it touches.
    ball?: OtherBall;
    /// Of the cushion that it touches, into the playing field.
    normal?: Place;
    pocket?: string;
}

/// Two directions after a contact, of length 1.
export interface AfterContact {
    /// The other ball leaves along the line of centres; null if nothing is hit.
    object: Place | null;
    /// The moving ball leaves along the tangent if it slides, at a cushion as from a mirror; null
    /// for a full hit.
    own: Place | null;
}

function minus(a: Place, b: Place): Place {
    return [a[0] - b[0], a[1] - b[1]];
}

function times(a: Place, b: Place): number {
    return a[0] * b[0] + a[1] * b[1];
}

function along(from: Place, direction: Place, distance: number): Place {
    return [from[0] + distance * direction[0], from[1] + distance * direction[1]];
}

/// The distance along the line at which two discs first touch; null if they never do, or move
/// apart.
function meetsDisc(from: Place, direction: Place, centre: Place, reach: number): number | null {
    const to = minus(centre, from);
    const ahead = times(to, direction);
    if (ahead <= 0) {
        return null;
    }
    const off = times(to, to) - ahead * ahead;
    const half = reach * reach - off;
    return half <= 0 ? null : Math.max(0, ahead - Math.sqrt(half));
}

/// The distance at which a ball's foremost point reaches a nose; null if it passes its ends.
function meetsNose(
    from: Place, direction: Place, radius: number, ends: { from: Place; to: Place },
): { distance: number; normal: Place } | null {
    const side = minus(ends.to, ends.from);
    const length = Math.hypot(...side);
    const normal: Place = [-side[1] / length, side[0] / length];
    const speed = -times(direction, normal);
    const height = times(minus(from, ends.from), normal) - radius;
    if (speed < 1e-9 || height < -radius) {
        return null;
    }
    const distance = Math.max(0, height / speed);
    const foot = times(minus(along(from, direction, distance), ends.from), side) / length;
    return foot >= 0 && foot <= length ? { distance, normal } : null;
}

/// The distance at which the line leaves the table, where no nose is.
function leaves(from: Place, direction: Place, table: TablePlan): number {
    const until = (at: number, speed: number, end: number) =>
        (Math.abs(speed) < 1e-12 ? Infinity : Math.max(0, (Math.sign(speed) * end - at) / speed));
    return Math.min(until(from[0], direction[0], table.length / 2 + kBeyond),
        until(from[1], direction[1], table.width / 2 + kBeyond));
}

/// What a ball of `radius` touches first that moves from `from` along `direction` (length 1).
/// `others` are without the ball itself.
export function firstContact(
    from: Place, direction: Place, radius: number, others: readonly OtherBall[],
    table: TablePlan | null,
): Contact {
    let best: Contact = {
        kind: 'none', ghost: along(from, direction, kFar), distance: kFar,
    };
    const consider = (distance: number | null, rest: Partial<Contact> & Pick<Contact, 'kind'>) => {
        if (distance !== null && distance < best.distance) {
            best = { ghost: along(from, direction, distance), distance, ...rest };
        }
    };
    if (table) {
        consider(leaves(from, direction, table), { kind: 'none' });
    }
    for (const pocket of table?.pockets ?? []) {
        const middle = meetsDisc(from, direction, pocket.place, pocket.radius);
        consider(middle, { kind: 'pocket', pocket: pocket.name });
    }
    for (const nose of table?.noses ?? []) {
        const hit = meetsNose(from, direction, radius, nose);
        consider(hit?.distance ?? null, { kind: 'cushion', normal: hit?.normal ?? [0, 0] });
    }
    for (const ball of others) {
        const reach = contactDistance(radius, ball.radius);
        consider(meetsDisc(from, direction, ball.place, reach), { kind: 'ball', ball });
    }
    return best;
}

/// Where both balls go after a contact of a ball that came along `direction`.
export function afterContact(contact: Contact, direction: Place): AfterContact {
    if (contact.kind === 'cushion' && contact.normal) {
        const into = times(direction, contact.normal);
        return { object: null, own: along(direction, contact.normal, -2 * into) };
    }
    if (contact.kind !== 'ball' || !contact.ball) {
        return { object: null, own: null };
    }
    const line = minus(contact.ball.place, contact.ghost);
    const length = Math.hypot(...line);
    const object: Place = [line[0] / length, line[1] / length];
    const rest = along(direction, object, -times(direction, object));
    const size = Math.hypot(...rest);
    return { object, own: size < 1e-6 ? null : [rest[0] / size, rest[1] / size] };
}

/// The point at `angle` (rad) and the distance from a place.
export function polar(from: Place, angle: number, distance: number): Place {
    return along(from, [Math.cos(angle), Math.sin(angle)], distance);
}

/// A line with gaps, as pieces from end to end. `piece` and `gap` in metres.
export function dashed(from: Place, to: Place, piece = 0.02, gap = 0.015): [Place, Place][] {
    const way = minus(to, from);
    const length = Math.hypot(...way);
    const direction: Place = [way[0] / (length || 1), way[1] / (length || 1)];
    const pieces: [Place, Place][] = [];
    for (let at = 0; at < length; at += piece + gap) {
        const end = Math.min(at + piece, length);
        pieces.push([along(from, direction, at), along(from, direction, end)]);
    }
    return pieces;
}
