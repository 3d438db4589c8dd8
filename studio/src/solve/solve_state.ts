/// The pot that the user seeks, and the strikes that were found for it: a way of looking, until one is
/// written into the text.
import { computed, signal } from '@preact/signals';
import type { ShotSolution, TablePocket } from '../protocol';
import { solutions } from '../state/state';

export interface Wish {
    /// That shall be potted, in this pocket; empty: in any.
    ball: string;
    pocket: string;
    /// The strike that is sought: its ball, and its index in the events; that after the last one: a
    /// new strike.
    struck: string;
    event: number;
    /// Where the struck ball shall end; null: anywhere.
    rest: [number, number] | null;
}

export const kWithin = 0.15; // m, from the middle of the place where the struck ball shall end

/// Null: nothing is sought.
export const wish = signal<Wish | null>(null);
/// Whether that place is being dragged.
export const isPlacing = signal(false);
/// The number of the newest question.
export const askedNumber = signal(0);
/// The route of the chosen solution; empty: the best one.
export const chosenRoute = signal('');

/// The number of the first question about this pot.
export const firstNumber = signal(0);

/// What is shown: the newest answers about this pot, also while those for a newer place are awaited.
export const shownSolutions = computed(() =>
    wish.value && (solutions.value?.head.q ?? -1) >= firstNumber.value ? solutions.value : null);

export const found = computed<readonly ShotSolution[]>(() =>
    shownSolutions.value?.head.solutions ?? []);

/// Of `found`; -1 without any.
export const chosenIndex = computed(() => {
    const all = found.value;
    const at = all.findIndex(({ route }) => route === chosenRoute.value);
    return at >= 0 ? at : all.length > 0 ? 0 : -1;
});

export const chosen = computed<ShotSolution | null>(() => found.value[chosenIndex.value] ?? null);

/// Whether more answers to the newest question may come.
export const isSearching = computed(() => wish.value !== null
    && (shownSolutions.value?.head.q !== askedNumber.value || !shownSolutions.value.head.complete));

/// Where the ring of the struck ball's end is: the place that was wished, else where it ends.
export const restPlace = computed<[number, number] | null>(() =>
    wish.value?.rest ?? chosen.value?.rest ?? null);

/// The pocket at a place over the cloth; undefined if there is none.
export function pocketAt(
    [x, y]: readonly [number, number, ...number[]], pockets: readonly TablePocket[],
): TablePocket | undefined {
    return pockets.find(({ place, radius }) =>
        Math.hypot(place[0] - x, place[1] - y) < 1.15 * radius);
}
