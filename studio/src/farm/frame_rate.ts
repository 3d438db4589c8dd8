/// The curve of frames an hour.
import type { FrameRow } from './farm_types';

export interface RateCurve {
    from: number; // Unix time
    to: number;
    rates: number[]; // frames an hour in equal stretches of that time
    most: number; // a round number that is no less than any rate
}

const kMostBins = 48;
const kLeastBin = 10; // s

/// The least of 1, 2, 5, 10, 20 ... that is no less than the number.
export function roundedUp(value: number): number {
    const ten = 10 ** Math.floor(Math.log10(Math.max(value, 1)));
    return [1, 2, 5, 10].map((step) => step * ten).find((one) => one >= value) ?? 10 * ten;
}

/// Of the frames that are done and whose workers noted when; null if these are fewer than two.
export function rateCurve(rows: FrameRow[]): RateCurve | null {
    const ends = rows.flatMap(({ state, ended }) => (state === 'done' && ended ? [ended] : []))
        .sort((a, b) => a - b);
    const [from, to] = [ends[0], ends.at(-1)];
    if (from === undefined || to === undefined || to <= from) {
        return null;
    }
    const count = Math.max(1, Math.min(kMostBins, Math.floor((to - from) / kLeastBin)));
    const rates = new Array<number>(count).fill(0);
    for (const end of ends) {
        const bin = Math.min(count - 1, Math.floor((count * (end - from)) / (to - from)));
        rates[bin] = (rates[bin] ?? 0) + (3600 * count) / (to - from);
    }
    return { from, to, rates, most: roundedUp(Math.max(...rates)) };
}
