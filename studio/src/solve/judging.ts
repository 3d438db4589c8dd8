/// Asks what the selected strike pots as it is, and what comes of others like it, once the shot rests
/// after an edit.
import { computed, effect } from '@preact/signals';
import { onMessage } from '../connection/receive';
import { send } from '../connection/socket';
import { dragging, isStale, judged, strikeMap, timeline } from '../state/state';
import { shownStrike } from '../view/gizmos/strike';
import { NewestQuestion } from '../view/scene_annotations/newest_question';
import { wish } from './solve_state';

const kRest = 250; // ms without a change
const kInside = 0.8; // of the map: a strike in this part of it keeps its directions

interface Question {
    v: number;
    event: number;
    wants_map: boolean;
    directions?: [number, number];
}

const chosenEvent = computed(() => {
    const strike = shownStrike.value;
    return strike?.isChosen ? Number(strike.event.path[1]) : -1;
});

/// What the selected strike pots; null: nothing, or that is not known yet. While the strike is changed
/// it is that of before.
export const judgedStrike = computed(() => {
    const one = judged.value;
    return one && one.event === chosenEvent.value && one.pots.length > 0 ? one : null;
});

/// Whether that belongs to the motion that is shown.
export const isJudgedNow = computed(() => judged.value !== null && !isStale.value
    && !dragging.value && judged.value.v === timeline.value?.head.v);

/// The map of the selected strike.
export const shownMap = computed(() =>
    strikeMap.value?.event === chosenEvent.value ? strikeMap.value : null);

/// The directions of the map, if the strike is well inside of it.
function keptDirections(direction: number): [number, number] | undefined {
    const range = shownMap.peek()?.directions;
    if (!range) {
        return undefined;
    }
    const from = (range[0] + range[1]) / 2;
    return Math.abs(direction - from) < kInside * (range[1] - from) ? range : undefined;
}

/// Asks until the returned function is called.
export function watchJudging(): () => void {
    const questions = new NewestQuestion<Question>((q, question) => send('judge', { q, ...question }));
    let timer = 0;
    const ends = [
        effect(() => {
            const event = chosenEvent.value;
            const v = timeline.value?.head.v;
            const isResting = wish.value === null && !dragging.value && !isStale.value;
            window.clearTimeout(timer);
            if (event >= 0 && v !== undefined && isResting) {
                timer = window.setTimeout(() => {
                    const directions = keptDirections(shownStrike.peek()?.event.direction ?? 0);
                    questions.ask({ v, event, wants_map: true, ...directions ? { directions } : {} });
                }, kRest);
            } else {
                questions.forget();
            }
        }),
        effect(() => {
            const one = judged.value;
            if (one) {
                questions.answered(one.q);
            }
        }),
        onMessage('failed', ({ what }) => {
            if (what === 'judge') {
                questions.failed();
            }
        }),
    ];
    return () => {
        window.clearTimeout(timer);
        ends.forEach((end) => end());
    };
}
