/// The ends and fades of the parts of a film of several shots, in whole frames.
import type { Change } from '../../edit/edit';
import type { FilmPart, SequenceState } from '../../protocol';
import { clipColourName } from '../colours';
import { oldTexts, timeChange, timeOfFrame, type OldTexts } from '../film_time';
import { laneOf, type Layout } from '../layout';
import type { Handle } from './handle';

const kLongest = 3600; // s

function within(value: number, least: number, most: number): number {
    return Math.min(Math.max(Math.round(value), least), Math.max(least, most));
}

/// The frames that the fades at both ends of a part take; at least one, as a part has.
function leastFrames(parts: readonly FilmPart[], index: number): number {
    return Math.max(1, (parts[index]?.fade ?? 0) + (parts[index + 1]?.fade ?? 0));
}

/// The edit that lets a shot begin with another frame of its own film.
export function fromChange(
    { film: { fps }, parts }: SequenceState, index: number, frame: number, old: OldTexts = oldTexts(),
): Change[] {
    const part = parts[index];
    return part?.kind !== 'shot' ? [] : [timeChange([...part.path, 'from'], timeOfFrame(
        within(frame, 0, part.first + part.frames - leastFrames(parts, index)), fps), old)];
}

/// The edit that gives a part another number of frames, by its end.
export function lengthChange(
    { film: { fps }, parts }: SequenceState, index: number, frames: number, old: OldTexts = oldTexts(),
): Change[] {
    const part = parts[index];
    if (!part) {
        return [];
    }
    const least = leastFrames(parts, index);
    return part.kind === 'title'
        ? [timeChange([...part.path, 'for'], timeOfFrame(within(frames, least, kLongest * fps), fps), old)]
        : [timeChange([...part.path, 'to'], timeOfFrame(
            part.first + within(frames, least, part.of_frames - part.first), fps), old)];
}

/// The edit that gives a part a fade of so many frames; both parts keep room for their other fades.
export function fadeChange(
    { film: { fps }, parts }: SequenceState, index: number, frames: number, old: OldTexts = oldTexts(),
): Change[] {
    const part = parts[index];
    if (!part) {
        return [];
    }
    const before = parts[index - 1];
    const most = Math.min(part.frames - (parts[index + 1]?.fade ?? 0),
        before ? before.frames - before.fade : part.frames, 60 * fps);
    return [timeChange([...part.path, 'fade'], timeOfFrame(within(frames, 0, most), fps), old)];
}

function handlesOf(layout: Layout, sequence: SequenceState, index: number): Handle[] {
    const part = sequence.parts[index] as FilmPart;
    const { fps } = sequence.film;
    const lane = laneOf(layout.clips, index);
    const old = oldTexts();
    const name = part.name.replace(/\s+/g, ' ');
    const seconds = (frames: number) => `${(frames / fps).toFixed(2)} s`;
    const common = { path: part.path, axis: layout.film, value: null,
        colour: part.kind === 'title' ? 'text-soft' : clipColourName(index), step: { time: 1 / fps, value: 0 } };
    const edge = { ...common, mark: 'none' as const, y: lane.y + lane.height * 0.6,
        reach: { x: 5, y: lane.height * 0.4 } };
    const id = part.path.join('/');
    // The end of the part before stands still: a longer fade lets this one begin earlier.
    const [time, sign] = index === 0 ? [part.fade, 1] : [part.start, -1];
    return [
        { ...common, id: `${id} fade`, time: time / fps, mark: 'fade', y: lane.y + 6, reach: { x: 7, y: 6 },
            label: `fade of ${name}`, text: part.fade > 0 ? seconds(part.fade) : 'none',
            change: (next) => fadeChange(sequence, index, part.fade + sign * (next * fps - time), old) },
        ...part.kind === 'title' ? [] : [{ ...edge, id: `${id} from`, time: part.start / fps,
            label: `start of ${name}`, text: seconds(part.first),
            change: (next: number) =>
                fromChange(sequence, index, part.first + next * fps - part.start, old) }],
        { ...edge, id: `${id} ${part.kind === 'title' ? 'for' : 'to'}`,
            time: (part.start + part.frames) / fps, label: `end of ${name}`,
            text: seconds(part.first + part.frames),
            change: (next) => lengthChange(sequence, index, next * fps - part.start, old) },
    ];
}

/// The handles of all parts, those of the selected one first.
export function partHandles(layout: Layout, sequence: SequenceState, selected: number): Handle[] {
    const order = sequence.parts.map((_, i) => i);
    return [...order.filter((i) => i === selected), ...order.filter((i) => i !== selected)]
        .flatMap((index) => handlesOf(layout, sequence, index));
}
