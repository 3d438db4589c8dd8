/// The parts of a film of several shots: which one is shown, and what can be done with one.
import { computed, effect } from '@preact/signals';
import { moveItem, sourceOf } from '../edit/edit';
import { goToFrame } from '../motion/clock';
import type { FilmPart, KeyPath } from '../protocol';
import { openShot } from '../start/file_actions';
import { filmTime, notice, selection, sequence, shot } from '../state/state';

export const kParts: KeyPath = ['film', 'shots'];

/// The index of the part that a frame of the film shows, in a fade of the one that appears; -1 if it
/// shows none.
export function partAt(parts: readonly FilmPart[], frame: number): number {
    return parts.findLastIndex(({ start, frames }) => frame >= start && frame < start + frames);
}

/// The frame of the film at the play head.
export const shownFrame = computed(() => {
    const film = sequence.value?.film;
    const last = Math.max(0, (film?.frames ?? 1) - 1);
    return Math.min(last, Math.floor(filmTime.value * (film?.fps ?? 24) + 1e-6));
});

/// The index of the part at the play head, or -1.
export const shownPart = computed(() => partAt(sequence.value?.parts ?? [], shownFrame.value));

/// The index of a part by its path, or of what is inside it; -1 if the path leads elsewhere.
export function indexOfPart(path: KeyPath | null): number {
    return path?.[0] === 'film' && path[1] === 'shots' && path.length >= 3 ? Number(path[2]) : -1;
}

/// The selected part, or null.
export const chosenPart = computed<FilmPart | null>(() =>
    sequence.value?.parts[indexOfPart(selection.value)] ?? null);

/// Opens the shot of a part in the studio; changes are saved first, or a question comes.
export function openPart(part: FilmPart): void {
    if (part.file !== '') {
        void openShot(part.file);
    }
}

/// Nothing is selected any more once a shot is open instead of the film, or a film instead of a shot.
/// Returns a function that ends this.
export function followKind(): () => void {
    return effect(() => {
        const isPart = selection.peek()?.[0] === 'film';
        if ((shot.value && isPart) || (sequence.value && selection.peek() && !isPart
            && selection.peek()?.[0] !== 'output')) {
            selection.value = null;
        }
    });
}

/// Moves a part by one place, earlier (-1) or later (1). The selection follows it.
export function movePart(part: FilmPart, step: 1 | -1): void {
    const from = indexOfPart(part.path);
    const to = from + step;
    const text = sourceOf(part.path)?.text;
    if (text === undefined || to < 0 || to >= (sequence.peek()?.parts.length ?? 0)) {
        return;
    }
    const result = moveItem(kParts, from, to, text, `Move ${part.name} ${step < 0 ? 'earlier' : 'later'}`);
    if (result.ok) {
        selection.value = [...kParts, String(to)];
    } else if (result.message !== '') {
        notice.value = { kind: 'error', text: result.message };
    }
}

/// Puts the play head to the beginning of the next part, or of this one and the ones before it.
export function stepParts(direction: number): void {
    const starts = (sequence.peek()?.parts ?? []).map(({ start }) => start);
    const frame = shownFrame.peek();
    const found = direction > 0 ? starts.find((start) => start > frame)
        : starts.findLast((start) => start < frame);
    if (found !== undefined) {
        goToFrame(found);
    }
}
