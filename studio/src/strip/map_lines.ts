/// Which lines of a camera's map between both clocks are drawn and dragged.
import type { Camera } from '../protocol';
import type { Axis } from './axis';

const kSpacing = 9; // px between lines
const kMost = 400;

/// Film times of the lines of a camera, its start first and its end last.
export function linesOf(camera: Camera, film: Axis): number[] {
    const length = camera.video_end - camera.video_start;
    const pixels = length / (film.to - film.from) * film.width;
    const count = Math.max(1, Math.min(kMost, Math.floor(pixels / kSpacing)));
    return Array.from({ length: count + 1 }, (_, i) => camera.video_start + length * (i / count));
}
