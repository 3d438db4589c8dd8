/// Dragging a ball changes the place at which it starts, in the text: over the cloth, where it
/// snaps to other balls, cushions and the table's marks (not with Ctrl); with Alt in the plane of
/// the view; with x, y or z held along that axis; with Shift ten times finer.
import type { Change } from '../edit/edit';
import { tracks } from '../motion/clock';
import type { SceneObject, TablePocket, Triple } from '../protocol';
import { canPot, seekPot } from '../solve/search';
import { pocketAt } from '../solve/solve_state';
import { pocketWords } from '../solve/solution_text';
import { sceneTime, selection, shot } from '../state/state';
import { kBodyPriority, type Drag, type MakePart, type ViewContext } from './parts';
import { ballItems } from './gizmos/ball_menu';
import { snapBall, tablePlan, type OtherBall, type Snap } from './gizmos/ball_snap';
import { editDrag, follower, hasShift } from './gizmos/dragging';
import { kColours, type Figure } from './gizmos/figure';
import { followAxisKeys, heldAxis } from './gizmos/held_axis';
import { stepOf } from './gizmos/rays';
import { valueAt } from './gizmos/shot_values';
import { sketchOf } from './gizmos/sketch';

const kPrecision = 1e-4; // m, of the places that are written
const kSnapPrecision = 1e-6; // m, of places that touch something
const kSnapPixels = 9;
const kOnCloth = 1e-6; // m

export const makeBallDrag: MakePart = (context) => {
    const sketch = sketchOf(context);
    const forgetKeys = followAxisKeys();
    return {
        priority: kBodyPriority,
        grab: (event) => {
            const ball = context.objectAt(event);
            return ball?.kind === 'ball' ? dragBall(ball, event, context) : null;
        },
        hover: (event) => context.objectAt(event)?.kind === 'ball' ? 'grab' : null,
        menu: (pixel) => {
            const ball = context.objectAt(pixel);
            return ball?.kind === 'ball' ? ballItems(ball, pixel.clientX, pixel.clientY) : [];
        },
        dispose: () => {
            forgetKeys();
            sketch.dispose();
        },
    };
};

/// The place that the text gives to a ball; that of the last valid text if it is derived.
function startOf(ball: SceneObject): { place: Triple; count: number } {
    const at = valueAt([...ball.path, 'at']);
    const numbers = Array.isArray(at) ? at.filter((one) => typeof one === 'number') : [];
    const [x = ball.position[0], y = ball.position[1], z = ball.position[2]] = numbers;
    return { place: [x, y, z], count: numbers.length === 3 ? 3 : 2 };
}

/// The other balls on the cloth that do not move with this one.
export function othersOf(ball: SceneObject, objects: readonly SceneObject[]): OtherBall[] {
    return objects
        .filter((one) => one.kind === 'ball' && one.name !== ball.name
            && Math.abs(one.position[2] - one.radius) < kOnCloth
            && valueAt([...one.path, 'touching', 'ball']) !== ball.name)
        .map(({ name, position, radius }) => ({ name, radius, place: [position[0], position[1]] }));
}

function dragBall(ball: SceneObject, start: PointerEvent, context: ViewContext): Drag {
    const sketch = sketchOf(context);
    const { place: from, count } = startOf(ball);
    // The ball is taken where it is seen now, which may be somewhere else.
    const seen = tracks.peek().get(ball.name)?.position(sceneTime.peek()) ?? ball.position;
    const follow = follower(context, seen, start);
    const others = othersOf(ball, shot.peek()?.objects ?? []);
    const partner = others.find(({ name }) => name === valueAt([...ball.path, 'touching', 'ball']));
    const plan = shot.peek() ? tablePlan(shot.peek() as NonNullable<typeof shot.value>) : null;
    selection.value = ball.path;

    const show = (place: Triple, snap: Snap) =>
        sketch.show('ball-drag', dragFigure(ball, place, snap, seen));
    const around = (event: PointerEvent): Change[] | null => {
        const to = follow(event, 'level', hasShift(event));
        if (!to || !partner) {
            return null;
        }
        const offset = [to[0] - seen[0] + from[0] - partner.place[0],
            to[1] - seen[1] + from[1] - partner.place[1]] as const;
        const reach = Math.hypot(...offset);
        const angle = Math.atan2(offset[1], offset[0]);
        const pixel = (context.metresPerPixel(from) / reach) * (180 / Math.PI);
        const precision = stepOf(pixel, 1e-3, 0.1);
        const factor = (ball.radius + partner.radius) / reach;
        const [x, y] = partner.place;
        show([x + factor * offset[0], y + factor * offset[1], from[2]], {
            place: partner.place, to: [`touches ${partner.name}; Alt frees it`], guides: [],
        });
        return [{
            path: [...ball.path, 'touching', 'direction'], value: angle,
            precision: (precision * Math.PI) / 180,
        }];
    };
    const freely = (event: PointerEvent): Change[] | null => {
        const to = follow(event, event.altKey && !partner ? 'view' : 'level', hasShift(event));
        if (!to) {
            return null;
        }
        const free: Triple = [to[0] - seen[0] + from[0], to[1] - seen[1] + from[1],
            to[2] - seen[2] + from[2]];
        const reach = kSnapPixels * context.metresPerPixel(to);
        const isSnapping = !event.ctrlKey && !event.metaKey;
        if (isSnapping && Math.abs(free[2] - ball.radius) < Math.min(reach, ball.radius / 2)) {
            free[2] = ball.radius;
        }
        const isLow = Math.abs(free[2] - ball.radius) < kOnCloth;
        const snap: Snap = isSnapping && isLow && heldAxis() === null
            ? snapBall([free[0], free[1]], ball.radius, others, plan, reach)
            : { place: [free[0], free[1]], to: [], guides: [] };
        const place: Triple = [...snap.place, free[2]];
        show(place, snap);
        const value = isLow && count === 2 ? place.slice(0, 2) : place;
        const precision = snap.to.length > 0 ? kSnapPrecision : hasShift(event)
            ? stepOf(context.metresPerPixel(to) / 10, 1e-6, kPrecision) : kPrecision;
        return [{ path: [...ball.path, 'at'], value, precision }];
    };
    // No ball rests in a pocket: over one, the drag says that it shall be potted there, and the ball is
    // where it was.
    let pocket: TablePocket | undefined;
    const intoPocket = (event: PointerEvent): boolean => {
        const to = !event.altKey && canPot(ball) ? follow(event, 'level') : null;
        pocket = to ? pocketAt(to, shot.peek()?.pockets ?? []) : undefined;
        if (pocket) {
            sketch.show('ball-drag', pocketFigure(ball, pocket));
        }
        return pocket !== undefined;
    };
    const drag = editDrag(start, {
        label: `Move ${ball.name}`,
        changes: (event) => intoPocket(event) ? []
            : partner && !event.altKey ? around(event) : freely(event),
        ended: () => sketch.hide('ball-drag'),
    });
    return {
        ...drag,
        end: (event) => {
            drag.end(event);
            if (pocket) {
                seekPot(ball.name, pocket.name);
            }
        },
    };
}

/// The wish to pot a ball.
function pocketFigure(ball: SceneObject, { name, place, radius }: TablePocket): Figure {
    return {
        balls: [{ at: [...place, 0], radius: ball.radius, colour: kColours.potted }],
        dots: [{ at: [...place, 0.03], colour: kColours.potted, size: 26, shape: 'ring' }],
        labels: [{
            at: [place[0], place[1], radius / 2], text: `pot ${ball.name} in ${pocketWords(name)}`,
        }],
    };
}

/// The ball where it starts now, if the view shows it elsewhere, and what it snaps to.
function dragFigure(ball: SceneObject, place: Triple, snap: Snap, seen: Triple): Figure {
    const isElsewhere = Math.hypot(seen[0] - ball.position[0], seen[1] - ball.position[1]) > 1e-3;
    const level = ball.radius * 0.1;
    return {
        balls: isElsewhere ? [{ at: place, radius: ball.radius, colour: kColours.ghost }] : [],
        lines: snap.guides.map(([a, b]) => ({
            from: [...a, level], to: [...b, level], colour: kColours.accent, isFaint: true,
        })),
        labels: snap.to.length > 0 ? [{ at: place, text: snap.to.join(', ') }] : [],
    };
}
