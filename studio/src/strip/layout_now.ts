/// The rows of the strip at its present size.
import { computed, signal } from '@preact/signals';
import { filmThumbnails } from '../state/film_thumbnails';
import { layoutOf } from './layout';
import { shownFilm, shownScene } from './strip_state';

/// CSS pixels of the strip's canvases.
export const stripSize = signal({ width: 0, height: 0 });

export const currentLayout = computed(() => layoutOf(
    stripSize.value.width, stripSize.value.height, shownFilm.value, shownScene.value,
    filmThumbnails.value.size > 0));
