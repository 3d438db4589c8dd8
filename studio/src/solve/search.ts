/// Seeking a pot: begin, go through what is found, move the place where the struck ball shall end, and
/// write the strike.
import { batch, effect } from '@preact/signals';
import { onMessage } from '../connection/receive';
import { send } from '../connection/socket';
import { changeAndRemove, insertItem, type EditResult } from '../edit/edit';
import type { SceneObject } from '../protocol';
import {
    dragging, isStale, notice, selection, shot, solutions, timeline,
} from '../state/state';
import { NewestQuestion } from '../view/scene_annotations/newest_question';
import { valueAt } from '../view/gizmos/shot_values';
import { shownStrike } from '../view/gizmos/strike';
import {
    askedNumber, chosen, chosenIndex, chosenRoute, firstNumber, found, isPlacing, isSearching, kWithin, shownSolutions, wish,
    type Wish,
} from './solve_state';
import { pocketWords } from './solution_text';
import { newStrike, solvePaths, strikeChanges } from './strike_text';

const kSeconds = 10; // of a search
const kPlaceSeconds = 4; // of one for a place, whose ways are known already
const kPlacingSeconds = 2; // while the place is dragged

interface Question extends Omit<Wish, 'rest'> {
    v: number;
    rest?: [number, number];
    within: number;
    seconds: number;
}

const questions = new NewestQuestion<Question>((q, question) => {
    const isSent = send('solve', { q, ...question });
    askedNumber.value = isSent ? q : askedNumber.peek();
    return isSent;
});

/// Whose strike pots a ball: the shown one, or a new one of the cue ball.
function strikeFor(ball: string): Pick<Wish, 'struck' | 'event'> | null {
    const state = shot.peek();
    const shown = shownStrike.peek()?.event;
    if (!state) {
        return null;
    }
    if (shown && shown.object !== ball) {
        return { struck: shown.object, event: Number(shown.path[1]) };
    }
    const balls = state.names.balls.filter((name) => name !== ball);
    const struck = balls.find((name) => name === 'cue') ?? balls[0];
    return struck === undefined ? null : { struck, event: state.events.length };
}

/// Whether a strike could pot this ball: there is another one to strike, and a pocket.
export function canPot(ball: SceneObject): boolean {
    return ball.kind === 'ball' && (shot.peek()?.pockets.length ?? 0) > 0
        && strikeFor(ball.name) !== null;
}

/// Begins to seek strikes that pot a ball.
export function seekPot(ball: string, pocket: string): void {
    const strike = strikeFor(ball);
    if (strike) {
        batch(() => {
            firstNumber.value = askedNumber.peek() + 1;
            chosenRoute.value = '';
            questions.forget();
            wish.value = { ball, pocket, ...strike, rest: null };
        });
        document.querySelector<HTMLElement>('.view canvas')?.focus({ preventScroll: true });
    }
}

export function leaveSearch(): void {
    wish.value = null;
}

export function choose(index: number): void {
    chosenRoute.value = found.peek()[index]?.route ?? '';
}

/// Goes to the next solution, or by as many as told.
export function step(by: number): void {
    const count = found.peek().length;
    if (count > 0) {
        choose((((chosenIndex.peek() + by) % count) + count) % count);
    }
}

/// Where the struck ball shall end; null: anywhere.
export function wishRest(rest: [number, number] | null): void {
    const one = wish.peek();
    if (one) {
        wish.value = { ...one, rest };
    }
}

/// How many strikes the text's `solve` finds.
function solveCount(): number {
    const all = valueAt(['solve']);
    return all === undefined ? 0 : Array.isArray(all) ? all.length : 1;
}

/// Writes the chosen strike into the text, as one step of undo.
export function writeChosen(): void {
    const [one, solution, head] = [wish.peek(), chosen.peek(), shownSolutions.peek()?.head];
    if (!one || !solution || !head || isStale.peek()) {
        return;
    }
    const label = `Pot ${one.ball}`;
    const path = ['events', String(one.event)];
    const isNew = one.event >= (shot.peek()?.events.length ?? 0);
    const result: EditResult = isNew
        ? insertItem(['events'], one.event, newStrike(one.struck, head.time, solution), label)
        : changeAndRemove(
            strikeChanges([...path, 'strike'], solution,
                (key) => valueAt([...path, 'strike', key]) !== undefined),
            solvePaths(head.solve_item, solveCount()), label);
    if (result.ok) {
        leaveSearch();
        selection.value = path;
        notice.value = {
            kind: 'info', text: `The strike pots ${one.ball} in ${pocketWords(solution.pocket)}.`,
        };
    }
}

/// Asks while something is sought, until the returned function is called.
export function watchSearch(): () => void {
    let isAsking = false;
    const ends = [
        effect(() => {
            const one = wish.value;
            const v = timeline.value?.head.v;
            if (one && v !== undefined && !dragging.value && !isStale.value) {
                const { rest, ...others } = one;
                isAsking = true;
                questions.ask({ v, ...others, ...rest ? { rest } : {}, within: kWithin,
                    seconds: isPlacing.value ? kPlacingSeconds : rest ? kPlaceSeconds : kSeconds });
            } else if (!one && isAsking) {
                isAsking = false;
                questions.forget();
                send('unsolve', {});
            }
        }),
        effect(() => {
            const head = solutions.value?.head;
            if (head) {
                questions.answered(head.q);
            }
        }),
        // What was sought may be gone from the shot.
        effect(() => {
            const one = wish.value;
            const state = shot.value;
            const isThere = (name: string) => state?.names.balls.includes(name) ?? false;
            if (one && (!isThere(one.ball) || !isThere(one.struck)
                || one.event > (state?.events.length ?? 0))) {
                wish.value = null;
            }
        }),
        onMessage('failed', ({ what, message }) => {
            if (what === 'solve') {
                questions.failed();
                wish.value = null;
                notice.value = { kind: 'error', text: message };
            }
        }),
    ];
    window.studio['solve'] = {
        wish, found, chosen, chosenIndex, isSearching, solutions: shownSolutions, seekPot,
    };
    return () => {
        wish.value = null;
        ends.forEach((end) => end());
    };
}
