/// Playing: the play head moves with the display's frames, and only while playing.
import { effect, signal } from '@preact/signals';
import { filmDuration, goToFilmTime, goToFrame, goToSceneTime } from '../motion/clock';
import { onCommand } from '../state/keys';
import { stepParts } from '../sequence/parts';
import { filmTime, openFilm, playing, sceneTime, sequence } from '../state/state';
import { currentEvent, fitStrip, shownEvents, visitedEvent } from './strip_state';

/// The speeds of playing, of the film's own.
export const kSpeeds = [1, 1 / 2, 1 / 4, 1 / 8] as const;
export const speed = signal<number>(1);
export const loops = signal(false);

let startedAt = 0; // film time at which playing began
let movedAt = 0; // ms of performance.now(), when the play head was last moved by playing; 0: not yet

/// Where the play head is at this moment while playing, also between frames of the display; null
/// before its first move.
export function headTime(): number | null {
    return movedAt === 0 ? null
        : filmTime.peek() + (performance.now() - movedAt) / 1000 * speed.peek();
}

/// The film time after `elapsed` seconds, and whether the film has ended there.
export function advanced(
    time: number, elapsed: number, duration: number, repeat: boolean,
): { time: number; ended: boolean } {
    const next = time + elapsed;
    if (next < duration) {
        return { time: next, ended: false };
    }
    return repeat && duration > 0 ? { time: next % duration, ended: false }
        : { time: duration, ended: true };
}

/// Moves the play head at each frame of the display while `playing`. Returns a function that ends
/// this.
function runClock(): () => void {
    let request = 0;
    let last = 0;
    const step = (now: number) => {
        const elapsed = last > 0 ? (now - last) / 1000 * speed.peek() : 0;
        movedAt = last > 0 ? now : 0;
        last = now;
        const { time, ended } =
            advanced(filmTime.peek(), elapsed, filmDuration.peek(), loops.peek());
        goToFilmTime(time);
        if (ended) {
            playing.value = false;
        } else {
            request = requestAnimationFrame(step);
        }
    };
    return effect(() => {
        cancelAnimationFrame(request);
        movedAt = 0;
        if (playing.value) {
            last = 0;
            request = requestAnimationFrame(step);
        }
    });
}

/// Starts or stops playing; at the end of the film it starts again from the beginning.
export function togglePlaying(): void {
    if (!playing.peek()) {
        if (filmTime.peek() >= filmDuration.peek() - 1e-9) {
            goToFilmTime(0);
        }
        startedAt = filmTime.peek();
    }
    playing.value = !playing.peek();
}

/// Stops where playing began.
export function returnToStart(): void {
    playing.value = false;
    goToFilmTime(startedAt);
}

/// Stops at a time of the film.
export function stopAt(time: number): void {
    playing.value = false;
    goToFilmTime(time);
}

/// The frame of the film under the play head: the last one that has begun.
export function currentFrame(): number {
    const fps = openFilm.value?.fps ?? 24;
    return Math.floor(filmTime.value * fps + 1e-6);
}

/// Stops `count` whole frames further; between two frames one step goes to the nearest in that
/// direction.
export function stepFrames(count: number): void {
    playing.value = false;
    const fps = openFilm.peek()?.fps ?? 24;
    const frame = filmTime.peek() * fps;
    const whole = Math.abs(frame - Math.round(frame)) < 1e-6 ? Math.round(frame)
        : count > 0 ? Math.floor(frame) : Math.ceil(frame);
    const last = Math.max(0, (openFilm.peek()?.frames ?? 1) - 1);
    goToFrame(Math.min(Math.max(whole + count, 0), last));
}

/// Stops at a scene time that is `seconds` further.
export function stepScene(seconds: number): void {
    playing.value = false;
    goToSceneTime(sceneTime.peek() + seconds);
}

/// The next event in a direction (1 or -1): the neighbour of the one that the clock stands at, of
/// events of one time, too; otherwise the first one beyond the clock. Null if there is none.
export function nextEvent<T extends { time: number }>(
    events: readonly T[], current: T | null, time: number, direction: number,
): T | null {
    if (current) {
        return events[events.indexOf(current) + direction] ?? null;
    }
    const beyond = events.filter((event) => direction * (event.time - time) > 1e-9);
    return (direction > 0 ? beyond[0] : beyond.at(-1)) ?? null;
}

/// Stops at the next event of those that are shown, or at the next part of a film of several shots.
export function stepEvent(direction: number): void {
    playing.value = false;
    if (sequence.peek()) {
        stepParts(direction);
        return;
    }
    const next = nextEvent(shownEvents.peek(), currentEvent.peek(), sceneTime.peek(), direction);
    if (next) {
        goToSceneTime(next.time);
        visitedEvent.value = next;
    }
}

function changeSpeed(by: number): void {
    const at = kSpeeds.findIndex((choice) => choice === speed.peek());
    speed.value = kSpeeds[Math.min(Math.max(at + by, 0), kSpeeds.length - 1)] ?? 1;
}

/// Runs the clock and binds the commands of time. Returns a function that ends both.
export function startPlayback(): () => void {
    const endings = [
        runClock(),
        onCommand('play', togglePlaying),
        onCommand('returnToStart', returnToStart),
        onCommand('toStart', () => stopAt(0)),
        onCommand('toEnd', () => stopAt(filmDuration.peek())),
        onCommand('frameBack', () => stepFrames(-1)),
        onCommand('frameForward', () => stepFrames(1)),
        onCommand('tenBack', () => stepFrames(-10)),
        onCommand('tenForward', () => stepFrames(10)),
        onCommand('tenthBack', () => stepScene(-0.1)),
        onCommand('tenthForward', () => stepScene(0.1)),
        onCommand('eventBack', () => stepEvent(-1)),
        onCommand('eventForward', () => stepEvent(1)),
        onCommand('loop', () => { loops.value = !loops.peek(); }),
        onCommand('slower', () => changeSpeed(1)),
        onCommand('faster', () => changeSpeed(-1)),
        onCommand('fitStrip', fitStrip),
    ];
    return () => endings.forEach((end) => end());
}
