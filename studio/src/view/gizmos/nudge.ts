/// The arrow keys move the selected ball or object in the view's directions: 1 mm, with Alt 0.1 mm,
/// with Shift 10 mm. A pause, another key or the pointer ends the step of undo.
import { Vector3 } from 'three';
import { beginGesture, type Gesture } from '../../edit/edit';
import type { KeyPath, SceneObject } from '../../protocol';
import { selection, shot } from '../../state/state';
import { kDrawingPriority, type MakePart, type ViewContext } from '../parts';
import { valueAt } from './shot_values';

const kPause = 700; // ms
const kStep = 1e-3; // m
const kPrecision = 1e-4; // m

const kWays: Readonly<Record<string, [number, number]>> = {
    ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1],
};

/// A run of key presses that is one step of undo.
interface Run {
    path: KeyPath;
    name: string;
    gesture: Gesture;
    start: number[];
    offset: [number, number];
    timer: number;
}

export const makeNudge: MakePart = (context) => {
    let run: Run | null = null;
    const finish = () => {
        if (run) {
            clearTimeout(run.timer);
            run.gesture.commit(`Move ${run.name}`);
            run = null;
        }
    };
    const onKey = (event: KeyboardEvent) => {
        const way = kWays[event.key];
        const object = selectedObject();
        const isFree = !event.ctrlKey && !event.metaKey && !takesArrows(event.target);
        if (!way || !object || !isFree || event.defaultPrevented) {
            if (!['Shift', 'Alt', 'Control', 'Meta'].includes(event.key)) {
                finish();
            }
            return;
        }
        event.preventDefault();
        if (run && run.path.join('/') !== object.path.join('/')) {
            finish();
        }
        run ??= {
            path: object.path, name: object.name, gesture: beginGesture(), timer: 0,
            start: startOf(object), offset: [0, 0],
        };
        clearTimeout(run.timer);
        run.timer = window.setTimeout(finish, kPause);
        const step = kStep * (event.shiftKey ? 10 : event.altKey ? 0.1 : 1);
        const [dx, dy] = inWorld(context, way);
        run.offset = [run.offset[0] + step * dx, run.offset[1] + step * dy];
        run.gesture.update([{
            path: [...object.path, 'at'], precision: kPrecision, insteadOf: 'touching',
            value: run.start.map((value, i) => value + (run?.offset[i] ?? 0)),
        }]);
    };
    window.addEventListener('keydown', onKey, { capture: true });
    window.addEventListener('pointerdown', finish, { capture: true });
    return {
        priority: kDrawingPriority,
        dispose: () => {
            finish();
            window.removeEventListener('keydown', onKey, { capture: true });
            window.removeEventListener('pointerdown', finish, { capture: true });
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
function takesArrows(target: EventTarget | null): boolean {
    return target instanceof Element && target.closest('input, textarea, select, '
        + '[contenteditable], [role=tree], [role=listbox], [role=menu], [role=tablist], '
        + '[role=slider], [role=spinbutton], [role=separator], dialog') !== null;
}

/// The place in the text, or, if it is derived, where the ball or object starts.
function startOf(object: SceneObject): number[] {
    const at = valueAt([...object.path, 'at']);
    if (Array.isArray(at) && at.length >= 2 && at.every((one) => typeof one === 'number')) {
        return at as number[];
    }
    return object.kind === 'ball' ? object.position.slice(0, 2) : [0, 0, 0];
}

/// The axis of the world that is nearest to a direction of the view, on the level plane.
function inWorld(context: ViewContext, [right, up]: [number, number]): [number, number] {
    const camera = context.camera();
    const across = new Vector3(1, 0, 0).applyQuaternion(camera.quaternion);
    const [x, y] = Math.abs(across.x) >= Math.abs(across.y)
        ? [Math.sign(across.x) || 1, 0] : [0, Math.sign(across.y)];
    // A quarter turn from the right, seen from above, leads away from the viewer.
    return [right * x - up * y, right * y + up * x];
}
