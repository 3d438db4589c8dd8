/// The drag that types into texts outside of their histories, until it ends. There is one at a time:
/// of a value in the view, on the strip or in the inspector, or of a number in the text.
import type { EditorState } from '@codemirror/state';
import { send } from '../connection/socket';
import { dragging } from '../state/state';

export interface LiveDrag {
    hasTyped(file: string): boolean;
    /// A file as it would be without the drag.
    stateBefore(file: string): EditorState | undefined;
    /// Lets `change` change a file as if there were no drag, which then goes on.
    rebase(file: string, change: () => void): void;
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

/// A file gets another text from outside of the page, by `change`; a drag that types into it goes on
/// in that text.
export function changeUnder(file: string, change: () => void): void {
    if (running?.hasTyped(file)) {
        running.rebase(file, change);
    } else {
        change();
    }
}

/// A file without what a drag typed into it; undefined: no drag has.
export function stateWithoutDrag(file: string): EditorState | undefined {
    return running?.hasTyped(file) ? running.stateBefore(file) : undefined;
}
