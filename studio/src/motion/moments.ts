/// Moments: scene times that are written as what happens then.
import { parseQuantity, writeNumber } from '../edit/quantity';
import type { TimelineEvent } from '../protocol';

const kOneContact = 0.01; // s: impacts of a pair within this time are one contact (sim/force_event.h)

/// The key and the value of what happens in an event; null if no moment names it.
function occurrenceOf(event: TimelineEvent): string | null {
    switch (event.kind) {
        case 'impact':
            return event.b === 'cushion' ? `cushion: ${event.a}` : `contact: [${event.a}, ${event.b}]`;
        case 'strike':
        case 'potted':
        case 'resting':
            return `${event.kind}: ${event.a}`;
        default:
            return null;
    }
}

/// The moment that names an event among all events of the motion, as YAML: "{contact: [cue, one]}",
/// "{cushion: cue, nth: 2}"; null if none does, because the event belongs to a contact that began
/// before.
export function momentOf(event: TimelineEvent, events: readonly TimelineEvent[]): string | null {
    const what = occurrenceOf(event);
    if (what === null) {
        return null;
    }
    let count = 0;
    let last = -Infinity;
    for (const one of events) {
        if (occurrenceOf(one) !== what) {
            continue;
        }
        if (one.kind !== 'impact' || one.time - last > kOneContact) {
            count += 1;
        } else if (one === event) {
            return null;
        }
        last = one.time;
        if (one === event) {
            break;
        }
    }
    return count === 1 ? `{${what}}` : `{${what}, nth: ${count}}`;
}

/// A moment as it is written in the text, apart from its delay.
export interface WrittenMoment {
    /// "contact: [cue, one]"
    what: string;
    delay: number; // s after it
}

/// Reads a moment in flow style; null if the text is none.
export function parseMoment(text: string): WrittenMoment | null {
    const inside = /^\{(.*)\}$/s.exec(text.trim())?.[1];
    if (inside === undefined || /(^|,)\s*(from|speeds)\s*:/.test(inside.replace(/\{[^}]*\}/g, ''))) {
        return null;
    }
    let delay = 0;
    let isRead = true;
    const what = inside.replace(/,?\s*\b(before|after)\s*:\s*([^,}]+)/, (_, key: string, time: string) => {
        const quantity = parseQuantity(time.trim());
        isRead = quantity !== null;
        delay = (key === 'before' ? -1 : 1) * (quantity?.value ?? 0);
        return '';
    }).replace(/^\s*,\s*/, '').trim();
    return isRead ? { what, delay } : null;
}

/// The moment with another delay, not written finer than `precision` (s).
export function writeMoment(moment: WrittenMoment, delay: number, precision: number): string {
    const text = writeNumber(Math.abs(delay), precision);
    return text === '0' ? `{${moment.what}}`
        : `{${moment.what}, ${delay < 0 ? 'before' : 'after'}: ${text} s}`;
}
