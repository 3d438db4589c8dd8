/// What the keys of the view do.
import { cameraAxes } from '../motion/camera';
import { scale } from '../motion/vectors';
import type { ShotState } from '../protocol';
import { onCommand } from '../state/keys';
import { kTheFilm, lookThrough, selection, shot } from '../state/state';
import { isWireframe, viewKind } from '../state/view_state';
import { boundsOf, wholeScene } from './bounds';
import { activeLens } from './camera_gizmos/camera_part';
import type { Cameras } from './cameras';
import type { ViewContext } from './parts';

const kFirstPlace: [number, number, number] = [-0.6, -2.6, 1.7];

/// Shows the whole shot from above one side.
export function lookAtAll(cameras: Cameras): void {
    cameras.lookFrom(kFirstPlace, [0, 0, 0]);
    cameras.frame(wholeScene(shot.peek()));
}

/// Listens until the returned function is called. `changed` draws.
export function answerViewKeys(
    cameras: Cameras, context: ViewContext, changed: () => void,
): () => void {
    const freely = (kind: 'free' | 'top' | 'side' | null, look: () => void) => () => {
        lookThrough.value = null;
        viewKind.value = kind ?? viewKind.peek();
        look();
        changed();
    };
    const ends = [
        onCommand('viewTop', freely('top', () =>
            cameras.lookAlong([0, 0, -1], [0, 1, 0], wholeScene(shot.peek())))),
        onCommand('viewSide', freely('side', () =>
            cameras.lookAlong([0, 1, 0], [0, 0, 1], wholeScene(shot.peek())))),
        onCommand('viewFree', freely('free', () => lookAtAll(cameras))),
        onCommand('viewAboveCamera', () => {
            const lens = activeLens.peek();
            if (lens) {
                const { up, back } = cameraAxes(lens.pose);
                const box = shot.peek() && boundsOf(lens.camera.path, shot.peek() as ShotState, context);
                freely('top', () => cameras.lookAlong(scale(-1, up), scale(-1, back),
                    box ?? wholeScene(shot.peek())))();
            }
        }),
        onCommand('lookThrough', () => {
            const hasCamera = (shot.peek()?.cameras.length ?? 0) > 0;
            lookThrough.value = lookThrough.peek() === null && hasCamera ? kTheFilm : null;
        }),
        onCommand('frameSelection', freely(null, () => {
            const state = shot.peek();
            const chosen = selection.peek();
            const box = state && chosen && boundsOf(chosen, state, context);
            cameras.frame(box || wholeScene(state));
        })),
        onCommand('wireframe', () => { isWireframe.value = !isWireframe.peek(); }),
    ];
    return () => ends.forEach((end) => end());
}
