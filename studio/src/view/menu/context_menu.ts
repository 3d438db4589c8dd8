/// The menu of a place of the view: by the right button without a drag, by a long touch (pointer.ts),
/// and by the menu key for what is selected.
import { Vector3 } from 'three';
import { applyChanges, removeValue } from '../../edit/edit';
import type { Camera, KeyPath, SceneObject, Triple } from '../../protocol';
import { runCommand } from '../../state/keys';
import { lookThrough, selection, shot } from '../../state/state';
import { showPath } from '../../text/show_path';
import { boundsOf } from '../bounds';
import { activeLens } from '../camera_gizmos/camera_part';
import { freePoint, isDerived } from '../camera_gizmos/free_point';
import { rayThrough, viewDirection } from '../gizmos/dragging';
import { onPlane } from '../gizmos/rays';
import type { Pixel, ViewContext, ViewPart } from '../parts';
import { pickedBy } from '../selecting';
import { addItem, objectItems, placeItems } from './camera_items';
import { openMenu, type MenuItem } from './menu_state';

const kPrecision = 1e-3; // m, of a place that is written
const kClickDistance = 4; // CSS pixels; a longer way is a drag

/// Where the ray of a pixel meets an object.
function surfaceAt(context: ViewContext, object: SceneObject, pixel: Pixel): Triple | null {
    const node = context.meshNode(object.name);
    const hit = node && context.raycasterAt(pixel).intersectObject(node, true)[0];
    return hit ? hit.point.toArray() : null;
}

/// The place at a pixel as far away as the camera's path is.
function placeBesidePath(context: ViewContext, camera: Camera, pixel: Pixel): Triple | null {
    const points = camera.position.points.map((point) => point.position);
    const near = points.map((at) => ({ at, place: context.toScreen(at) }))
        .filter(({ place }) => place !== null);
    const box = context.canvas.getBoundingClientRect();
    const distance = ([x, y]: [number, number]) =>
        Math.hypot(x + box.left - pixel.clientX, y + box.top - pixel.clientY);
    near.sort((a, b) => distance(a.place as [number, number]) - distance(b.place as [number, number]));
    const at = near[0]?.at;
    return at ? onPlane(rayThrough(context, pixel), at, viewDirection(context)) : null;
}

/// What a value is called in the menu's title.
function nameOf(path: KeyPath): string {
    const state = shot.peek();
    const camera = path[0] === 'cameras' ? state?.cameras[Number(path[1])] : undefined;
    return camera ? [`camera ${camera.name}`, ...path.slice(2)].join(' ') : path.slice(1).join(' ');
}

/// For a point that belongs to an object: it stays where it is now.
function freeItems(camera: Camera, path: KeyPath): MenuItem[] {
    const lens = activeLens.peek();
    return (['position', 'target'] as const).flatMap((part) => {
        const { kind, points } = camera[part];
        const point = points.find((one) => one.path.join('/') === path.join('/') && isDerived(one));
        const moves = kind === 'follow' || kind === 'along';
        const at = moves && lens?.camera === camera ? lens.pose[part] : point?.position;
        return !point || !at ? [] : [{
            label: 'Free this point', hint: 'Alt-drag', run: () => {
                applyChanges(freePoint(camera, part, point, at, kPrecision), 'Free a point',
                    true);
            },
        }];
    });
}

function pathItems(path: KeyPath): MenuItem[] {
    const camera = path[0] === 'cameras' ? shot.peek()?.cameras[Number(path[1])] : undefined;
    const points = camera ? [camera.position, camera.target].find((shape) =>
        shape.points.some((point) => point.path.join('/') === path.join('/'))) : undefined;
    const isRemovable = points !== undefined && points.points.length > 1;
    return [
        ...camera && lookThrough.peek() !== camera.name ? [{
            label: `Look through “${camera.name}”`, startsGroup: true,
            run: () => { lookThrough.value = camera.name; },
        }] : [],
        ...camera ? [{
            label: `View from above “${camera.name}”`,
            run: () => {
                selection.value = camera.path;
                runCommand('viewAboveCamera');
            },
        }] : [],
        ...camera ? freeItems(camera, path) : [],
        ...isRemovable ? [{
            label: 'Remove this point', run: () => { removeValue(path, 'Remove a point', true); },
        }] : [],
    ];
}

function commonItems(path: KeyPath, context: ViewContext): MenuItem[] {
    const state = shot.peek();
    const isSomewhere = state !== null && boundsOf(path, state, context) !== null;
    return [
        { label: 'Show in the text', hint: 'T', startsGroup: true, run: () => { showPath(path); } },
        {
            label: 'Frame', hint: 'F', isDisabled: !isSomewhere,
            run: () => {
                selection.value = path;
                runCommand('frameSelection');
            },
        },
    ];
}

/// Everything that can be done with what is at a pixel.
function itemsAt(
    context: ViewContext, parts: readonly ViewPart[], pixel: Pixel, path: KeyPath | null,
): MenuItem[] {
    const object = context.objectAt(pixel);
    const lens = activeLens.peek();
    const surface = object && surfaceAt(context, object, pixel);
    const isBody = object !== null && object.kind !== 'table'
        && path?.join('/') === object.path.join('/');
    const beside = lens && placeBesidePath(context, lens.camera, pixel);
    return [
        ...parts.flatMap((part) => part.menu?.(pixel) ?? []),
        ...path ? pathItems(path) : [],
        ...lens && isBody ? objectItems(lens, object) : [],
        ...lens && !isBody && surface ? placeItems(lens, surface) : [],
        ...lens && beside && lookThrough.peek() === null ? [
            { ...addItem(lens.camera, 'position', beside), startsGroup: true },
            addItem(lens.camera, 'target', surface ?? beside),
        ] : [],
        ...path ? commonItems(path, context) : [],
    ];
}

/// The middle of what is selected, on the page; else of the view.
function placeOfSelection(context: ViewContext): Pixel {
    const box = context.canvas.getBoundingClientRect();
    const [chosen, state] = [selection.peek(), shot.peek()];
    const bounds = chosen && state ? boundsOf(chosen, state, context) : null;
    const middle = bounds && new Vector3(...bounds.low).add(new Vector3(...bounds.high))
        .divideScalar(2).toArray();
    const place = middle && context.toScreen(middle);
    const [x, y] = place ?? [box.width / 2, box.height / 2];
    return { clientX: box.left + x, clientY: box.top + y };
}

/// Opens the menu of what is at a pixel, or of `known`.
export function openContextMenu(
    context: ViewContext, parts: readonly ViewPart[], pixel: Pixel, known: KeyPath | null = null,
): void {
    const object = context.objectAt(pixel);
    const body = object && object.kind !== 'table' ? object.path : null;
    const path = known ?? pickedBy(parts, pixel) ?? body;
    const items = itemsAt(context, parts, pixel, path);
    if (path) {
        selection.value = path;
    }
    if (items.length > 0) {
        openMenu({
            title: path ? nameOf(path) : 'Here', x: pixel.clientX, y: pixel.clientY,
            items: () => items,
        });
    }
}

/// Opens the menu by the right button and by the menu key, until the returned function is called.
export function answerContextMenu(
    context: ViewContext, parts: readonly ViewPart[],
): () => void {
    const { canvas } = context;
    const open = (pixel: Pixel, known: KeyPath | null = null) =>
        openContextMenu(context, parts, pixel, known);
    let start: Pixel | null = null;
    const down = (event: PointerEvent) => {
        start = event.button === 2 ? { clientX: event.clientX, clientY: event.clientY } : null;
    };
    const up = (event: PointerEvent) => {
        const way = start
            ? Math.hypot(event.clientX - start.clientX, event.clientY - start.clientY) : Infinity;
        start = null;
        if (event.button === 2 && way < kClickDistance) {
            open(event);
        }
    };
    const asked = (event: MouseEvent) => event.preventDefault();
    const key = (event: KeyboardEvent) => {
        if (event.key === 'ContextMenu' || (event.key === 'F10' && event.shiftKey)) {
            event.preventDefault();
            open(placeOfSelection(context), selection.peek());
        }
    };
    const listeners = [
        ['pointerdown', down], ['pointerup', up], ['contextmenu', asked], ['keydown', key],
    ] as const;
    listeners.forEach(([name, listener]) => canvas.addEventListener(name, listener as EventListener));
    return () => listeners.forEach(([name, listener]) =>
        canvas.removeEventListener(name, listener as EventListener));
}
