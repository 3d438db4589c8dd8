/// How sure an outcome is, in words at its place: "nine is potted in 3 of 8".
import type { FanHead, TablePocket } from '../../protocol';
import type { Label } from './figure';
import type { Pin } from './event_pins';

/// A label for each ball that some of the runs pot: at the pin of the shot itself if it pots the
/// ball there, else at the pocket, if it is always the same.
export function fanText(
    answer: { head: FanHead } | null, pins: readonly Pin[], pockets: readonly TablePocket[],
): Label[] {
    const { finished = 0, outcomes = [] } = answer?.head ?? {};
    if (finished === 0) {
        return [];
    }
    return outcomes.filter(({ kind }) => kind === 'potted').flatMap(({ a, b, runs }): Label[] => {
        const pin = pins.find(({ event }) => event.kind === 'potted' && event.a === a);
        const pocket = pockets.find(({ name }) => name === b);
        const text = `${a} is potted in ${runs} of ${finished}`;
        if (pin) {
            return [{ at: pin.at, text }];
        }
        return pocket ? [{ at: [...pocket.place, 0.03], text, tone: 'faint' }] : [];
    });
}
