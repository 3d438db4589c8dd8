/// The arrow keys move the selected ball or object in the view's directions: 1 mm, with Alt 0.1 mm,
/// with Shift 10 mm. A pause, another key or the pointer ends the step of undo.
import { Vector3 } from 'three';
import { endKeyRun, keyStep } from '../../input/key_run';
import type { SceneObject } from '../../protocol';
import { wish } from '../../solve/solve_state';
import { selection, shot } from '../../state/state';
import { kDrawingPriority, type MakePart, type ViewContext } from '../parts';
import { placePath } from './object_drags';
import { valueAt } from './shot_values';

const kStep = 1e-3; // m
const kPrecision = 1e-4; // m

const kWays: Readonly<Record<string, [number, number]>> = {
    ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1],
};

export const makeNudge: MakePart = (context) => {
    const onKey = (event: KeyboardEvent) => {
        const way = kWays[event.key];
        const object = selectedObject();
        const isFree = wish.peek() === null && !event.ctrlKey && !event.metaKey && !takesArrows(event.target);
        if (!way || !object || !isFree || event.defaultPrevented) {
            return;
        }
        event.preventDefault();
        const step = kStep * (event.shiftKey ? 10 : event.altKey ? 0.1 : 1);
        const offset = inWorld(context, way);
        const path = placePath(object.path);
        keyStep<number[]>({
            id: path.join('/'), label: `Move ${object.name}`, start: startOf(object), isOfScene: true,
            next: (place) => place.map((one, i) => one + step * (offset[i] ?? 0)),
            changes: (value) => [{ path, value, precision: kPrecision }],
        });
    };
    window.addEventListener('keydown', onKey, { capture: true });
    return {
        priority: kDrawingPriority,
        dispose: () => {
            endKeyRun();
            window.removeEventListener('keydown', onKey, { capture: true });
        },
    };
};

/// The ball or object that is selected, or whose part is.
export function selectedObject(): SceneObject | null {
    const chosen = selection.peek();
    return chosen === null ? null : shot.peek()?.objects.find((one) => one.kind !== 'table'
        && one.path.every((key, i) => chosen[i] === key)) ?? null;
}

/// Text fields, lists, sliders and menus use the arrows themselves.
export function takesArrows(target: EventTarget | null): boolean {
    return target instanceof Element && target.closest('input, textarea, select, '
        + '[contenteditable], [role=tree], [role=listbox], [role=menu], [role=tablist], '
        + '[role=slider], [role=spinbutton], [role=separator], dialog') !== null;
}

/// The place in the text, or, if it is derived, where the ball or object starts.
function startOf(object: SceneObject): number[] {
    const at = valueAt(placePath(object.path));
    if (Array.isArray(at) && at.length >= 2 && at.every((one) => typeof one === 'number')) {
        return at as number[];
    }
    return object.kind === 'ball' ? object.position.slice(0, 2) : [0, 0, 0];
}

/// The axis of the world that is nearest to a direction of the view, on the level plane.
export function inWorld(context: ViewContext, [right, up]: [number, number]): [number, number] {
    const camera = context.camera();
    const across = new Vector3(1, 0, 0).applyQuaternion(camera.quaternion);
    const [x, y] = Math.abs(across.x) >= Math.abs(across.y)
        ? [Math.sign(across.x) || 1, 0] : [0, Math.sign(across.y)];
    // A quarter turn from the right, seen from above, leads away from the viewer.
    return [right * x - up * y, right * y + up * x];
}
