/// Dragging a ball over the cloth changes the place at which it starts, in the text.
import type { Raycaster } from 'three';
import { beginGesture, type Gesture } from '../edit/edit';
import type { SceneObject } from '../protocol';
import { selection } from '../state/state';
import { onLevel } from './picking';

const kPrecision = 1e-4; // m, of the places that are written
const kDragDistance = 3; // CSS pixels; a shorter way is a click

/// What a drag asks the view.
export interface DragView {
    rayAt(event: PointerEvent): Raycaster;
    objectAt(event: PointerEvent): SceneObject | null;
}

interface Drag {
    ball: SceneObject;
    from: [number, number];    // the place on the ball's level at which it was taken
    pixel: [number, number];
    gesture: Gesture | null;   // null until the pointer has moved far enough
}

/// Drags balls on the canvas, before its other listeners. Returns a function that ends this.
export function dragBalls(canvas: HTMLCanvasElement, view: DragView): () => void {
    let drag: Drag | null = null;

    const down = (event: PointerEvent) => {
        const ball = event.button === 0 ? view.objectAt(event) : null;
        const from = ball?.kind === 'ball' ? onLevel(view.rayAt(event), ball.position[2]) : null;
        if (!ball || !from) {
            return;
        }
        event.stopImmediatePropagation();
        canvas.setPointerCapture(event.pointerId);
        canvas.focus();
        selection.value = ball.path;
        drag = { ball, from, pixel: [event.clientX, event.clientY], gesture: null };
    };
    const move = (event: PointerEvent) => {
        if (!drag) {
            return;
        }
        event.stopImmediatePropagation();
        const way = Math.hypot(event.clientX - drag.pixel[0], event.clientY - drag.pixel[1]);
        if (!drag.gesture && way < kDragDistance) {
            return;
        }
        const { ball, from } = drag;
        const to = onLevel(view.rayAt(event), ball.position[2]);
        if (to) {
            drag.gesture ??= beginGesture();
            const [x, y, z] = ball.position;
            const place = [x + to[0] - from[0], y + to[1] - from[1]];
            const isOnCloth = Math.abs(z - ball.radius) < 1e-6;
            drag.gesture.update([{
                path: [...ball.path, 'at'], value: isOnCloth ? place : [...place, z],
                precision: kPrecision,
            }]);
        }
    };
    const up = (event: PointerEvent) => {
        if (drag) {
            event.stopImmediatePropagation();
            drag.gesture?.commit(`Move ${drag.ball.name}`);
            drag = null;
        }
    };
    const lost = () => {
        drag?.gesture?.cancel();
        drag = null;
    };

    const all = { capture: true };
    canvas.addEventListener('pointerdown', down, all);
    canvas.addEventListener('pointermove', move, all);
    canvas.addEventListener('pointerup', up, all);
    canvas.addEventListener('pointercancel', lost, all);
    return () => {
        canvas.removeEventListener('pointerdown', down, all);
        canvas.removeEventListener('pointermove', move, all);
        canvas.removeEventListener('pointerup', up, all);
        canvas.removeEventListener('pointercancel', lost, all);
    };
}
