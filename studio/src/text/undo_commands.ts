/// Undo and redo, with a notice of what was taken back.
import { notice } from '../state/state';
import { travel } from './buffers';
import { endDrag } from './live_drag';
import { redoable, undoable } from './steps';

/// Takes the last step back, or does it again, and says so. A drag in progress ends first: it is the
/// last step then. Returns whether there was one.
export function undoStep(back: boolean): boolean {
    endDrag(true);
    const steps = (back ? undoable : redoable).value;
    const label = steps[steps.length - 1]?.label ?? '';
    const isDone = travel(back);
    if (isDone && label !== '') {
        notice.value = { kind: 'info', text: `${back ? 'Undone' : 'Redone'}: ${label}` };
    }
    return isDone;
}
