/// Drags that change values: they type into the texts outside of the histories, and are one step of
/// undo at their end.
import { typeStep } from '../text/buffers';
import { DragTyping } from '../text/drag_typing';
import { endDrag, isRunning, startDrag, stopDrag, type LiveDrag } from '../text/live_drag';
import { answersFor, kNoAnswers } from './answers';
import { applyChanges, changed, done, refused } from './apply';
import type { Change, EditResult, Gesture } from './edit_types';
import { Undecided } from './plan';
import { checkScenePath } from './scene_paths';

class EditGesture implements LiveDrag {
    private readonly typing = new DragTyping();
    private readonly checked = new Set<string>();  // paths that were found to lead where they should
    private unanswered: Change[] | null = null;  // the last changes, if they need an answer

    constructor(private readonly isOfScene: boolean) {}

    hasTyped(file: string): boolean {
        return this.typing.hasTyped(file);
    }

    stateBefore(file: string) {
        return this.typing.stateBefore(file);
    }

    rebase(file: string, change: () => void): void {
        this.typing.rebase(file, change);
    }

    /// Types the changes of the texts as they were before the drag. Does nothing once it has ended.
    update(changes: Change[]): EditResult {
        if (!isRunning(this)) {
            return done('');
        }
        if (!this.typing.isAlone) {
            this.cancel();  // the user typed into the same text meanwhile
            return done('');
        }
        const { origin } = this.typing;
        try {
            this.checkPaths(changes);
            const target = changed(origin, changes, { aliases: answersFor(origin, kNoAnswers) });
            this.unanswered = null;
            this.typing.show(target);
            return done(target.find((file, i) => file.text !== origin[i]?.text)?.file ?? '');
        } catch (error) {
            this.unanswered = error instanceof Undecided ? changes : null;
            return refused(error, null);
        }
    }

    commit(label: string): void {
        if (!stopDrag(this)) {
            return;
        }
        const isWhole = this.typing.isAlone;
        typeStep(this.typing.finish(), label);
        if (isWhole && this.unanswered) {
            applyChanges(this.unanswered, label);
        }
    }

    cancel(): void {
        if (stopDrag(this)) {
            this.typing.finish();
        }
    }

    end(isKept: boolean): void {
        if (isKept) {
            this.commit('Change');
        } else {
            this.cancel();
        }
    }

    private checkPaths(changes: readonly Change[]): void {
        for (const { path } of this.isOfScene ? changes : []) {
            const key = path.join('/');
            if (!this.checked.has(key)) {
                checkScenePath(path, this.typing.origin);
                this.checked.add(key);
            }
        }
    }
}

/// Starts a drag. One may be in progress at a time: the one before is committed. `isOfScene`: the
/// paths of its changes come from the scene that is shown, which may be that of an earlier text;
/// changes whose paths lead elsewhere in the text of now are refused.
export function beginGesture(isOfScene = false): Gesture {
    endDrag(true);
    const gesture = new EditGesture(isOfScene);
    startDrag(gesture);
    return {
        update: (changes) => gesture.update(changes),
        commit: (label) => gesture.commit(label),
        cancel: () => gesture.cancel(),
    };
}

/// Takes the drag in progress back; whether there was one.
export function cancelGesture(): boolean {
    return endDrag(false);
}
