/// What the view shows, and how.
import { computed, signal } from '@preact/signals';
import { lookThrough } from './state';

/// Which of its own cameras the view uses, while it does not look through one of the shot.
export const viewKind = signal<'free' | 'top' | 'side'>('free');
/// Edges instead of surfaces.
export const isWireframe = signal(false);

export const showCameras = signal(true);
export const showLights = signal(true);
export const showTrails = signal(true);
export const showAnnotations = signal(true);
/// Null: in all views but that from above, where lamps would hide the table.
export const lampsChosen = signal<boolean | null>(null);

/// Whether lamps and their shades are drawn. A camera of the shot sees all of the shot.
export const showLamps = computed(() => lookThrough.value !== null
    || (lampsChosen.value ?? viewKind.value !== 'top'));

/// Whether moving the view moves the camera of the shot that is looked through.
export const isCameraLocked = signal(false);
