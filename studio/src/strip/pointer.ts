/// What the pointer does on the strip: scrubs, drags handles, zooms, pans.
import { effect } from '@preact/signals';
import { beginGesture, type Gesture } from '../edit/edit';
import { goToFilmTime, goToSceneTime } from '../motion/clock';
import { playing, selection, shot } from '../state/state';
import { panned, secondsPerPixel, timeAt, xOf, zoomed, type Range } from './axis';
import { sceneClock } from './clock_text';
import { handleAt, handlesOf, type Handle } from './drags';
import { binAt, binsOf } from './event_bins';
import { isFilmSide, type Layout, type Row } from './layout';
import {
    filmRange, sceneRange, shownEvents, shownFilm, shownScene, wholeFilm, wholeScene,
} from './strip_state';

/// A text beside the pointer; null: none.
export interface Tip {
    x: number;
    y: number;
    text: string;
}

const kMostLines = 7;

function isIn(row: Row, y: number): boolean {
    return y >= row.y && y < row.y + row.height;
}

/// The text for a place of the strip.
export function tipAt(layout: Layout, x: number, y: number): Tip | null {
    const state = shot.peek();
    const handle = state && handleAt(handlesOf(layout, state), x, y);
    if (handle) {
        return { x, y, text: `Drag: ${handle.label}` };
    }
    const bin = isIn(layout.events, y)
        ? binAt(binsOf(shownEvents.peek(), layout.scene), x) : undefined;
    if (!bin) {
        return null;
    }
    const lines = bin.events.slice(0, kMostLines)
        .map((event) => `${sceneClock(event.time)}  ${event.text}`);
    const more = bin.events.length - lines.length;
    return { x, y, text: [...lines, ...(more > 0 ? [`and ${more} more`] : [])].join('\n') };
}

/// Selects the camera whose clip is at a place.
function selectClip(layout: Layout, x: number): void {
    const time = timeAt(layout.film, x);
    const camera = shot.peek()?.cameras.findLast((one) =>
        time >= one.video_start && time < one.video_end);
    if (camera) {
        selection.value = camera.path;
    }
}

/// Puts the play head where the pointer is; film times snap to frames unless alt is held.
function scrub(layout: Layout, x: number, isFilm: boolean, isFree: boolean): void {
    playing.value = false;
    if (!isFilm) {
        goToSceneTime(timeAt(layout.scene, x));
        return;
    }
    const fps = shot.peek()?.film.fps ?? 24;
    const time = timeAt(layout.film, x);
    goToFilmTime(isFree ? time : Math.round(time * fps) / fps);
}

interface Place {
    x: number;
    y: number;
}

function placeOf(canvas: HTMLCanvasElement, event: MouseEvent): Place {
    const box = canvas.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
}

/// Moves a range by the pixels that the pointer moved.
function pan(layout: Layout, isFilm: boolean, pixels: number): void {
    const seconds = -pixels * secondsPerPixel(isFilm ? layout.film : layout.scene);
    const [range, shown, whole] = isFilm
        ? [filmRange, shownFilm, wholeFilm] : [sceneRange, shownScene, wholeScene];
    range.value = panned(shown.peek(), seconds, whole.peek());
}

/// Zooms an axis towards the pointer; all of it, once zoomed out again, follows the shot.
function zoom(layout: Layout, isFilm: boolean, x: number, factor: number): void {
    const axis = isFilm ? layout.film : layout.scene;
    const [range, shown, whole] = isFilm
        ? [filmRange, shownFilm, wholeFilm] : [sceneRange, shownScene, wholeScene];
    const next: Range = zoomed(shown.peek(), timeAt(axis, x), factor, whole.peek());
    const all = whole.peek();
    range.value = next.to - next.from >= 0.999 * (all.to - all.from) ? null : next;
}

/// Listens to the pointer on the strip's canvas. `layout` gives the rows as they are now, `show` is
/// called with the text to show. Returns a function that ends this.
export function watchPointer(
    canvas: HTMLCanvasElement, layout: () => Layout, show: (tip: Tip | null) => void,
): () => void {
    let gesture: Gesture | null = null;
    let handle: Handle | null = null;
    let scrubs: 'film' | 'scene' | null = null;
    let pans: 'film' | 'scene' | null = null;
    let last: Place = { x: 0, y: 0 };

    const end = () => {
        gesture = null;
        handle = null;
        scrubs = null;
        pans = null;
    };
    const onDown = (event: PointerEvent) => {
        const at = placeOf(canvas, event);
        const rows = layout();
        const side = isFilmSide(rows, at.y) ? 'film' : 'scene';
        last = at;
        show(null);
        canvas.setPointerCapture(event.pointerId);
        if (event.button !== 0) {
            pans = side;
            return;
        }
        const state = shot.peek();
        handle = (state && handleAt(handlesOf(rows, state), at.x, at.y)) ?? null;
        if (handle) {
            selection.value = handle.path.slice(0, 2);
            gesture = beginGesture();
            return;
        }
        const bin = isIn(rows.events, at.y)
            ? binAt(binsOf(shownEvents.peek(), rows.scene), at.x) : undefined;
        if (bin?.events[0]) {
            playing.value = false;
            goToSceneTime(bin.events[0].time);
            return;
        }
        if (isIn(rows.clips, at.y)) {
            selectClip(rows, at.x);
        }
        scrubs = side;
        scrub(rows, at.x, side === 'film', event.altKey);
    };
    const onMove = (event: PointerEvent) => {
        const at = placeOf(canvas, event);
        const rows = layout();
        if (handle && gesture) {
            const result = gesture.update(handle.changes(at.x, at.y));
            show(result.ok ? null : { ...at, text: result.message });
        } else if (scrubs) {
            scrub(rows, at.x, scrubs === 'film', event.altKey);
        } else if (pans) {
            pan(rows, pans === 'film', at.x - last.x);
        } else {
            const tip = tipAt(rows, at.x, at.y);
            show(tip);
            canvas.style.cursor = tip?.text.startsWith('Drag') ? 'ew-resize' : 'default';
        }
        last = at;
    };
    const onUp = () => {
        if (gesture && handle) {
            gesture.commit(`Move the ${handle.label}`);
        }
        end();
    };
    const onWheel = (event: WheelEvent) => {
        event.preventDefault();
        const at = placeOf(canvas, event);
        const isFilm = isFilmSide(layout(), at.y);
        if (event.shiftKey || Math.abs(event.deltaX) > Math.abs(event.deltaY)) {
            pan(layout(), isFilm, -(event.deltaX || event.deltaY));
        } else {
            zoom(layout(), isFilm, at.x, 1.0015 ** event.deltaY);
        }
    };
    const listeners = {
        pointerdown: onDown, pointermove: onMove, pointerup: onUp,
        pointercancel: () => { gesture?.cancel(); end(); },
        pointerleave: () => show(null),
        wheel: onWheel, contextmenu: (event: Event) => event.preventDefault(),
    };
    for (const [name, listener] of Object.entries(listeners)) {
        canvas.addEventListener(name, listener as EventListener, { passive: false });
    }
    return () => {
        for (const [name, listener] of Object.entries(listeners)) {
            canvas.removeEventListener(name, listener as EventListener);
        }
    };
}

/// Keeps the play head in sight while it moves over a zoomed axis. Returns a function that ends this.
export function followPlayHead(filmTime: () => number, layout: () => Layout): () => void {
    return effect(() => {
        const time = filmTime();
        const range = filmRange.peek();
        if (range && playing.value && (time < range.from || time > range.to)) {
            const { film } = layout();
            pan(layout(), true, film.left + 0.1 * film.width - xOf(film, time));
        }
    });
}
