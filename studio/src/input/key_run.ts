/// Presses of arrow keys that follow each other, as a held key gives them, are one step of undo. A
/// pause, another key or the pointer ends it.
import { beginGesture, type Change, type Gesture } from '../edit/edit';
import { dragging } from '../state/state';

const kPause = 700; // ms

interface Run {
    id: string;
    label: string;
    gesture: Gesture;
    /// Of the first press: all changes are made to the text before it, so that what a later press
    /// knows of the server's answers must not count.
    changes(value: unknown): Change[];
    /// Where the last press led.
    value: unknown;
    written: string;
    timer: number;
}

let run: Run | null = null;

/// Makes the presses so far one step of undo.
export function endKeyRun(): void {
    const last = run;
    run = null;
    if (last) {
        stopListening();
        clearTimeout(last.timer);
        last.gesture.commit(last.label);
    }
}

function onKey(event: KeyboardEvent): void {
    if (!/^(Arrow(Left|Right|Up|Down)|Shift|Alt|Control|Meta)$/.test(event.key)) {
        endKeyRun();
    }
}

function listen(): void {
    window.addEventListener('keydown', onKey, { capture: true });
    window.addEventListener('pointerdown', endKeyRun, { capture: true });
}

function stopListening(): void {
    window.removeEventListener('keydown', onKey, { capture: true });
    window.removeEventListener('pointerdown', endKeyRun, { capture: true });
}

/// Whether presses of this are going on.
function isKeyRun(id: string): boolean {
    return run?.id === id && dragging.peek();
}

export interface KeyStep<T> {
    /// Tells what is moved; another one begins a step of undo of its own.
    id: string;
    label: string;
    /// Whether its paths come from the scene, as those of beginGesture.
    isOfScene?: boolean;
    /// Where the first press starts. Later ones start where the one before led, so that no press is
    /// lost while the server has not answered.
    start: T;
    next(value: T): T;
    /// What is written in the text before the run; only that of the first press is called.
    changes(value: T): Change[];
}

/// Makes one press.
export function keyStep<T>(
    { id, label, isOfScene, start, next, changes }: KeyStep<T>,
): void {
    // Another edit may have ended its gesture.
    if (!run || !isKeyRun(id)) {
        endKeyRun();
        run = { id, label, gesture: beginGesture(isOfScene), changes: changes as Run['changes'],
            value: start, written: '', timer: 0 };
        listen();
    }
    const value = next(run.value as T);
    const list = run.changes(value);
    const written = JSON.stringify(list);
    // A press against a limit changes nothing, so that the first one back counts.
    if (written !== run.written) {
        run.value = value;
        run.written = written;
        run.gesture.update(list);
    }
    clearTimeout(run.timer);
    run.timer = window.setTimeout(endKeyRun, kPause);
}
