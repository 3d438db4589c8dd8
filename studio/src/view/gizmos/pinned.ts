/// The motion that the user pinned, to compare later ones with: a way of looking, not a part of the
/// shot.
import { signal } from '@preact/signals';
import { tracks } from '../../motion/clock';
import type { Track } from '../../motion/track';
import type { SceneObject } from '../../protocol';
import { notice, shot } from '../../state/state';
import { kColours, type GhostBall } from './figure';

const kDifferent = 0.002; // m

export interface Pinned {
    objects: readonly SceneObject[];
    tracks: ReadonlyMap<string, Track>;
}

export const pinned = signal<Pinned | null>(null);

/// Pins the present motion, or takes the pinned one away.
export function togglePin(): void {
    const state = shot.peek();
    if (pinned.peek() || !state) {
        pinned.value = null;
        notice.value = { kind: 'info', text: 'Paths unpinned.' };
        return;
    }
    pinned.value = { objects: state.objects, tracks: tracks.peek() };
    notice.value = { kind: 'info', text: 'The present paths are pinned, in grey.' };
}

/// The balls of the pinned motion at a scene time, where the present ones are not.
export function pinnedBalls(time: number): GhostBall[] {
    const now = tracks.value;
    const objects = shot.value?.objects ?? [];
    return (pinned.value?.objects ?? []).flatMap((ball): GhostBall[] => {
        const at = pinned.value?.tracks.get(ball.name)?.position(time) ?? ball.position;
        const present = now.get(ball.name)?.position(time)
            ?? objects.find(({ name }) => name === ball.name)?.position ?? [0, 0, -9];
        const way = Math.hypot(at[0] - present[0], at[1] - present[1], at[2] - present[2]);
        return ball.kind === 'ball' && way > kDifferent
            ? [{ at, radius: ball.radius, colour: kColours.pinned }] : [];
    });
}
