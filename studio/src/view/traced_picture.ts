/// The path-traced picture of the film's frame at the play head, over the view of its camera.
import { effect, signal } from '@preact/signals';
import { send } from '../connection/socket';
import { filmCamera, filmDuration } from '../motion/clock';
import {
    filmTime, isStale, lookThrough, picture, pictureAsked, playing, shot,
} from '../state/state';
import { onCommand } from '../state/keys';

/// Whether the picture is wanted whenever the view looks through the film's camera.
export const isRefining = signal(false);

let question = 0;

/// The frame that the view shows, if it is the film's own; else null.
function shownFrame(): number | null {
    const film = shot.value?.film;
    const camera = shot.value?.cameras[filmCamera.value];
    if (!film || !camera || lookThrough.value !== camera.name || playing.value) {
        return null;
    }
    const last = Math.max(0, film.frames - 1);
    return Math.min(last, Math.floor(Math.min(filmTime.value, filmDuration.value) * film.fps + 1e-6));
}

/// Draws into a canvas that fills `parent`, the film's rectangle in the view. Returns a function
/// that ends this.
export function showTracedPicture(parent: HTMLElement): () => void {
    const canvas = document.createElement('canvas');
    canvas.setAttribute('aria-hidden', 'true');
    Object.assign(canvas.style, { width: '100%', height: '100%', display: 'block' });
    canvas.hidden = true;
    parent.append(canvas);
    let asked: number | null = null; // the frame of the newest question

    const ends = [
        effect(() => {
            const frame = isRefining.value ? shownFrame() : null;
            if (frame === asked) {
                return;
            }
            asked = frame;
            canvas.hidden = true;
            question += 1;
            const film = { q: question, v: shot.peek()?.v ?? 0, width: 0, height: 0, samples: 0 };
            pictureAsked.value = frame === null
                ? send('unsee', {}) && false
                : send('see', { ...film, frame, channel: '' });
        }),
        effect(() => {
            const one = picture.value;
            if (!one || one.head.q !== question || asked === null) {
                return;
            }
            const { width, height } = one.head;
            canvas.width = width;
            canvas.height = height;
            canvas.getContext('2d')?.putImageData(new ImageData(one.pixels, width, height), 0, 0);
            canvas.style.display = 'block';
            canvas.hidden = false;
            pictureAsked.value = !one.head.complete;
        }),
        effect(() => {
            canvas.style.opacity = isStale.value ? '0.35' : '1';
        }),
        onCommand('refine', () => {
            const camera = shot.peek()?.cameras[filmCamera.peek()];
            const isOn = isRefining.peek() && lookThrough.peek() === camera?.name;
            lookThrough.value = isOn ? lookThrough.peek() : camera?.name ?? null;
            isRefining.value = !isOn;
        }),
    ];
    return () => {
        ends.forEach((end) => end());
        canvas.remove();
    };
}
