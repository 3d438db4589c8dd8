/// What the keys of the view do.
import { filmCamera } from '../motion/clock';
import { onCommand } from '../state/keys';
import { lookThrough, shot } from '../state/state';
import type { Cameras } from './cameras';
import { wholeScene } from './bounds';

/// Listens until the returned function is called. `changed` draws.
export function answerViewKeys(cameras: Cameras, changed: () => void): () => void {
    const freely = (look: () => void) => () => {
        lookThrough.value = null;
        look();
        changed();
    };
    const ends = [
        onCommand('viewTop', freely(() =>
            cameras.lookAlong([0, 0, -1], [0, 1, 0], wholeScene(shot.peek())))),
        onCommand('viewSide', freely(() =>
            cameras.lookAlong([0, 1, 0], [0, 0, 1], wholeScene(shot.peek())))),
        onCommand('viewFree', freely(() =>
            cameras.lookFrom([-0.6, -2.6, 1.7], [0, 0, 0]))),
        onCommand('lookThrough', () => {
            const camera = shot.peek()?.cameras[filmCamera.peek()];
            lookThrough.value = lookThrough.peek() === null ? camera?.name ?? null : null;
        }),
    ];
    return () => ends.forEach((end) => end());
}
