/// The arrows of the shot in the view: their tips are dragged on their level, with Alt in the
/// view's plane, with x, y or z held along that axis, with Shift ten times finer.
import { computed, effect, signal } from '@preact/signals';
import { tracks } from '../../motion/clock';
import type { KeyPath, SceneObject, ShotEvent, Triple, Turn } from '../../protocol';
import { add, inverse, scale, rotate, subtract } from '../../motion/vectors';
import { dragging, selection, shot } from '../../state/state';
import { kHandlePriority, type MakePart } from '../parts';
import {
    arrowFigure, arrowScales, arrowTip, kUnits, type Arrow, type ArrowKind,
} from './arrow_figure';
import { editDrag, follower, hasShift, nearestHandle } from './dragging';
import { followAxisKeys } from './held_axis';
import { stepOf } from './rays';
import { tripleOf, valueAt } from './shot_values';
import { forTests, sketchOf } from './sketch';

const kKeys: Readonly<Record<ArrowKind, string>> = {
    impulse: 'newton_seconds', force: 'newtons', torque: 'newton_metres', velocity: 'linear',
};

function isArrow(kind: string): kind is ArrowKind {
    return kind in kUnits;
}

function isPart(chosen: KeyPath | null, whole: KeyPath): boolean {
    return chosen !== null && whole.every((key, i) => chosen[i] === key);
}

/// The two or three numbers at a path, with zeros for those that are not written.
function vectorAt(path: KeyPath): { vector: Triple; count: number } | null {
    const value = valueAt(path);
    if (!Array.isArray(value) || value.length < 2 || value.some((one) => typeof one !== 'number')) {
        return null;
    }
    const [x = 0, y = 0, z = 0] = value as number[];
    return { vector: [x, y, z], count: value.length };
}

function eventArrow(event: ShotEvent, object: SceneObject, chosen: KeyPath | null): Arrow | null {
    if (!isArrow(event.kind)) {
        return null;
    }
    const section = [...event.path, event.kind];
    const path = [...section, kKeys[event.kind]];
    const written = vectorAt(path);
    if (!written) {
        return null;
    }
    const track = tracks.value.get(object.name);
    const centre = track?.position(event.time) ?? object.position;
    const orientation: Turn = track?.orientation(event.time) ?? object.orientation;
    const turn = valueAt([...section, 'axes']) === 'body' ? orientation : null;
    const point = tripleOf(valueAt([...section, 'at_point'])) ?? [0, 0, 0];
    return {
        path, kind: event.kind, ...written, turn,
        base: add(centre, turn ? rotate(turn, point) : point),
        isChosen: isPart(chosen, event.path) || isPart(chosen, object.path),
    };
}

/// The velocity with which the selected ball or object starts.
function startArrow(object: SceneObject | undefined): Arrow | null {
    if (!object) {
        return null;
    }
    const path = [...object.path, ...(object.kind === 'ball' ? [] : ['physics']), 'velocity'];
    const written = vectorAt(path);
    return written && {
        path, kind: 'velocity', ...written, turn: null, base: object.position, isChosen: true,
    };
}

export const arrows = computed<Arrow[]>(() => {
    const objects = shot.value?.objects ?? [];
    const chosen = selection.value;
    const ofEvents = (shot.value?.events ?? []).map((event) => {
        const object = objects.find(({ name }) => name === event.object);
        return object ? eventArrow(event, object, chosen) : null;
    });
    const selected = objects.find(({ kind, path }) => kind !== 'table' && isPart(chosen, path));
    return [...ofEvents, startArrow(selected)].filter((one) => one !== null);
});

const scales = signal<ReadonlyMap<ArrowKind, number>>(new Map());

/// The tips that can be dragged.
function tips(): { at: Triple; arrow: Arrow; unit: number }[] {
    return arrows.peek().filter(({ isChosen }) => isChosen).map((arrow) => {
        const unit = scales.peek().get(arrow.kind) ?? 1;
        return { arrow, unit, at: arrowTip(arrow, unit) };
    });
}

export const makeArrows: MakePart = (context) => {
    const sketch = sketchOf(context);
    forTests['arrows'] = () => tips();
    const ends = [
        effect(() => {
            const all = arrows.value;
            // The scale stays as it is while a tip is dragged.
            if (!dragging.value) {
                scales.value = arrowScales(all, scales.peek());
            }
            sketch.show('arrows', arrowFigure(all, scales.peek()));
        }),
        followAxisKeys(),
    ];
    return {
        priority: kHandlePriority,
        grab: (start) => {
            const handle = nearestHandle(context, tips(), start);
            if (!handle) {
                return null;
            }
            const { arrow, unit, at } = handle;
            const follow = follower(context, at, start);
            return editDrag(start, {
                label: `Change the ${arrow.kind}`,
                changes: (event) => {
                    const to = follow(event, event.altKey ? 'view' : 'level', hasShift(event));
                    if (!to) {
                        return null;
                    }
                    const world = scale(1 / unit, subtract(to, arrow.base));
                    const own = arrow.turn ? rotate(inverse(arrow.turn), world) : world;
                    const count = own[2] === 0 ? arrow.count : 3;
                    const pixel = (context.metresPerPixel(at) / unit) * (hasShift(event) ? 0.1 : 1);
                    return [{
                        path: arrow.path, value: own.slice(0, count),
                        precision: stepOf(pixel, 1e-9, 1e6),
                    }];
                },
            });
        },
        hover: (event) => nearestHandle(context, tips(), event) ? 'grab' : null,
        dispose: () => {
            ends.forEach((end) => end());
            sketch.dispose();
        },
    };
};
