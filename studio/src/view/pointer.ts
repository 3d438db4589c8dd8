/// Which part of the view gets the pointer.
import { onCommand } from '../state/keys';
import { kBodyPriority, type Drag, type ViewPart } from './parts';

const kLongPress = 500; // ms, of a finger that stays where it is
const kStill = 8; // CSS pixels, that such a finger may move
const kLate = 50; // ms, by which a timer of a busy page is late

/// Gives presses, drags and hovering to the parts, before all other listeners of the canvas. A press
/// that no part wants is left to them. A finger that stays where it is ends the drag that it began:
/// `longPress` is called. Returns a function that ends this.
export function arbitratePointer(
    canvas: HTMLCanvasElement, parts: readonly ViewPart[], longPress: (at: PointerEvent) => void,
): () => void {
    const inOrder = [...parts].sort((a, b) => b.priority - a.priority);
    let drag: Drag | null = null;
    let pointer: number | null = null; // pressed by a part; its drag may have been cancelled
    let forgetCancel = () => {};
    let hovering = 0;
    let finger: { at: PointerEvent; timer: number } | null = null;

    const finish = (how: (drag: Drag) => void) => {
        const ended = drag;
        drag = null;
        forgetCancel();
        forgetCancel = () => {};
        if (ended) {
            how(ended);
        }
    };
    const watchFinger = (event: PointerEvent) => {
        const isFirst = finger === null && event.pointerType === 'touch' && event.isPrimary;
        forgetFinger();
        finger = isFirst ? { at: event, timer: waitFor(event, kLongPress) } : null;
    };
    /// A page that was busy may have heard of the finger, but not yet that it was lifted: it waits
    /// again.
    const waitFor = (event: PointerEvent, wait: number) => {
        const due = performance.now() + wait;
        return window.setTimeout(() => {
            if (finger && performance.now() > due + kLate) {
                finger.timer = waitFor(event, 2 * kLate);
                return;
            }
            finger = null;
            finish((one) => one.cancel());
            longPress(event);
        }, wait);
    };
    const forgetFinger = () => {
        window.clearTimeout(finger?.timer);
        finger = null;
    };
    const down = (event: PointerEvent) => {
        watchFinger(event);
        cancelAnimationFrame(hovering);
        if (pointer !== null) {
            event.stopImmediatePropagation();
            return;
        }
        for (const part of event.button === 0 ? inOrder : []) {
            drag = part.grab?.(event) ?? null;
            if (drag) {
                break;
            }
        }
        if (drag) {
            pointer = event.pointerId;
            event.stopImmediatePropagation();
            canvas.setPointerCapture(event.pointerId);
            canvas.focus();
            forgetCancel = onCommand('cancel', () => finish((one) => one.cancel()));
        }
    };
    const move = (event: PointerEvent) => {
        if (finger && Math.hypot(event.clientX - finger.at.clientX, event.clientY - finger.at.clientY) > kStill) {
            forgetFinger();
        }
        if (pointer === event.pointerId) {
            event.stopImmediatePropagation();
            drag?.move(event);
        } else if (event.buttons === 0) {
            cancelAnimationFrame(hovering);
            hovering = requestAnimationFrame(() => {
                canvas.style.cursor = cursorAt(inOrder, event) ?? '';
            });
        }
    };
    const up = (event: PointerEvent) => {
        forgetFinger();
        if (pointer === event.pointerId) {
            event.stopImmediatePropagation();
            pointer = null;
            finish((one) => one.end(event));
        }
    };
    const lost = (event: PointerEvent) => {
        forgetFinger();
        if (pointer === event.pointerId) {
            pointer = null;
            finish((one) => one.cancel());
        }
    };

    const listeners = [
        ['pointerdown', down], ['pointermove', move], ['pointerup', up], ['pointercancel', lost],
    ] as const;
    listeners.forEach(([name, listener]) =>
        canvas.addEventListener(name, listener, { capture: true }));
    return () => {
        cancelAnimationFrame(hovering);
        forgetFinger();
        finish((one) => one.cancel());
        listeners.forEach(([name, listener]) =>
            canvas.removeEventListener(name, listener, { capture: true }));
    };
}

/// Whether a handle, not only a body of the scene, would get a press of the pointer.
export function isHandleAt(parts: readonly ViewPart[], event: MouseEvent): boolean {
    return parts.some((part) => part.priority > kBodyPriority
        && (part.hover?.(event as PointerEvent) ?? null) !== null);
}

function cursorAt(parts: readonly ViewPart[], event: PointerEvent): string | null {
    for (const part of parts) {
        const cursor = part.hover?.(event) ?? null;
        if (cursor !== null) {
            return cursor;
        }
    }
    return null;
}
