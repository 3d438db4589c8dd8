/// What the pointer does on the strip: scrubs, drags handles, zooms, pans.
import { beginGesture, type Gesture } from '../edit/edit';
import { goToFilmTime, goToSceneTime } from '../motion/clock';
import { openPart } from '../sequence/parts';
import { openFilm, playing, selection, sequence, shot } from '../state/state';
import { timeAt } from './axis';
import { curveRow, curveScale, heldScale } from './curve_row';
import { binAt, binsOf } from './event_bins';
import { activeHandle, handleAt, selectedCamera, shownHandles } from './handles/all_handles';
import { dragOf, type HandleDrag } from './handles/drag';
import type { Handle } from './handles/handle';
import { lineAt } from './handles/map_handles';
import { isFilmSide, isIn, type Layout } from './layout';
import { currentLayout } from './layout_now';
import { addPointAt } from './add_point';
import { otherInstants } from './instants';
import { partUnder } from './part_under';
import { panAxis, zoomAxis } from './ranges';
import { shownEvents, visitedEvent } from './strip_state';
import { tipOf, type Tip } from './tips';

const kTouchReach = 8; // px, added to handles for fingers
const kInstantReach = 7; // px

interface Place {
    x: number;
    y: number;
}

/// What the pointer has in hand.
type Held =
    | { kind: 'handle'; handle: Handle; gesture: Gesture; drag: HandleDrag }
    | { kind: 'scrub'; isFilm: boolean }
    | { kind: 'pan'; isFilm: boolean };

/// The handle under the pointer, also a line of the map.
export function handleUnder(layout: Layout, at: Place, isTouch: boolean): Handle | undefined {
    const state = shot.peek();
    const handle = handleAt(shownHandles.peek(), at.x, at.y, isTouch ? kTouchReach : 0);
    return handle ?? (state && isIn(layout.map, at.y)
        ? lineAt(layout, state, selectedCamera.peek(), at.x, at.y) : undefined);
}

/// Selects the camera whose clip is at a place, or the part of the film.
function selectClip(layout: Layout, at: Place): void {
    const part = partUnder(layout, at);
    if (part) {
        selection.value = part.path;
        return;
    }
    const time = timeAt(layout.film, at.x);
    const camera = shot.peek()?.cameras.findLast((one) =>
        time >= one.video_start && time < one.video_end);
    if (camera) {
        selection.value = camera.path;
    }
}

/// Adds a point to a curve, or opens the shot of a part.
function doubleClick(layout: Layout, at: Place): void {
    const part = partUnder(layout, at);
    if (part) {
        openPart(part);
    } else if (!sequence.peek()) {
        addPointAt(layout, at);
    }
}

/// Puts the play head where the pointer is; film times snap to frames unless alt is held.
function scrub(layout: Layout, x: number, isFilm: boolean, isFree: boolean): void {
    playing.value = false;
    if (!isFilm) {
        goToSceneTime(timeAt(layout.scene, x));
        return;
    }
    const fps = openFilm.peek()?.fps ?? 24;
    const time = timeAt(layout.film, x);
    goToFilmTime(isFree ? time : Math.round(time * fps) / fps);
}

/// Jumps to an event, or to another instant of the film that shows the same time of the scene, if
/// one is at the place.
function jump(layout: Layout, at: Place): boolean {
    const bin = isIn(layout.events, at.y)
        ? binAt(binsOf(shownEvents.peek(), layout.scene), at.x) : undefined;
    const event = bin?.events[0];
    if (event) {
        playing.value = false;
        goToSceneTime(event.time);
        visitedEvent.value = event;
        return true;
    }
    const instant = isIn(layout.filmRuler, at.y) ? otherInstants.peek().find(({ time }) =>
        Math.abs(time - timeAt(layout.film, at.x)) < kInstantReach * (layout.film.to - layout.film.from)
            / layout.film.width) : undefined;
    if (instant) {
        playing.value = false;
        goToFilmTime(instant.time);
    }
    return instant !== undefined;
}

/// Listens to the pointer on the strip's canvas; `show` is called with the text to show. Returns a
/// function that ends this.
export function watchPointer(
    canvas: HTMLCanvasElement, show: (tip: Tip | null) => void,
): () => void {
    const pointers = new Map<number, Place>();
    let held: Held | null = null;

    const placeOf = (event: MouseEvent): Place => {
        const box = canvas.getBoundingClientRect();
        return { x: event.clientX - box.left, y: event.clientY - box.top };
    };
    const letGo = (isDone: boolean) => {
        if (held?.kind === 'handle') {
            if (isDone && held.drag.moved()) {
                held.gesture.commit(`Move ${held.handle.label}`);
            } else {
                held.gesture.cancel();
            }
            heldScale.value = null;
        }
        held = null;
    };
    const grab = (layout: Layout, at: Place, handle: Handle) => {
        if (selection.peek()?.join('/') !== handle.path.join('/')) {
            selection.value = handle.path;
        }
        heldScale.value = curveScale.peek();
        activeHandle.value = handle.id;
        const drag = dragOf(handle, at, curveRow(layout.curve, curveScale.peek()));
        held = { kind: 'handle', handle, gesture: beginGesture(true), drag };
    };
    const onDown = (event: PointerEvent) => {
        const at = placeOf(event);
        const layout = currentLayout.peek();
        pointers.set(event.pointerId, at);
        canvas.setPointerCapture(event.pointerId);
        show(null);
        if (pointers.size > 1) {
            letGo(false);
            return;
        }
        const isFilm = isFilmSide(layout, at.y);
        if (event.button !== 0) {
            held = { kind: 'pan', isFilm };
            return;
        }
        const handle = handleUnder(layout, at, event.pointerType === 'touch');
        if (handle) {
            grab(layout, at, handle);
        } else if (!jump(layout, at)) {
            if (isIn(layout.clips, at.y)) {
                selectClip(layout, at);
            }
            held = { kind: 'scrub', isFilm };
            scrub(layout, at.x, isFilm, event.altKey);
        }
    };
    const pinch = (event: PointerEvent, at: Place) => {
        const layout = currentLayout.peek();
        const last = pointers.get(event.pointerId) ?? at;
        const other = [...pointers].find(([id]) => id !== event.pointerId)?.[1] ?? at;
        const isFilm = isFilmSide(layout, (at.y + other.y) / 2);
        const ratio = Math.max(Math.abs(last.x - other.x), 20) / Math.max(Math.abs(at.x - other.x), 20);
        zoomAxis(layout, isFilm, (at.x + other.x) / 2, ratio);
        panAxis(currentLayout.peek(), isFilm, (at.x - last.x) / 2);
    };
    const onMove = (event: PointerEvent) => {
        const at = placeOf(event);
        const layout = currentLayout.peek();
        if (pointers.size > 1) {
            pinch(event, at);
        } else if (held?.kind === 'handle') {
            const result = held.gesture.update(held.drag.changes(at));
            show(result.ok ? { ...at, text: held.drag.text() } : { ...at, text: result.message });
        } else if (held?.kind === 'scrub') {
            scrub(layout, at.x, held.isFilm, event.altKey);
        } else if (held) {
            panAxis(layout, held.isFilm, at.x - (pointers.get(event.pointerId)?.x ?? at.x));
        } else {
            const handle = handleUnder(layout, at, false);
            activeHandle.value = handle?.id ?? null;
            show(tipOf(layout, at, handle));
            canvas.style.cursor = !handle ? 'default' : handle.value === null ? 'ew-resize' : 'move';
        }
        if (pointers.has(event.pointerId)) {
            pointers.set(event.pointerId, at);
        }
    };
    const onUp = (event: PointerEvent) => {
        pointers.delete(event.pointerId);
        letGo(true);
        show(null);
    };
    const onWheel = (event: WheelEvent) => {
        event.preventDefault();
        const at = placeOf(event);
        const layout = currentLayout.peek();
        const isFilm = isFilmSide(layout, at.y);
        if (event.shiftKey || Math.abs(event.deltaX) > Math.abs(event.deltaY)) {
            panAxis(layout, isFilm, -(event.deltaX || event.deltaY));
        } else {
            zoomAxis(layout, isFilm, at.x, 1.0015 ** event.deltaY);
        }
    };
    const listeners = {
        pointerdown: onDown, pointermove: onMove, pointerup: onUp,
        pointercancel: (event: PointerEvent) => { pointers.delete(event.pointerId); letGo(false); },
        pointerleave: () => { activeHandle.value = null; show(null); },
        dblclick: (event: MouseEvent) => doubleClick(currentLayout.peek(), placeOf(event)),
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
