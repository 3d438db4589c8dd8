/// The rows of the strip at its present size.
import { computed, signal } from '@preact/signals';
import { filmThumbnails } from '../state/film_thumbnails';
import { hasSoundRow } from '../sound/sound_state';
import { isSequence } from '../state/state';
import { layoutOf, layoutOfParts } from './layout';
import { shownFilm, shownScene } from './strip_state';

/// CSS pixels of the strip's canvases.
export const stripSize = signal({ width: 0, height: 0 });

export const currentLayout = computed(() => {
    const { width, height } = stripSize.value;
    const hasFrames = filmThumbnails.value.size > 0;
    const hasSound = hasSoundRow.value;
    return isSequence.value ? layoutOfParts(width, height, shownFilm.value, hasFrames, hasSound)
        : layoutOf(width, height, shownFilm.value, shownScene.value, hasFrames, hasSound);
});
