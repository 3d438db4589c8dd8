/// Events that are too near to each other to be told apart share a column of the strip.
import type { TimelineEvent } from '../protocol';
import { xOf, type Axis } from './axis';
import { groupOf, type EventGroup } from './strip_state';

export interface Bin {
    x: number; // px, of the first of its events
    events: TimelineEvent[]; // the most important first
    groups: EventGroup[]; // of each event
}

const kColumn = 6; // px
const kOrder: readonly EventGroup[] = [
    'actions', 'pockets', 'contacts', 'cushions', 'rest', 'changes',
];

/// The columns of events, which come in the order of time.
export function binsOf(events: readonly TimelineEvent[], axis: Axis): Bin[] {
    const bins: Bin[] = [];
    for (const event of events) {
        const x = xOf(axis, event.time);
        const last = bins.at(-1);
        if (last && x - last.x < kColumn) {
            last.events.push(event);
        } else {
            bins.push({ x, events: [event], groups: [] });
        }
    }
    const rank = (event: TimelineEvent) => kOrder.indexOf(groupOf(event));
    for (const bin of bins) {
        bin.events.sort((a, b) => rank(a) - rank(b) || a.time - b.time);
        bin.groups = bin.events.map(groupOf);
    }
    return bins;
}

/// The column at a place; undefined if none is near.
export function binAt(bins: readonly Bin[], x: number): Bin | undefined {
    return bins.find((bin) => x >= bin.x - kColumn / 2 - 1 && x < bin.x + kColumn / 2 + 1);
}
