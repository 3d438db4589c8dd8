/// The strike in the view: of the selected strike or of the selected ball, with handles for aim,
/// speed and elevation; the first strike is always there, faintly.
import { computed, effect, signal } from '@preact/signals';
import { Color } from 'three';
import type { Change } from '../../edit/edit';
import { tracks } from '../../motion/clock';
import type { KeyPath, ShotEvent, ShotState } from '../../protocol';
import { wish } from '../../solve/solve_state';
import { lookThrough, playing, selection, shot } from '../../state/state';
import { kHandlePriority, type Drag, type MakePart, type ViewContext } from '../parts';
import { tablePlan, type OtherBall } from './ball_snap';
import {
    editDrag, hasShift, nearestHandle, pixelDistance, rayThrough, viewDirection,
} from './dragging';
import type { Parsed } from './measures';
import { alongAxis, onPlane, shortAngle, stepOf } from './rays';
import { valueAt } from './shot_values';
import { forTests, sketchOf } from './sketch';
import {
    speedOfLength, stickOf, strikeFigure, strikeHandles, tipPlace, type StrikeHandle,
    type StrikeView,
} from './strike_figure';

const kDegree = Math.PI / 180;
const kSteepest = 89.9 * kDegree;
const kSlowest = 0.01; // m/s

function isPart(chosen: KeyPath | null, whole: KeyPath): boolean {
    return chosen !== null && whole.every((key, i) => chosen[i] === key);
}

/// The strike to show, and whether it or its ball is selected.
export const shownStrike = computed<{ event: ShotEvent; isChosen: boolean } | null>(() => {
    const strikes = (shot.value?.events ?? []).filter(({ kind }) => kind === 'strike');
    const chosen = selection.value;
    const event = strikes.find((one) => isPart(chosen, one.path))
        ?? strikes.find((one) => isPart(chosen, ['balls', one.object]));
    const first = strikes[0];
    return event ? { event, isChosen: true } : first ? { event: first, isChosen: false } : null;
});

/// While a handle is dragged, what it says; the server's answer is a moment late.
const dragged = signal<Partial<StrikeView> | null>(null);

/// The strike as it is drawn.
export const strikeView = computed<StrikeView | null>(() => {
    const state = shot.value;
    const event = shownStrike.value?.event;
    const view = state && event ? viewOf(state, event) : null;
    return view && { ...view, ...dragged.value };
});

function viewOf(state: ShotState, event: ShotEvent): StrikeView | null {
    const cue = state.objects.find(({ name }) => name === event.object);
    if (!cue) {
        return null;
    }
    const placeOf = (name: string, start: [number, number, number]) =>
        tracks.value.get(name)?.position(event.time) ?? start;
    const balls = state.objects.filter(({ kind }) => kind === 'ball');
    const others = balls.flatMap(({ name, radius, position }): OtherBall[] => {
        const [x, y, z] = placeOf(name, position);
        const isOnCloth = Math.abs(z - radius) < radius / 2;
        return name === cue.name || !isOnCloth ? [] : [{ name, radius, place: [x, y] }];
    });
    const colours = new Map(balls.map(({ name, colour }) =>
        [name, new Color(...colour).lerp(new Color(1, 1, 1), 0.3).getHex()]));
    return {
        centre: placeOf(cue.name, cue.position), radius: cue.radius || 0.028575,
        direction: event.direction, elevation: event.elevation, tip: event.tip, speed: event.speed,
        isBallSpeed: event.ball_speed, others, colours, plan: tablePlan(state),
    };
}

export const makeStrike: MakePart = (context) => {
    const sketch = sketchOf(context);
    const handles = (): StrikeHandle[] => {
        const isShown = shownStrike.peek()?.isChosen && wish.peek() === null;
        const view = isShown ? strikeView.peek() : null;
        const isFromAbove = Math.abs(viewDirection(context)[2]) > 0.97;
        return view ? strikeHandles(view).filter(({ kind }) => kind !== 'elevation' || !isFromAbove)
            : [];
    };
    forTests['handles'] = handles;
    const end = effect(() => {
        const view = strikeView.value;
        const isChosen = shownStrike.value?.isChosen ?? false;
        // What is only faint does not disturb the film.
        const isShown = wish.value === null
            && (isChosen || (!playing.value && lookThrough.value === null));
        sketch.show('strike', view && isShown ? strikeFigure(view, isChosen) : {});
    });
    return {
        priority: kHandlePriority,
        grab: (event) => {
            const handle = nearestHandle(context, handles(), event);
            const view = strikeView.peek();
            const strike = shownStrike.peek()?.event;
            return handle && view && strike
                ? dragStrike(handle, view, strike, event, context) : null;
        },
        hover: (event) => nearestHandle(context, handles(), event) ? 'grab' : null,
        dispose: () => {
            end();
            sketch.dispose();
        },
    };
};

function dragStrike(
    handle: StrikeHandle, view: StrikeView, strike: ShotEvent, start: PointerEvent,
    context: ViewContext,
): Drag {
    const path = [...strike.path, 'strike'];
    const toward = valueAt([...path, 'toward']); // in the text before the drag
    const how: HowToChange = handle.kind === 'speed' ? speedChange
        : handle.kind === 'elevation' ? elevationChange
            : (...all) => aimChange(toward, ...all);
    return editDrag(start, {
        label: { aim: 'Aim', speed: 'Change the speed', elevation: 'Raise the stick' }[handle.kind],
        changes: (event) => how(event, view, path, start, context),
        ended: () => { dragged.value = null; },
    });
}

type HowToChange = (
    event: PointerEvent, view: StrikeView, path: KeyPath, start: PointerEvent, context: ViewContext,
) => Change[] | null;

/// The direction of the aim at a pixel, on the ball's level.
function aimAt(context: ViewContext, event: PointerEvent, view: StrikeView) {
    const point = onPlane(rayThrough(context, event), view.centre, [0, 0, 1]);
    const offset = point ? [point[0] - view.centre[0], point[1] - view.centre[1]] as const : null;
    return point && offset
        ? { point, reach: Math.hypot(...offset), angle: Math.atan2(offset[1], offset[0]) } : null;
}

function aimChange(
    toward: Parsed | undefined, ...[event, view, path, start, context]: Parameters<HowToChange>
): Change[] | null {
    const [to, from] = [aimAt(context, event, view), aimAt(context, start, view)];
    if (!to || !from) {
        return null;
    }
    const target = event.ctrlKey || event.metaKey || event.shiftKey ? undefined
        : view.others.find(({ place, radius }) => {
            const at: [number, number, number] = [place[0], place[1], radius];
            return pixelDistance(context, at, event) * context.metresPerPixel(at) < radius;
        });
    const [x, y] = view.centre;
    const aimed = target ? Math.atan2(target.place[1] - y, target.place[0] - x)
        : hasShift(event) ? view.direction + 0.1 * shortAngle(to.angle - from.angle) : to.angle;
    const direction = view.direction + shortAngle(aimed - view.direction);
    dragged.value = { direction };
    if (Array.isArray(toward) && toward.every((one) => typeof one === 'number')) {
        const point = target?.place ?? [to.point[0], to.point[1]];
        const value = [...point, ...toward.slice(2)];
        return [{ path: [...path, 'toward'], value, precision: 1e-4 }];
    }
    if (target && typeof toward === 'string') {
        return [{ path: [...path, 'toward'], value: target.name }];
    }
    const pixel = (context.metresPerPixel(view.centre) / to.reach / kDegree)
        * (hasShift(event) ? 0.1 : 1);
    const precision = target ? 1e-3 : stepOf(pixel, 1e-3, 0.1);
    return [{ path: [...path, 'direction'], value: direction, precision: precision * kDegree }];
}

const speedChange: HowToChange = (event, view, path, start, context) => {
    const tip = tipPlace(view);
    const { butt } = stickOf(view);
    const [to, from] = [alongAxis(rayThrough(context, event), tip, butt),
        alongAxis(rayThrough(context, start), tip, butt)];
    if (to === null || from === null) {
        return null;
    }
    const way = (hasShift(event) ? 0.1 : 1) * (speedOfLength(to) - speedOfLength(from));
    const speed = Math.max(kSlowest, view.speed + way);
    dragged.value = { speed };
    const precision = hasShift(event) ? 0.01 : stepOf(speed / 20, 0.01, 0.1);
    const key = valueAt([...path, 'ball_speed']) === undefined ? 'speed' : 'ball_speed';
    return [{ path: [...path, key], value: speed, precision }];
};

const elevationChange: HowToChange = (event, view, path, _start, context) => {
    const { aim } = stickOf(view);
    const tip = tipPlace(view);
    const point = onPlane(rayThrough(context, event), tip, [-aim[1], aim[0], 0]);
    if (!point) {
        return null;
    }
    const back = -(point[0] - tip[0]) * aim[0] - (point[1] - tip[1]) * aim[1];
    const angle = Math.atan2(point[2] - tip[2], Math.max(back, 1e-6));
    const elevation = Math.min(Math.max(angle, 0), kSteepest);
    dragged.value = { elevation };
    return [{ path: [...path, 'elevation'], value: elevation, precision: 0.1 * kDegree }];
};
