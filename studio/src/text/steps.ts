/// One stack of undo steps over all files: which files each step changed, and what it did.
import { computed, signal } from '@preact/signals';

export interface Step {
    files: string[];
    /// What the step did, as a title: "Move cue". Empty for typing.
    label: string;
}

/// The steps that can be undone and redone, the oldest first.
export const undoable = signal<readonly Step[]>([]);
export const redoable = signal<readonly Step[]>([]);

/// "Undo: Move cue"
function title(word: string, steps: readonly Step[]): string {
    const last = steps[steps.length - 1];
    return last ? `${word}: ${last.label || 'typing'}` : word;
}

/// For tooltips of buttons and for the notice after a step was taken back.
export const undoTitle = computed(() => title('Undo', undoable.value));
export const redoTitle = computed(() => title('Redo', redoable.value));

/// The oldest of more steps are forgotten. Each file's own history is longer than this.
export const kMostSteps = 5000;

/// A new step; what was undone before can no longer be done again.
export function addStep(step: Step): void {
    redoable.value = [];
    undoable.value = [...undoable.value, step].slice(-kMostSteps);
}

/// Whether the last step has this label and changed these files, and nothing is undone.
export function isLastStep(files: readonly string[], label: string): boolean {
    const last = undoable.value[undoable.value.length - 1];
    return redoable.value.length === 0 && last?.label === label
        && last.files.join('\n') === files.join('\n');
}

/// Moves the last step from one stack to the other. Returns it, or null if there is none.
export function moveStep(back: boolean): Step | null {
    const [from, to] = back ? [undoable, redoable] : [redoable, undoable];
    const step = from.value[from.value.length - 1] ?? null;
    if (step) {
        from.value = from.value.slice(0, -1);
        to.value = [...to.value, step];
    }
    return step;
}

/// Puts other steps in place of all.
export function setSteps(back: readonly Step[], forward: readonly Step[]): void {
    undoable.value = back;
    redoable.value = forward;
}
