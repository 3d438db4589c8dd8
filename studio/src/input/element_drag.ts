/// A drag that a press on an element begins. It is followed on the whole window, so that it also ends
/// if the element leaves the page meanwhile.

export interface DragParts {
    /// Called for each move of the pointer.
    move(event: PointerEvent): void;
    /// Called once: by the release (true), or by Escape or the browser (false).
    end(isDone: boolean): void;
}

/// Whether a press may begin a drag: the main button, or the first finger.
export function beginsDrag(event: Pick<PointerEvent, 'button' | 'isPrimary'>): boolean {
    return event.button === 0 && event.isPrimary;
}

/// Keeps the pointer for the element, or for the page once the element has left it. Returns whether
/// it is kept: not if it was released where nothing could hear of it.
function capture(element: Element, pointer: number): boolean {
    const holder = element.isConnected ? element : document.documentElement;
    try {
        holder.setPointerCapture(pointer);
        return holder.hasPointerCapture(pointer);
    } catch {
        return false;
    }
}

/// Follows the pointer of a press until it is released. Does nothing for other buttons and further
/// fingers.
export function dragFrom(press: PointerEvent, parts: DragParts): void {
    const element = press.currentTarget as HTMLElement | SVGElement;
    if (!beginsDrag(press)) {
        return;
    }
    // No selection of text, and no drag of a selected one, which would take the pointer away.
    press.preventDefault();
    element.focus({ preventScroll: true });
    const stop = new AbortController();
    const options = { signal: stop.signal, capture: true };
    const end = (isDone: boolean) => {
        if (!stop.signal.aborted) {
            stop.abort();
            parts.end(isDone);
        }
    };
    const ofPress = (act: (event: PointerEvent) => void) => (event: PointerEvent) => {
        if (event.pointerId === press.pointerId) {
            act(event);
        }
    };
    capture(element, press.pointerId);
    window.addEventListener('pointermove', ofPress((event) => parts.move(event)), options);
    window.addEventListener('pointerup', ofPress(() => end(true)), options);
    window.addEventListener('pointercancel', ofPress(() => end(false)), options);
    window.addEventListener('lostpointercapture', ofPress((event) => {
        if (!capture(element, event.pointerId)) {
            end(true);
        }
    }), options);
    window.addEventListener('keydown', (event) => {
        if (event.key === 'Escape') {
            event.preventDefault();
            event.stopPropagation();
            end(false);
        }
    }, options);
}
