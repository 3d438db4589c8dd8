/// A strike as a figure: the stick, the line of the aim, the ghost ball and what follows from it.
import type { Triple } from '../../protocol';
import { add, cross, scale } from '../../motion/vectors';
import type { OtherBall, Place, TablePlan } from './ball_snap';
import { kColours, together, type Figure, type Line } from './figure';
import { afterContact, dashed, firstContact, polar, type Contact } from './strike_geometry';

const kStickBase = 0.07; // m, of the arrow at no speed
const kStickPerSpeed = 0.06; // m for each m/s
const kElevationBeyond = 0.09; // m, of the elevation's handle beyond the butt
const kNearestAim = 0.2; // m, of the aim's handle from the ball
const kLongestTangent = 0.5; // m
const kLongestRebound = 1.2; // m

/// What the figure shows, at the time of the strike.
export interface StrikeView {
    centre: Triple;
    radius: number;
    direction: number; // rad
    elevation: number; // rad
    tip: [number, number];
    speed: number;
    isBallSpeed: boolean;
    others: readonly OtherBall[];
    plan: TablePlan | null;
    /// sRGB colours of the balls by name.
    colours: ReadonlyMap<string, number>;
}

export interface StrikeHandle {
    kind: 'aim' | 'speed' | 'elevation';
    at: Triple;
}

/// The directions of a strike: of the aim, and from the tip to the butt.
export function stickOf({ direction, elevation }: StrikeView): { aim: Place; butt: Triple } {
    const aim: Place = [Math.cos(direction), Math.sin(direction)];
    const c = Math.cos(elevation);
    return { aim, butt: [-aim[0] * c, -aim[1] * c, Math.sin(elevation)] };
}

/// Where the tip touches the ball, seen by the player to the right and up.
export function tipPlace(view: StrikeView): Triple {
    const { aim, butt } = stickOf(view);
    const right: Triple = [aim[1], -aim[0], 0];
    const up = cross(right, scale(-1, butt));
    const [x, y] = view.tip;
    const depth = Math.sqrt(Math.max(0, 1 - x * x - y * y));
    const offset = add(add(scale(x, right), scale(y, up)), scale(depth, butt));
    return add(view.centre, scale(view.radius, offset));
}

/// The end of the stick's arrow: the faster, the farther.
export function buttPlace(view: StrikeView): Triple {
    return add(tipPlace(view), scale(kStickBase + kStickPerSpeed * view.speed, stickOf(view).butt));
}

/// The speed of a stick whose arrow has this length.
export function speedOfLength(length: number): number {
    return Math.max(0, (length - kStickBase) / kStickPerSpeed);
}

export function contactOf(view: StrikeView): Contact {
    const { centre, radius, others, plan } = view;
    return firstContact([centre[0], centre[1]], stickOf(view).aim, radius, others, plan);
}

export function strikeHandles(view: StrikeView): StrikeHandle[] {
    const { ghost, distance } = contactOf(view);
    const [x, y, level] = view.centre;
    const near = polar([x, y], view.direction, kNearestAim);
    const butt = buttPlace(view);
    return [
        { kind: 'aim', at: [...(distance < kNearestAim ? near : ghost), level] },
        { kind: 'speed', at: butt },
        { kind: 'elevation', at: add(butt, scale(kElevationBeyond, stickOf(view).butt)) },
    ];
}

/// Everything that a strike shows. `isChosen`: with handles and strong lines.
export function strikeFigure(view: StrikeView, isChosen: boolean): Figure {
    const contact = contactOf(view);
    const aim = aimFigure(view, contact, isChosen);
    return isChosen ? together(aim, stickFigure(view)) : aim;
}

function stickFigure(view: StrikeView): Figure {
    const tip = tipPlace(view);
    const [, speed, elevation] = strikeHandles(view);
    if (!speed || !elevation) {
        return {};
    }
    const degrees = (view.elevation * 180) / Math.PI;
    return {
        lines: [
            { from: tip, to: speed.at, colour: kColours.strike },
            { from: speed.at, to: elevation.at, colour: kColours.strike, isFaint: true },
        ],
        tips: [{ at: tip, along: scale(-1, stickOf(view).butt), colour: kColours.strike }],
        dots: [
            { at: speed.at, colour: kColours.strike, size: 13, shape: 'disc' },
            { at: elevation.at, colour: kColours.strike, size: 12, shape: 'diamond' },
        ],
        labels: [{
            at: speed.at, isBelow: true,
            text: `${Number(view.speed.toPrecision(3))} m/s`
                + (view.isBallSpeed ? ' of the ball' : '')
                + (degrees > 0.05 ? `, ${degrees.toFixed(1)}° raised` : ''),
        }],
    };
}

function aimFigure(view: StrikeView, contact: Contact, isChosen: boolean): Figure {
    const { centre, radius, others, plan, colours } = view;
    const { aim } = stickOf(view);
    const level = centre[2];
    const at = ([x, y]: Place): Triple => [x, y, level];
    const lines: Line[] = [{
        from: at([centre[0] + radius * aim[0], centre[1] + radius * aim[1]]), to: at(contact.ghost),
        colour: kColours.aim, isFaint: !isChosen,
    }];
    const dash = (from: Place, to: Place, colour: number) => {
        lines.push(...dashed(from, to).map(([a, b]) =>
            ({ from: at(a), to: at(b), colour, isFaint: !isChosen })));
    };
    const balls: Figure['balls'] = [];
    const dots: Figure['dots'] = [];
    if (contact.kind === 'ball' || contact.kind === 'cushion') {
        balls.push({ at: at(contact.ghost), radius, colour: kColours.ghost });
    }
    const after = afterContact(contact, aim);
    if (contact.ball && after.object) {
        const { ball } = contact;
        const rest = others.filter((one) => one !== ball);
        const next = firstContact(ball.place, after.object, ball.radius, rest, plan);
        const colour = colours.get(ball.name) ?? kColours.aim;
        lines.push({ from: at(ball.place), to: at(next.ghost), colour, isFaint: !isChosen });
        const rebound = afterContact(next, after.object).own;
        if (next.kind === 'cushion' && rebound) {
            const last = firstContact(next.ghost, rebound, ball.radius, rest, plan);
            dash(next.ghost, reaching(next.ghost, last.ghost, kLongestRebound), colour);
        }
        if (next.kind === 'pocket' && isChosen) {
            dots.push({ at: at(next.ghost), colour: kColours.potted, size: 15, shape: 'ring' });
        }
    }
    if (after.own) {
        const rest = others.filter((one) => one !== contact.ball);
        const next = firstContact(contact.ghost, after.own, radius, rest, plan);
        const most = contact.kind === 'ball' ? kLongestTangent : kLongestRebound;
        dash(contact.ghost, reaching(contact.ghost, next.ghost, most),
            contact.kind === 'ball' ? kColours.tangent : kColours.rebound);
    }
    if (isChosen) {
        const handle = strikeHandles(view)[0]?.at ?? centre;
        dots.push({ at: handle, colour: kColours.aim, size: 17, shape: 'ring' });
        if (contact.distance < kNearestAim) {
            lines.push({ from: centre, to: handle, colour: kColours.aim, isFaint: true });
        }
    }
    return { lines, balls, dots };
}

/// The point between both ends that is at most `most` away from the first.
function reaching(from: Place, to: Place, most: number): Place {
    const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
    const share = length > most ? most / length : 1;
    return [from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1])];
}
