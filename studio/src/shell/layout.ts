/// Sizes of the page's areas in pixels, remembered by the browser; 0: folded away.
import { signal, type Signal } from '@preact/signals';

interface Area {
    name: string;
    least: number;
    most: number;
    size: Signal<number>;
    /// The size that it unfolds to: that before it was folded away.
    usual: number;
}

function makeArea(name: string, usual: number, least: number, most: number): Area {
    const key = `carom.size.${name}`;
    const stored = (word: string) => Number(localStorage.getItem(word) ?? NaN);
    const before = stored(`${key}.unfolded`);
    const size = signal(Number.isFinite(stored(key)) ? stored(key) : usual);
    const area = { name, least, most, size, usual: before > 0 ? before : usual };
    size.subscribe((value) => {
        localStorage.setItem(key, String(value));
        if (value > 0) {
            unfoldTo(area, value);
        }
    });
    return area;
}

/// Says which size an area has when it is unfolded.
export function unfoldTo(area: Area, size: number): void {
    area.usual = size;
    localStorage.setItem(`carom.size.${area.name}.unfolded`, String(size));
}

export type { Area };
export const outlineArea = makeArea('outline', Math.max(220, Math.min(280, Math.round(innerWidth * 0.175))), 170, 460);
export const textArea = makeArea('text', Math.min(540, Math.round(innerWidth * 0.34)), 260, 1000);
export const stripArea = makeArea('strip', 244, 130, 520);
export const inspectorArea = makeArea('inspector', Math.round(Math.max(280, innerHeight * 0.46)), 120, 900);

/// Gives an area a size; below half of its least size it is folded away.
export function resize(area: Area, size: number): void {
    area.size.value = size < area.least / 2
        ? 0 : Math.max(area.least, Math.min(area.most, Math.round(size)));
}

/// Folds an area away, or unfolds it.
export function toggle(area: Area): void {
    area.size.value = area.size.value === 0 ? area.usual : 0;
}
