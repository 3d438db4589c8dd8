/// Moving, turning and measuring of the selected object, with handles; small objects are also moved
/// by dragging themselves.
import { computed, effect, signal } from '@preact/signals';
import { Box3, Sphere } from 'three';
import { tracks } from '../../motion/clock';
import { add, scale } from '../../motion/vectors';
import type { SceneObject, Triple } from '../../protocol';
import { onCommand } from '../../state/keys';
import { sceneTime, selection, shot } from '../../state/state';
import { kBodyPriority, kHandlePriority, type MakePart, type ViewContext } from '../parts';
import { nearestHandle, pixelDistance, reachOf } from './dragging';
import { followAxisKeys } from './held_axis';
import { selectedObject } from './nudge';
import {
    kArmPixels, objectFigure, objectHandles, ringPoints, type Selected,
} from './object_handles';
import { kAxes } from './object_frame';
import { dragBody, dragHandle, dragRing, placePath } from './object_drags';
import { objectFrame, rotationText, tripleOf, valueAt } from './shot_values';
import { forTests, sketchOf } from './sketch';
import { tool } from './tool_state';

const kLeastArm = 20; // CSS pixels, of an arrow that can be dragged
const kLargest = 0.5; // m, radius of objects that are moved by dragging themselves

const kShapeKeys = ['hull', 'rounded_box', 'cone', 'capsule', 'cylinder', 'mesh'];

/// The ball or object that is selected, of the newest shot.
const chosen = computed<SceneObject | null>(() => {
    void [selection.value, shot.value];
    return selectedObject();
});
/// The axis of the running drag, and what is written beside the object.
const active = signal<{ axis: number | null; text: string } | null>(null);

/// What the text says about an object. Balls are turned only; they are moved in ball_drag.ts.
function selectedState(object: SceneObject, context: ViewContext): Selected | null {
    const isBall = object.kind === 'ball';
    if (isBall && tool.value !== 'turn') {
        return null;
    }
    const frame = objectFrame(object.path);
    const origin = isBall ? object.position
        : tripleOf(valueAt(placePath(object.path))) ?? frame.origin;
    // A hull, for example, is drawn as a mesh.
    const shape = [object.shape, ...kShapeKeys].find((key) =>
        valueAt([...object.path, key]) !== undefined) ?? object.shape;
    return {
        shape, value: valueAt([...object.path, shape]), tool: tool.value,
        frame: { ...frame, origin }, metresPerPixel: context.metresPerPixel(origin), isBall,
        hiddenAxes: axesTowardsViewer(origin, context),
    };
}

/// The axes whose arrows are nearly points in this view.
function axesTowardsViewer(origin: Triple, context: ViewContext): number[] {
    const reach = kArmPixels * context.metresPerPixel(origin);
    const foot = context.toScreen(origin);
    return [0, 1, 2].filter((i) => {
        const tip = context.toScreen(add(origin, scale(reach, kAxes[i] ?? [0, 0, 1])));
        return foot && tip && Math.hypot(tip[0] - foot[0], tip[1] - foot[1]) < kLeastArm;
    });
}

/// Handles of the selection: grabbed before everything else.
export const makeObjectHandles: MakePart = (context) => {
    const sketch = sketchOf(context);
    const state = () => {
        const object = chosen.peek();
        return object && selectedState(object, context);
    };
    forTests['objectHandles'] = () => {
        const now = state();
        return now ? objectHandles(now) : [];
    };
    forTests['ring'] = (axis: number) => {
        const now = state();
        return now ? ringPoints(now, axis) : [];
    };
    const ends = [
        effect(() => {
            void context.moved.value;
            const object = chosen.value;
            const now = object && selectedState(object, context);
            const figure = now ? objectFigure(now, active.value?.axis ?? null) : {};
            const text = active.value?.text ?? '';
            sketch.show('object', now && text !== ''
                ? { ...figure, labels: [{ at: now.frame.origin, text }] } : figure);
        }),
        onCommand('toolMove', () => { tool.value = 'move'; }),
        onCommand('toolTurn', () => { tool.value = 'turn'; }),
        onCommand('toolScale', () => { tool.value = 'scale'; }),
        followAxisKeys(),
    ];
    return {
        priority: kHandlePriority,
        grab: (event) => {
            const object = chosen.peek();
            const now = state();
            if (!object || !now) {
                return null;
            }
            const handle = nearestHandle(context, objectHandles(now), event);
            if (handle) {
                const axis = handle.kind === 'axis' ? handle.axis : null;
                active.value = { axis, text: '' };
                return dragHandle(handle, object.path, object.name, now, event, context, (text) => {
                    active.value = text === null ? null : { axis, text };
                });
            }
            const ring = nearestRing(now, event, context);
            return ring === null ? null : dragRing(
                object.path, object.name, rotationText(object.path), object.orientation,
                now.frame.origin, ring, event, context, (angle) => {
                    active.value = angle === null ? null
                        : { axis: ring, text: `${((angle * 180) / Math.PI).toFixed(1)}°` };
                });
        },
        hover: (event) => {
            const now = state();
            return now && (nearestHandle(context, objectHandles(now), event)
                || nearestRing(now, event, context) !== null) ? 'grab' : null;
        },
        dispose: () => {
            ends.forEach((end) => end());
            sketch.dispose();
        },
    };
};

/// The axis of the ring at the pointer.
function nearestRing(now: Selected, event: PointerEvent, context: ViewContext): number | null {
    if (now.tool !== 'turn') {
        return null;
    }
    let best: number | null = null;
    let least = reachOf(event) - 2;
    for (const axis of [0, 1, 2]) {
        for (const point of ringPoints(now, axis)) {
            const distance = pixelDistance(context, point, event);
            if (distance < least) {
                [best, least] = [axis, distance];
            }
        }
    }
    return best;
}

/// Objects that are dragged themselves.
export const makeObjectBodies: MakePart = (context) => {
    const movable = (event: PointerEvent): SceneObject | null => {
        const object = context.objectAt(event);
        const node = object?.kind === 'object' && object.shape !== 'plane'
            ? context.meshNode(object.name) : null;
        const sphere = node && new Box3().setFromObject(node).getBoundingSphere(new Sphere());
        return sphere && sphere.radius <= kLargest ? object : null;
    };
    return {
        priority: kBodyPriority,
        grab: (event) => {
            const object = movable(event);
            const node = object && context.meshNode(object.name);
            const hit = node && context.raycasterAt(event).intersectObject(node, true)[0];
            if (!object || !hit) {
                return null;
            }
            selection.value = object.path;
            const origin = tripleOf(valueAt(placePath(object.path))) ?? [0, 0, 0];
            const lowest = new Box3().setFromObject(node).min.z;
            const below = isAtStart(object) ? origin[2] - lowest : NaN;
            const moved = { path: object.path, name: object.name, origin, below };
            return dragBody(moved, hit.point.toArray(), event, context, (place) => {
                active.value = place && { axis: null, text: written(place) };
            });
        },
        hover: (event) => movable(event) ? 'grab' : null,
        dispose: () => {},
    };
};

/// Whether the view shows it where it starts.
function isAtStart({ name, position }: SceneObject): boolean {
    const now = tracks.peek().get(name)?.position(sceneTime.peek()) ?? position;
    return Math.hypot(now[0] - position[0], now[1] - position[1], now[2] - position[2]) < 1e-9;
}

function written(place: Triple): string {
    return place.map((one) => one.toFixed(3)).join(', ');
}
