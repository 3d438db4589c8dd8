/// The texts beside the pointer.
import type { FilmPart } from '../protocol';
import { openFilm, sequence, shot } from '../state/state';
import { soundData } from '../sound/sound_state';
import { secondsPerPixel, timeAt } from './axis';
import { fastestAt } from './ball_speeds';
import { filmClock, sceneClock, speedText } from './clock_text';
import { partAbout } from './draw/parts';
import { curveName } from './strip_state';
import { binAt, binsOf } from './event_bins';
import type { Handle } from './handles/handle';
import { isIn, type Layout } from './layout';
import { partUnder } from './part_under';
import { shownEvents } from './strip_state';
import { speedAt } from '../motion/time_map';

/// A text beside the pointer.
export interface Tip {
    x: number;
    y: number;
    text: string;
}

const kMostLines = 7;

function eventLines(layout: Layout, x: number): string[] {
    const bin = binAt(binsOf(shownEvents.peek(), layout.scene), x);
    const events = bin?.events ?? [];
    const lines = events.slice(0, kMostLines)
        .map((event) => `${sceneClock(event.time)}  ${event.text}`);
    const more = events.length - lines.length;
    return more > 0 ? [...lines, `and ${more} more`] : lines;
}

function clipLines(layout: Layout, x: number): string[] {
    const time = timeAt(layout.film, x);
    const camera = shot.peek()?.cameras.findLast((one) =>
        time >= one.video_start && time < one.video_end);
    return camera ? [`camera ${camera.name}, ${speedText(speedAt(camera, time))}`,
        `${camera.video_start.toFixed(2)} s to ${camera.video_end.toFixed(2)} s of the film`] : [];
}

function partLines(part: FilmPart | undefined): string[] {
    const fps = openFilm.peek()?.fps ?? 24;
    return !part ? [] : [part.name.replace(/\s+/g, ' '), partAbout(part, fps),
        `${filmClock(part.start / fps)} to ${filmClock((part.start + part.frames) / fps)} of the film`,
        ...part.fade > 0 ? [`appears in ${(part.fade / fps).toFixed(2)} s`] : [],
        ...part.file !== '' ? ['double-click to open the shot'] : []];
}

/// How loud the sound is under the pointer.
function soundLines({ film }: Layout, x: number): string[] {
    const time = timeAt(film, x);
    const peak = soundData.peek()?.peak(time, time + secondsPerPixel(film)) ?? null;
    return peak === null ? [] : [filmClock(time),
        peak > 0 ? `sound: peak ${(20 * Math.log10(peak)).toFixed(1).replace('-', '−')} dB of full scale`
            : 'sound: silence'];
}

/// The text for a place of the strip; null if there is nothing to say.
export function tipOf(
    layout: Layout, { x, y }: { x: number; y: number }, handle: Handle | undefined,
): Tip | null {
    const lines = handle ? [`${handle.label}: ${handle.text}`,
        handle.remove ? 'drag to move it, Delete to remove it' : 'drag to move it']
        : isIn(layout.sound, y) ? soundLines(layout, x)
        : sequence.peek() ? partLines(partUnder(layout, { x, y }))
        : isIn(layout.events, y) ? eventLines(layout, x)
            : isIn(layout.motion, y)
                ? [sceneClock(timeAt(layout.scene, x)), ...fastestAt(timeAt(layout.scene, x), 5)]
                : isIn(layout.clips, y) ? clipLines(layout, x)
                    : isIn(layout.curve, y) && curveName.peek() === 'speed'
                        ? [...clipLines(layout, x).slice(0, 1), 'double-click to add a point'] : [];
    return lines.length > 0 && x >= layout.film.left ? { x, y, text: lines.join('\n') } : null;
}
