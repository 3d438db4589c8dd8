/// When which samples of the film have to sound. Film times and times of the audio context are s.
import type { SoundExtent } from './sound_data';

/// How film time runs in the clock of an audio context.
export interface Anchor {
    film: number; // the film time of the sample that is played at `context`
    context: number;
    speed: number; // seconds of the film in a second of the context, > 0
}

export function filmTimeAt({ film, context, speed }: Anchor, time: number): number {
    return film + (time - context) * speed;
}

export function contextTimeAt({ film, context, speed }: Anchor, time: number): number {
    return context + (time - film) / speed;
}

/// A part of one piece of the sound, and when it begins.
export interface Part {
    piece: number;
    from: number; // sample of the piece
    count: number; // samples
    at: number; // time of the context
}

/// The parts with all samples whose times are in [from, until): stretches that follow each other
/// have each sample once.
export function partsBetween(
    anchor: Anchor, { rate, samples, piece }: SoundExtent, from: number, until: number,
): Part[] {
    const parts: Part[] = [];
    const sampleAt = (time: number) => Math.ceil(time * rate - 1e-6);
    const end = Math.min(samples, sampleAt(until));
    for (let at = Math.max(0, sampleAt(from)); at < end;) {
        const index = Math.floor(at / piece);
        const next = Math.min(end, (index + 1) * piece);
        parts.push({ piece: index, from: at - index * piece, count: next - at,
            at: contextTimeAt(anchor, at / rate) });
        at = next;
    }
    return parts;
}

const kTolerance = 0.025; // s; the clock of a context goes in steps of up to 20 ms
const kJump = 0.1; // s: the play head was moved
const kPatience = 4; // frames of the display

/// Watches how far the sound is from the play head. A jump counts at once; a small difference,
/// which a late frame of the display may feign, only if it stays.
export class DriftWatch {
    private frames = 0;

    /// Whether the sound has to begin anew, for a difference of s at a frame of the display.
    isOff(difference: number): boolean {
        this.frames = Math.abs(difference) > kTolerance ? this.frames + 1 : 0;
        return Math.abs(difference) > kJump || this.frames >= kPatience;
    }

    reset(): void {
        this.frames = 0;
    }
}

export const kGrain = 0.06; // s, of what is heard at a place while scrubbing
const kGrainBefore = 0.01; // s of it before the place: an event is heard when one goes to it

/// The stretch of film time that is heard while the play head is put to a time.
export function grainAt(time: number, duration: number): { from: number; until: number } {
    const from = Math.max(0, Math.min(time - kGrainBefore, duration - kGrain));
    return { from, until: Math.min(duration, from + kGrain) };
}
