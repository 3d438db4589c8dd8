/// Plays the film's sound in step with the play head, and short pieces of it while scrubbing. The
/// play head leads: the sound follows it, because it also moves where there is no sound.
import { effect, untracked } from '@preact/signals';
import { filmDuration, goToFilmTime } from '../motion/clock';
import { filmTime, playing } from '../state/state';
import { headTime, speed } from '../strip/playback';
import { contextTimeAt, DriftWatch, filmTimeAt, grainAt, partsBetween, type Anchor } from './schedule';
import type { SoundData } from './sound_data';
import { gain, soundData, soundPieces } from './sound_state';

const kRate = 48000; // as the server's samples: the parts of a sound then join exactly
const kAhead = 1.5; // s of the context that are given to it in advance
const kFade = 0.005; // s, where a sound is cut off or begins in its middle
const kGrainsApart = 0.05; // s
const kRest = 5000; // ms without sound, after which the context rests: it takes processor time

/// What sounds from one start of playing, or from one jump of the play head, on.
interface Run {
    data: SoundData;
    anchor: Anchor;
    output: GainNode;
    sources: Set<AudioBufferSourceNode>;
    until: number; // film time up to which parts were given to the context
}

let context: AudioContext | null = null;
let output: GainNode | null = null;
let run: Run | null = null;
const drift = new DriftWatch();
let begun = 0; // runs

/// The context, once the user has done something in the page: before that, browsers forbid sound.
function readyContext(): AudioContext | null {
    if (navigator.userActivation?.hasBeenActive === false || typeof AudioContext === 'undefined') {
        return null;
    }
    if (!context) {
        context = new AudioContext({ sampleRate: kRate, latencyHint: 'interactive' });
        output = context.createGain();
        output.gain.value = gain.peek();
        output.connect(context.destination);
        context.onstatechange = follow;
    }
    restLater();
    if (context.state === 'suspended') {
        void context.resume().catch(() => undefined);
    }
    return context.state === 'running' ? context : null;
}

let resting = 0;

/// Lets the context rest if nothing sounds for a while.
function restLater(): void {
    clearTimeout(resting);
    resting = window.setTimeout(() => {
        if (!run && context?.state === 'running') {
            void context.suspend();
        }
    }, kRest);
}

/// How long a sample takes from the context's clock to the ear, s, as far as the browser knows.
function latency(): number {
    const known = context?.outputLatency ?? 0;
    return Number.isFinite(known) ? Math.min(Math.max(known, 0), 0.5) : 0;
}

/// A fade of an output, from now on.
function fade(node: GainNode, to: number, at: number, length: number): void {
    node.gain.setValueAtTime(1 - to, at);
    node.gain.linearRampToValueAtTime(to, at + length);
}

function endRun(): void {
    if (!run || !context) {
        return;
    }
    const now = context.currentTime;
    run.output.gain.cancelScheduledValues(now);
    fade(run.output, 0, now, kFade);
    for (const source of run.sources) {
        source.stop(now + 2 * kFade);
    }
    run = null;
    restLater();
}

/// Gives a stretch of the sound to the context, as far as its pieces have come. Returns the film
/// time up to which that was possible.
function give(to: AudioContext, one: Run, from: number, until: number): number {
    for (const part of partsBetween(one.anchor, one.data.extent, from, until)) {
        const [left, right] = one.data.channels(part.piece, part.from, part.count);
        if (left.length === 0) {
            return (part.piece * one.data.extent.piece + part.from) / one.data.extent.rate;
        }
        const buffer = to.createBuffer(2, left.length, one.data.extent.rate);
        buffer.getChannelData(0).set(left);
        buffer.getChannelData(1).set(right);
        const source = to.createBufferSource();
        source.buffer = buffer;
        source.playbackRate.value = one.anchor.speed;
        source.connect(one.output);
        source.onended = () => {
            one.sources.delete(source);
            source.disconnect();
        };
        one.sources.add(source);
        source.start(part.at);
    }
    return until;
}

function newRun(now: AudioContext, data: SoundData, anchor: Anchor): Run {
    const node = now.createGain();
    node.connect(output as GainNode);
    begun += 1;
    return { data, anchor, output: node, sources: new Set(), until: 0 };
}

function beginRun(now: AudioContext, data: SoundData, head: number): void {
    endRun();
    const rate = speed.peek();
    // On the grid of samples: at normal speed nothing is interpolated then.
    const at = Math.round((now.currentTime + kFade) * kRate) / kRate;
    const film = head + (at - now.currentTime + latency()) * rate;
    run = newRun(now, data, { film: Math.round(film * kRate) / kRate, context: at, speed: rate });
    run.until = run.anchor.film;
    fade(run.output, 1, at, kFade);
    drift.reset();
}

/// The film time that is heard now; null: nothing is played.
export function heardTime(): number | null {
    return run && context ? filmTimeAt(run.anchor, context.currentTime - latency()) : null;
}

/// Keeps the sound with the play head.
function follow(): void {
    const data = soundData.peek();
    const now = playing.peek() && data && !document.hidden ? readyContext() : null;
    const head = headTime();
    if (!now || !data || head === null) {
        endRun();
        return;
    }
    const off = (heardTime() ?? 0) - head;
    if (run?.data !== data || run.anchor.speed !== speed.peek() || drift.isOff(off)) {
        beginRun(now, data, head);
    }
    if (run) {
        // A piece may come late: what of it has passed is left out.
        const passed = filmTimeAt(run.anchor, now.currentTime);
        const until = Math.min(passed + kAhead * run.anchor.speed, filmDuration.peek());
        if (until - run.until > 0.5 * kAhead * run.anchor.speed || until >= filmDuration.peek()) {
            run.until = Math.max(run.until, give(now, run, Math.max(run.until, passed), until));
        }
    }
}

let lastGrain = -1;
let waitingGrain = 0;

/// Plays what is under the play head, at most every 50 ms; the last place of a quick move is heard.
function playGrain(): void {
    const data = soundData.peek();
    const now = data ? readyContext() : null;
    if (!now || !data) {
        return;
    }
    clearTimeout(waitingGrain);
    const wait = lastGrain + kGrainsApart - now.currentTime;
    if (wait > 0) {
        waitingGrain = window.setTimeout(playGrain, 1000 * wait);
        return;
    }
    lastGrain = now.currentTime;
    const { from, until } = grainAt(filmTime.peek(), data.duration);
    const grain = newRun(now, data, { film: from, context: now.currentTime + kFade, speed: 1 });
    const end = contextTimeAt(grain.anchor, until);
    fade(grain.output, 1, grain.anchor.context, kFade);
    fade(grain.output, 0, end - 2 * kFade, 2 * kFade);
    give(now, grain, from, until);
}

/// Plays from now on. Returns a function that ends this.
export function playSound(): () => void {
    let shown = filmTime.peek();
    let wasPlaying = false;
    const endings = [
        effect(() => {
            void [soundPieces.value, soundData.value, speed.value];
            const [time, isPlaying] = [filmTime.value, playing.value];
            untracked(() => {
                follow();
                if (!isPlaying && !wasPlaying && time !== shown) {
                    playGrain();
                }
            });
            [shown, wasPlaying] = [time, isPlaying];
        }),
        effect(() => {
            const value = gain.value;
            if (context && output) {
                output.gain.setTargetAtTime(value, context.currentTime, 0.01);
            }
        }),
    ];
    document.addEventListener('visibilitychange', follow);
    return () => {
        endings.forEach((end) => end());
        document.removeEventListener('visibilitychange', follow);
        endRun();
    };
}

/// What tests see of the sound: `window.studio.sound`.
export function exposeSound(): void {
    window.studio['sound'] = {
        data: soundData, heardTime, runs: () => begun, context: () => context, output: () => output,
        isPlaying: () => run !== null, goTo: goToFilmTime,
    };
}
