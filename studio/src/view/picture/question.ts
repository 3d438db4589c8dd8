/// The question for the picture of what the view shows.
import { filmDuration } from '../../motion/clock';
import { filmTime, shot } from '../../state/state';
import type { ViewCamera } from '../parts';
import { PerspectiveCamera, Vector3 } from 'three';
import type { FreeView, See } from '../../protocol';

/// What the view shows: a frame of the film, or a view of its own.
export type Shown = Pick<See, 'frame' | 'view' | 'width' | 'height'> & { samples?: number };

/// Bounds of the pictures that the page asks for; the film's own frames are not limited by it.
const kMostPixels = 1_500_000;

/// The frame of the film at a time.
export function frameAt(filmTime: number, film: { frames: number; fps: number }): number {
    const last = Math.max(0, film.frames - 1);
    return Math.max(0, Math.min(last, Math.floor(filmTime * film.fps + 1e-6)));
}

/// The film's frame at the play head; null without a film.
export function filmsFrame(): Shown | null {
    const film = shot.value?.film;
    return film && filmDuration.value > 0 && shot.value && shot.value.cameras.length > 0
        ? { frame: frameAt(Math.min(filmTime.value, filmDuration.value), film), width: 0, height: 0 }
        : null;
}

/// The largest size with the proportions of the view that is not too large to be traced.
export function sizeOfView(width: number, height: number): { width: number; height: number } {
    const shrink = Math.min(1, Math.sqrt(kMostPixels / (width * height)));
    return {
        width: Math.max(1, Math.round(width * shrink)),
        height: Math.max(1, Math.round(height * shrink)),
    };
}

/// The view of a camera of the page, without depth of field; null for one that shows no
/// perspective.
export function viewOf(camera: ViewCamera, sceneTime: number): FreeView | null {
    if (!(camera instanceof PerspectiveCamera)) {
        return null;
    }
    camera.updateMatrixWorld();
    const forward = camera.getWorldDirection(new Vector3());
    const up = new Vector3().setFromMatrixColumn(camera.matrixWorld, 1);
    return {
        scene_time: sceneTime,
        position: camera.position.toArray(),
        target: camera.position.clone().add(forward).toArray(),
        up: up.toArray(),
        fov: (camera.fov * Math.PI) / 180,
        focus: 1,
        lens_radius: 0,
    };
}
