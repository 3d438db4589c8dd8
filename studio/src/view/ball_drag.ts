/// Dragging a ball over the cloth changes the place at which it starts, in the text.
import { beginGesture, type Gesture } from '../edit/edit';
import type { SceneObject } from '../protocol';
import { selection } from '../state/state';
import { kBodyPriority, type Drag, type MakePart, type ViewContext } from './parts';
import { onLevel } from './picking';

const kPrecision = 1e-4; // m, of the places that are written
const kDragDistance = 3; // CSS pixels; a shorter way is a click

export const makeBallDrag: MakePart = (context) => ({
    priority: kBodyPriority,
    grab: (event) => {
        const ball = context.objectAt(event);
        return ball?.kind === 'ball' ? dragBall(ball, event, context) : null;
    },
    dispose: () => {},
});

/// Null if the pointer's ray does not meet the ball's level.
function dragBall(ball: SceneObject, start: PointerEvent, context: ViewContext): Drag | null {
    const [x, y, z] = ball.position;
    const from = onLevel(context.rayAt(start), z);
    if (!from) {
        return null;
    }
    let gesture: Gesture | null = null; // until the pointer has moved far enough
    selection.value = ball.path;
    return {
        move: (event) => {
            const way = Math.hypot(event.clientX - start.clientX, event.clientY - start.clientY);
            const to = gesture || way >= kDragDistance ? onLevel(context.rayAt(event), z) : null;
            if (!to) {
                return;
            }
            gesture ??= beginGesture();
            const place = [x + to[0] - from[0], y + to[1] - from[1]];
            const isOnCloth = Math.abs(z - ball.radius) < 1e-6;
            gesture.update([{
                path: [...ball.path, 'at'], value: isOnCloth ? place : [...place, z],
                precision: kPrecision,
            }]);
        },
        end: () => gesture?.commit(`Move ${ball.name}`),
        cancel: () => gesture?.cancel(),
    };
}
