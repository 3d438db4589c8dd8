/// Drags that change values: they type into the texts outside of the histories, and are one step of
/// undo at their end.
import { typeStep } from '../text/buffers';
import { endDrag, isRunning, startDrag, stopDrag, type LiveDrag } from '../text/live_drag';
import { OutsideTyping } from '../text/outside_typing';
import { answersFor, kNoAnswers } from './answers';
import { applyChanges, changed, done, refused, stepTo } from './apply';
import { currentFiles, textOfDocument } from './current_files';
import type { Change, EditResult, Gesture, SourceFile } from './edit_types';
import { Undecided } from './plan';

class EditGesture implements LiveDrag {
    private readonly typing = new OutsideTyping();
    private last: SourceFile[] = [];
    private unanswered: Change[] | null = null;  // the last changes, if they need an answer

    hasTyped(file: string): boolean {
        return this.typing.hasTyped(file);
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
        const before = this.filesBefore();
        try {
            this.last = changed(before, changes, { aliases: answersFor(before, kNoAnswers) });
            this.unanswered = null;
        } catch (error) {
            this.unanswered = error instanceof Undecided ? changes : null;
            return refused(error, null);
        }
        for (const step of stepTo(this.last)) {
            this.typing.type(step.file, step.changes);
        }
        return done(this.last.find((file, i) => file.text !== before[i]?.text)?.file ?? '');
    }

    commit(label: string): void {
        if (!stopDrag(this)) {
            return;
        }
        const isWhole = this.typing.isAlone;
        this.typing.takeBack();
        if (isWhole) {
            typeStep(stepTo(this.last.filter(({ file }) => this.typing.hasTyped(file))), label);
            if (this.unanswered) {
                applyChanges(this.unanswered, label);
            }
        }
    }

    cancel(): void {
        if (stopDrag(this)) {
            this.typing.takeBack();
        }
    }

    end(isKept: boolean): void {
        if (isKept) {
            this.commit('Change');
        } else {
            this.cancel();
        }
    }

    /// The texts of now, without what this drag typed.
    private filesBefore(): SourceFile[] {
        return currentFiles().map((one) => {
            const document = this.typing.docBefore(one.file);
            return document ? { ...one, text: textOfDocument(document) } : one;
        });
    }
}

/// Starts a drag. One may be in progress at a time: the one before is committed.
export function beginGesture(): Gesture {
    const gesture = new EditGesture();
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
