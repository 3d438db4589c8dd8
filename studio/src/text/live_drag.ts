/// The drag that types into texts outside of their histories, until it ends. There is one at a time:
/// of a value in the view, on the strip or in the inspector, or of a number in the text.
import { send } from '../connection/socket';
import { dragging } from '../state/state';

export interface LiveDrag {
    hasTyped(file: string): boolean;
    /// Makes what it typed a step of undo, or takes it back. Nothing happens if it has ended.
    end(isKept: boolean): void;
}

let running: LiveDrag | null = null;

/// Ends the drag in progress, if there is one. Returns whether there was.
export function endDrag(isKept: boolean): boolean {
    const drag = running;
    drag?.end(isKept);
    return drag !== null;
}

/// A drag begins; one in progress is kept as it is.
export function startDrag(drag: LiveDrag): void {
    endDrag(true);
    running = drag;
    dragging.value = true;
    send('dragging', { on: true });
}

export function isRunning(drag: LiveDrag): boolean {
    return running === drag;
}

/// Says that a drag ends. Returns false if it had ended.
export function stopDrag(drag: LiveDrag): boolean {
    if (running !== drag) {
        return false;
    }
    running = null;
    dragging.value = false;
    send('dragging', { on: false });
    return true;
}

/// A file gets another text from outside of the page: a drag that typed into it is taken back.
export function makeWay(file: string): void {
    if (running?.hasTyped(file)) {
        running.end(false);
    }
}
