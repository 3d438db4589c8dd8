/// The texts that the server had in the last moments. A text of another window was made from one of
/// them, but not always from the newest, as both windows send while the other's text is on its way.
import { difference } from '../edit/text_edit';

const kMoment = 2000;  // ms
const kMost = 32;

const recent = new Map<string, { text: string; time: number }[]>();

/// Takes note of a text that was sent to the server, or came from there.
export function noteRecent(file: string, text: string): void {
    const now = performance.now();
    const all = recent.get(file) ?? [];
    // The last one before that time was the server's when it began.
    const first = all.findLastIndex(({ time }) => time < now - kMoment);
    recent.set(file, [...all.slice(Math.max(0, first)), { text, time: now }].slice(-kMost));
}

export function forgetRecent(): void {
    recent.clear();
}

/// How many characters are not the same.
function distance(a: string, b: string): number {
    const edit = difference(a, b);
    return edit ? edit.to - edit.from + edit.insert.length : 0;
}

/// The recent text from which another window most likely made `text`: the one that differs least, of
/// equals the newest. Null if none is known.
export function ancestorOf(file: string, text: string): string | null {
    let best: string | null = null;
    let least = Infinity;
    for (const one of [...recent.get(file) ?? []].reverse()) {
        const far = distance(one.text, text);
        if (far < least) {
            [best, least] = [one.text, far];
        }
    }
    return best;
}
