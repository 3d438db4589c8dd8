/// Zooming and panning of both axes.
import { effect } from '@preact/signals';
import { filmTime, playing } from '../state/state';
import { panned, secondsPerPixel, timeAt, xOf, zoomed } from './axis';
import type { Layout } from './layout';
import { currentLayout } from './layout_now';
import { filmRange, sceneRange, shownFilm, shownScene, wholeFilm, wholeScene } from './strip_state';

function rangesOf(isFilm: boolean) {
    return isFilm ? { range: filmRange, shown: shownFilm, whole: wholeFilm }
        : { range: sceneRange, shown: shownScene, whole: wholeScene };
}

/// Moves a range by the pixels that the pointer moved.
export function panAxis(layout: Layout, isFilm: boolean, pixels: number): void {
    const seconds = -pixels * secondsPerPixel(isFilm ? layout.film : layout.scene);
    const { range, shown, whole } = rangesOf(isFilm);
    range.value = panned(shown.peek(), seconds, whole.peek());
}

/// Zooms an axis towards a pixel; all of it, once zoomed out again, follows the shot.
export function zoomAxis(layout: Layout, isFilm: boolean, x: number, factor: number): void {
    const axis = isFilm ? layout.film : layout.scene;
    const { range, shown, whole } = rangesOf(isFilm);
    const all = whole.peek();
    const next = zoomed(shown.peek(), timeAt(axis, x), factor, all);
    range.value = next.to - next.from >= 0.999 * (all.to - all.from) ? null : next;
}

/// Keeps the play head in sight while it moves over a zoomed axis. Returns a function that ends this.
export function followPlayHead(): () => void {
    return effect(() => {
        const time = filmTime.value;
        const range = filmRange.peek();
        if (range && playing.value && (time < range.from || time > range.to)) {
            const layout = currentLayout.peek();
            panAxis(layout, true, layout.film.left + 0.1 * layout.film.width - xOf(layout.film, time));
        }
    });
}
