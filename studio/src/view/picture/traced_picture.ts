/// The path-traced picture of what the view shows: the film's own frame while the view looks
/// through the film's camera, otherwise the view itself, without depth of field.
import { batch, computed, effect, signal } from '@preact/signals';
import { send } from '../../connection/socket';
import { cameraLookedThrough, filmCamera, filmDuration } from '../../motion/clock';
import {
    connection, dragging, filmTime, isStale, lookThrough, notice, picture, pictureAsked, playing, sceneTime, shot,
    timeline, waitsForButton, welcome,
} from '../../state/state';
import { onCommand } from '../../state/keys';
import { letterbox, type Rectangle } from '../letterbox';
import { kDrawingPriority, type MakePart, type ViewContext } from '../parts';
import { channel, isRefining, keptPicture, shownPicture, wipe } from './picture_state';
import { PictureQuad } from './quad';
import { frameAt, sizeOfView, viewOf, type Shown } from './question';

const kStaleOpacity = 0.35;

let question = 0;
/// The number of the question that the server answers; 0: none.
const openQuestion = signal(0);

/// Whether the view looks through the film's own camera at the play head.
const looksAsFilm = computed(() => lookThrough.value !== null && filmCamera.value >= 0
    && cameraLookedThrough.value === filmCamera.value);

/// Whether the page is seen at all: nobody looks at the pictures of a hidden one.
const isPageSeen = signal(document.visibilityState !== 'hidden');

function watchPage(): () => void {
    const changed = () => { isPageSeen.value = document.visibilityState !== 'hidden'; };
    document.addEventListener('visibilitychange', changed);
    changed();
    return () => document.removeEventListener('visibilitychange', changed);
}

function filmsFrame(): number | null {
    const film = shot.value?.film;
    return film && looksAsFilm.value
        ? frameAt(Math.min(filmTime.value, filmDuration.value), film) : null;
}

/// What the view shows now; null while it plays, or if it cannot be traced.
function shown(context: ViewContext): Shown | null {
    void context.moved.value;
    if (playing.value || !shot.value || !isPageSeen.value
        || connection.value !== 'open') {
        return null;
    }
    const frame = filmsFrame();
    if (frame !== null) {
        return { frame, width: 0, height: 0 };
    }
    const view = viewOf(context.camera(), sceneTime.value);
    const { clientWidth, clientHeight } = context.canvas;
    return view && { view, ...sizeOfView(clientWidth, clientHeight) };
}

/// The part of the canvas that the picture fills, CSS pixels.
function boxOf({ canvas }: ViewContext): Rectangle {
    const size = { width: canvas.clientWidth, height: canvas.clientHeight };
    const film = shot.peek()?.film;
    return film && film.height > 0 && looksAsFilm.peek()
        ? letterbox(size, film.width / film.height) : { left: 0, top: 0, ...size };
}

/// Asks for what is shown, once for each change.
function ask(wanted: Shown | null): void {
    question += 1;
    shownPicture.value = null;
    const isAsked = wanted !== null
        ? send('see', {
            q: question, v: shot.peek()?.v ?? 0, samples: 0, channel: channel.peek(), ...wanted,
        })
        : send('unsee', {}) && false;
    openQuestion.value = isAsked ? question : 0;
}

/// Whether the shown picture is of older texts than the motion. The server makes it anew by itself.
function isPictureOld(): boolean {
    return (shownPicture.value?.head.v ?? Infinity) < (timeline.value?.head.v ?? 0);
}

/// Whether a picture will come.
function isAwaited(): boolean {
    const isDone = (shownPicture.value?.head.complete ?? false) && !isPictureOld();
    return openQuestion.value > 0 && !waitsForButton.value && !isDone;
}

export const makeTracedPicture: MakePart = (context) => {
    const quad = new PictureQuad();
    context.scene.parent?.add(quad.group);
    let asked = '';

    const ends = [
        watchPage(),
        effect(() => {
            const wanted = isRefining.value ? shown(context) : null;
            const key = JSON.stringify([wanted, channel.value, welcome.value?.shot]);
            const isNew = key !== asked && (wanted !== null || question > 0);
            asked = key;
            if (isNew) {
                batch(() => ask(wanted));
            }
        }),
        effect(() => {
            const one = picture.value;
            if (one && one.head.q === openQuestion.peek()) {
                shownPicture.value = one;
            }
        }),
        effect(() => { pictureAsked.value = isAwaited(); }),
        effect(() => {
            void context.moved.value;
            const { clientWidth: width, clientHeight: height } = context.canvas;
            quad.place(boxOf(context), { width, height });
            const one = dragging.value ? null : shownPicture.value; // it would hide what moves
            const isOld = isStale.value || isPictureOld();
            quad.show(one, keptPicture.value, wipe.value, isOld ? kStaleOpacity : 1);
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
        priority: kDrawingPriority,
        dispose: () => {
            ends.forEach((end) => end());
            quad.dispose();
        },
    };
};
