/// How fast each ball is over scene time.
import { computed } from '@preact/signals';
import { tracks } from '../motion/clock';
import type { Triple } from '../protocol';
import { shot, timeline } from '../state/state';

export interface BallSpeeds {
    name: string;
    colour: Triple; // linear
    speeds: Float32Array; // m/s, at even steps from the timeline's start to its end
}

const kSamples = 320;

export const ballSpeeds = computed<{ balls: readonly BallSpeeds[]; most: number }>(() => {
    const head = timeline.value?.head;
    const balls = (shot.value?.objects ?? []).flatMap((object): BallSpeeds[] => {
        const track = object.kind === 'ball' ? tracks.value.get(object.name) : undefined;
        if (!track?.moves || !head) {
            return [];
        }
        const step = (head.end - head.start) / (kSamples - 1);
        return [{ name: object.name, colour: object.colour,
            speeds: Float32Array.from({ length: kSamples }, (_, i) =>
                track.speed(head.start + i * step)) }];
    });
    const most = balls.reduce((all, { speeds }) => speeds.reduce((a, b) => Math.max(a, b), all), 0);
    return { balls, most };
});

/// The fastest balls at a scene time: "cue 3.21 m/s", at most `count`.
export function fastestAt(time: number, count: number): string[] {
    return (shot.peek()?.objects ?? []).filter((object) => object.kind === 'ball')
        .map(({ name }) => ({ name, speed: tracks.peek().get(name)?.speed(time) ?? 0 }))
        .filter(({ speed }) => speed > 0.001)
        .sort((a, b) => b.speed - a.speed).slice(0, count)
        .map(({ name, speed }) => `${name}  ${speed.toFixed(2)} m/s`);
}
