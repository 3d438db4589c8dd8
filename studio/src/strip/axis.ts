/// A time axis of the strip: which times it shows, and where they are.

/// A range of times and the pixels that it fills.
export interface Axis {
    from: number; // s, at `left`
    to: number; // s, at `left + width`; larger than `from`
    left: number; // px
    width: number; // px, larger than 0
}

export interface Range {
    from: number;
    to: number;
}

export interface Tick {
    time: number;
    major: boolean;
}

const kShortest = 1e-4; // s, the shortest range that zooming reaches

/// Pixels from the left of the canvas.
export function xOf(axis: Axis, time: number): number {
    return axis.left + (time - axis.from) / (axis.to - axis.from) * axis.width;
}

export function timeAt(axis: Axis, x: number): number {
    return axis.from + (x - axis.left) / axis.width * (axis.to - axis.from);
}

/// Seconds per pixel.
export function secondsPerPixel(axis: Axis): number {
    return (axis.to - axis.from) / axis.width;
}

/// The range zoomed by a factor (below 1: closer) around a time, at most as long as `whole`.
export function zoomed(range: Range, time: number, factor: number, whole: Range): Range {
    const length = range.to - range.from;
    const longest = whole.to - whole.from;
    const next = Math.min(Math.max(length * factor, kShortest), longest);
    const from = time - (time - range.from) / length * next;
    return kept({ from, to: from + next }, whole);
}

/// The range moved by seconds, without leaving `whole`.
export function panned(range: Range, seconds: number, whole: Range): Range {
    return kept({ from: range.from + seconds, to: range.to + seconds }, whole);
}

/// The range pushed back into `whole`.
export function kept(range: Range, whole: Range): Range {
    const length = Math.min(range.to - range.from, whole.to - whole.from);
    const from = Math.min(Math.max(range.from, whole.from), whole.to - length);
    return { from, to: from + length };
}

/// The step, 1, 2 or 5 times a power of ten, that is at least `least`.
export function roundStep(least: number): number {
    const power = 10 ** Math.floor(Math.log10(least));
    const first = [1, 2, 5, 10].find((factor) => factor * power >= least * (1 - 1e-9)) ?? 10;
    return first * power;
}

/// Round times within the axis, the major ones at least `spacing` pixels apart.
export function ticksOf(axis: Axis, spacing: number): Tick[] {
    const step = roundStep(secondsPerPixel(axis) * spacing);
    const minor = step / 5;
    const ticks: Tick[] = [];
    for (let i = Math.ceil(axis.from / minor - 1e-6); i * minor <= axis.to + 1e-9; i += 1) {
        ticks.push({ time: i * minor, major: i % 5 === 0 });
    }
    return ticks;
}

/// The decimals that tell ticks of an axis apart.
export function decimalsOf(axis: Axis, spacing: number): number {
    return Math.max(0, -Math.floor(Math.log10(roundStep(secondsPerPixel(axis) * spacing)) + 1e-9));
}

/// The time rounded to what a pixel resolves: a round step, at least 0.1 ms.
export function resolved(axis: Axis, time: number): { time: number; step: number } {
    const step = roundStep(Math.max(secondsPerPixel(axis) * 0.5, 1e-4));
    return { time: Math.round(time / step) * step, step };
}
