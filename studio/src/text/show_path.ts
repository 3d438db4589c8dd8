/// Shows where the text says something about a value of the shot.
import type { KeyPath } from '../protocol';
import { notice, sequence, shot } from '../state/state';
import { showRange } from './show';

/// Shows the value, or the nearest one above it that stands in a text. Returns false if none does.
export function showPath(path: KeyPath): boolean {
    const places = (sequence.peek() ?? shot.peek())?.places ?? [];
    for (let depth = path.length; depth > 0; --depth) {
        const place = places.find((one) =>
            one.path.length === depth && one.path.every((key, i) => key === path[i]));
        if (place && place.value.line > 0) {
            showRange(place.key.line > 0 ? place.key : place.value);
            return true;
        }
    }
    notice.value = { kind: 'info', text: `No text says anything about ${path.join('.')}.` };
    return false;
}
