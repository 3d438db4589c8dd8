/// The path-traced picture of what the view shows: the film's own frame while the view looks
/// through the film's camera, otherwise the view itself, without depth of field.
import { computed, effect } from '@preact/signals';
import { cameraLookedThrough, filmCamera } from '../../motion/clock';
import { dragging, lookThrough, notice, sceneTime, shot } from '../../state/state';
import { onCommand } from '../../state/keys';
import { letterbox, type Rectangle } from '../letterbox';
import { kGizmoPriority, type MakePart, type ViewContext } from '../parts';
import { followShown, isPictureOld } from './asking';
import { isRefining, keptPicture, shownPicture, wipe } from './picture_state';
import { PictureQuad } from './quad';
import { filmsFrame, sizeOfView, viewOf, type Shown } from './question';
import { dragLine, isOnLine } from './wipe_line';

const kStaleOpacity = 0.35;

/// Whether the view looks through the film's own camera at the play head.
const looksAsFilm = computed(() => lookThrough.value !== null && filmCamera.value >= 0
    && cameraLookedThrough.value === filmCamera.value);

/// What the view shows now; null if it cannot be traced.
function shown(context: ViewContext): Shown | null {
    void context.moved.value;
    if (looksAsFilm.value) {
        return filmsFrame();
    }
    const view = viewOf(context.camera(), sceneTime.value);
    const { width, height } = context.size();
    return view && { view, ...sizeOfView(width, height) };
}

/// The part of the canvas that the picture fills, CSS pixels.
function boxOf(context: ViewContext): Rectangle {
    const size = context.size();
    const film = shot.peek()?.film;
    return film && film.height > 0 && looksAsFilm.peek()
        ? letterbox(size, film.width / film.height) : { left: 0, top: 0, ...size };
}

export const makeTracedPicture: MakePart = (context) => {
    const quad = new PictureQuad();
    context.scene.parent?.add(quad.group);
    const ends = [
        followShown(() => shown(context)),
        effect(() => {
            void context.moved.value;
            quad.place(boxOf(context), context.size());
            const one = dragging.value ? null : shownPicture.value; // it would hide what moves
            quad.show(one, keptPicture.value, wipe.value, isPictureOld() ? kStaleOpacity : 1);
            context.ask();
        }),
        onCommand('refine', () => {
            isRefining.value = !isRefining.peek();
            if (isRefining.peek() && !looksAsFilm.peek() && !viewOf(context.camera(), 0)) {
                notice.value = {
                    kind: 'info',
                    text: 'The view from above has no perspective, so its picture is not traced. '
                        + 'Press 3 for the free view or C for the camera.',
                };
            }
        }),
    ];
    return {
        priority: kGizmoPriority,
        grab: (event) => isOnLine(event, context, boxOf(context))
            ? dragLine(context, boxOf(context)) : null,
        hover: (event) => isOnLine(event, context, boxOf(context)) ? 'ew-resize' : null,
        dispose: () => {
            ends.forEach((end) => end());
            quad.dispose();
        },
    };
};
