/// What the drags of an object's handles write into the text.
import type { Change } from '../../edit/edit';
import type { KeyPath, Triple, Turn } from '../../protocol';
import { add, length, scale, subtract } from '../../motion/vectors';
import type { Drag, Pixel, ViewContext } from '../parts';
import { editDrag, follower, hasShift, rayThrough } from './dragging';
import { turned, kAxes, toLocal, type RotationText } from './object_frame';
import { measureAxis, type ObjectHandle, type Selected } from './object_handles';
import { alongAxis, angleAround, shortAngle, stepOf } from './rays';
import { rotationText, tripleOf, valueAt } from './shot_values';

const kPlaceStep = 1e-4; // m
const kAngleStep = (0.1 * Math.PI) / 180;
const kTurnSteps = (15 * Math.PI) / 180; // with Shift
const kSnapPixels = 7;
const kLongestSnap = 0.03; // m
const kFinest = 1e-5; // m, of the height of what stands on the cloth
const kSmallest = 1e-4; // m, of a measure

/// Where the text has the object's place at the start: a motion may give its own.
export function placePath(object: KeyPath): KeyPath {
    const first = [...object, 'motion', 'keys', '0', 'position'];
    return tripleOf(valueAt(first)) ? first : [...object, 'at'];
}

/// An object that is moved.
export interface Moved {
    path: KeyPath;
    name: string;
    origin: Triple;
    /// How far its lowest point is below its origin, m.
    below: number;
}

/// The place near `place` at which the object stands on the cloth (not with Ctrl), else `place`; in
/// whole steps of what the view resolves.
function onCloth(
    place: Triple, { below }: Moved, event: PointerEvent, context: ViewContext,
): Triple {
    const step = placeStep(context, place);
    const reach = Math.min(kSnapPixels * context.metresPerPixel(place), kLongestSnap);
    const [x, y, z] = place.map((one) => step * Math.round(one / step)) as Triple;
    const isNear = Math.abs(place[2] - below) < reach && !event.ctrlKey && !event.metaKey;
    return [x, y, isNear ? kFinest * Math.ceil(below / kFinest - 1e-3) : z];
}

/// Moves an object so that the point at which it was taken follows the pointer: in the view's
/// plane, with Shift on its level, with x, y or z held along that axis. It snaps to the cloth.
export function dragBody(
    moved: Moved, taken: Triple, start: PointerEvent, context: ViewContext,
    say: (place: Triple | null) => void,
): Drag {
    const { path, name, origin } = moved;
    const place = placePath(path);
    const follow = follower(context, taken, start);
    return editDrag(start, {
        label: `Move ${name}`,
        changes: (event) => {
            const to = follow(event, hasShift(event) ? 'level' : 'view');
            if (!to) {
                return null;
            }
            const value = onCloth(add(origin, subtract(to, taken)), moved, event, context);
            say(value);
            const precision = Math.min(placeStep(context, origin), kFinest);
            return [{ path: place, value, precision }];
        },
        ended: () => say(null),
    });
}

function placeStep(context: ViewContext, at: Triple): number {
    return stepOf(context.metresPerPixel(at), 1e-6, kPlaceStep);
}

/// Turns an object about a world axis; with Shift in steps of 15 degrees.
export function dragRing(
    path: KeyPath, name: string, text: RotationText, now: Turn, origin: Triple, axis: number,
    start: PointerEvent, context: ViewContext, say: (angle: number | null) => void,
): Drag | null {
    const direction = kAxes[axis] as Triple;
    const angleAt = (pixel: Pixel) => angleAround(rayThrough(context, pixel), origin, direction);
    let last = angleAt(start);
    if (last === null) {
        return null;
    }
    let total = 0;
    return editDrag(start, {
        label: `Turn ${name}`,
        changes: (event) => {
            const angle = angleAt(event);
            if (angle === null || last === null) {
                return null;
            }
            total += shortAngle(angle - last);
            last = angle;
            const by = hasShift(event) ? kTurnSteps * Math.round(total / kTurnSteps) : total;
            const rounded = kAngleStep * Math.round(by / kAngleStep);
            say(rounded);
            return turned(text, direction, rounded, now).map(({ key, value }): Change => ({
                path: [...path, ...key], value,
                precision: key.includes('axis') || key.includes('axes') ? 1e-5 : kAngleStep,
            }));
        },
        ended: () => say(null),
    });
}

/// Drags a handle that is a point. `say` gets what to show beside it; null at the end.
export function dragHandle(
    handle: ObjectHandle, path: KeyPath, name: string, selected: Selected, start: PointerEvent,
    context: ViewContext, say: (text: string | null) => void,
): Drag {
    const ended = () => say(null);
    switch (handle.kind) {
    case 'vertex': {
        const follow = follower(context, handle.at, start);
        return editDrag(start, {
            label: `Move a corner of ${name}`, ended,
            changes: (event) => {
                const to = follow(event, hasShift(event) ? 'level' : 'view');
                const local = to && toLocal(selected.frame, to);
                return local && [{
                    path: [...path, selected.shape, String(handle.index)], value: local,
                    precision: placeStep(context, handle.at) / scaleOf(selected),
                }];
            },
        });
    }
    case 'axis':
        return dragAlong(handle.axis, path, name, selected.frame.origin, start, context, ended);
    case 'scale':
        return dragScale(path, name, selected, start, context, say);
    default:
        return dragMeasure(handle, path, name, selected, start, context, say);
    }
}

function scaleOf({ frame }: Selected): number {
    return 10 ** Math.ceil(Math.log10(Math.max(...frame.axes.map(length), 1)));
}

function dragAlong(
    axis: number, path: KeyPath, name: string, origin: Triple, start: PointerEvent,
    context: ViewContext, ended: () => void,
): Drag {
    const direction = kAxes[axis] as Triple;
    const from = alongAxis(rayThrough(context, start), origin, direction);
    const place = placePath(path);
    return editDrag(start, {
        label: `Move ${name}`, ended,
        changes: (event) => {
            const to = alongAxis(rayThrough(context, event), origin, direction);
            return from === null || to === null ? null : [{
                path: place, value: add(origin, scale(to - from, direction)),
                precision: placeStep(context, origin),
            }];
        },
    });
}

/// With Alt the opposite side stays where it is.
function dragMeasure(
    handle: ObjectHandle & { kind: 'measure' }, path: KeyPath, name: string, selected: Selected,
    start: PointerEvent, context: ViewContext, say: (text: string | null) => void,
): Drag {
    const { measure } = handle;
    const { axis, unit } = measureAxis(selected.frame, measure);
    const { origin } = selected.frame;
    const from = alongAxis(rayThrough(context, start), origin, axis);
    const precision = placeStep(context, handle.at);
    return editDrag(start, {
        label: `Change the ${measure.about} of ${name}`,
        ended: () => say(null),
        changes: (event) => {
            const to = alongAxis(rayThrough(context, event), origin, axis);
            if (from === null || to === null) {
                return null;
            }
            const isOneSided = event.altKey && measure.rate > 1;
            const way = to - from;
            const grown = ((isOneSided ? 1 : measure.rate) * way) / (unit || 1);
            const value = Math.max(kSmallest, measure.value + grown);
            say(`${measure.about} ${(1000 * value).toFixed(1)} mm`);
            const changes: Change[] = [{ path: [...path, ...measure.key], value, precision }];
            return isOneSided ? [...changes, {
                path: placePath(path), precision,
                value: add(origin, scale(((value - measure.value) * unit) / 2, axis)),
            }] : changes;
        },
    });
}

/// Scales the whole object by the distance from its origin on the screen.
function dragScale(
    path: KeyPath, name: string, selected: Selected, start: PointerEvent, context: ViewContext,
    say: (text: string | null) => void,
): Drag {
    const text = rotationText(path);
    const written = valueAt([...path, 'scale']);
    const triple = tripleOf(written);
    const before = typeof written === 'number' ? written : 1;
    const middle = context.toScreen(selected.frame.origin) ?? [0, 0];
    const box = context.canvas.getBoundingClientRect();
    const reach = (pixel: Pixel) => Math.max(1, Math.hypot(
        pixel.clientX - box.left - middle[0], pixel.clientY - box.top - middle[1]));
    return editDrag(start, {
        label: `Scale ${name}`,
        ended: () => say(null),
        changes: (event) => {
            const factor = reach(event) / reach(start);
            say(`× ${factor.toFixed(2)}`);
            if (text.kind === 'axes') {  // they have the scale in them
                const value = text.axes.map((one) => scale(factor, one));
                return [{ path: [...path, 'axes'], value, precision: 1e-5 }];
            }
            const value = triple ? triple.map((one) => one * factor) : before * factor;
            return [{ path: [...path, 'scale'], value, precision: 1e-3 }];
        },
    });
}
