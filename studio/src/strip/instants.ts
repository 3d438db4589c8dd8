/// The other instants of the film that show the scene's present time: a choice that the user has.
import { computed } from '@preact/signals';
import { instantsAt, type FilmInstant } from '../motion/time_map';
import { filmTime, playing, sceneTime, shot } from '../state/state';

const kSame = 1e-4; // s

/// Empty while the film plays.
export const otherInstants = computed<readonly FilmInstant[]>(() => {
    const cameras = shot.value?.cameras ?? [];
    if (playing.value) {
        return [];
    }
    return instantsAt(cameras, sceneTime.value, filmTime.value)
        .filter(({ time }) => Math.abs(time - filmTime.value) > kSame);
});
